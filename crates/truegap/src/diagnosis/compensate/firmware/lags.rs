//! First-order lags as the firmware steps them, in numbers of double length: what its states are compared with.
//!
//! Limits: inputs that are straight between rows; the first row of a run is at rest.

use truegap_core::Inputs;

/// Lags of one input side by side, behind a first stage where there is one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Lags {
    /// time constant of the first stage, s; 0 where there is none
    pub first_s: f64,
    /// time constant in s, and share of the input that comes with it
    pub parts: Vec<(f64, f64)>,
}

impl Lags {
    /// A quick part and a part, `share` of the whole, that is `slower` times slower; `tau_s` is the mean of both, `first` the time constant of a stage before them over that.
    pub fn of_two(tau_s: f64, share: f64, slower: f64, first: f64) -> Self {
        let first_s = (first * tau_s).max(0.0);
        if share <= 0.0 {
            return Self { first_s, parts: vec![(tau_s, 1.0)] };
        }
        let quick = tau_s / (1.0 - share + share * slower);
        let parts = [(quick, 1.0 - share), (quick * slower, share)];
        Self { first_s, parts: parts.into_iter().filter(|(_, share)| *share > 0.0).collect() }
    }

    /// Least time constant, s.
    pub fn least_s(&self) -> f64 {
        let all = self.parts.iter().map(|(tau, _)| *tau).chain((self.first_s > 0.0).then_some(self.first_s));
        all.fold(f64::INFINITY, f64::min)
    }

    /// States that a firmware keeps.
    pub fn states(&self) -> usize {
        self.parts.len() + usize::from(self.first_s > 0.0)
    }

    /// A column of `inputs` behind these lags.
    pub fn late(&self, inputs: &Inputs, column: &[f64]) -> Vec<f64> {
        let first = late(inputs, self.first_s, column);
        let parts = self.parts.iter().map(|(tau, share)| (late(inputs, *tau, &first), share));
        parts.fold(vec![0.0; column.len()], |sum, (part, share)| sum.iter().zip(&part).map(|(s, p)| s + share * p).collect())
    }
}

fn late(inputs: &Inputs, tau_s: f64, column: &[f64]) -> Vec<f64> {
    if tau_s <= 0.0 {
        return column.to_vec();
    }
    let mut state = 0.0;
    let steps = inputs.steps_s();
    let next = |row: usize| {
        let begins = row == 0 || inputs.run[row] != inputs.run[row - 1];
        state = if begins { column[row] } else { stepped(state, column[row - 1], column[row], steps[row] / tau_s) };
        state
    };
    (0..column.len()).map(next).collect()
}

/// A lag a step of `ratio` time constants later, its input straight from `before` to `now`: `tau y' + y = x` integrated.
fn stepped(state: f64, before: f64, now: f64, ratio: f64) -> f64 {
    if ratio <= 0.0 {
        return state;
    }
    let gain = -(-ratio).exp_m1();
    state + gain * (before - state) + (1.0 - gain / ratio) * (now - before)
}
