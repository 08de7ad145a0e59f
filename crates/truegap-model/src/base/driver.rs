//! What drives a model that is given as a curve: one recorded column, and the way of a load to what it deforms.
//!
//! Limits: deformation is taken in proportion to the load until physics is plugged in; the share at full load sets no more than the scale of that physics.

use crate::equations::load::{BeadLaw, compressive_strain};
use serde::{Deserialize, Serialize};
use truegap_core::{Drive, Inputs, Role, SimulationError, Stage};

/// Strain at full load that stands for a deformation whose size is not known.
const TYPICAL_STRAIN: f64 = 0.2;

/// Columns that may drive a curve, in the order in which one is taken where none is named.
pub const DRIVERS: [Role; 6] = [Role::Force, Role::Pressure, Role::Gap, Role::Temperature, Role::Humidity, Role::Time];

/// Whether a role is a load, which deforms what it acts on.
pub(crate) fn is_load(role: Role) -> bool {
    matches!(role, Role::Force | Role::Pressure)
}

/// A column with the range by which it is made a number of the order of 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Driver {
    /// which column
    pub role: Role,
    /// where the number is 0: no load, else the least value recorded
    pub zero: f64,
    /// from there to where it is 1: the load farthest from 0, else the greatest value recorded
    pub width: f64,
}

impl Driver {
    /// The driver as a recording has it; `None` where the column is not there or never moves.
    pub fn of(inputs: &Inputs, role: Role) -> Option<Self> {
        let column = inputs.column(role)?;
        let (low, high) = column.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)));
        let (zero, width) = if is_load(role) { (0.0, high.max(-low)) } else { (low, high - low) };
        (high > low && width.is_finite()).then_some(Self { role, zero, width })
    }

    /// The recorded column as such numbers.
    ///
    /// # Errors
    /// [`SimulationError::MissingColumn`] where it was not recorded.
    pub(crate) fn recorded(&self, inputs: &Inputs, model: &str) -> Result<Vec<f64>, SimulationError> {
        let missing = || SimulationError::MissingColumn { model: model.to_owned(), role: self.role };
        Ok(inputs.column(self.role).ok_or_else(missing)?.iter().map(|value| self.number(*value)).collect())
    }

    /// What arrives, once clocks, load path, deformation and thermal path have been gone through.
    ///
    /// # Errors
    /// [`SimulationError`] where the column is missing or the physics has no answer.
    pub(crate) fn arrived(&self, drive: &Drive<'_>, stages: &[&dyn Stage], model: &str) -> Result<Vec<f64>, SimulationError> {
        match self.role {
            role if is_load(role) => deformation(drive.load, drive, stages),
            Role::Temperature => Ok(drive.temperature_c.iter().map(|value| self.number(*value)).collect()),
            _ => self.recorded(drive.inputs, model),
        }
    }

    fn number(&self, value: f64) -> f64 {
        (value - self.zero) / self.width
    }
}

/// A deformation in units of that at full load, with softening, stiffening and memory plugged in; `elastic` is what it is without them.
///
/// # Errors
/// [`SimulationError::GapCloses`] where what is plugged in cannot carry the load.
pub(crate) fn deformation(elastic: &[f64], drive: &Drive<'_>, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
    let mut factor = vec![1.0; elastic.len()];
    stages.iter().for_each(|stage| stage.modulus(drive, &mut factor));
    let add = |sum: [f64; 2], next: [f64; 2]| [sum[0] + next[0], sum[1] + next[1]];
    let stiffening = stages.iter().map(|stage| stage.stiffening()).fold([0.0; 2], add);
    let law = BeadLaw { poisson: 0.0, stiffening };
    let strain = |(row, factor): (usize, f64)| {
        let closes = || SimulationError::GapCloses { row, load_si: drive.load[row] * drive.full_load, strain: 1.0 };
        compressive_strain(TYPICAL_STRAIN * elastic[row] / factor, law).filter(|s| s.is_finite()).ok_or_else(closes)
    };
    let mut strain = factor.into_iter().enumerate().map(strain).collect::<Result<Vec<_>, _>>()?;
    stages.iter().for_each(|stage| stage.strain(drive, &mut strain));
    Ok(strain.into_iter().map(|strain| strain / TYPICAL_STRAIN).collect())
}
