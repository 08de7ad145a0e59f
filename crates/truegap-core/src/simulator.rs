//! What a diagnosis needs of a model: parameters with priors, and a response that omitted physics can be plugged into.
//!
//! Limits: one scalar response a row.

use crate::{chain::Stage, corrections::Corrections, inputs::Inputs, joined::Joined, parameter::Parameter};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// What a column of a recording is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, PartialOrd, Ord)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// clock, s
    Time,
    /// applied force, N
    Force,
    /// applied pressure, Pa
    Pressure,
    /// plate separation, m
    Gap,
    /// thermometer, degrees Celsius
    Temperature,
    /// relative humidity, per cent
    Humidity,
    /// recorded value
    Response,
    /// somebody else's simulation
    Simulated,
    /// run number
    Run,
    /// sensor name
    Sensor,
}

/// A model of the response, in SI or in the recording's own unit ([`Simulator::unit`]).
pub trait Simulator: Send + Sync {
    /// Name of the base model as in files: `stack`, `parallel-plate`, ...
    fn name(&self) -> &str;
    /// Unit of the response.
    fn unit(&self) -> &str;
    /// Numbers that calibration may adjust, with what is known of them.
    fn parameters(&self) -> &[Parameter];
    /// The centre of what is known of them, in their units.
    fn centre(&self) -> Vec<f64> {
        self.parameters().iter().map(Parameter::centre).collect()
    }
    /// Columns without which there is no response.
    fn needs(&self) -> &[Role];
    /// Stages that mean something in this model; others are skipped with the reason given.
    fn lacks(&self, stage: StageName) -> Option<&'static str>;
    /// Full load in SI, to which [`crate::Drive::load`] is relative; `None` where load plays no part.
    fn full_load(&self) -> Option<f64>;
    /// Whether the electrode of the base model warps with temperature; `None` where it has no electrode to warp.
    fn warps(&self) -> Option<bool> {
        None
    }
    /// Temperature at which the model is described, degrees Celsius.
    fn reference_c(&self) -> f64 {
        20.0
    }
    /// What finite elements say of this sensor, without a free number; `None` where nobody has asked them, or they have no answer.
    fn corrections(&self) -> Option<&Arc<Corrections>> {
        None
    }
    /// The recordings that the model joins; `None` where it is of one.
    fn joined(&self) -> Option<&dyn Joined> {
        None
    }
    /// Recorded load over [`Simulator::full_load`], before any stage; `None` where load plays no part.
    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>>;
    /// Response of each row, one pass down the chain with `stages` plugged in.
    ///
    /// # Errors
    /// [`SimulationError`] where a row has no physical answer (closed gap) or a column is missing.
    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError>;
}

/// Places of the chain, in its order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StageName {
    /// clocks and references of the inputs
    Inputs,
    /// load path
    LoadPath,
    /// thermal path
    ThermalPath,
    /// compressible dielectric
    Beads,
    /// gap and electrode shape
    Geometry,
    /// permittivities
    Dielectric,
    /// field outside the plates
    Field,
    /// electronics
    Readout,
}

/// Why a model has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SimulationError {
    /// The plates touch.
    #[error(
        "row {row}: a load of {load_si} closes the gap (strain {strain}); leave out loads beyond the sensor's range, or give a thicker or stiffer dielectric"
    )]
    GapCloses {
        /// row of the inputs
        row: usize,
        /// load, SI
        load_si: f64,
        /// compressive strain reached
        strain: f64,
    },
    /// A column that the model needs.
    #[error("the base model `{model}` needs a column `{role:?}`; name it under [columns] or choose another [base] model")]
    MissingColumn {
        /// model
        model: String,
        /// the column's role
        role: Role,
    },
    /// A number that is not finite came out.
    #[error("row {row}: the response is {value}; the parameters {parameters:?} lie outside what the model can describe")]
    NotFinite {
        /// row of the inputs
        row: usize,
        /// response
        value: f64,
        /// parameter values
        parameters: Vec<f64>,
    },
}
