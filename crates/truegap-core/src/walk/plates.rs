//! What a model with plates tells of itself: row by row, or whole columns at once.
//!
//! Limits: a column is answered whole or not at all; a refusal names the first row that has no answer.

use crate::{
    chain::{Dielectric, Drive, Geometry, Readout},
    simulation_error::{Refusal, SimulationError},
};

/// How stiff the dielectric is in a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness {
    /// factor on the Young's modulus
    pub modulus: f64,
    /// `[a, b]`: stress at strain e is multiplied by `1 + a e + b e^2`
    pub stiffening: [f64; 2],
}

/// What a pair of plates reads in a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateReading {
    /// reading with everything that belongs to the sensor, before any field outside the plates, in the response's unit
    pub value: f64,
    /// what a field outside the plates is in proportion to; `None` where the size of the plates is unknown, and with it such a field
    pub gap: Option<GapReading>,
}

/// The gap of a row, as [`crate::FieldView`] shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GapReading {
    /// mean separation of the electrodes, as a share of the electrode's radius
    pub aspect: f64,
    /// capacitance between the plates alone, in the response's unit
    pub plates: f64,
}

/// Physics of plates with a compressible dielectric between them, one set of parameter values filled in.
///
/// Each method answers for one row; [`walk`](crate::walk) goes through the rows and through the places of the chain.
pub trait Plates {
    /// Elastic compressive strain of the dielectric, before any history of it.
    ///
    /// # Errors
    /// [`Refusal`] where no strain answers the load, or only one that closes the gap.
    fn strain(&self, drive: &Drive<'_>, row: usize, stiffness: Stiffness) -> Result<f64, Refusal>;
    /// Factor on the curvature of the electrode before any stage: 1 where the base model warps, else 0.
    fn warp_factor(&self) -> f64 {
        0.0
    }
    /// What the plates read.
    ///
    /// # Errors
    /// [`Refusal`] where the plates touch.
    fn reading(
        &self,
        drive: &Drive<'_>,
        row: usize,
        geometry: &Geometry<'_>,
        factors: &Dielectric,
    ) -> Result<PlateReading, Refusal>;
    /// Zero and span of the sensor at these parameter values.
    ///
    /// # Errors
    /// [`SimulationError`] where the full load has no answer.
    fn readout(&self) -> Result<Readout, SimulationError>;
}

/// A row that has no answer, and why.
pub type RefusedRow = (usize, Refusal);

/// What pairs of plates read, a column a quantity.
#[derive(Clone, Debug, Default)]
pub struct Readings {
    /// as [`PlateReading::value`]
    pub value: Vec<f64>,
    /// as [`PlateReading::gap`]; `None` where a row has none
    pub gap: Option<GapReadings>,
}

/// The gaps of all rows, a column a quantity.
#[derive(Clone, Debug, Default)]
pub struct GapReadings {
    /// as [`GapReading::aspect`]
    pub aspect: Vec<f64>,
    /// as [`GapReading::plates`]
    pub plates: Vec<f64>,
}

/// As [`Plates`], but asked for whole columns: for a model that knows which columns are as they were, and has nothing to compute for those.
pub trait PlateColumns {
    /// Elastic compressive strain of each row; `modulus` and `stiffening` as in [`Stiffness`].
    ///
    /// # Errors
    /// The first row that [`Plates::strain`] would refuse.
    fn strains(&self, drive: &Drive<'_>, modulus: &[f64], stiffening: [f64; 2]) -> Result<Vec<f64>, RefusedRow>;
    /// As [`Plates::warp_factor`].
    fn warp_factor(&self) -> f64 {
        0.0
    }
    /// What the plates read in each row.
    ///
    /// # Errors
    /// The first row that [`Plates::reading`] would refuse.
    fn readings(&self, drive: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<Readings, RefusedRow>;
    /// As [`Plates::readout`].
    ///
    /// # Errors
    /// As [`Plates::readout`].
    fn readout(&self) -> Result<Readout, SimulationError>;
}

impl<P: Plates> PlateColumns for P {
    fn strains(&self, drive: &Drive<'_>, modulus: &[f64], stiffening: [f64; 2]) -> Result<Vec<f64>, RefusedRow> {
        let mut strains = Vec::with_capacity(modulus.len());
        for (row, &modulus) in modulus.iter().enumerate() {
            strains.push(self.strain(drive, row, Stiffness { modulus, stiffening }).map_err(|refusal| (row, refusal))?);
        }
        Ok(strains)
    }

    fn warp_factor(&self) -> f64 {
        Plates::warp_factor(self)
    }

    fn readings(&self, drive: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<Readings, RefusedRow> {
        let rows = drive.load.len();
        let (mut value, mut aspect, mut plates) = (Vec::with_capacity(rows), Vec::with_capacity(rows), Vec::with_capacity(rows));
        for row in 0..rows {
            let reading = self.reading(drive, row, geometry, factors).map_err(|refusal| (row, refusal))?;
            value.push(reading.value);
            if let Some(gap) = reading.gap {
                aspect.push(gap.aspect);
                plates.push(gap.plates);
            }
        }
        let gap = (aspect.len() == rows).then_some(GapReadings { aspect, plates });
        Ok(Readings { value, gap })
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        Plates::readout(self)
    }
}
