//! Air shut in between the beads carries load and leaks out.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::{Lag, walk_lags},
    },
    text::{percent_with_sd, with_sd},
};
use truegap_core::{EffectId, Inputs, Parameter, Stage, simulator::StageName};

/// A dashpot and spring beside the beads: the air takes a share of every change of load and gives it back as it leaks.
pub struct TrappedAirStiffness;

struct Air {
    share: f64,
    /// weight and time constant, s, of each way out
    leaks: Vec<(f64, f64)>,
}

impl Stage for Air {
    fn load(&self, inputs: &Inputs, load: &mut [f64]) {
        if self.share == 0.0 {
            return;
        }
        let (mut leaks, taus): (Vec<(f64, Lag)>, Vec<f64>) =
            self.leaks.iter().map(|(weight, tau)| ((*weight, Lag::default()), *tau)).unzip();
        walk_lags(inputs, &taus, |row, weights| {
            let whole = load[row];
            let leaked = |(index, (weight, lag)): (usize, &mut (f64, Lag))| match weights {
                None => *weight * lag.start(whole, 0.0),
                Some(weights) => *weight * lag.next(whole, weights, index),
            };
            load[row] = whole - self.share * (whole - leaks.iter_mut().enumerate().map(leaked).sum::<f64>());
        });
    }
}

impl Effect for TrappedAirStiffness {
    fn id(&self) -> EffectId {
        EffectId("trapped_air_stiffness")
    }
    fn stage(&self) -> StageName {
        StageName::Beads
    }
    fn family(&self) -> Family {
        Family::MechanicalMemory
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Mechanics, driver: Driver::Load, kinetics: Kinetics::FirstOrder })
    }
    fn about(&self) -> About {
        About {
            physics: "air shut in between the beads (or in the pores of a foam) carries a share of a fast load and leaks out",
            equation: "L_beads = L - a (L - lag(L; tau)), no load borne by air before a run; the heating of the air is left out",
            excitation: "fast steps of load and holds of several time constants, with a clock",
            impostors: &["viscoelastic_creep", "readout_lag", "rate_independent_hysteresis", "thermal_lag"],
            separates: "one time constant, where creep is spread over decades; stiffer when fast, and no stiffness left in a long hold; sealed or vented edges change it",
            source: "Gibson & Ashby, Cellular Solids, sec. 5.3 (fluid in the cells); Biot, J. Appl. Phys. 12 (1941) 155",
        }
    }
    fn touches(&self) -> Vec<StageName> {
        vec![StageName::LoadPath]
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let shortest = context.shortest_step_s.unwrap_or(1.0);
        let longest = context.longest_run_s.max(10.0 * shortest);
        let middle = (shortest * longest).sqrt();
        vec![
            Parameter::normal("share", "1", 0.0, 0.05, "share of a sudden load that the air takes").within(0.0, 0.95),
            Parameter::log_normal("tau", "s", middle, 0.4 * (longest / shortest).ln().max(1.0), "time constant of the leak")
                .within(0.3 * shortest, 3.0 * longest),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let shortest = context.shortest_step_s.unwrap_or(1.0);
        let decades = (context.longest_run_s / shortest).max(10.0).log10();
        (1..=4).map(|k| vec![shortest * 10f64.powf(decades * f64::from(k) / 5.0)]).collect()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Beads)?;
        context.needs_clock()?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Air { share: values[0], leaks: vec![(1.0, values[1])] })
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        // diffusion of pressure through the layer: the first modes of a disc that is open at its rim
        Some(Box::new(Air { share: values[0], leaks: vec![(0.75, 1.15 * values[1]), (0.25, 0.22 * values[1])] }))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("air shut in takes {} of a sudden load and leaks out with {}", share(fitted), time_constant(fitted))
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        if context.simulator.corrections().is_some() || context.simulator.warps().is_some() {
            return self.says(fitted);
        }
        format!(
            "{} of a sudden change comes late, with {}, as where something shut in leaks out",
            share(fitted),
            time_constant(fitted)
        )
    }
}

fn share(fitted: &[FittedParameter]) -> String {
    percent_with_sd(fitted[0].value, fitted[0].sd)
}

fn time_constant(fitted: &[FittedParameter]) -> String {
    format!("a time constant of {}", with_sd(fitted[1].value, fitted[1].sd, "s"))
}
