//! The analytic chain with finite elements' answers in the place of its broken pieces, at its own speed.
//!
//! Limits: bonded beads; the box of each table; shielded layout; a rigid load plate, full contact (no lift-off), no bending between beads.

use super::{parts::Parts, pieces::Pieces, range, warped::Gains};
use crate::error::AuditError;
use truegap_core::{Inputs, Parameter, Role, Sensor, SimulationError, Simulator, Stage, simulator::StageName};
use truegap_model::{Stack, StackOptions};

/// The corrected model of one sensor.
#[derive(Clone, Debug)]
pub struct Corrected {
    sensor: Sensor,
    stack: Stack,
    pieces: Pieces,
}

impl Corrected {
    /// The corrected model of a sensor.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] where the sensor lies outside of a table, [`AuditError::Lacks`] without beads or shields.
    pub fn new(sensor: &Sensor) -> Result<Self, AuditError> {
        let options = StackOptions { warp: false, ..StackOptions::default() };
        Ok(Self { sensor: sensor.clone(), stack: Stack::new(sensor, options), pieces: Pieces::new(sensor)? })
    }

    /// The sensor.
    pub fn sensor(&self) -> &Sensor {
        &self.sensor
    }

    /// What is read at a force (N) and a temperature (degrees Celsius), pF.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] where the beads are squeezed beyond their table.
    pub fn capacitance_pf(&self, force_n: f64, temperature_c: f64) -> Result<f64, AuditError> {
        Ok(self.parts(force_n, temperature_c)?.total())
    }

    /// What is added up at a force (N) and a temperature (degrees Celsius).
    ///
    /// # Errors
    /// As [`Corrected::capacitance_pf`].
    pub fn parts(&self, force_n: f64, temperature_c: f64) -> Result<Parts, AuditError> {
        self.pieces.parts(force_n, temperature_c)
    }

    /// What is left of the warp at a force (N) below a rigid plate and a temperature (degrees Celsius).
    pub fn gains(&self, force_n: f64, temperature_c: f64) -> Gains {
        self.pieces.warp.gains(temperature_c - self.sensor.reference_c, force_n)
    }

    /// Strain of the beads at a force (N) and a temperature (degrees Celsius).
    ///
    /// # Errors
    /// As [`Corrected::capacitance_pf`].
    pub fn strain(&self, force_n: f64, temperature_c: f64) -> Result<f64, AuditError> {
        let warm = self.pieces.warm(temperature_c);
        self.pieces.strain(&warm, force_n)
    }
}

/// Why no stage plugs in.
const COMPLETE: &str = "the corrected model has its own beads, geometry and field; plug effects into the model `stack`";

impl Simulator for Corrected {
    fn name(&self) -> &str {
        "corrected"
    }

    fn unit(&self) -> &str {
        "pF"
    }

    fn parameters(&self) -> &[Parameter] {
        self.stack.parameters()
    }

    fn needs(&self) -> &[Role] {
        &[Role::Force]
    }

    fn lacks(&self, _stage: StageName) -> Option<&'static str> {
        Some(COMPLETE)
    }

    fn full_load(&self) -> Option<f64> {
        Some(self.sensor.full_scale)
    }

    fn warps(&self) -> Option<bool> {
        Some(false)
    }

    fn has_insulator(&self) -> bool {
        true
    }

    fn knows_its_level(&self) -> bool {
        true
    }

    fn reference_c(&self) -> f64 {
        self.sensor.reference_c
    }

    /// Response of each row; stages are left out, as [`Simulator::lacks`] says. A row beyond the tables counts as a gap that closes.
    fn respond(&self, values: &[f64], inputs: &Inputs, _stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        self.check(values, inputs)?;
        let force = self.column(inputs, Role::Force)?;
        // the pieces are the sensor's: where they cannot be, no row has an answer, and the first stands for all
        let outside = || SimulationError::NotFinite { row: 0, parameters: values.to_vec() };
        let pieces = Pieces::new(&self.stack.calibrated(values)).map_err(|_| outside())?;
        let row = |(row, &force_n): (usize, &f64)| {
            let temperature = inputs.temperature_c.as_ref().map_or(self.sensor.reference_c, |t| t[row]);
            let beyond = |_| SimulationError::GapCloses { row, load_si: force_n, strain: range::GREATEST_STRAIN };
            pieces.parts(force_n, temperature).map(|parts| parts.total()).map_err(beyond)
        };
        force.iter().enumerate().map(row).collect()
    }
}
