//! The field at the rims of disc and tail, as finite elements have computed it for this sensor.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        foreseen::{share, stage},
    },
    text::with_sd,
};
use std::sync::Arc;
use truegap_core::{Corrections, Drive, EffectId, FieldView, Parameter, Stage, simulator::StageName};

/// The field at the rims of shielded electrodes.
pub struct RimField;

struct Rims {
    share: f64,
    computed: Arc<Corrections>,
}

impl Rims {
    fn add(&self, view: &FieldView<'_>, extra: &mut [f64], fringing: impl Fn(f64) -> f64) {
        for ((extra, &aspect), &plates) in extra.iter_mut().zip(view.aspect).zip(view.plates) {
            *extra += self.share * (plates * fringing(aspect) + self.computed.tail_edge_pf);
        }
    }
}

impl Stage for Rims {
    fn field(&self, _: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        let fringing = self.computed.fringing.smooth();
        self.add(view, extra, |aspect| fringing.at(aspect));
    }
}

/// Sibling: a rim whose share of the field does not change as the gap closes.
struct Constant(Rims);

impl Stage for Constant {
    fn field(&self, _: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        let open = view.aspect.iter().copied().fold(0.0, f64::max);
        let fringing = self.0.computed.fringing(open);
        self.0.add(view, extra, |_| fringing);
    }
}

impl RimField {
    fn computed(values: &[f64], context: &Context<'_>) -> Option<Rims> {
        Some(Rims { share: values[0], computed: context.foreseen().ok()?.clone() })
    }
}

impl Effect for RimField {
    fn id(&self) -> EffectId {
        EffectId("rim_field")
    }
    fn stage(&self) -> StageName {
        StageName::Field
    }
    fn family(&self) -> Family {
        Family::Field
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Geometry, driver: Driver::Load, kinetics: Kinetics::Static })
    }
    fn foreseen(&self) -> bool {
        true
    }
    fn about(&self) -> About {
        About {
            physics: "the field of the shielded electrode goes on beyond its rim, and that of the trace beyond its edges",
            equation: "C + r (C_plates f(gap / radius) + C_tail edges), f and the edges by finite elements for this sensor, r near 1",
            excitation: "a well known capacitance without load, or load",
            impostors: &["parasitic_capacitance", "fringing_field", "dead_gap"],
            separates: "no free number but a share near 1; nearly a constant, so a stray capacitance of the same size takes it up",
            source: "finite elements of open field and tail, truegap_audit::corrections (docs/audit.md)",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![share("share of the field at the rims that finite elements compute")]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.foreseen()?;
        context.has(StageName::Field)?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        stage(Self::computed(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Self::computed(values, context).map(|rims| Box::new(Constant(rims)) as Box<dyn Stage>)
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!(
            "the field at the rims of disc and tail is missing: {} of what finite elements compute for this sensor",
            with_sd(fitted[0].value, fitted[0].sd, "1")
        )
    }
}
