//! The modulus drifts over hours and days.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::elapsed_s,
    },
    text::percent_with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Stage, simulator::StageName};

/// Modulus that changes with the clock: straight at first, logarithmic later.
pub struct Ageing;

/// Seconds in an hour.
const HOUR: f64 = 3600.0;

struct Clock {
    per_hour: f64,
    knee_s: f64,
}

impl Clock {
    /// Multiplies the modulus by `1 + per_hour course(seconds) / course(one hour)`.
    fn apply(&self, drive: &Drive<'_>, factor: &mut [f64], course: impl Fn(f64) -> f64) {
        let scale = self.per_hour / course(HOUR);
        for (row, factor) in factor.iter_mut().enumerate() {
            *factor *= 1.0 + scale * course(elapsed_s(drive.inputs, row));
        }
    }
}

impl Stage for Clock {
    fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
        self.apply(drive, factor, |t| (t / self.knee_s).ln_1p());
    }
}

/// Sibling: the square root of the clock, as diffusion has it.
struct Diffusion(Clock);

impl Stage for Diffusion {
    fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
        self.0.apply(drive, factor, |t| (1.0 + t / self.0.knee_s).sqrt() - 1.0);
    }
}

fn clock(values: &[f64]) -> Clock {
    Clock { per_hour: values[0], knee_s: values[1] }
}

impl Effect for Ageing {
    fn id(&self) -> EffectId {
        EffectId("ageing")
    }
    fn stage(&self) -> StageName {
        StageName::Beads
    }
    fn family(&self) -> Family {
        Family::MechanicalMemory
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Mechanics, driver: Driver::Time, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the dielectric goes on curing, drying out or losing plasticiser, so its modulus drifts with the clock, loaded or not",
            equation: "E = E0 [1 + a ln(1 + t / k) / ln(1 + 1 h / k)], t from the first row through all runs",
            excitation: "the same loads early and late, with a clock",
            impostors: &["offset_drift", "mullins_softening", "viscoelastic_creep", "gain_drift"],
            separates: "no change without load, in proportion to the strain with it; goes on while the sensor rests",
            source: "Struik, Physical Aging in Amorphous Polymers and Other Materials, ch. 4 (logarithm of the time)",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let hours = context.length_s() / HOUR;
        let knee = 0.5 * context.length_s();
        let course = |t: f64| (t / knee).ln_1p();
        let sd = 0.03 * course(HOUR) / course(hours * HOUR);
        vec![
            Parameter::normal("per_hour", "1", 0.0, sd, "relative change of the modulus in the first hour"),
            Parameter::log_normal("knee", "s", knee, 1.5, "time after which the course turns from straight to logarithmic")
                .within(1e-3 * knee, 1e3 * knee),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let duration = context.duration_s.max(2.0);
        vec![vec![0.03 * duration], vec![3.0 * duration]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Beads)?;
        context.needs_duration()?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(clock(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Diffusion(clock(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("the modulus drifts with the clock, by {} in the first hour", percent_with_sd(fitted[0].value, fitted[0].sd))
    }
}
