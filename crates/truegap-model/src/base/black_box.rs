//! Somebody else's simulator that can be asked again: a function or a program that answers inputs and parameters with a response.
//!
//! Limits: omitted physics acts on what goes in (clock, load, temperature), on what comes out (readout), and on the load by what comes out ([`super::fed_back`]); what is
//! inside cannot be changed otherwise. Deformation is taken in proportion to the load, as in a table.

use super::driver::{Driver, deformation};
use super::fed_back::fed_back;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use truegap_core::{Drive, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, StageName, walk_without_plates};

/// Who answers: one value a row.
pub trait Responder: Send + Sync {
    /// Response of each row of `inputs` at parameter `values`. A number that is not finite says that the simulator has no answer at these values.
    ///
    /// # Errors
    /// [`SimulationError::Program`] where it failed, so that asking again would be of no use.
    fn respond(&self, values: &[f64], inputs: &Inputs) -> Result<Vec<f64>, SimulationError>;
}

/// What is known of the simulator beside its answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BlackBoxFacts {
    /// unit of the response
    pub unit: String,
    /// temperature at which it is described, degrees Celsius
    pub reference_c: f64,
    /// the load that drives it, where one was recorded and moves
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<Driver>,
    /// numbers that calibration may adjust
    pub parameters: Vec<Parameter>,
    /// whether it may be asked so often that physics inside of it is looked for
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inside: bool,
}

/// Response of a [`Responder`].
pub struct BlackBox {
    name: &'static str,
    facts: BlackBoxFacts,
    needs: Vec<Role>,
    responder: Arc<dyn Responder>,
}

impl BlackBox {
    /// A simulator that is asked through `responder`; `name` is the base model's, as in files.
    pub fn new(name: &'static str, facts: BlackBoxFacts, responder: Arc<dyn Responder>) -> Self {
        let needs = facts.load.iter().map(|load| load.role).collect();
        Self { name, facts, needs, responder }
    }

    /// The inputs as they arrive: load and temperature with what is plugged in, the other columns as recorded.
    fn arrived(&self, drive: &Drive<'_>, stages: &[&dyn Stage]) -> Result<Inputs, SimulationError> {
        let mut inputs = drive.inputs.clone();
        if stages.is_empty() {
            return Ok(inputs);
        }
        if let Some(load) = self.facts.load {
            let recorded = self.load(drive.inputs).unwrap_or_default();
            let deformed = deformation(drive.load, drive, stages)?;
            let column = inputs.column_mut(load.role).into_iter().flatten();
            // a row that nothing acts on keeps its last bit
            let rows = column.flatten().zip(recorded.iter().zip(&deformed));
            rows.filter(|(_, (before, after))| before != after).for_each(|(value, (_, after))| *value = after * load.width);
        }
        inputs.temperature_c.iter_mut().for_each(|column| column.copy_from_slice(drive.temperature_c));
        Ok(inputs)
    }
}

impl Simulator for BlackBox {
    fn name(&self) -> &str {
        self.name
    }

    fn unit(&self) -> &str {
        &self.facts.unit
    }

    fn parameters(&self) -> &[Parameter] {
        &self.facts.parameters
    }

    fn needs(&self) -> &[Role] {
        &self.needs
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        match stage {
            StageName::LoadPath | StageName::Beads if self.facts.load.is_none() => Some("the simulator is not driven by a load"),
            StageName::Geometry | StageName::Dielectric | StageName::Field => Some("the plates of the simulator are not known"),
            _ => None,
        }
    }

    fn full_load(&self) -> Option<f64> {
        self.facts.load.map(|load| load.width)
    }

    fn feeds_back(&self) -> bool {
        self.facts.inside && self.facts.load.is_some()
    }

    fn reference_c(&self) -> f64 {
        self.facts.reference_c
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        walk_without_plates(self, values, inputs, stages, |drive| {
            let asked = |load: &[f64]| self.responder.respond(values, &self.arrived(&Drive { load, ..*drive }, stages)?);
            let value = if self.facts.load.is_some() && stages.iter().any(|stage| stage.feeds_back()) {
                let feedback =
                    |response: &[f64], load: &mut [f64]| stages.iter().for_each(|stage| stage.feedback(drive, response, load));
                fed_back(drive.load, feedback, asked)?
            } else {
                asked(drive.load)?
            };
            let low = value.iter().copied().fold(f64::INFINITY, f64::min);
            let high = value.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            Ok((value, Readout { zero: low, span: high - low }))
        })
    }
}
