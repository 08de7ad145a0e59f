//! An effect that no library holds: an amplifier whose gain ripples with the clock. One file, as an effect from outside of the crate is written.
#![allow(dead_code)]

use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};
use truegap_diagnose::{About, Context, Effect, Family, FittedParameter};

/// Period of the ripple, s: whoever built the amplifier knows it.
const PERIOD_S: f64 = 173.0;

/// Gain that swings by a share of the reading's way from zero.
pub struct GainRipple;

struct Ripple(f64);

impl Stage for Ripple {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        let time = drive.inputs.time_s.as_deref().unwrap_or_default();
        for (value, t) in value.iter_mut().zip(time) {
            *value += self.0 * (std::f64::consts::TAU * t / PERIOD_S).sin() * (*value - readout.zero);
        }
    }
}

impl Effect for GainRipple {
    fn id(&self) -> EffectId {
        EffectId("gain_ripple")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn about(&self) -> About {
        About {
            physics: "the gain of the amplifier ripples with its own clock",
            equation: "value = zero + (true - zero) [1 + g sin(2 pi t / 173 s)]",
            excitation: "a load, and a clock",
            impostors: &["gain_drift"],
            separates: "one frequency, the same on every day",
            source: "invented for a test",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![Parameter::normal("gain_ripple", "1", 0.0, 0.05, "swing of the gain")]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.needs_clock()?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Ripple(values[0]))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("the gain ripples by {:.2} % (sd {:.2})", 100.0 * fitted[0].value, 100.0 * fitted[0].sd)
    }
}
