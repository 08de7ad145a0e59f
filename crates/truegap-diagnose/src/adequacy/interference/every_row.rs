//! Interference on every row of a recording, where means of rows would take it out: bursts, and a tone.
//!
//! Neither is anything that a model lacks, so they take no part in naming; where nothing else is found, they are what there is to say.
//!
//! Limits: judged on what one model leaves.

use crate::{
    adequacy::{
        interference::{burst::Burst, tone::Tone},
        lack_of_fit::Adequacy,
    },
    fit::model::Model,
    stats::excess_of,
    whitening::noise_model::NoiseModel,
};
use truegap_core::SimulationError;

/// The loudest of each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interference {
    /// rows that are louder than the noise
    pub burst: Burst,
    /// interference of a constant frequency
    pub tone: Tone,
}

impl Interference {
    /// In what a model leaves of a recording at `z`; `slack` is the factor by which the noise may be larger than taken.
    ///
    /// # Errors
    /// Those of the simulator.
    pub fn in_what_is_left(model: &Model<'_>, z: &[f64], noise: &NoiseModel, slack: f64) -> Result<Self, SimulationError> {
        let runs = model.problem.runs();
        let residual = model.residual(z, &noise.whitener(&runs, None))?;
        let runs = model.problem.runs_in_order();
        let tone = Tone::strongest(&residual, model.problem.inputs.time_s.as_deref(), &runs);
        Ok(Self { burst: Burst::loudest(&residual, &runs, slack), tone })
    }

    /// How much the stronger of the two holds, in units of the noise variance.
    pub fn excess(&self) -> f64 {
        let burst = if self.burst.is_significant() { self.burst.rows as f64 * (self.burst.loudness.powi(2) - 1.0) } else { 0.0 };
        let tone = if self.tone.is_significant() { excess_of(self.tone.p_value) } else { 0.0 };
        burst.max(tone)
    }

    /// Whether it is what there is to say of a recording in which nothing is named, `before` the adequacy of the base model: a mismatch that other tests see is
    /// louder in some rows, too.
    pub fn is_the_matter(&self, before: &Adequacy) -> bool {
        self.tone.is_significant() || (self.burst.is_significant() && !before.fires())
    }

    /// Whether there is any.
    pub fn is_anything(&self) -> bool {
        self.burst.is_significant() || self.tone.is_significant()
    }
}
