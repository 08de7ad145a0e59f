//! What drives a model that is given as a curve: one recorded column, and the way of a load to what it deforms.
//!
//! Limits: deformation is taken in proportion to the load until physics is plugged in; the share at full load sets no more than the scale of that physics.

use crate::equations::load::{BeadLaw, compressive_strain};
use serde::{Deserialize, Serialize};
use truegap_core::{Drive, Inputs, Role, SimulationError, Stage, ends};

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
        let (low, high) = ends(column.iter().copied());
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

/// A column under `[drivers]` with the range by which it is made a number of the order of 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NamedDriver {
    /// its name there
    pub name: String,
    /// where the number is 0: the least value recorded, in the driver's unit
    pub zero: f64,
    /// from there to where it is 1: the greatest value recorded
    pub width: f64,
}

impl NamedDriver {
    /// The driver of this name as a recording has it, or the first that moves where none is named; `None` where there is none that moves.
    pub fn of(inputs: &Inputs, name: Option<&str>) -> Option<Self> {
        let named = inputs.drivers.iter().filter(|driver| name.is_none_or(|name| name == driver.name));
        named
            .filter_map(|driver| {
                let (low, high) = ends(driver.values.iter().copied());
                let width = high - low;
                (width > 0.0 && width.is_finite()).then(|| Self { name: driver.name.clone(), zero: low, width })
            })
            .next()
    }

    fn recorded(&self, inputs: &Inputs, model: &str) -> Result<Vec<f64>, SimulationError> {
        let missing = || SimulationError::MissingDriver { model: model.to_owned(), name: self.name.clone() };
        let driver = inputs.drivers.iter().find(|driver| driver.name == self.name).ok_or_else(missing)?;
        Ok(driver.values.iter().map(|value| (value - self.zero) / self.width).collect())
    }
}

/// What a curve follows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Followed {
    /// a column with a role of its own
    Column(Driver),
    /// a column under `[drivers]`
    Named(NamedDriver),
}

impl Followed {
    /// Its role; `None` of a column under `[drivers]`.
    pub fn role(&self) -> Option<Role> {
        match self {
            Self::Column(driver) => Some(driver.role),
            Self::Named(_) => None,
        }
    }

    /// The full load in SI, where it is a load.
    pub(crate) fn full_load(&self) -> Option<f64> {
        match self {
            Self::Column(driver) if is_load(driver.role) => Some(driver.width),
            _ => None,
        }
    }

    /// As [`Driver::recorded`].
    ///
    /// # Errors
    /// [`SimulationError`] where it was not recorded.
    pub(crate) fn recorded(&self, inputs: &Inputs, model: &str) -> Result<Vec<f64>, SimulationError> {
        match self {
            Self::Column(driver) => driver.recorded(inputs, model),
            Self::Named(driver) => driver.recorded(inputs, model),
        }
    }

    /// As [`Driver::arrived`]; what stands under `[drivers]` arrives as it was recorded.
    ///
    /// # Errors
    /// [`SimulationError`] where it was not recorded or the physics has no answer.
    pub(crate) fn arrived(&self, drive: &Drive<'_>, stages: &[&dyn Stage], model: &str) -> Result<Vec<f64>, SimulationError> {
        match self {
            Self::Column(driver) => driver.arrived(drive, stages, model),
            Self::Named(driver) => driver.recorded(drive.inputs, model),
        }
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
