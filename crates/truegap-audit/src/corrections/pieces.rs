//! What the tables give for one sensor, and the analytic chain with it.
//!
//! Limits: as [`super::Corrected`]; smooth in load and temperature but for the load at which a rim that curls up lies flat.

use super::{
    BondedLayers, Table, library,
    one_sensor::{check_permittivities, curve, field},
    warped::{Warp, Warped},
};
use crate::{
    AuditError,
    cell::{Cell, Growth},
    fit::Chebyshev,
};
use truegap_core::{Sensor, VACUUM_PERMITTIVITY, sensor::Layout};
use truegap_model::{
    StackOptions,
    stack::{Device, Refusal, Warm},
};

/// What the tables give for one sensor.
#[derive(Clone, Debug)]
pub(super) struct Pieces {
    pub device: Device,
    pub secant: Chebyshev,
    /// over (temperature above the reference, strain)
    pub field: Table,
    pub rim: Table,
    pub tail: f64,
    pub growth: Growth,
    pub layers: BondedLayers,
    pub warp: Warp,
    pub softest: f64,
}

impl Pieces {
    pub fn new(sensor: &Sensor) -> Result<Self, AuditError> {
        let lacks = |part| AuditError::Lacks { sensor: sensor.name.clone(), part };
        if sensor.layout != Layout::Shielded {
            return Err(lacks("shields, for which the field at the rim is tabulated"));
        }
        let (cell, tables) = (Cell::of(sensor)?, library()?);
        check_permittivities(sensor)?;
        let compressibility = 1.0 - 2.0 * cell.poisson;
        let s = cell.shape_factor();
        let radius = 0.5 * sensor.diameter.value;
        let electrode = sensor.conductor.thickness.value + sensor.plating.as_ref().map_or(0.0, |p| p.thickness.value);
        let growth = Growth::of(sensor, tables.held_expansion.at(&[s, compressibility])?);
        let tail = match sensor.tail {
            (length, width) if length * width > 0.0 => {
                tables.tail_edge.at(&[width / cell.film, sensor.conductor.thickness.value / cell.film])?
            }
            _ => 1.0,
        };
        let secant = curve(&tables.bead_load.given(&[s, compressibility])?);
        let layers = BondedLayers::of(sensor);
        let device = Device::new(&layers.sensor, StackOptions { warp: false, ..StackOptions::default() });
        let mut pieces = Self {
            softest: secant.at(0.0)?,
            secant,
            field: field(&tables.cell_field, &device, growth, &cell)?,
            rim: tables.rim_field.given(&[cell.film / radius, electrode / radius])?,
            device,
            tail,
            growth,
            layers,
            warp: Warp::none(),
        };
        pieces.warp = Warp::of(&Warped::of(sensor)?, |kelvin, strain| pieces.state(kelvin, strain))?;
        Ok(pieces)
    }

    /// Gap (m) and stiffness of the beads per their own cold area (Pa/m) at a temperature above the reference and a strain.
    fn state(&self, kelvin: f64, strain: f64) -> Result<[f64; 2], AuditError> {
        let mut warm = self.device.warmed_by(kelvin);
        self.growth.apply(&mut warm);
        let wider = warm.areas.solid / self.device.warmed_by(0.0).areas.solid;
        Ok([warm.layers.beads * (1.0 - strain), warm.young * self.tangent(strain)? * wider / warm.layers.beads])
    }

    /// Slope of the load over modulus and area at a strain.
    fn tangent(&self, strain: f64) -> Result<f64, AuditError> {
        let step = 1e-4 * self.secant.high;
        let (low, high) = ((strain - step).max(0.0), (strain + step).min(self.secant.high));
        Ok((high * self.secant.at(high)? - low * self.secant.at(low)?) / (high - low))
    }

    /// The warm sensor with beads whose faces are held.
    pub fn warm(&self, temperature_c: f64) -> Warm {
        let mut warm = self.device.at(temperature_c);
        self.growth.apply(&mut warm);
        warm
    }

    /// Strain at a load over modulus and area, by Newton's method on e k(e).
    pub fn strain(&self, reduced_load: f64) -> Result<f64, AuditError> {
        let mut strain = (reduced_load / self.softest).clamp(0.0, self.secant.high);
        for _ in 0..50 {
            let next = strain - (strain * self.secant.at(strain)? - reduced_load) / self.tangent(strain)?;
            if (next - strain).abs() <= 1e-12 {
                // an argument beyond the table is refused here
                self.secant.at(next)?;
                return Ok(next);
            }
            strain = if next > self.secant.high { 0.5 * (strain + self.secant.high) } else { next.max(0.0) };
        }
        let what = "load over modulus and bead area".to_owned();
        let high = self.secant.high * self.secant.at(self.secant.high)?;
        Err(AuditError::Uncovered { what, value: reduced_load, low: 0.0, high, remedy: "take a smaller load" })
    }

    /// Capacitance at the rim, F; `beads` is that of the bead layer.
    pub fn rim(&self, warm: &Warm, strain: f64, beads: f64) -> Result<f64, AuditError> {
        let gap = warm.layers.beads * (1.0 - strain);
        let mixed = beads * gap / (warm.areas.electrode * VACUUM_PERMITTIVITY);
        Ok(VACUUM_PERMITTIVITY * warm.radius * self.rim.at(&[mixed, gap / warm.radius])?)
    }

    /// What is read, pF.
    pub fn capacitance_pf(&self, force_n: f64, temperature_c: f64) -> Result<f64, AuditError> {
        let warm = self.warm(temperature_c);
        let strain = self.strain(force_n / (warm.areas.solid * warm.young))?;
        let row = self.device.plain(&warm, force_n, strain);
        let refuse = |refusal| {
            let strain = if let Refusal::Touches { strain } = refusal { strain } else { f64::NAN };
            AuditError::NoResponse { force_n, temperature_c, strain }
        };
        let mut parts = self.device.capacitances(&warm, &row).map_err(refuse)?;
        let rim = self.rim(&warm, strain, parts.beads)?;
        let bent = self.warp.gains(warm.kelvin, strain, force_n)?;
        parts.shares.main *= self.field.at(&[warm.kelvin, strain])? * (1.0 + bent.main);
        parts.shares.backing *= (1.0 + bent.backing) / (1.0 + self.layers.backing_per_kelvin * warm.kelvin);
        parts.shares.main += rim;
        parts.shares.tail *= self.tail;
        Ok(self.device.total(parts.shares) * 1e12)
    }
}
