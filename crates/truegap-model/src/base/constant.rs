//! A value that should not move: for drift studies.
//!
//! Limits: no load, no plates; only clock, thermal path and readout mean anything.

use super::scale::ResponseScale;
use truegap_core::{
    Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, StageName, named_values, walk_without_plates,
};

/// Response `level`.
#[derive(Clone, Debug)]
pub(super) struct Constant {
    unit: String,
    range: f64,
    reference_c: f64,
    parameters: Vec<Parameter>,
}

impl Constant {
    /// A level somewhere about the recorded one.
    pub fn new(scale: &ResponseScale, reference_c: f64) -> Self {
        let level = Parameter::normal("level", &scale.unit, scale.centre, 10.0 * scale.range, "value that should not move");
        Self { unit: scale.unit.clone(), range: scale.range, reference_c, parameters: vec![level] }
    }
}

impl Simulator for Constant {
    fn name(&self) -> &str {
        "constant"
    }

    fn unit(&self) -> &str {
        &self.unit
    }

    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn needs(&self) -> &[Role] {
        &[]
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        match stage {
            StageName::Inputs | StageName::LoadPath | StageName::Beads => Some("a constant has no load"),
            StageName::Geometry | StageName::Dielectric | StageName::Field => Some("a constant has no plates"),
            StageName::ThermalPath | StageName::Readout => None,
        }
    }

    fn full_load(&self) -> Option<f64> {
        None
    }

    fn reference_c(&self) -> f64 {
        self.reference_c
    }

    fn moves(&self) -> bool {
        false
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let [level] = named_values(self, values)?;
        // nothing spans a constant: the range of the recording is the scale for effects that ask for one
        let readout = Readout { zero: level, span: self.range };
        walk_without_plates(self, values, inputs, stages, |drive| Ok((vec![level; drive.load.len()], readout)))
    }
}
