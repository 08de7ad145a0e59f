//! Beads touch one after another at small load.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    text::{percent_of, percent_with_sd},
};
use truegap_core::{EffectId, Inputs, Parameter, Stage, simulator::StageName};

/// A share of the beads has no contact until the load has brought the plate down to it.
pub struct ContactToeIn;

struct Contact {
    missing: f64,
    scale: f64,
}

impl Contact {
    /// The load on the beads that touch already, per bead, in units of the same load on all.
    fn apply(&self, load: &mut [f64], absent: impl Fn(f64) -> f64) {
        load.iter_mut().for_each(|load| *load /= 1.0 - self.missing * absent(load.max(0.0) / self.scale));
    }
}

impl Stage for Contact {
    fn load(&self, _: &Inputs, load: &mut [f64]) {
        self.apply(load, |ratio| (-ratio).exp());
    }
}

/// Sibling: heights spread such that contact comes as a rational function of the load.
struct Gradual(Contact);

impl Stage for Gradual {
    fn load(&self, _: &Inputs, load: &mut [f64]) {
        self.0.apply(load, |ratio| 1.0 / (1.0 + ratio * (1.0 + ratio * (0.5 + ratio / 6.0))));
    }
}

fn contact(values: &[f64]) -> Contact {
    Contact { missing: values[0], scale: values[1] }
}

impl Effect for ContactToeIn {
    fn id(&self) -> EffectId {
        EffectId("contact_toe_in")
    }
    fn stage(&self) -> StageName {
        StageName::LoadPath
    }
    fn family(&self) -> Family {
        Family::StaticMechanics
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Inputs, driver: Driver::Load, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "beads of unequal height touch one after another, so the sensor is soft at small load",
            equation: "L_beads = L / (1 - m exp(-L / l)), m the share of beads without contact at zero load",
            excitation: "many readings at small loads, below a fifth of the full one",
            impostors: &["strain_stiffening", "load_cell_error", "eccentric_load", "dead_gap"],
            separates: "the change is all at small load, the same up and down and at every rate",
            source: "Greenwood & Williamson, Proc. R. Soc. A 295 (1966) 300 (exponential spread of heights)",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![
            Parameter::normal("missing", "1", 0.0, 0.15, "share of the beads without contact at zero load").within(0.0, 0.95),
            Parameter::log_normal("load", "full loads", 0.12, 0.7, "load that brings two thirds of them into contact")
                .within(0.005, 1.0),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![0.04], vec![0.12], vec![0.35]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::LoadPath)?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(contact(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Gradual(contact(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!(
            "{} of the beads have no contact at zero load; two thirds of them touch by {} of the full load",
            percent_with_sd(fitted[0].value, fitted[0].sd),
            percent_of(fitted[1].value)
        )
    }
}
