//! A two-metal electrode bends as temperature changes.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Geometry, Parameter, Stage, simulator::StageName};

/// Share of the free bimetal curvature.
pub struct ElectrodeWarp;

struct Warp(f64);

impl Stage for Warp {
    fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
        geometry.warp_factor += self.0;
    }
}

/// Sibling: expansion coefficients that themselves grow with temperature, so that the curvature is not quite in proportion.
struct Growing(f64);

/// Growth of the difference of expansions, 1/K.
const GROWTH: f64 = 2e-3;

impl Stage for Growing {
    fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
        geometry.warp_factor += self.0;
        geometry.warp_kelvin.iter_mut().for_each(|kelvin| *kelvin *= 1.0 + GROWTH * *kelvin);
    }
}

impl Effect for ElectrodeWarp {
    fn id(&self) -> EffectId {
        EffectId("electrode_warp")
    }
    fn stage(&self) -> StageName {
        StageName::Geometry
    }
    fn family(&self) -> Family {
        Family::Thermal
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Geometry, driver: Driver::Temperature, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "tin and copper expand differently, so the electrode bends: its centre comes closer to the other plate, its rim moves away",
            equation: "curvature = w k(T), k the free curvature of the bimetal; w = 1 where nothing holds the plate down",
            excitation: "temperature that moves by several kelvin",
            impostors: &["permittivity_temperature", "gain_drift", "thermal_hysteresis"],
            separates: "even in the temperature difference about the flat state, and larger when the load has closed the gap; a size near 1 needs no free number",
            source: "Timoshenko, J. Opt. Soc. Am. 11 (1925) 233; Hampson & Dobie eq. (9), (18), (19)",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![Parameter::normal("factor", "1", 0.0, 0.7, "share of the free curvature of the bimetal").within(0.0, 3.0)]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Geometry)?;
        match context.simulator.warps() {
            None => Err("the base model has no electrode of two metals".into()),
            Some(true) => Err("the base model holds the warp already".into()),
            Some(false) => context.needs_temperature(2.0),
        }
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Warp(values[0]))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Growing(values[0])))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!(
            "the electrode warps with temperature, by {} of the curvature of a free bimetal",
            with_sd(fitted[0].value, fitted[0].sd, "1")
        )
    }
}
