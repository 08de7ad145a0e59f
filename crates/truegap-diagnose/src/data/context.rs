//! Facts of a recording and its simulator that effects scale their priors by.
//!
//! Limits: only inputs, never the response's course; the response gives nothing but its span and its level.

pub use crate::data::load::load_column;

use crate::data::moved::Moved;
use std::sync::{Arc, OnceLock};
use truegap_core::ends;
use truegap_core::{Corrections, EffectId, Inputs, Joined, Parameter, Prior, Simulator, simulator::StageName};

/// Why nothing that takes time can be looked for.
pub(crate) const NO_CLOCK: &str = "no time column";

/// A number of an effect, by its name.
pub(crate) type Number = (EffectId, &'static str);

/// Facts that priors, starting values and testability rest on.
#[derive(Clone)]
pub struct Context<'a> {
    /// what was done
    pub inputs: &'a Inputs,
    /// the base model
    pub simulator: &'a dyn Simulator,
    /// response of the base model between least and greatest input, in the response's unit
    pub response_span: f64,
    /// mean size of the recorded response, in its unit; 0 where there is no recording
    pub response_level: f64,
    /// white-noise standard deviation of the response
    pub noise_sd: f64,
    /// smallest and greatest load, in units of the full load
    pub load_range: (f64, f64),
    /// smallest and greatest temperature, degrees Celsius; `None` without a thermometer
    pub temperature_range: Option<(f64, f64)>,
    /// smallest and greatest relative humidity, per cent
    pub humidity_range: Option<(f64, f64)>,
    /// shortest time step inside a run, s; `None` without a clock, or where every run is one row
    pub shortest_step_s: Option<f64>,
    /// longest run, s
    pub longest_run_s: f64,
    /// from first to last row, s
    pub duration_s: f64,
    /// number of runs
    pub runs: usize,
    /// temperature at which the sensor is described, degrees Celsius
    pub reference_c: f64,
    /// what moved in the recording to which effects were fitted: these inputs, or those of a model file
    pub moved: Moved,
    /// numbers of effects that are held at nothing, since rows left out do not bear them out
    pub(crate) held: Vec<Number>,
    /// strain of a full load, once an effect has asked for it
    pub(crate) full_strain: OnceLock<f64>,
    /// response where next to no load acts, once an effect has asked for it
    pub(crate) unloaded: OnceLock<f64>,
    /// whether the base model follows each recorded driver by itself, once an effect has asked for it
    pub(crate) followed: Vec<OnceLock<bool>>,
}

fn range(column: &[f64]) -> (f64, f64) {
    ends(column.iter().copied())
}

/// From first to last row on one clock; of the longest recording where there are several.
fn duration(time: &[f64], inputs: &Inputs, simulator: &dyn Simulator) -> f64 {
    let elapsed = |rows: &[f64]| rows.last().copied().unwrap_or(0.0) - rows.first().copied().unwrap_or(0.0);
    let of = |j: &dyn Joined| (0..j.count()).map(|k| elapsed(&time[j.rows(k, inputs)])).fold(0.0, f64::max);
    simulator.joined().map_or_else(|| elapsed(time), of)
}

/// Standard deviation of a number that is held, over that of its prior: no recording moves it.
const HELD: f64 = 1e-6;

/// What a reader is told of it.
const HELD_SAYS: &str = "; held at 0, since rows left out are predicted as well or better so";

/// Change of a temperature that a thermometer sees, K.
const SOME_KELVIN: f64 = 0.2;

impl<'a> Context<'a> {
    /// Facts of `inputs` under `simulator`; `response_span` and `noise_sd` in the response's unit.
    pub fn new(inputs: &'a Inputs, simulator: &'a dyn Simulator, response_span: f64, noise_sd: f64) -> Self {
        let load = load_column(inputs, simulator);
        let steps = inputs.steps_s();
        let clock = inputs.time_s.as_deref();
        let runs = inputs.runs();
        let longest = clock.map_or(0.0, |t| runs.iter().map(|r| t[r.end - 1] - t[r.start]).fold(0.0, f64::max));
        Self {
            inputs,
            simulator,
            response_span,
            response_level: 0.0,
            noise_sd,
            load_range: load.as_deref().map_or((0.0, 0.0), range),
            temperature_range: inputs.temperature_c.as_deref().map(range),
            humidity_range: inputs.humidity_pct.as_deref().map(range),
            shortest_step_s: clock.and_then(|_| steps.iter().copied().filter(|s| *s > 0.0).min_by(f64::total_cmp)),
            longest_run_s: longest,
            duration_s: clock.map_or(0.0, |t| duration(t, inputs, simulator)),
            runs: runs.len(),
            reference_c: simulator.reference_c(),
            moved: Moved::of(inputs, simulator),
            held: Vec::new(),
            full_strain: OnceLock::new(),
            unloaded: OnceLock::new(),
            followed: vec![OnceLock::new(); inputs.drivers.len()],
        }
    }

    /// The same of a recording with so many runs.
    #[must_use]
    pub fn with_runs(self, runs: usize) -> Self {
        Self { runs, ..self }
    }

    /// The same with these numbers of effects held at nothing.
    #[must_use]
    pub(crate) fn holding(&self, held: Vec<Number>) -> Self {
        Self { held, ..self.clone() }
    }

