//! A series gap that never closes.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter, Separation},
    text::percent_with_sd,
};
use truegap_core::{Drive, EffectId, Geometry, Parameter, Stage, simulator::StageName};

/// Constant extra separation.
pub struct DeadGap;

struct Extra(f64);

impl Stage for Extra {
    fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
        geometry.gap.iter_mut().for_each(|gap| *gap += self.0);
    }
}

/// Sibling: a film of the same height that gives way a little with the dielectric.
struct Film(f64);

impl Stage for Film {
    fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
        geometry.gap.iter_mut().zip(geometry.strain).for_each(|(gap, strain)| *gap += self.0 * (1.0 - 0.3 * strain));
    }
}

impl Effect for DeadGap {
    fn id(&self) -> EffectId {
        EffectId("dead_gap")
    }
    fn stage(&self) -> StageName {
        StageName::Geometry
    }
    fn family(&self) -> Family {
        Family::Field
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Geometry, driver: Driver::Load, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "a layer of air or film in series with the dielectric, which the load does not close",
            equation: "gap = h(T) (1 - e) + g h(T_ref), g constant: it neither closes nor grows with the silicone",
            excitation: "strain large enough to bend the curve of capacitance over gap (10 % and more)",
            impostors: &["strain_stiffening", "parasitic_capacitance", "plate_bending", "fringing_field"],
            separates: "less curvature of the reading over load, the same at every temperature, rate and direction",
            source: "capacitors in series, Baxter, Capacitive Sensors, ch. 2",
        }
    }
    fn separations(&self) -> &'static [Separation] {
        &[Separation { rival: "contact_toe_in", says: "measure the thickness of the stack independently under load" }]
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![Parameter::normal("share", "unloaded gaps", 0.0, 0.1, "extra separation that never closes").within(0.0, 2.0)]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Geometry)?;
        if context.simulator.full_load().is_some() { context.needs_load() } else { Ok(()) }
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Extra(values[0]))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Film(values[0])))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("a gap of {} of the unloaded one lies in series and never closes", percent_with_sd(fitted[0].value, fitted[0].sd))
    }
}
