//! The reading clips.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    stats::spread,
    text::{percent_of, percent_with_sd, with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Slope that is lost above a knee.
pub struct Saturation;

/// Where a knee may lie, spans above the zero.
pub(crate) const KNEES: [f64; 2] = [0.1, 2.0];

/// Rounding of the knee, as a share of the span; a converter that loses all of the slope ends in a corner.
const ROUNDING: f64 = 0.01;

struct Clip {
    lost: f64,
    knee: f64,
}

impl Clip {
    /// Takes `lost excess(reading in spans above zero)` off each value.
    fn apply(&self, readout: &Readout, value: &mut [f64], excess: impl Fn(f64) -> f64) {
        if readout.span == 0.0 {
            return;
        }
        for value in value {
            let share = (*value - readout.zero) / readout.span;
            *value -= self.lost * readout.span * excess(share);
        }
    }
}

/// Smooth part of `x` above 0, rounded over `width`.
fn above(x: f64, width: f64) -> f64 {
    0.5 * (x + x.hypot(2.0 * width))
}

impl Stage for Clip {
    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        let width = if self.lost < 1.0 { ROUNDING } else { 0.0 };
        self.apply(readout, value, |share| above(share - self.knee, width));
    }
}

/// Share of the slope that is lost from which on it is a ceiling.
const HARD: f64 = 0.8;

/// Sibling: slope that is lost little by little above the knee.
struct Gradual(Clip);

impl Stage for Gradual {
    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.0.apply(readout, value, |share| {
            let over = (share - self.0.knee).max(0.0);
            over * over / (over + 0.05)
        });
    }
}

fn clip(values: &[f64]) -> Clip {
    Clip { lost: values[0], knee: values[1] }
}

fn numbers() -> [Parameter; 2] {
    [
        Parameter::normal("lost", "1", 0.0, 0.3, "share of the slope that is lost above the knee").within(0.0, 1.0),
        Parameter::normal("knee", "spans", 0.85, 0.3, "reading above which it is lost; a warm sensor reads beyond its span")
            .within(0.1, 2.0),
    ]
}

impl Saturation {
    /// A hard clip that was seen and not fitted: its knee, in spans, and the standard deviations of that and of the share that is lost.
    pub(crate) fn hard([knee, knee_sd]: [f64; 2], lost_sd: f64) -> [FittedParameter; 2] {
        let seen =
            |parameter: Parameter, value: f64, sd: f64| FittedParameter { parameter, value, sd, sd_of_fit: sd, at_limit: false };
        let [lost, at] = numbers();
        [seen(lost, 1.0, lost_sd), seen(at, knee, knee_sd)]
    }

    /// The effect in words.
    pub(crate) fn words() -> InWords {
        InWords { place: Place::Readout, driver: Driver::Reading, kinetics: Kinetics::Static }
    }
}

impl Effect for Saturation {
    fn id(&self) -> EffectId {
        EffectId("saturation")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(Self::words())
    }
    fn about(&self) -> About {
        About {
            physics: "amplifier or converter runs out of range: above a certain reading the slope falls, at the worst to nothing",
            equation: "value = true - s [x + sqrt(x^2 + 4 w^2)] / 2, x the reading above the knee; w = 1 % of the span; s = 1 is a hard clip, with w = 0",
            excitation: "readings at the upper end of the range",
            impostors: &["strain_stiffening", "load_cell_error", "dead_gap"],
            separates: "depends on the reading alone, with a corner in it, whatever load or temperature brought it there",
            source: "Horowitz & Hill, The Art of Electronics, sec. 4.4 (limits of amplifiers)",
        }
    }
    fn clips(&self) -> bool {
        true
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        numbers().to_vec()
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        [0.5, 0.7, 0.85, 0.95, 1.15, 1.35].map(|knee| vec![knee]).to_vec()
    }
    fn comes_down_to(&self) -> Option<EffectId> {
        Some(EffectId("gain_error"))
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if !context.simulator.moves() {
            return Err("a value that does not move does not clip".into());
        }
        context.needs_movement()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(clip(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Gradual(clip(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!(
            "the reading saturates: above {} of its span it loses {} of its slope",
            percent_of(fitted[1].value),
            percent_with_sd(fitted[0].value, fitted[0].sd)
        )
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        let Some(simulated) = context.inputs.simulated.as_deref().filter(|_| fitted[0].value > HARD) else {
            return self.says(fitted);
        };
        // the readout of a simulation that is given counts from its least value, over its range
        let low = simulated.iter().copied().fold(f64::INFINITY, f64::min);
        let ceiling = low + fitted[1].value * spread(simulated);
        let unit = context.simulator.unit();
        format!("the reading has a ceiling: it stops at {}", with_sd(ceiling, fitted[1].sd * spread(simulated), unit))
    }
}
