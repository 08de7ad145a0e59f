//! The paper's sensor as a [`Simulator`]: parameters from the sensor's tolerances, response in pF.
//!
//! Limits: what [`Device`] can describe; loads that close the gap are errors.

use super::{
    beside::Near,
    columns::{Filled, plain},
    device::{Described, Device},
    knobs::{self, Knob},
    options::StackOptions,
    plates::Rows,
};
use std::sync::Arc;
use truegap_core::{Beside, Corrections, Inputs, Parameter, Role, Sensor, SimulationError, Simulator, Stage, StageName, walk};

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

impl Described for Stack {
    fn described(&self, values: &[f64]) -> Device {
        self.device(values)
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

    fn has_insulator(&self) -> bool {
        true
    }

    fn knows_its_level(&self) -> bool {
        true
    }

    fn reference_c(&self) -> f64 {
        self.sensor.reference_c
    }

    fn corrections(&self) -> Option<&Arc<Corrections>> {
        self.corrections.as_ref()
    }

    fn row_by_row(&self) -> bool {
        true
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        self.check(values, inputs)?;
        let device = self.device(values);
        let filled = Filled(Rows { device: &device, values });
        if stages.is_empty() {
            return plain(&filled, inputs, self.column(inputs, Role::Force)?, inputs.temperature_c.as_deref());
        }
        walk(self, &filled, values, inputs, stages)
    }

    fn beside<'s>(
        &'s self,
        values: &[f64],
        inputs: &'s Inputs,
        stages: &[&dyn Stage],
    ) -> Result<Option<Box<dyn Beside + 's>>, SimulationError> {
        Ok(Some(Box::new(Near::at(self, values, inputs, stages)?)))
    }
}
