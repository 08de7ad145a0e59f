//! A capacitance beside the sensor that load does not change.

use crate::{
    data::context::Context,
    effects::effect::{About, Effect, Family, FittedParameter},
    text::with_sd,
};
use truegap_core::{Drive, EffectId, FieldView, Parameter, Stage, simulator::StageName};

/// Constant capacitance in parallel.
pub struct ParasiticCapacitance;

/// Parameters of base models that are this effect already.
const CALIBRATED: [&str; 2] = ["stray_capacitance", "offset"];

/// Share of the reading's range from which on the base model's own constant is as free as this one; a tight one is a maker's tolerance, and more than that
/// is physics that it does not foresee.
const SAME: f64 = 0.2;

/// Share of the whole reading that wiring may usually add: an unshielded lead has 50 to 100 pF a metre, whatever the sensor's own range is.
const USUAL: f64 = 0.2;

fn scale(context: &Context<'_>) -> f64 {
    context.response_span.abs().max(USUAL * context.response_level)
}

struct Stray(f64);

impl Stage for Stray {
    fn field(&self, _: &Drive<'_>, _: &FieldView<'_>, extra: &mut [f64]) {
        extra.iter_mut().for_each(|extra| *extra += self.0);
    }
}

/// Sibling: wiring that sees the moving plate a little, so that it grows as the logarithm of the separation falls.
struct Wiring(f64);

impl Stage for Wiring {
    fn field(&self, _: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        extra.iter_mut().zip(view.aspect).for_each(|(extra, aspect)| *extra += self.0 * (1.0 - 0.03 * (aspect / 0.02).ln()));
    }
}

impl Effect for ParasiticCapacitance {
    fn id(&self) -> EffectId {
        EffectId("parasitic_capacitance")
    }
    fn stage(&self) -> StageName {
        StageName::Field
    }
    fn family(&self) -> Family {
        Family::Field
    }
    fn about(&self) -> About {
        About {
            physics: "cable, connector or guard add a capacitance that does not depend on the gap",
            equation: "C = C_plates + c, c constant",
            excitation: "a gap that changes by a known amount, and a gain that is known",
            impostors: &["dead_gap", "fringing_field", "gain_drift"],
            separates: "the reading does not go to zero as the gap grows; the share of it that moves is too small at every load alike",
            source: "Baxter, Capacitive Sensors, ch. 6 (stray capacitance and guards)",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        vec![Parameter::normal("stray", context.simulator.unit(), 0.0, scale(context), "reading that the gap does not change")]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Field)?;
        let same = |p: &&Parameter| CALIBRATED.contains(&p.name.as_str()) && p.sd() > SAME * context.response_span.abs();
        match context.simulator.parameters().iter().find(same) {
            Some(own) => Err(format!("the base model calibrates `{}`, which is the same thing", own.name)),
            None => Ok(()),
        }
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Stray(values[0]))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Wiring(values[0])))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let unit = &fitted[0].parameter.unit;
        format!(
            "a part of {} of the reading lies beside the sensor and does not change with the gap",
            with_sd(fitted[0].value, fitted[0].sd, unit)
        )
    }
}
