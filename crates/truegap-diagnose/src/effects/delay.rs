//! Changes of a reading that come late by two ways at once: what a lag of the reading and a relaxation of it share.
//!
//! Limits: linear in the reading; runs that start out of equilibrium began alike: each as far from it as the first, in proportion to its own first value.

use crate::{
    data::context::Context,
    effects::memory::{Haste, Lag, walk_lags},
};
use truegap_core::Inputs;

/// First-order lags side by side, and how the reading stood before its first row.
#[derive(Clone, Debug)]
pub struct Delay {
    /// time constant in s, and share of the change that comes with it
    pub parts: Vec<(f64, f64)>,
    /// time constant in s of a first stage, which all of them are behind; 0 where there is none
    pub first_s: f64,
    /// log of the time constants while the reading falls, over those while it rises
    pub recovery: f64,
    /// how the speed goes with the difference that is left; as one that is in proportion to it where the power is 0
    pub haste: Haste,
    /// what the true value does between rows, as a [`Lag`] has it; straight for a speed that is not in proportion
    pub between: f64,
    /// change per second of the true value before the first row of the recording; before each other run as many times that as its first value stands further from rest
    pub before: f64,
}

impl Delay {
    /// A part with the time constant `tau_s` and a part, `share` of the whole, that is `slower` times slower.
    pub fn of_two(tau_s: f64, share: f64, slower: f64, before: f64) -> Self {
        Self {
            parts: vec![(tau_s, 1.0 - share), (tau_s * slower, share)],
            first_s: 0.0,
            recovery: 0.0,
            haste: Haste::default(),
            between: 0.0,
            before,
        }
    }

    /// The delayed column, in place; `rest` is its value at rest. Time constants of 0 are the identity.
    pub fn apply(&self, inputs: &Inputs, rest: f64, value: &mut [f64]) {
        if self.parts.iter().all(|(tau, _)| *tau <= 0.0) {
            return;
        }
        let truth = value.to_vec();
        let before = |row: usize| self.before * if row == 0 { 1.0 } else { steps_alike(truth[0] - rest, truth[row] - rest) };
        let mut staged = Vec::new();
        if self.first_s > 0.0 {
            staged.clone_from(&truth);
            let ways = (&[self.first_s][..], self.between);
            late(inputs, ways, &truth, |row| self.first_s * before(row), |row, late| staged[row] = late);
        }
        // what a first stage hands on bends between rows, and is held nowhere
        let (given, between) = if staged.is_empty() { (&truth, self.between) } else { (&staged, 0.0) };
        // while it rises, and while it falls
        let apart = (0.5 * self.recovery).exp();
        value.fill(0.0);
        for (tau_s, share) in self.parts.iter().filter(|(_, share)| *share > 0.0) {
            if self.haste.power != 0.0 && *tau_s > 0.0 {
                self.haste.late(inputs, *tau_s, given, |row| tau_s * before(row), |row, late| value[row] += share * late);
                continue;
            }
            let ways = [tau_s / apart, tau_s * apart];
            let ways = if self.recovery == 0.0 { &ways[..1] } else { &ways };
            late(inputs, (ways, between), given, |row| tau_s * before(row), |row, late| value[row] += share * late);
        }
    }
}

/// Gives a column that does this `between` rows with a lag, row by row: by the time constants `ways` while it rises and while it falls, or by one; each run begins `behind` its first value.
fn late(
    inputs: &Inputs,
    (ways, between): (&[f64], f64),
    given: &[f64],
    behind: impl Fn(usize) -> f64,
    mut give: impl FnMut(usize, f64),
) {
    let mut lag = Lag::of(between);
    walk_lags(inputs, ways, |row, weights| {
        let x = given[row];
        let falls = usize::from(ways.len() > 1 && x < lag.state);
        let late = match weights {
            None => lag.start(x, x - behind(row)),
            Some(weights) => lag.next(x, weights, falls),
        };
        give(row, late);
    });
}

/// How many times as far from rest a run begins as the first; 0 where the first begins at rest, and never more than [`MOST_ALIKE`] times.
fn steps_alike(first: f64, this: f64) -> f64 {
    let times = this / first;
    if times.is_finite() { times.clamp(-MOST_ALIKE, MOST_ALIKE) } else { 0.0 }
}

/// Beyond that the first run begins next to rest, and says nothing of the others.
const MOST_ALIKE: f64 = 10.0;

/// Whether the reading itself is a temperature that somebody has simulated: then the reading is late, and not an input of it.
pub(crate) fn reads_temperature(context: &Context<'_>) -> bool {
    is_temperature(context) && context.moved.simulated
}

