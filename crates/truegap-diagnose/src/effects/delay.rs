//! Changes of a reading that come late by two ways at once: what a lag of the reading and a relaxation of it share.
//!
//! Limits: linear in the reading; only the first run may start out of equilibrium.

use crate::{
    data::context::Context,
    effects::memory::{Lag, walk},
};
use truegap_core::Inputs;

/// First-order lags side by side, and how the reading stood before its first row.
#[derive(Clone, Debug)]
pub struct Delay {
    /// time constant in s, and share of the change that comes with it
    pub parts: Vec<(f64, f64)>,
    /// change per second of the true value before the first row of the recording
    pub before: f64,
}

impl Delay {
    /// A part with the time constant `tau_s` and a part, `share` of the whole, that is `slower` times slower.
    pub fn of_two(tau_s: f64, share: f64, slower: f64, before: f64) -> Self {
        Self { parts: vec![(tau_s, 1.0 - share), (tau_s * slower, share)], before }
    }

    /// The delayed column, in place; time constants of 0 are the identity.
    pub fn apply(&self, inputs: &Inputs, value: &mut [f64]) {
        if self.parts.iter().all(|(tau, _)| *tau <= 0.0) {
            return;
        }
        let given = value.to_vec();
        value.fill(0.0);
        for (tau_s, share) in self.parts.iter().filter(|(_, share)| *share > 0.0) {
            let mut lag = Lag::new(*tau_s);
            walk(inputs, |row, step| {
                let x = given[row];
                let late = match step {
                    None if row == 0 => lag.start(x, x - tau_s * self.before),
                    None => lag.start(x, x),
                    Some(step) => lag.next(x, step),
                };
                value[row] += share * late;
            });
        }
    }
}

/// Whether the reading itself is a temperature that somebody has simulated: then the reading is late, and not an input of it.
pub(crate) fn reads_temperature(context: &Context<'_>) -> bool {
    let unit = context.simulator.unit().to_lowercase();
    let is_temperature = matches!(unit.as_str(), "degc" | "°c" | "celsius" | "deg c" | "k" | "kelvin" | "degf" | "°f");
    is_temperature && context.moved.simulated
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
        Delay::of_two(300.0 / 4.6, 0.4, 10.0, 0.02).apply(&inputs, &mut value);
        // 0.02 a second times 300 s
        time.iter().zip(&value).for_each(|(t, v)| approx::assert_abs_diff_eq!(*v, 14.0 + 0.02 * t, epsilon = 1e-9));
    }
}
