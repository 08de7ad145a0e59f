//! What a deformation makes of a reading fades while the deformation is held.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::{Lag, walk_lags},
    },
    text::{percent_with_sd, rounded, with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// The dual of creep: a share of every change of the reading fades with a time constant, or over a decade of them.
pub struct StressRelaxation;

struct Fading {
    share: f64,
    tau_s: f64,
    /// decades over which the time constants are spread
    spread: f64,
}

/// Time constants, evenly apart in the logarithm.
const TIMES: usize = 5;

impl Fading {
    fn times(&self) -> impl Iterator<Item = f64> + '_ {
        (0..TIMES).map(|k| self.tau_s * 10f64.powf(self.spread * (k as f64 / (TIMES - 1) as f64 - 0.5)))
    }

    fn apply(&self, drive: &Drive<'_>, value: &mut [f64], times: &[f64]) {
        if self.share == 0.0 {
            return;
        }
        let weight = self.share / times.len() as f64;
        let mut lags = vec![Lag::default(); times.len()];
        walk_lags(drive.inputs, times, |row, weights| {
            let now = value[row];
            let late = |(index, lag): (usize, &mut Lag)| match weights {
                None => lag.start(now, now),
                Some(weights) => lag.next(now, weights, index),
            };
            let faded: f64 = lags.iter_mut().enumerate().map(late).map(|late| now - late).sum();
            // what has not faded yet stands above the relaxed reading
            value[row] = now + weight * faded;
        });
    }
}

impl Stage for Fading {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        self.apply(drive, value, &self.times().collect::<Vec<_>>());
    }
}

/// Sibling: two time constants, half as long and twice as long.
struct Two(Fading);

impl Stage for Two {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        self.0.apply(drive, value, &[0.5 * self.0.tau_s, 2.0 * self.0.tau_s]);
    }
}

/// Usual share of a sudden change that fades. It may be many times that: what relaxes to a fifth of what it was has four. Of 17 in recordings by other people 14 are larger than 0.3, which a Gaussian all but excludes.
const USUAL: f64 = 0.1;

fn fading(values: &[f64]) -> Fading {
    Fading { share: values[0], tau_s: values[1], spread: values[2] }
}

impl Effect for StressRelaxation {
    fn id(&self) -> EffectId {
        EffectId("stress_relaxation")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::MechanicalMemory
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Mechanics, driver: Driver::Reading, kinetics: Kinetics::FirstOrder })
    }
    fn about(&self) -> About {
        About {
            physics: "the reading overshoots when a deformation is imposed and fades while it is held, as the stress in a viscoelastic solid does",
            equation: "value = true + (a / 5) sum_k [true - lag(true; tau_k)], five tau_k over d decades about tau; true is the relaxed reading",
            excitation: "steps of a gap, a displacement or a simulated value, and holds, with a clock",
            impostors: &["slow_response", "offset_drift", "friction", "readout_lag"],
            separates: "overshoots on the way up and undershoots on the way down, and fades with the time of the hold",
            source: "Ferry, Viscoelastic Properties of Polymers, ch. 1 and 3 (relaxation modulus); ISO 3384 (stress relaxation in compression)",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let shortest = context.step_s();
        let longest = context.longest_run_s.max(10.0 * shortest);
        let middle = (shortest * longest).sqrt();
        vec![
            Parameter::wide("share", "1", USUAL, "part of a sudden change that fades, over what stays").within(0.0, 5.0),
            Parameter::log_normal("tau", "s", middle, 0.4 * (longest / shortest).ln().max(1.0), "middle of the time constants")
                .within(0.3 * shortest, 3.0 * longest),
            Parameter::normal("spread", "decades", 0.0, 1.0, "decades over which they are spread").within(0.0, 4.0),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let shortest = context.step_s();
        let decades = (context.longest_run_s / shortest).max(10.0).log10();
        let tau = |k: i32| shortest * 10f64.powf(decades * f64::from(k) / 4.0);
        (1..=3).flat_map(|k| [vec![tau(k), 0.1], vec![tau(k), 2.0]]).collect()
    }
    fn comes_down_to(&self) -> Option<EffectId> {
        Some(EffectId("gain_error"))
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        context.needs_clock()?;
        if context.has(StageName::LoadPath).is_ok() && context.has(StageName::Beads).is_ok() {
            return Err("the base model is driven by a load: what goes on there is creep".into());
        }
        if !context.simulator.moves() {
            return Err("a value that does not move does not relax".into());
        }
        context.needs_movement()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(fading(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Two(fading(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let (share, tau, spread) = (&fitted[0], fitted[1].value, &fitted[2]);
        let over = if spread.value > 3.0 * spread.sd && spread.value > 0.3 {
            let wide = 10f64.powf(0.5 * spread.value);
            format!("time constants from {} to {}", rounded(tau / wide, "s"), rounded(tau * wide, "s"))
        } else {
            format!("a time constant of {}", with_sd(tau, fitted[1].sd, "s"))
        };
        format!(
            "the reading relaxes: a sudden change overshoots by {} and fades with {over}",
            percent_with_sd(share.value, share.sd)
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::Inputs;

    #[test]
    fn a_step_overshoots_by_the_share_and_fades_with_the_time_constant() {
        let time = vec![0.0, 1e-6, 10.0, 20.0, 1000.0];
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 5], ..Inputs::default() };
        let drive = Drive { inputs: &inputs, load: &[0.0; 5], temperature_c: &[20.0; 5], reference_c: 20.0, full_load: 1.0 };
        let mut value = vec![0.0, 1.0, 1.0, 1.0, 1.0];
        Fading { share: 0.3, tau_s: 20.0, spread: 0.0 }.readout(&drive, &Readout { zero: 0.0, span: 1.0 }, &mut value);
        for (t, v) in time.iter().zip(&value).skip(1) {
            approx::assert_abs_diff_eq!(*v, 1.0 + 0.3 * (-t / 20.0).exp(), epsilon = 1e-6);
        }
    }
}
