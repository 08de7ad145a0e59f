//! Strain that goes on growing under constant load.

use crate::{
    context::Context,
    effect::{About, Effect, Family, FittedParameter},
    memory::lag_step,
};
use truegap_core::{Drive, EffectId, Parameter, Stage, simulator::StageName};

/// Power-law creep compliance `J(t) = size [(1 + t)^exponent - 1] / [(1 + 60)^exponent - 1]`, t in s, as a spectrum of relaxation times.
pub struct ViscoelasticCreep;

/// Relaxation times a decade; the spectrum reproduces the power law to 1 % of its value from 1 s to the length of the run.
const PER_DECADE: f64 = 2.0;

struct Spectrum {
    weights: Vec<(f64, f64)>,
}

impl Spectrum {
    /// Weights `w_k` on `1 - exp(-t / tau_k)` with `w ~ tau^exponent`, scaled to `size` after one minute.
    fn new(size: f64, exponent: f64, longest_s: f64) -> Self {
        let last = (longest_s.max(10.0) * 3.0).log10();
        let count = (PER_DECADE * last).ceil() as usize + 1;
        let times = (0..count).map(|k| 10f64.powf(k as f64 / PER_DECADE));
        let raw: Vec<(f64, f64)> = times.map(|tau| (tau, tau.powf(exponent))).collect();
        let after_minute: f64 = raw.iter().map(|(tau, w)| -w * (-60.0 / tau).exp_m1()).sum();
        Self { weights: raw.iter().map(|(tau, w)| (*tau, size * w / after_minute)).collect() }
    }
}

impl Stage for Spectrum {
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        let steps = drive.inputs.steps_s();
        for run in drive.inputs.runs() {
            let mut states = vec![0.0; self.weights.len()];
            let mut before = strain[run.start];
            for row in run.start..run.end {
                let elastic = strain[row];
                let mut delayed = 0.0;
                for (state, (tau, weight)) in states.iter_mut().zip(&self.weights) {
                    *state = lag_step(*state, before, elastic, steps[row] / tau);
                    delayed += weight * *state;
                }
                before = elastic;
                strain[row] = elastic + delayed;
            }
        }
    }
}

impl Effect for ViscoelasticCreep {
    fn id(&self) -> EffectId {
        EffectId("viscoelastic_creep")
    }
    fn stage(&self) -> StageName {
        StageName::Beads
    }
    fn family(&self) -> Family {
        Family::MechanicalMemory
    }
    fn about(&self) -> About {
        About {
            physics: "the beads go on giving way under a constant load and come back slowly after it",
            equation: "strain(t) = e(t) + sum_k w_k lag(e; tau_k), w_k ~ tau_k^n",
            excitation: "holds under load of at least ten times the shortest step, with a clock",
            impostors: &["offset_drift", "trapped_air_stiffness", "rate_independent_hysteresis", "thermal_lag"],
            separates: "scales with the load, recovers after unloading, straight in the logarithm of dwell",
            source: "Ferry, Viscoelastic Properties of Polymers, ch. 2; SingleTact datasheet V7.4: 2 % in 1 min, 4 % in 10 min",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![
            Parameter::normal("size", "1", 0.0, 0.05, "share of the elastic strain that is added in the first minute")
                .within(0.0, 1.0),
            Parameter::log_normal("exponent", "1", 0.25, 0.5, "exponent of the power law").within(0.02, 1.5),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![0.1], vec![0.25], vec![0.6]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Beads)?;
        context.needs_clock()?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Spectrum::new(values[0], values[1], context.longest_run_s))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!(
            "the beads creep: strain grows by {:.2} % (sd {:.2}) of its elastic value in the first minute of a hold, as t^{:.2}",
            100.0 * fitted[0].value,
            100.0 * fitted[0].sd,
            fitted[1].value
        )
    }
}
