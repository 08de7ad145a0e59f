//! The zero settles as the logarithm of the time since something was begun: what ages, creeps or softens by many small steps, each slower than the one before.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter, ZeroCourse},
        memory::elapsed_s,
    },
    text::{rounded, with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Zero that moves by the same amount with every tenfold of the time.
pub struct Settling;

/// A logarithm of the clock, in the reading.
struct Logarithm {
    per_decade: f64,
    /// time after which it goes on as a logarithm; before, it is straight
    knee_s: f64,
    /// decades that a time, in knees, has gone through
    decades: fn(f64) -> f64,
}

/// Decades since the beginning after a time, in knees.
fn logarithm(knees: f64) -> f64 {
    knees.ln_1p() / std::f64::consts::LN_10
}

/// For the sibling: relaxations spread evenly over six decades of time constants, four a decade, from the knee on, each with the same weight.
fn relaxations(knees: f64) -> f64 {
    let each = |k: i32| -(-knees / 10f64.powf(0.25 * f64::from(k))).exp_m1();
    (0..24).map(each).sum::<f64>() * 0.25
}

impl Stage for Logarithm {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        let add = |row: usize| self.per_decade * (self.decades)(elapsed_s(drive.inputs, row) / self.knee_s);
        value.iter_mut().enumerate().for_each(|(row, value)| *value += add(row));
    }
}

/// Earliest and latest knee, in lengths of the recording: a later one is a straight line, and an earlier one follows the first few rows, as one within the first step of the clock does.
const KNEES: [f64; 2] = [1e-4, 0.3];

fn earliest_s(context: &Context<'_>, duration: f64) -> f64 {
    let step = context.shortest_step_s.filter(|step| step.is_finite()).unwrap_or(0.0);
    (KNEES[0] * duration).max(step).min(0.5 * KNEES[1] * duration)
}

impl Effect for Settling {
    fn id(&self) -> EffectId {
        EffectId("settling")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Time, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the zero settles as the logarithm of the time: ageing of a crystal or a resistor, relaxation of a bolt or a magnet, softening under cycles",
            equation: "value = true + a log10(1 + t / t0), t from the first row",
            excitation: "a clock, and rows over several decades of it",
            impostors: &["offset_drift", "slow_response", "stress_relaxation", "regime_change"],
            separates: "as much from a minute to ten as from one hour to ten; a drift with a time constant comes to rest",
            source: "Primak, Kinetics of processes distributed in activation energy, Phys. Rev. 100 (1955) 1677; Vig & Meeker, Ageing of bulk acoustic wave resonators, Proc. 45th Symp. Freq. Control (1991) 77",
        }
    }
    fn zero_course(&self) -> ZeroCourse {
        ZeroCourse::InsideRuns
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let duration = context.length_s();
        vec![
            Parameter::normal(
                "per_decade",
                context.simulator.unit(),
                0.0,
                // a value that should not move has no span of its own: what moved may all be drift
                context.response_span.abs(),
                "change of the zero with every tenfold of the time",
            ),
            Parameter::log_normal("knee", "s", 3e-3 * duration, 2.5, "time from which on it goes as the logarithm")
                .within(earliest_s(context, duration), KNEES[1] * duration),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let duration = context.length_s();
        [5e-4, 5e-3, 0.05].map(|knee| vec![(knee * duration).max(1.5 * earliest_s(context, duration))]).to_vec()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if context.has_plates() {
            return Err("the base model has ageing and creep of its own, which go as the logarithm of the time".into());
        }
        if context.simulator.moves() {
            return Err(
                "beside a value that moves a logarithm of the time is too like other slow courses; a drift stands for it".into(),
            );
        }
        context.needs_duration()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Logarithm { per_decade: values[0], knee_s: values[1], decades: logarithm })
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Logarithm { per_decade: values[0], knee_s: values[1], decades: relaxations }))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let [size, knee] = [&fitted[0], &fitted[1]];
        format!(
            "the zero settles by {} with every tenfold of the time, from {} after the first row on",
            with_sd(size.value, size.sd, &size.parameter.unit),
            rounded(knee.value, "s")
        )
    }
}
