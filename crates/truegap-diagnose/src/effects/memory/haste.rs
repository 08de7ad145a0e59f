//! A lag whose speed depends on how far behind it is: a drag that goes with the square, a tank that empties through a hole.
//!
//! Limits: one state; the speed is that in the middle of a part of a step. The middle is predicted with the speed of the part before, implicitly, so that one speed is asked for in each part and one more in each step: less than half
//! of what the explicit midpoint rule asks for in four parts, and no less exact. A step in which next to nothing of the difference goes is one part: most steps of a slow instrument are.
//!
//! **Source:** midpoint rule for `dy/dt = (x - y) / tau |x - y|^p / d^p`, its exponential step in each part; Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, sec. II.1.

use super::clock::Clock;
use truegap_core::Inputs;

/// Parts of a step from row to row in which much of the difference goes.
const PARTS: u32 = 3;
/// Share of the difference that may go in a step of one part, times the exponent. The column is off by 2e-4 of its span at most so, as in steps of three parts of a lag of ten rows.
const LITTLE: f64 = 0.05;
/// Exponents of `1 - exp(-a)` up to which it is summed: seven terms leave `0.1^7 / 8!` of it.
const SUMMED: f64 = 0.1;
/// Change of a difference, over itself, up to which its power goes by the binomial series from the last that was worked out: eight terms leave at most `0.1^8` of it.
const NEAR: f64 = 0.1;
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

/// The factor on the speed down the rows: what is left changes little from one to the next, and a power takes as long as all the rest.
struct Speed {
    haste: Haste,
    /// one over the difference at which the factor was worked out last, and the factor there
    per_left: f64,
    there: f64,
    /// binomial coefficients of the power, from the first on
    binomial: [f64; 7],
}

impl Speed {
    fn of(haste: Haste) -> Self {
        let mut coefficient = 1.0;
        let binomial = std::array::from_fn(|k| {
            coefficient *= (haste.power - k as f64) / (k + 1) as f64;
            coefficient
        });
        Self { haste, per_left: f64::NAN, there: f64::NAN, binomial }
    }

    /// Factor where so much is left.
    fn at(&mut self, left: f64) -> f64 {
        let change = left * self.per_left - 1.0;
        let factor = if change.abs() < NEAR {
            self.there * (1.0 + change * summed(&self.binomial, change))
        } else {
            self.per_left = left.recip();
            self.there = (left / self.haste.at).abs().powf(self.haste.power);
            self.there
        };
        factor.clamp(FASTEST.recip(), FASTEST)
    }
}

impl Haste {
    /// Gives a column with the lag, row by row; each run begins `behind` its first value.
    pub fn late(
        self,
        inputs: &Inputs,
        tau_s: f64,
        given: &[f64],
        behind: impl Fn(usize) -> f64,
        mut give: impl FnMut(usize, f64),
    ) {
        let (mut state, mut speed_at) = (0.0, Speed::of(self));
        for (row, x) in given.iter().copied().enumerate() {
            match Clock::step(inputs, false, row) {
                None => state = x - behind(row),
                Some(step) => {
                    let from = given[row - 1];
                    let left = 0.5 * (from + x) - state;
                    let mut speed = speed_at.at(left);
                    let goes = step / tau_s * speed * (1.0 + self.power.abs());
                    let parts = if goes < LITTLE && (x - from).abs() < left.abs() { 1 } else { PARTS };
                    let part = f64::from(parts).recip();
                    let lasts = part * step / tau_s;
                    for k in 0..parts {
                        let middle = from + (x - from) * (f64::from(k) + 0.5) * part;
                        let half = middle + (state - middle) / (1.0 + 0.5 * lasts * speed);
                        speed = speed_at.at(middle - half);
                        state += (middle - state) * goes_in(lasts * speed);
                    }
                }
            }
            give(row, state);
        }
    }
}

/// Terms of `(1 - exp(-a)) / a`.
const SERIES: [f64; 7] = [1.0, -1.0 / 2.0, 1.0 / 6.0, -1.0 / 24.0, 1.0 / 120.0, -1.0 / 720.0, 1.0 / 5040.0];

/// A polynomial of the sixth degree. In pairs, which do not wait for one another: a row waits for the row before it, and all else that waits adds to that.
fn summed([a, b, c, d, e, f, g]: &[f64; 7], x: f64) -> f64 {
    let square = x * x;
    let fourth = square * square;
    (a + b * x) + (c + d * x) * square + (e + f * x + g * square) * fourth
}

/// `1 - exp(-a)`.
fn goes_in(a: f64) -> f64 {
    if a > SUMMED {
        return -(-a).exp_m1();
    }
    a * summed(&SERIES, a)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_goes_in_a_step_is_that_of_the_exponential() {
        let all = (0..200).map(|k| 1e-3 * f64::from(k));
        // 0.1^7 / 8! of the sum
        all.for_each(|a| approx::assert_relative_eq!(goes_in(a), -(-a).exp_m1(), max_relative = 3e-12));
    }

    #[test]
    fn a_power_goes_by_its_series_near_the_last() {
        for power in [-0.9, -0.3, 0.4, 1.0, 2.0] {
            let haste = Haste { power, at: 0.3 };
            let mut speed = Speed::of(haste);
            for row in 0..400 {
                let left = 1.2 * (0.03 * f64::from(row)).cos();
                let exact = (left / 0.3).abs().powf(power).clamp(FASTEST.recip(), FASTEST);
                // 0.1^8, the binomial coefficient beside it at most 1
                approx::assert_relative_eq!(speed.at(left), exact, max_relative = 2e-8);
            }
            // nothing left is no number to go on from
            let nothing = if power < 0.0 { FASTEST } else { FASTEST.recip() };
            assert_eq!((speed.at(0.0), speed.at(-0.3)), (nothing, 1.0));
        }
    }

    /// A slow wave that is followed by a power, against the same in forty times as many rows: where the input goes straight from row to row only the rule differs.
    #[test]
    fn steps_of_one_part_are_off_by_less_than_any_recording_tells() {
        let course = |row: usize| (0.07 * row as f64).sin() + 0.3 * (0.4 * row as f64).cos();
        let late = |finer: usize, tau_s: f64, power: f64| {
            let rows = 200 * finer + 1;
            let straight = |k: usize| {
                let (row, share) = (k / finer, (k % finer) as f64 / finer as f64);
                course(row) + share * (course(row + 1) - course(row))
            };
            let time = (0..rows).map(|k| k as f64 / finer as f64).collect();
            let inputs = Inputs { time_s: Some(time), run: vec![1; rows], ..Inputs::default() };
            let given: Vec<f64> = (0..rows).map(straight).collect();
            let mut late = Vec::new();
            Haste { power, at: 0.2 }.late(&inputs, tau_s, &given, |_| 0.1, |_, value| late.push(value));
            late.into_iter().step_by(finer).collect::<Vec<f64>>()
        };
        for (tau_s, power) in [(100.0, 0.5), (100.0, 1.0), (30.0, -0.4), (10.0, 0.5)] {
            let (rough, fine) = (late(1, tau_s, power), late(40, tau_s, power));
            let worst = rough.iter().zip(&fine).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // 2e-4 of a span of 2.6
            assert!(worst < 5e-4, "{tau_s} {power} {worst}");
        }
    }

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
