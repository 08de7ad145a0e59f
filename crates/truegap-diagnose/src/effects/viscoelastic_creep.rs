//! Strain that goes on growing under constant load.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::{LagSum, walk_lags},
    },
    text::{percent_with_sd, significant, with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Stage, simulator::StageName};

/// Power-law creep compliance `J(t) ~ (1 + t / onset)^exponent - 1`, as a spectrum of relaxation times.
pub struct ViscoelasticCreep;

/// Relaxation times a decade.
const PER_DECADE: f64 = 2.0;
/// Dwell at which the size is quoted, s.
const QUOTED_AFTER_S: f64 = 60.0;

struct Spectrum {
    /// relaxation time in s, and weight of `1 - exp(-t / tau)`
    weights: Vec<(f64, f64)>,
}

impl Spectrum {
    /// Spectrum `tau^exponent exp(-onset / tau)` from a tenth of the onset to ten times the longest run, scaled to `size` after a minute.
    ///
    /// Beyond its end every element is a dashpot; the last one carries the sum of their geometric series.
    fn new(size: f64, exponent: f64, onset_s: f64, longest_s: f64) -> Self {
        let first = onset_s.log10() - 1.0;
        let last = (10.0 * longest_s.max(QUOTED_AFTER_S)).log10().max(first + 1.0);
        let count = (PER_DECADE * (last - first)).ceil() as usize + 1;
        let tau = |k: usize| 10f64.powf(first + k as f64 / PER_DECADE);
        let beyond = 1.0 / (1.0 - 10f64.powf((exponent - 1.0) / PER_DECADE));
        let weight = |k: usize| tau(k).powf(exponent) * (-onset_s / tau(k)).exp() * if k + 1 == count { beyond } else { 1.0 };
        let raw: Vec<(f64, f64)> = (0..count).map(|k| (tau(k), weight(k))).collect();
        let quoted: f64 = raw.iter().map(|(tau, w)| -w * (-QUOTED_AFTER_S / tau).exp_m1()).sum();
        Self { weights: raw.iter().map(|(tau, w)| (*tau, size * w / quoted)).collect() }
    }
}

impl Stage for Spectrum {
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        let (taus, sizes): (Vec<f64>, Vec<f64>) = self.weights.iter().copied().unzip();
        let mut delayed = LagSum::new(&sizes);
        walk_lags(drive.inputs, &taus, |row, weights| {
            let elastic = strain[row];
            strain[row] = elastic
                + match weights {
                    None => delayed.start(elastic),
                    Some(weights) => delayed.next(elastic, weights),
                };
        });
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
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Mechanics, driver: Driver::Load, kinetics: Kinetics::FirstOrder })
    }
    fn about(&self) -> About {
        About {
            physics: "the beads go on giving way under a constant load and come back slowly after it",
            equation: "strain(t) = e(t) + sum_k w_k lag(e; tau_k), w_k ~ tau_k^n exp(-t0 / tau_k): compliance (1 + t / t0)^n - 1; a part c of it may have one time constant: a c lag(e; tau), Zener's solid for c = 1",
            excitation: "holds under load of at least ten times the shortest step, with a clock",
            impostors: &["offset_drift", "trapped_air_stiffness", "rate_independent_hysteresis", "thermal_lag", "ageing"],
            separates: "scales with the load, recovers after unloading, straight in the logarithm of dwell",
            source: "Ferry, Viscoelastic Properties of Polymers, ch. 2 and 3; SingleTact datasheet V7.4: 2 % in 1 min, 4 % in 10 min",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let (shortest, longest) = times(context);
        let middle = (shortest * longest).sqrt();
        vec![
            Parameter::normal("size", "1", 0.0, 0.03, "share of the elastic strain that is added in the first minute")
                .within(0.0, 2.0),
            Parameter::log_normal("exponent", "1", 0.25, 0.5, "exponent of the power law").within(0.02, 0.95),
            Parameter::log_normal("onset", "s", 1.0, 1.0, "time after which the power law holds").within(0.01, 100.0),
            Parameter::normal("single", "1", 0.0, 0.5, "part of the creep that has one time constant instead").within(0.0, 1.0),
            Parameter::log_normal("tau", "s", middle, 0.4 * (longest / shortest).ln().max(1.0), "that time constant")
                .within(0.3 * shortest, 3.0 * longest),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let (shortest, longest) = times(context);
        let middle = (shortest * longest).sqrt();
        let spread = [[0.15, 1.0], [0.3, 0.3], [0.5, 3.0]].map(|[exponent, onset]| vec![exponent, onset, 0.0, middle]);
        let decades = (longest / shortest).log10();
        let single = (1..=3).map(|k| vec![0.25, 1.0, 1.0, shortest * 10f64.powf(decades * f64::from(k) / 4.0)]);
        spread.into_iter().chain(single).collect()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Beads)?;
        context.needs_clock()?;
        if context.simulator.full_load().is_some() { context.needs_load() } else { Ok(()) }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        // one time constant: share of the size; where it is none, the power law to the last bit
        let single = values.get(3).copied().unwrap_or(0.0);
        let mut spectrum = Spectrum::new((1.0 - single) * values[0], values[1], values[2], context.longest_run_s);
        spectrum.weights.extend(values.get(4).filter(|_| single > 0.0).map(|tau| (*tau, single * values[0])));
        Box::new(spectrum)
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        if let (Some(single), Some(tau)) = (values.get(3), values.get(4))
            && *single > MOSTLY
        {
            let weights = [0.6, 1.7].map(|factor| (factor * tau, 0.5 * values[0])).to_vec();
            return Some(Box::new(Spectrum { weights }));
        }
        // two Kelvin-Voigt elements a decade apart, of which the slower is the softer for a larger exponent
        let times = [10.0 * values[2].max(0.3), 100.0 * values[2].max(0.3)];
        let raw = [1.0, 10f64.powf(values[1])];
        let quoted: f64 = times.iter().zip(raw).map(|(tau, w)| -w * (-QUOTED_AFTER_S / tau).exp_m1()).sum();
        let weights = times.into_iter().zip(raw).map(|(tau, w)| (tau, values[0] * w / quoted)).collect();
        Some(Box::new(Spectrum { weights }))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("the beads creep: strain grows {}", growth(fitted, "of its elastic value"))
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        if context.simulator.corrections().is_some() || context.simulator.warps().is_some() {
            return self.says(fitted);
        }
        format!("creep: the reading goes on changing after a step, {}", growth(fitted, "of the step's strain"))
    }
}

