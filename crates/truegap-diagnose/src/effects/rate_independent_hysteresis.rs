//! Loading and unloading differ at any speed.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::{Play, half_widths, plays, walk},
        scale::full_strain,
    },
    text::{percent_of, percent_with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Stage, simulator::StageName};

/// Internal friction as a set of sliders: it carries part of the stress, against the motion, whatever makes the beads move.
pub struct RateIndependentHysteresis;

/// Friction on the strain; size and width in full loads where there is a load, else in strain.
struct Friction {
    size: f64,
    width: f64,
    /// 0 for three plays, 1 for one
    sudden: f64,
    /// strain of a full load
    full: f64,
}

impl Stage for Friction {
    /// Adds what the sliders hold back; each run starts with the sliders slack at zero.
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        if self.size == 0.0 {
            return;
        }
        let given = strain.to_vec();
        let full = self.full;
        let add = |row: usize, slip: f64| strain[row] += self.size * full * slip;
        plays(drive.inputs, half_widths(self.width * full, 1.0 - self.sudden), |row| given[row], |_| 0.0, add);
    }
}

/// Sibling: one slider with a corner rounded by the square root of its travel.
struct Rounded(Friction);

impl Stage for Rounded {
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        let full = self.0.full;
        let mut play = Play::new(1.6 * self.0.width * full, 0.0);
        walk(drive.inputs, |row, step| {
            if step.is_none() {
                play.state = 0.0;
            }
            let slip = play.slip(strain[row]) / play.width;
            strain[row] += self.0.size * full * (1.5 * slip - 0.5 * slip.powi(3));
        });
    }
}

/// Numbers of its other law: one play in the place of three.
const SUDDEN: &[&str] = &["sudden"];

fn friction(values: &[f64], context: &Context<'_>) -> Friction {
    Friction { size: values[0], width: values[1], sudden: values.get(2).copied().unwrap_or(0.0), full: full_strain(context) }
}

impl Effect for RateIndependentHysteresis {
    fn id(&self) -> EffectId {
        EffectId("rate_independent_hysteresis")
    }
    fn stage(&self) -> StageName {
        StageName::Beads
    }
    fn family(&self) -> Family {
        Family::MechanicalMemory
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Mechanics, driver: Driver::Load, kinetics: Kinetics::RateIndependent })
    }
    fn about(&self) -> About {
        About {
            physics: "internal friction of the beads carries part of the load, against the motion and at any speed",
            equation: "e_beads = e + a E s, s = sum_k (play(e; w_k E) - e) / (E sum_k w_k), three plays with half widths w_k = (0.4, 0.8, 1.8) w, nearer to w each the more suddenly it turns over where rows left out bear that out, E the strain of a full load at the reference temperature, slack at e = 0 when a run starts",
            excitation: "load that turns around, at best at several amplitudes and rates",
            impostors: &[
                "viscoelastic_creep",
                "trapped_air_stiffness",
                "readout_lag",
                "time_offset",
                "load_cell_error",
                "mullins_softening",
            ],
            separates: "the loop over load keeps its width at every rate and in every hold; minor loops are narrower; it is there in every cycle",
            source: "Visintin, Differential Models of Hysteresis, ch. III (plays); Armitage et al., Sensors 23:3778 (0.9 to 1.3 % of range at 1 N/s)",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![
            Parameter::normal("friction", "full loads", 0.0, 0.01, "load that friction holds back, on a long rise or fall")
                .within(0.0, 0.5),
            Parameter::log_normal(
                "width",
                "full loads",
                0.08,
                0.7,
                "turn of the load after which half of the friction has changed sign",
            )
            .within(0.01, 1.0),
            Parameter::normal(
                SUDDEN[0],
                "1",
                0.0,
                0.5,
                "how suddenly it changes sign: 0 by three plays, 1 by one, as a joint with play does",
            )
            .within(0.0, 1.0),
        ]
    }
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        &[SUDDEN]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        [0.03, 0.1, 0.3].map(|width| vec![width, 0.0]).to_vec()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Beads)?;
        if context.simulator.full_load().is_some() { context.needs_load() } else { Ok(()) }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(friction(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Rounded(friction(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!(
            "loading and unloading differ at any speed: friction holds back {} of the full load, reversed within {} of it after a turn",
            percent_with_sd(fitted[0].value, fitted[0].sd),
            percent_of(2.0 * fitted[1].value)
        )
    }
}
