//! Somebody else's simulation, given as a column of the recording.
//!
//! Limits: nothing inside it can be changed; only clocks, thermal path and readout plug in, the simulation itself being shifted with the load's clock.

use super::scale::ResponseScale;
use serde::{Deserialize, Serialize};
use truegap_core::{Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, StageName, walk_without_plates};

/// What of an external simulation may be adjusted; nothing unless asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ExternalOptions {
    /// standard deviation of a gain about 1
    pub gain_sd: Option<f64>,
    /// whether an offset is free
    pub offset: bool,
}

/// Response `offset + gain x simulated`.
#[derive(Clone, Debug)]
pub struct External {
    unit: String,
    reference_c: f64,
    options: ExternalOptions,
    parameters: Vec<Parameter>,
}

impl External {
    /// A simulated column; `options` say what may be adjusted.
    pub fn new(scale: &ResponseScale, reference_c: f64, options: ExternalOptions) -> Self {
        let gain = options.gain_sd.map(|sd| Parameter::normal("gain", "", 1.0, sd, "factor on the simulation"));
        let offset = || Parameter::normal("offset", &scale.unit, 0.0, 10.0 * scale.range, "added to the simulation");
        let parameters = gain.into_iter().chain(options.offset.then(offset)).collect();
        Self { unit: scale.unit.clone(), reference_c, options, parameters }
    }

    /// Gain and offset of a set of parameter values.
    fn line(&self, values: &[f64]) -> (f64, f64) {
        let mut values = values.iter().copied();
        let gain = self.options.gain_sd.and_then(|_| values.next()).unwrap_or(1.0);
        let offset = if self.options.offset { values.next().unwrap_or(0.0) } else { 0.0 };
        (gain, offset)
    }
}

impl Simulator for External {
    fn name(&self) -> &str {
        "external"
    }

    fn unit(&self) -> &str {
        &self.unit
    }

    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn needs(&self) -> &[Role] {
        &[Role::Simulated]
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        match stage {
            StageName::LoadPath | StageName::Beads => {
                Some("the simulation is given as a column; what loads its dielectric is not known")
            }
            StageName::Geometry | StageName::Dielectric | StageName::Field => {
                Some("the simulation is given as a column; its plates are not known")
            }
            StageName::Inputs | StageName::ThermalPath | StageName::Readout => None,
        }
    }

    fn full_load(&self) -> Option<f64> {
        None
    }

    fn reference_c(&self) -> f64 {
        self.reference_c
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let (gain, offset) = self.line(values);
        walk_without_plates(self, values, inputs, stages, |drive| {
            let simulated = self.column(drive.inputs, Role::Simulated)?;
            let value: Vec<f64> = simulated.iter().map(|value| offset + gain * value).collect();
            let low = value.iter().copied().fold(f64::INFINITY, f64::min);
            let high = value.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            Ok((value, Readout { zero: low, span: high - low }))
        })
    }
}