/// Part of one time constant from which on it is spoken of.
const MOSTLY: f64 = 0.5;

fn growth(fitted: &[FittedParameter], of: &str) -> String {
    let size = percent_with_sd(fitted[0].value, fitted[0].sd);
    match (fitted.get(3), fitted.get(4)) {
        (Some(single), Some(tau)) if single.value > MOSTLY => {
            format!("by {size} {of}, with a time constant of {}", with_sd(tau.value, tau.sd, "s"))
        }
        _ => format!("by {size} {of} in the first minute of a hold, as t^{}", significant(fitted[1].value, 2)),
    }
}

/// Shortest step and longest run, s.
fn times(context: &Context<'_>) -> (f64, f64) {
    let shortest = context.step_s();
    (shortest, context.longest_run_s.max(10.0 * shortest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spectrum_is_the_power_law_from_a_fifth_of_the_onset_to_the_longest_run() {
        let law = |t: f64, n: f64, t0: f64| (1.0 + t / t0).powf(n) - 1.0;
        for (n, t0) in [(0.18, 1.5), (0.3, 0.5), (0.5, 3.0)] {
            let spectrum = Spectrum::new(0.04, n, t0, 3600.0);
            for t in [0.2 * t0, 1.0, 10.0, 300.0, 3600.0] {
                let sum: f64 = spectrum.weights.iter().map(|(tau, w)| -w * (-t / tau).exp_m1()).sum();
                let exact = 0.04 * law(t, n, t0) / law(QUOTED_AFTER_S, n, t0);
                // ripple of two relaxation times a decade, and dashpots at the far end for n = 0.5
                approx::assert_relative_eq!(sum, exact, max_relative = 4e-3);
            }
        }
    }

    #[test]
    fn one_time_constant_is_zeners_solid() {
        let plate_time = [0.0, 10.0, 30.0, 90.0];
        let spectrum = Spectrum { weights: vec![(30.0, 0.05)] };
        let inputs = truegap_core::Inputs { time_s: Some(plate_time.to_vec()), run: vec![1; 4], ..Default::default() };
        let drive = Drive { inputs: &inputs, load: &[1.0; 4], temperature_c: &[20.0; 4], reference_c: 20.0, full_load: 1.0 };
        let mut strain = vec![0.2; 4];
        spectrum.strain(&drive, &mut strain);
        for (t, e) in plate_time.iter().zip(&strain) {
            approx::assert_relative_eq!(*e, 0.2 * (1.0 - 0.05 * (-t / 30.0).exp_m1()), max_relative = 1e-12);
        }
    }
}
