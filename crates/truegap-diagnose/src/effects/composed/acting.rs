//! A column that changes one quantity of the chain, as a stage.
//!
//! ```text
//! quantity + size u      (adds)
//! quantity (1 + size u)  (scales; a reading above its zero)
//! ```
//!
//! Limits: one quantity.

use crate::effects::composed::{
    signal::Courses,
    words::{Action, Quantity},
};
use truegap_core::{Dielectric, Drive, Geometry, Inputs, Readout, Stage};

/// The column u, from what can be followed; `None` where it cannot.
pub type Column = dyn Fn(&Courses<'_>) -> Option<Vec<f64>> + Send + Sync;

/// A quantity that follows a column.
pub struct Acting {
    /// what is changed
    pub quantity: Quantity,
    /// how
    pub action: Action,
    /// change per unit of the column
    pub size: f64,
    /// temperature at which the sensor is described, degrees Celsius
    pub reference_c: f64,
    /// u
    pub column: Box<Column>,
}

impl Acting {
    /// Changes a column of the quantity.
    fn change(&self, courses: &Courses<'_>, zero: f64, values: &mut [f64]) {
        let Some(u) = (self.column)(courses).filter(|_| self.size != 0.0) else { return };
        match self.action {
            Action::Adds => values.iter_mut().zip(&u).for_each(|(v, u)| *v += self.size * u),
            Action::Scales => values.iter_mut().zip(&u).for_each(|(v, u)| *v += (*v - zero) * self.size * u),
        }
    }

    /// At a place behind load path and thermal path.
    fn along(&self, quantity: Quantity, drive: &Drive<'_>, values: &mut [f64]) {
        if self.quantity == quantity {
            self.behind(drive, None, 0.0, values);
        }
    }

    fn behind(&self, drive: &Drive<'_>, reading: Option<&[f64]>, zero: f64, values: &mut [f64]) {
        let temperature: Vec<f64> = drive.temperature_c.iter().map(|t| t - drive.reference_c).collect();
        let courses = Courses { inputs: drive.inputs, load: Some(drive.load), temperature: Some(&temperature), reading };
        self.change(&courses, zero, values);
    }

    /// Before the chain knows the temperature of the sensor.
    fn before(&self, quantity: Quantity, inputs: &Inputs, load: Option<&[f64]>, values: &mut [f64]) {
        if self.quantity != quantity {
            return;
        }
        let above = |t: &Vec<f64>| t.iter().map(|t| t - self.reference_c).collect::<Vec<f64>>();
        let temperature = inputs.temperature_c.as_ref().map(above);
        self.change(&Courses { inputs, load, temperature: temperature.as_deref(), reading: None }, 0.0, values);
    }
}

impl Stage for Acting {
    fn load(&self, inputs: &Inputs, load: &mut [f64]) {
        if self.quantity == Quantity::Load {
            let before = load.to_vec();
            self.before(Quantity::Load, inputs, Some(&before), load);
        }
    }
    fn thermal(&self, inputs: &Inputs, temperature_c: &mut [f64]) {
        self.before(Quantity::Temperature, inputs, None, temperature_c);
    }
    fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
        self.along(Quantity::Modulus, drive, factor);
    }
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        self.along(Quantity::Strain, drive, strain);
    }
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        self.along(Quantity::Gap, drive, &mut geometry.gap);
        self.along(Quantity::Warp, drive, &mut geometry.warp_kelvin);
    }
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
        self.along(Quantity::Permittivity, drive, &mut factors.beads);
    }
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        if self.quantity == Quantity::Reading {
            let reading: Vec<f64> = value.iter().map(|v| v - readout.zero).collect();
            self.behind(drive, Some(&reading), readout.zero, value);
        }
    }
}