/// Whether the reading is a temperature.
pub(crate) fn is_temperature(context: &Context<'_>) -> bool {
    let unit = context.simulator.unit().to_lowercase();
    matches!(unit.as_str(), "degc" | "°c" | "celsius" | "deg c" | "k" | "kelvin" | "degf" | "°f")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_that_began_long_ago_is_late_by_the_mean_time_constant_from_the_first_row_on() {
        let time: Vec<f64> = (0..50).map(|i| 7.0 * f64::from(i)).collect();
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 50], ..Inputs::default() };
        let mut value: Vec<f64> = time.iter().map(|t| 20.0 + 0.02 * t).collect();
        // the mean of both is 0.6 q + 0.4 x 10 q
        Delay::of_two(300.0 / 4.6, 0.4, 10.0, 0.02).apply(&inputs, 20.0, &mut value);
        // 0.02 a second times 300 s
        time.iter().zip(&value).for_each(|(t, v)| approx::assert_abs_diff_eq!(*v, 14.0 + 0.02 * t, epsilon = 1e-9));
    }

    /// Behind a ramp that begins with the first row, two stages are behind by the sum of both time constants in the end, and on the way by
    /// `T (1 - ...)`: `y = t - a - b + (a^2 exp(-t / a) - b^2 exp(-t / b)) / (a - b)`, and which of the two comes first is not seen.
    #[test]
    fn two_stages_one_behind_the_other_follow_the_closed_form() {
        let time: Vec<f64> = (0..800).map(|i| 0.25 * f64::from(i)).collect();
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 800], ..Inputs::default() };
        let (a, b) = (20.0, 7.0);
        let closed = |t: f64| t - a - b + (a * a * (-t / a).exp() - b * b * (-t / b).exp()) / (a - b);
        for (first, second) in [(a, b), (b, a)] {
            let mut value = time.clone();
            Delay { first_s: first, ..Delay::of_two(second, 0.0, 10.0, 0.0) }.apply(&inputs, 0.0, &mut value);
            // between rows what the first stage hands on is taken as straight: off by at most h^2 / 12 of its greatest bend, 1 / 7 s
            time.iter()
                .zip(&value)
                .for_each(|(t, v)| approx::assert_abs_diff_eq!(*v, closed(*t), epsilon = 0.0625 / 12.0 / 7.0 * 1.5));
            let mut on_its_way = time.clone();
            Delay { first_s: first, ..Delay::of_two(second, 0.3, 4.0, 1.0) }.apply(&inputs, 0.0, &mut on_its_way);
            let mean = second * (0.7 + 0.3 * 4.0) + first;
            time.iter().zip(&on_its_way).for_each(|(t, v)| approx::assert_abs_diff_eq!(*v, t - mean, epsilon = 1e-9));
        }
    }

    /// After a step up and a step down each, 8 s on the way up and 32 s on the way down: exponentials in closed form.
    #[test]
    fn a_reading_that_recovers_slowly_falls_with_a_time_constant_of_its_own() {
        let time: Vec<f64> = (0..400).map(f64::from).collect();
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 400], ..Inputs::default() };
        let truth = |row: usize| if (100..200).contains(&row) { 1.0 } else { 0.0 };
        let mut value: Vec<f64> = (0..400).map(truth).collect();
        Delay { recovery: 4.0f64.ln(), ..Delay::of_two(16.0, 0.0, 10.0, 0.0) }.apply(&inputs, 0.0, &mut value);
        // a step is a ramp from row to row: behind it the rest falls from what is left at its end
        for (row, tau) in [(100, 8.0), (200, 32.0)] {
            for later in 1..80 {
                let rest = |row: usize| truth(row) - value[row];
                approx::assert_relative_eq!(rest(row + later), rest(row) * (-(later as f64) / tau).exp(), max_relative = 1e-9);
            }
        }
    }

    /// A heater that was switched on 30 s before the first row of each run, at another power in each: `p (1 - exp(-t / 50))` above rest.
    #[test]
    fn runs_that_began_alike_are_on_their_way_alike() {
        let power = [3.0, 7.5, 1.0];
        let time: Vec<f64> = (0..3).flat_map(|run| (0..40).map(move |i| 1000.0 * f64::from(run) + 5.0 * f64::from(i))).collect();
        let run: Vec<u32> = (0..120).map(|row| 1 + row / 40).collect();
        let inputs = Inputs { time_s: Some(time), run, ..Inputs::default() };
        let mut value: Vec<f64> = (0..120).map(|row| 20.0 + power[row / 40]).collect();
        let missing = 3.0 * (-30.0f64 / 50.0).exp();
        Delay::of_two(50.0, 0.0, 10.0, missing / 50.0).apply(&inputs, 20.0, &mut value);
        for (row, late) in value.iter().enumerate() {
            let since = 30.0 + 5.0 * (row % 40) as f64;
            approx::assert_abs_diff_eq!(*late, 20.0 + power[row / 40] * (1.0 - (-since / 50.0).exp()), epsilon = 1e-12);
        }
    }
}