    /// What is known of a number of an effect beforehand: next to nothing but 0 where it is held.
    pub(crate) fn known(&self, effect: EffectId, mut parameter: Parameter) -> Parameter {
        if self.holds(effect, &parameter.name)
            && let Prior::Normal { sd, .. } | Prior::Wide { sd } = parameter.prior
        {
            parameter.prior = Prior::Normal { mean: 0.0, sd: HELD * sd };
            parameter.meaning += HELD_SAYS;
        }
        parameter
    }

    /// Whether this number of an effect is held.
    pub(crate) fn holds(&self, effect: EffectId, number: &str) -> bool {
        self.held.iter().any(|(id, name)| *id == effect && *name == number)
    }

    /// Shortest time step inside a run, s; a row where there is none.
    pub fn step_s(&self) -> f64 {
        self.shortest_step_s.filter(|step| step.is_finite()).unwrap_or(1.0)
    }

    /// Longest run, s; 1 where none lasts. No time that physics takes is compared with a second: an oscilloscope's recording is over in microseconds.
    pub fn run_s(&self) -> f64 {
        if self.longest_run_s > 0.0 { self.longest_run_s } else { 1.0 }
    }

    /// From first to last row, s; 1 where no time passes.
    pub fn length_s(&self) -> f64 {
        if self.duration_s > 0.0 { self.duration_s } else { 1.0 }
    }

    /// The usual size of a time that belongs to a device, s: as long as such `devices` usually take, a step where that is longer, and never more than a tenth of a run.
    pub fn of_device_s(&self, devices: f64) -> f64 {
        self.step_s().max(devices.min(0.1 * self.run_s()))
    }

    /// Range of the load over the full load; 0 where load plays no part.
    pub fn load_span(&self) -> f64 {
        self.load_range.1 - self.load_range.0
    }

    /// Range of the temperature, K; 0 without a thermometer.
    pub fn temperature_span(&self) -> f64 {
        self.temperature_range.map_or(0.0, |(low, high)| high - low)
    }

    /// `Ok` where the base model has this stage.
    ///
    /// # Errors
    /// The model's own reason.
    pub fn has(&self, stage: StageName) -> Result<(), String> {
        self.simulator.lacks(stage).map_or(Ok(()), |why| Err(why.to_owned()))
    }

    /// Whether the base model has plates: then the equations of its effects are derived from sizes, and elsewhere they describe.
    pub(crate) fn has_plates(&self) -> bool {
        self.has(StageName::Dielectric).is_ok()
    }

    /// What finite elements say of the sensor.
    ///
    /// # Errors
    /// Why they say nothing.
    pub fn foreseen(&self) -> Result<&Arc<Corrections>, String> {
        self.simulator.corrections().ok_or_else(|| "finite elements have said nothing of this base model or sensor".into())
    }

    /// `Ok` where the load moves.
    ///
    /// # Errors
    /// What is missing.
    pub fn needs_load(&self) -> Result<(), String> {
        if self.load_span() > 0.05 { Ok(()) } else { Err("the load does not change".into()) }
    }

    /// `Ok` where something is given whose course the response follows: a load that moves, a gap, or somebody's own simulation.
    ///
    /// # Errors
    /// What is missing.
    fn needs_course(&self) -> Result<(), String> {
        if self.inputs.gap_m.is_some() || self.inputs.simulated.is_some() { Ok(()) } else { self.needs_load() }
    }

    /// `Ok` where the value of the base model moves: with a load, a gap, a simulation, or with whatever input it follows where it knows no load.
    ///
    /// # Errors
    /// What is missing.
    pub fn needs_movement(&self) -> Result<(), String> {
        let course = self.needs_course();
        if course.is_ok() || self.simulator.full_load().is_some() {
            return course;
        }
        // off the centre of the priors, where a slope may be 0
        let values: Vec<f64> = self.simulator.parameters().iter().map(|p| p.prior.at(1.0)).collect();
        match self.simulator.respond(&values, self.inputs, &[]) {
            Ok(value) if range(&value).0 < range(&value).1 => Ok(()),
            _ => Err("nothing moves that the base model follows".into()),
        }
    }

    /// `Ok` where the temperature moves at all, beside a base model of which no usual size of a temperature effect is known.
    ///
    /// # Errors
    /// What is missing.
    pub fn needs_some_temperature(&self) -> Result<(), String> {
        self.needs_temperature(SOME_KELVIN)
    }

    /// `Ok` where the temperature moves by more than `kelvin`.
    ///
    /// # Errors
    /// What is missing.
    pub fn needs_temperature(&self, kelvin: f64) -> Result<(), String> {
        match self.temperature_range {
            None => Err("no temperature column".into()),
            Some((low, high)) if high - low < kelvin => Err(format!("the temperature changes by {:.2} K only", high - low)),
            Some(_) => Ok(()),
        }
    }

    /// `Ok` where a clock runs inside the runs.
    ///
    /// # Errors
    /// What is missing.
    pub fn needs_clock(&self) -> Result<(), String> {
        match (self.shortest_step_s, &self.inputs.time_s) {
            (Some(_), _) => Ok(()),
            (None, Some(_)) => Err("every run is one row, so no time passes inside of any".into()),
            (None, None) => Err(NO_CLOCK.into()),
        }
    }

    /// `Ok` where time passes from the first row to the last, within runs or between them.
    ///
    /// # Errors
    /// What is missing.
    pub fn needs_duration(&self) -> Result<(), String> {
        match &self.inputs.time_s {
            None => Err(NO_CLOCK.into()),
            Some(_) if self.duration_s > 0.0 => Ok(()),
            Some(_) => Err("the time column stands still".into()),
        }
    }
}
