//! The paper's sensor as a [`Simulator`]: parameters from the sensor's tolerances, response in pF.
//!
//! Limits: what [`device`] can describe; loads that close the gap are errors.

mod chain;
mod coefficients;
mod device;
mod knobs;
mod states;
mod wedge;

pub use coefficients::{CoefficientOptions, Coefficients, coefficients};
pub use device::{Capacitances, Device, Refusal, Squeeze, Warm};
pub use states::{Point, State, states};
pub(crate) use wedge::shape_factor;

use knobs::Knob;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use truegap_core::{Corrections, Inputs, Parameter, Role, Sensor, SimulationError, Simulator, Stage, simulator::StageName};

/// In which order the layers of the main gap are added up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SeriesOrder {
    /// each layer over the plate, then in series: (21) as printed
    #[default]
    IntegrateThenSeries,
    /// in series at each point, then over the plate: exact for a bent gap
    SeriesThenIntegrate,
}

/// What the base model takes to be true.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct StackOptions {
    /// whether a two-metal electrode warps with temperature
    pub warp: bool,
    /// order of (19) and (21)
    pub series: SeriesOrder,
}

impl Default for StackOptions {
    fn default() -> Self {
        Self { warp: true, series: SeriesOrder::default() }
    }
}

/// The paper's sensor.
#[derive(Clone, Debug)]
pub struct Stack {
    sensor: Sensor,
    options: StackOptions,
    knobs: Vec<Knob>,
    parameters: Vec<Parameter>,
    corrections: Option<Arc<Corrections>>,
}

impl Stack {
    /// The model of a sensor; every toleranced quantity that matters becomes a parameter.
    pub fn new(sensor: &Sensor, options: StackOptions) -> Self {
        let (knobs, parameters) = knobs::of(sensor, options);
        Self { sensor: sensor.clone(), options, knobs, parameters, corrections: None }
    }

    /// The same model, with what finite elements say of the sensor handed on to whoever looks for physics that the model leaves out; it computes nothing
    /// with it.
    #[must_use]
    pub fn informed(self, corrections: Option<Corrections>) -> Self {
        Self { corrections: corrections.map(Arc::new), ..self }
    }

    /// The sensor as its file describes it.
    pub fn sensor(&self) -> &Sensor {
        &self.sensor
    }

    /// What the model takes to be true.
    pub fn options(&self) -> StackOptions {
        self.options
    }

    /// The sensor with parameter values put in, in the order of [`Simulator::parameters`].
    pub fn calibrated(&self, values: &[f64]) -> Sensor {
        let mut sensor = self.sensor.clone();
        self.knobs.iter().zip(values).for_each(|(knob, &value)| knob.set(&mut sensor, value));
        sensor
    }

    /// The numbers of one set of parameter values, ready for any row.
    pub fn device(&self, values: &[f64]) -> Device {
        Device::new(&self.calibrated(values), self.options)
    }
}

impl Simulator for Stack {
    fn name(&self) -> &str {
        "stack"
    }

    fn unit(&self) -> &str {
        "pF"
    }

    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn needs(&self) -> &[Role] {
        &[Role::Force]
    }

    fn lacks(&self, _stage: StageName) -> Option<&'static str> {
        None
    }

    fn full_load(&self) -> Option<f64> {
        Some(self.sensor.full_scale)
    }

    fn warps(&self) -> Option<bool> {
        self.sensor.plating.as_ref().map(|_| self.options.warp)
    }

    fn reference_c(&self) -> f64 {
        self.sensor.reference_c
    }

    fn corrections(&self) -> Option<&Arc<Corrections>> {
        self.corrections.as_ref()
    }

    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        let full_load = self.sensor.full_scale;
        inputs.force_n.as_ref().map(|column| column.iter().map(|force| force / full_load).collect())
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let missing = || SimulationError::MissingColumn { model: self.name().to_owned(), role: Role::Force };
        let device = self.device(values);
        if stages.is_empty() {
            let force = inputs.force_n.as_ref().ok_or_else(missing)?;
            return chain::plain(&device, force, inputs.temperature_c.as_deref(), values);
        }
        let load = |inputs: &Inputs| self.load(inputs).ok_or_else(missing);
        let start = crate::base::Start::new(inputs, stages, self.sensor.reference_c, self.sensor.full_scale, load)?;
        chain::staged(&device, &start.drive(), stages, values)
    }
}

/// The error of a row that has no answer.
fn refused(refusal: Refusal, row: usize, load_si: f64, values: &[f64]) -> SimulationError {
    match refusal {
        Refusal::Touches { strain } => SimulationError::GapCloses { row, load_si, strain },
        Refusal::NoAnswer => SimulationError::NotFinite { row, value: f64::NAN, parameters: values.to_vec() },
    }
}
