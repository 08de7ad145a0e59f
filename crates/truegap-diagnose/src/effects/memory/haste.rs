//! A lag whose speed depends on how far behind it is: a drag that goes with the square, a tank that empties through a hole.
//!
//! Limits: one state; the speed is that in the middle of a part of a step. The middle is predicted with the speed of the part before, implicitly, so that one speed is asked for in each part and one more in each step: less than half
//! of what the explicit midpoint rule asks for in four parts, and no less exact.
//!
//! **Source:** midpoint rule for `dy/dt = (x - y) / tau |x - y|^p / d^p`, its exponential step in each part; Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, sec. II.1.

use super::clock::Clock;
use truegap_core::Inputs;

/// Parts of a step from row to row.
const PARTS: u32 = 3;
/// Greatest factor on the speed, and one over the least.
const FASTEST: f64 = 1e3;

/// How the speed of a lag goes with the difference that is left.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Haste {
    /// exponent of the difference in the speed, less 1: 1 for a drag of the square, -0.5 for a tank that empties, 0 for a lag
    pub power: f64,
    /// difference at which the time constant is that of the lag
    pub at: f64,
}

impl Haste {
    /// Factor on the speed where so much is left.
    fn of(self, left: f64) -> f64 {
        (left / self.at).abs().powf(self.power).clamp(FASTEST.recip(), FASTEST)
    }

    /// Gives a column with the lag, row by row; each run begins `behind` its first value.
    pub fn late(
        self,
        inputs: &Inputs,
        tau_s: f64,
        given: &[f64],
        behind: impl Fn(usize) -> f64,
        mut give: impl FnMut(usize, f64),
    ) {
        let mut state = 0.0;
        for (row, x) in given.iter().copied().enumerate() {
            match Clock::step(inputs, false, row) {
                None => state = x - behind(row),
                Some(step) => {
                    let (from, part) = (given[row - 1], f64::from(PARTS).recip());
                    let middle = |k: u32| from + (x - from) * (f64::from(k) + 0.5) * part;
                    let lasts = part * step / tau_s;
                    let mut speed = self.of(middle(0) - state);
                    for middle in (0..PARTS).map(middle) {
                        let half = middle + (state - middle) / (1.0 + 0.5 * lasts * speed);
                        speed = self.of(middle - half);
                        state += (middle - state) * -(-lasts * speed).exp_m1();
                    }
                }
            }
            give(row, state);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// After a step of 1 at the first row: `1 / (1 + t / tau)` is left of it by a drag of the square, and `(1 - t / (2 tau))^2` in a tank that empties.
    #[test]
    fn what_is_left_of_a_step_follows_the_closed_forms() {
        let time: Vec<f64> = (0..100).map(f64::from).collect();
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 100], ..Inputs::default() };
        let left = |t: f64, power: f64| if power > 0.0 { 1.0 / (1.0 + t / 20.0) } else { (1.0 - t / 40.0).max(0.0).powi(2) };
        for power in [1.0, -0.5] {
            let mut late = Vec::new();
            Haste { power, at: 1.0 }.late(&inputs, 20.0, &[1.0; 100], |_| 1.0, |_, value| late.push(value));
            time.iter().zip(&late).for_each(|(t, v)| approx::assert_abs_diff_eq!(1.0 - v, left(*t, power), epsilon = 2e-4));
        }
    }
}
