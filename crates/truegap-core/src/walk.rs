//! The one walk down the chain: a base model gives its physics, the walk plugs the stages in between.
//!
//! Limits: all rows through one place before any goes to the next, because stages have a memory.

mod between;
mod known;
mod late;
mod plates;

use crate::{
    chain::{Dielectric, Drive, FieldView, Geometry, Readout, Stage},
    inputs::Inputs,
    simulation_error::{SimulationError, check_finite},
    simulator::Simulator,
};
use std::borrow::Cow;

pub use late::beyond_the_ends;
pub use plates::{GapReading, GapReadings, PlateColumns, PlateReading, Plates, Readings, RefusedRow, Stiffness};

/// Response of a model with plates: inputs, load path and thermal path, beads, geometry, dielectric, field, readout.
///
/// # Errors
/// [`SimulationError`] of [`Simulator::check`], of the first row that `plates` refuses, or of the first that is not finite.
pub fn walk(
    simulator: &dyn Simulator,
    plates: &impl PlateColumns,
    values: &[f64],
    inputs: &Inputs,
    stages: &[&dyn Stage],
) -> Result<Vec<f64>, SimulationError> {
    let head = Head::new(simulator, values, inputs, stages)?;
    let drive = head.drive();
    let strain = strains(plates, &drive, stages, values)?;
    let geometry = geometry(&strain, plates.warp_factor(), &drive, stages);
    let factors = dielectric(&drive, stages);
    let value = readings(plates, &drive, &geometry, &factors, stages, values)?;
    read_out(value, plates.readout()?, &drive, stages, values)
}

/// Response of a model without plates: inputs, load path, thermal path and readout; `reading` gives value and readout between them.
///
/// # Errors
/// [`SimulationError`] of [`Simulator::check`], of `reading`, or of the first row that is not finite.
pub fn walk_without_plates(
    simulator: &dyn Simulator,
    values: &[f64],
    inputs: &Inputs,
    stages: &[&dyn Stage],
    reading: impl FnOnce(&Drive<'_>) -> Result<(Vec<f64>, Readout), SimulationError>,
) -> Result<Vec<f64>, SimulationError> {
    let head = Head::new(simulator, values, inputs, stages)?;
    let drive = head.drive();
    let (value, readout) = reading(&drive)?;
    read_out(value, readout, &drive, stages, values)
}

/// Columns that drive a model, before anything is computed from them.
struct Head<'a> {
    inputs: Cow<'a, Inputs>,
    load: Vec<f64>,
    temperature_c: Vec<f64>,
    reference_c: f64,
    full_load: f64,
}

impl<'a> Head<'a> {
    /// Walks clocks, load path and thermal path.
    fn new(
        simulator: &dyn Simulator,
        values: &[f64],
        inputs: &'a Inputs,
        stages: &[&dyn Stage],
    ) -> Result<Self, SimulationError> {
        simulator.check(values, inputs)?;
        let (reference_c, rows) = (simulator.reference_c(), inputs.len());
        let inputs = late::on_one_clock(inputs, stages);
        let mut load = simulator.load(&inputs).unwrap_or_else(|| vec![0.0; rows]);
        stages.iter().for_each(|stage| stage.load(&inputs, &mut load));
        let mut temperature_c = inputs.temperature_c.clone().unwrap_or_else(|| vec![reference_c; rows]);
        stages.iter().for_each(|stage| stage.thermal(&inputs, &mut temperature_c));
        Ok(Self { inputs, load, temperature_c, reference_c, full_load: simulator.full_load().unwrap_or(1.0) })
    }

    fn drive(&self) -> Drive<'_> {
        Drive {
            inputs: &self.inputs,
            load: &self.load,
            temperature_c: &self.temperature_c,
            reference_c: self.reference_c,
            full_load: self.full_load,
        }
    }
}

/// Beads: strain with its history.
fn strains(
    plates: &impl PlateColumns,
    drive: &Drive<'_>,
    stages: &[&dyn Stage],
    values: &[f64],
) -> Result<Vec<f64>, SimulationError> {
    let mut modulus = vec![1.0; drive.load.len()];
    stages.iter().for_each(|stage| stage.modulus(drive, &mut modulus));
    let add = |sum: [f64; 2], next: [f64; 2]| [sum[0] + next[0], sum[1] + next[1]];
    let stiffening = stages.iter().map(|stage| stage.stiffening()).fold([0.0; 2], add);
    let mut strain = plates.strains(drive, &modulus, stiffening).map_err(|row| refused(row, drive, values))?;
    stages.iter().for_each(|stage| stage.strain(drive, &mut strain));
    Ok(strain)
}

/// Geometry: parallel plates, bent as the base model bends them, then what the stages add.
fn geometry<'a>(strain: &'a [f64], warp_factor: f64, drive: &Drive<'_>, stages: &[&dyn Stage]) -> Geometry<'a> {
    let rows = strain.len();
    let mut geometry = Geometry {
        strain,
        gap: vec![0.0; rows],
        warp_kelvin: drive.temperature_c.iter().map(|t| t - drive.reference_c).collect(),
        warp_factor,
        tilt: vec![0.0; rows],
        sag: vec![0.0; rows],
    };
    stages.iter().for_each(|stage| stage.geometry(drive, &mut geometry));
    geometry
}

/// Dielectric: factors on the permittivities.
fn dielectric(drive: &Drive<'_>, stages: &[&dyn Stage]) -> Dielectric {
    let rows = drive.load.len();
    let mut factors = Dielectric { beads: vec![1.0; rows], insulator: vec![1.0; rows] };
    stages.iter().for_each(|stage| stage.dielectric(drive, &mut factors));
    factors
}

/// Readings of the plates, and the field outside of them where their size is known.
fn readings(
    plates: &impl PlateColumns,
    drive: &Drive<'_>,
    geometry: &Geometry<'_>,
    factors: &Dielectric,
    stages: &[&dyn Stage],
    values: &[f64],
) -> Result<Vec<f64>, SimulationError> {
    let Readings { mut value, gap } = plates.readings(drive, geometry, factors).map_err(|row| refused(row, drive, values))?;
    if let Some(GapReadings { aspect, plates }) = gap {
        let view = FieldView { aspect: &aspect, strain: geometry.strain, plates: &plates };
        let mut extra = vec![0.0; value.len()];
        stages.iter().for_each(|stage| stage.field(drive, &view, &mut extra));
        value.iter_mut().zip(&extra).for_each(|(value, extra)| *value += extra);
    }
    Ok(value)
}

/// Readout: what the electronics make of the value.
fn read_out(
    mut value: Vec<f64>,
    readout: Readout,
    drive: &Drive<'_>,
    stages: &[&dyn Stage],
    values: &[f64],
) -> Result<Vec<f64>, SimulationError> {
    stages.iter().for_each(|stage| stage.readout(drive, &readout, &mut value));
    check_finite(value, values)
}

/// The error of a row that has no answer.
fn refused((row, refusal): RefusedRow, drive: &Drive<'_>, values: &[f64]) -> SimulationError {
    refusal.at(row, drive.load[row] * drive.full_load, values)
}
