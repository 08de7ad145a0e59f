//! A slow course as straight lines between knots, and what is known of it beforehand: a random walk on the clock.
//!
//! Limits: nothing faster than the distance of the knots; every run has two of them at least.

use crate::explain::tuning::{MOST_KNOTS, ROWS_PER_KNOT};
use nalgebra::DMatrix;
use std::ops::Range;
use truegap_core::Inputs;

/// Knots of one run, evenly spaced.
#[derive(Clone, Debug)]
struct RunKnots {
    /// index of the first
    first: usize,
    /// number of them
    count: usize,
    start_s: f64,
    step_s: f64,
}

/// All knots, in order.
#[derive(Clone, Debug)]
pub struct Knots {
    runs: Vec<RunKnots>,
    /// variance of the step from the knot before, for a walk of unit variance over a recording; of the level itself at the first knot of one
    variance: Vec<f64>,
    /// which knots begin a recording
    begins: Vec<bool>,
}

/// The two knots about a row, with their weights.
pub type Hat = [(usize, f64); 2];

impl Knots {
    /// Knots for these rows; `recordings` are the rows of each recording.
    pub fn new(inputs: &Inputs, recordings: &[Range<usize>]) -> Self {
        let clock = clock(inputs);
        let runs = inputs.runs();
        let length = |r: &Range<usize>| clock[r.end - 1] - clock[r.start];
        let total: f64 = runs.iter().map(length).sum::<f64>().max(f64::MIN_POSITIVE);
        let mut knots = Self { runs: Vec::new(), variance: Vec::new(), begins: Vec::new() };
        let mut before = 0.0;
        for run in &runs {
            let recording = recordings.iter().find(|r| r.contains(&run.start)).cloned().unwrap_or(0..inputs.len());
            let walk = (clock[recording.end - 1] - clock[recording.start]).max(f64::MIN_POSITIVE);
            let wanted = (MOST_KNOTS * length(run) / total).round() as usize;
            let count = wanted.min(run.len() / ROWS_PER_KNOT).max(2);
            let step_s = length(run) / (count - 1) as f64;
            knots.runs.push(RunKnots { first: knots.variance.len(), count, start_s: clock[run.start], step_s });
            for k in 0..count {
                let at = clock[run.start] + step_s * k as f64;
                let begins = k == 0 && run.start == recording.start;
                knots.begins.push(begins);
                // two knots at one time (runs without a pause) still may differ a little, so that the walk has a density
                knots.variance.push(if begins { 1.0 } else { ((at - before) / walk).max(1e-6) });
                before = at;
            }
        }
        knots
    }

    /// Number of knots.
    pub fn count(&self) -> usize {
        self.variance.len()
    }

    /// Knots and weights of each row; `inputs` have the runs for which the knots were made.
    pub fn hats(&self, inputs: &Inputs) -> Vec<Hat> {
        let clock = clock(inputs);
        let mut hats = vec![[(0, 0.0); 2]; inputs.len()];
        for (knots, run) in self.runs.iter().zip(inputs.runs()) {
            for row in run {
                let at = if knots.step_s > 0.0 { (clock[row] - knots.start_s) / knots.step_s } else { 0.0 };
                let at = at.clamp(0.0, (knots.count - 1) as f64);
                let left = (at.floor() as usize).min(knots.count - 2);
                let right = at - left as f64;
                hats[row] = [(knots.first + left, 1.0 - right), (knots.first + left + 1, right)];
            }
        }
        hats
    }

    /// Inverse covariance of the levels of a walk whose standard deviation over a recording is `sd`, and the logarithm of its determinant.
    pub fn precision(&self, sd: f64) -> (DMatrix<f64>, f64) {
        let n = self.count();
        let mut precision = DMatrix::zeros(n, n);
        let mut log_determinant = 0.0;
        for k in 0..n {
            let weight = 1.0 / (sd * sd * self.variance[k]);
            log_determinant += weight.ln();
            precision[(k, k)] += weight;
            if !self.begins[k] {
                precision[(k - 1, k - 1)] += weight;
                precision[(k, k - 1)] -= weight;
                precision[(k - 1, k)] -= weight;
            }
        }
        (precision, log_determinant)
    }
}

/// Seconds of each row; rows count as seconds without a clock.
fn clock(inputs: &Inputs) -> Vec<f64> {
    inputs.time_s.clone().unwrap_or_else(|| (0..inputs.len()).map(|row| row as f64).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_walk_has_the_covariance_of_its_clock() {
        let time: Vec<f64> = (0..40).map(f64::from).chain((0..40).map(|i| 100.0 + f64::from(i))).collect();
        let inputs = Inputs { run: [vec![1; 40], vec![2; 40]].concat(), time_s: Some(time), ..Inputs::default() };
        let knots = Knots::new(&inputs, std::slice::from_ref(&(0..80)));
        let (precision, log_determinant) = knots.precision(2.0);
        let covariance = precision.clone().try_inverse().unwrap();
        approx::assert_relative_eq!(log_determinant, precision.determinant().ln(), max_relative = 1e-9);
        // a walk that starts with variance 4 and gains 4 over the 139 s of the recording
        let last = knots.count() - 1;
        approx::assert_relative_eq!(covariance[(0, 0)], 4.0, max_relative = 1e-9);
        approx::assert_relative_eq!(covariance[(last, last)], 8.0, max_relative = 1e-9);
        approx::assert_relative_eq!(covariance[(0, last)], 4.0, max_relative = 1e-9);
    }

    #[test]
    fn hats_reproduce_a_straight_course() {
        let inputs =
            Inputs { run: vec![1; 50], time_s: Some((0..50).map(|i| 3.0 * f64::from(i)).collect()), ..Inputs::default() };
        let knots = Knots::new(&inputs, std::slice::from_ref(&(0..50)));
        let levels: Vec<f64> = (0..knots.count()).map(|k| 147.0 * k as f64 / (knots.count() - 1) as f64).collect();
        for (row, hat) in knots.hats(&inputs).iter().enumerate() {
            let value: f64 = hat.iter().map(|(k, w)| w * levels[*k]).sum();
            approx::assert_relative_eq!(value, 3.0 * row as f64, epsilon = 1e-9);
        }
    }
}
