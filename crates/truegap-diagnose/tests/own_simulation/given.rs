//! A simulation of the user's own, and what is asked of it.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use truegap_core::{
    Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, simulator::StageName, walk_without_plates,
};
use truegap_diagnose::{Diagnosis, Options, Problem, RecordingFacts, diagnose};

/// A reading that is given row by row, or 3 where none is, with a level to calibrate or without.
///
/// One that follows its first driver counts how often it is asked without any.
pub struct Given {
    pub parameters: Vec<Parameter>,
    pub unit: &'static str,
    pub follows_driver: bool,
    pub follows_clock: bool,
    pub asked_without: AtomicUsize,
    /// reading where nothing acts
    pub zero: f64,
}

impl Given {
    pub fn fixed() -> Self {
        Self {
            parameters: Vec::new(),
            unit: "V",
            follows_driver: false,
            follows_clock: false,
            asked_without: AtomicUsize::new(0),
            zero: 3.0,
        }
    }

    pub fn with_level() -> Self {
        Self { parameters: vec![Parameter::normal("level", "V", 3.0, 5.0, "level")], ..Self::fixed() }
    }
}

impl Simulator for Given {
    fn name(&self) -> &str {
        "given"
    }
    fn unit(&self) -> &str {
        self.unit
    }
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }
    fn needs(&self) -> &[Role] {
        &[]
    }
    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        let has = matches!(stage, StageName::ThermalPath | StageName::Readout);
        (!(has || self.follows_driver && stage == StageName::Inputs)).then_some("nothing is known of it")
    }
    fn full_load(&self) -> Option<f64> {
        None
    }
    fn load(&self, _: &Inputs) -> Option<Vec<f64>> {
        None
    }
    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        walk_without_plates(self, values, inputs, stages, |drive| {
            let level = values.first().copied().unwrap_or(3.0);
            let mut value = drive.inputs.simulated.clone().unwrap_or_else(|| vec![level; inputs.len()]);
            if let Some(time) = inputs.time_s.as_ref().filter(|_| self.follows_clock) {
                value.iter_mut().zip(time).for_each(|(value, t)| *value -= 0.001 / 60.0 * (t - time[0]));
            }
            if self.follows_driver {
                match drive.inputs.drivers.first() {
                    Some(driver) => value.iter_mut().zip(&driver.values).for_each(|(value, x)| *value += x),
                    None => _ = self.asked_without.fetch_add(1, Ordering::Relaxed),
                }
            }
            Ok((value, Readout { zero: self.zero, span: 1.0 }))
        })
    }
}

pub fn noisy(seed: u64, truth: impl Fn(usize) -> f64, rows: usize) -> Vec<f64> {
    let random = &mut ChaCha8Rng::seed_from_u64(seed);
    (0..rows).map(|row| truth(row) + 0.01 * Distribution::<f64>::sample(&StandardNormal, random)).collect()
}

pub fn said(model: &Given, inputs: &Inputs, response: &[f64]) -> Diagnosis {
    said_with(&Options::default(), model, inputs, response)
}

/// What is said where these effects alone may be named.
pub fn said_by(effects: &[&str], model: &Given, inputs: &Inputs, response: &[f64]) -> Diagnosis {
    let effects = effects.iter().map(|effect| (*effect).to_owned()).collect();
    let options = Options { effects, compose: false, ..Options::default() };
    said_with(&options, model, inputs, response)
}

fn said_with(options: &Options, model: &Given, inputs: &Inputs, response: &[f64]) -> Diagnosis {
    let problem = Problem { inputs, response, simulator: model };
    let facts = RecordingFacts { rows: response.len(), runs: inputs.runs().len(), ..RecordingFacts::default() };
    diagnose(&problem, facts, options, &|_| (), &AtomicBool::new(false)).unwrap().diagnosis
}

/// Half an hour at 1 s of a simulation that goes up and down.
pub fn simulated() -> Inputs {
    let rows = 1800;
    Inputs {
        time_s: Some((0..rows).map(f64::from).collect()),
        run: vec![1; rows as usize],
        simulated: Some((0..rows).map(|row| 3.0 + (f64::from(row) / 90.0).sin()).collect()),
        ..Inputs::default()
    }
}
