//! Exact recursions for physics that remembers, on uneven time steps, restarted with each run.
//!
//! Limits: inputs are taken as linear between rows (lags) or as given at rows (plays, running maxima).
//!
//! **Source:** the step of a lag is `tau dy/dt + y = x` integrated over a straight line, derived here; plays as in Visintin, Differential Models of Hysteresis (1994), ch. III.

mod clock;
mod haste;
mod lags;

use std::ops::Range;
use truegap_core::Inputs;

pub use clock::elapsed_s;
pub use haste::Haste;
use lags::walk_lags_through;
pub use lags::{Lag, LagSum, walk_lags};

/// Calls `visit(row, step)` down the rows: seconds since the row before, `None` at the first row of a run.
///
/// Rows count as seconds where no clock was recorded.
pub fn walk(inputs: &Inputs, mut visit: impl FnMut(usize, Option<f64>)) {
    for row in 0..inputs.len() {
        visit(row, clock::Clock::step(inputs, false, row));
    }
}

/// Value of `column` at `time`, straight between the rows of a run around it; held beyond its ends.
pub fn at_time(clock: &[f64], column: &[f64], run: &Range<usize>, time: f64) -> f64 {
    let after = run.start + clock[run.clone()].partition_point(|t| *t < time);
    let after = after.clamp((run.start + 1).min(run.end - 1), run.end - 1);
    let before = after.saturating_sub(1).max(run.start);
    let width = clock[after] - clock[before];
    let share = if width > 0.0 { ((time - clock[before]) / width).clamp(0.0, 1.0) } else { 0.0 };
    column[before] + share * (column[after] - column[before])
}

/// Rate of a column, per second (per row without a clock), by central differences inside each run.
pub fn rates(clock: Option<&[f64]>, column: &[f64], runs: &[Range<usize>]) -> Vec<f64> {
    let at = |row: usize| clock.map_or(row as f64, |t| t[row]);
    let mut rate = vec![0.0; column.len()];
    for run in runs {
        for row in run.clone() {
            let (left, right) = (row.saturating_sub(1).max(run.start), (row + 1).min(run.end - 1));
            let passed = at(right) - at(left);
            rate[row] = if passed > 0.0 { (column[right] - column[left]) / passed } else { 0.0 };
        }
    }
    rate
}

/// Lag of a column in place; each run starts at `start(x of its first row)`. A time constant of 0 is the identity.
pub fn first_order_lag(inputs: &Inputs, tau_s: f64, x: &mut [f64], start: impl Fn(f64) -> f64) {
    lag_between_rows(inputs, (tau_s, 0.0), x, start);
}

/// The same of a column that does this `between` its rows, as [`Lag`] has it.
pub fn lag_between_rows(inputs: &Inputs, (tau_s, between): (f64, f64), x: &mut [f64], start: impl Fn(f64) -> f64) {
    if tau_s <= 0.0 {
        return;
    }
    let mut lag = Lag::of(between);
    walk_lags(inputs, &[tau_s], |row, weights| {
        let now = x[row];
        x[row] = match weights {
            None => lag.start(now, start(now)),
            Some(weights) => lag.next(now, weights, 0),
        };
    });
}

/// Lag of a column in place that goes on from run to run on the clock, from equilibrium at the first row.
///
/// Nobody recorded what came between two runs: the column is taken to have the value of the next run from the end of the one before, so that what is quick beside a pause has come to rest in it
/// and what is slow remembers.
pub fn lag_through_runs(inputs: &Inputs, tau_s: f64, x: &mut [f64]) {
    if tau_s <= 0.0 {
        return;
    }
    let mut lag = Lag::default();
    walk_lags_through(inputs, &[tau_s], |row, weights| {
        let now = x[row];
        let Some(weights) = weights else {
            lag.start(now, now);
            return;
        };
        if inputs.run[row] != inputs.run[row - 1] {
            lag.start(now, lag.state);
        }
        x[row] = lag.next(now, weights, 0);
    });
}

/// One play operator of half width `width`: the output stays until the input pushes it.
#[derive(Clone, Copy, Debug)]
pub struct Play {
    /// half width, in the unit of the input
    pub width: f64,
    /// output at the last row
    pub state: f64,
}

impl Play {
    /// A play of half width `width` >= 0 at rest at `state`.
    pub fn new(width: f64, state: f64) -> Self {
        Self { width, state }
    }

    /// Output less input, between `-width` (rising) and `width` (falling).
    pub fn slip(&mut self, x: f64) -> f64 {
        self.state = self.state.max(x - self.width).min(x + self.width);
        self.state - x
    }
}

/// Ratios of the half widths of a set of plays to the named one; a set of equal weights rounds the corner of a single play.
pub const PLAY_SET: [f64; 3] = [0.4, 0.8, 1.8];

/// Half widths of a set of plays of mean `width` whose corners turn over so gradually: 0 for one play, 1 for the spread of [`PLAY_SET`].
pub fn half_widths(width: f64, gradual: f64) -> [f64; 3] {
    PLAY_SET.map(|ratio| (1.0 + gradual * (ratio - 1.0)) * width)
}

/// Slip of a set of plays of mean half width `width`, in units of `width`: -1 on a long rise, +1 on a long fall.
///
/// Each run starts with the plays at rest at `rest(x of its first row)`; `visit(row, slip)` is called down the rows.
pub fn play_set(inputs: &Inputs, width: f64, x: impl Fn(usize) -> f64, rest: impl Fn(f64) -> f64, visit: impl FnMut(usize, f64)) {
    plays(inputs, half_widths(width, 1.0), x, rest, visit);
}

/// The same of plays with these half widths: `visit` is given the slip of all of them over their sum, -1 to 1.
pub fn plays(
    inputs: &Inputs,
    half_widths: [f64; 3],
    x: impl Fn(usize) -> f64,
    rest: impl Fn(f64) -> f64,
    mut visit: impl FnMut(usize, f64),
) {
    let whole: f64 = half_widths.iter().sum();
    let mut plays = half_widths.map(|half_width| Play::new(half_width, 0.0));
    walk(inputs, |row, step| {
        let now = x(row);
        if step.is_none() {
            plays.iter_mut().for_each(|play| play.state = rest(now));
        }
        let slip: f64 = plays.iter_mut().map(|play| play.slip(now)).sum();
        visit(row, slip / whole);
    });
}

/// Play operator of half width `width` on a column; each run starts at `start(x of its first row)`.
pub fn play(inputs: &Inputs, width: f64, x: &[f64], start: impl Fn(f64) -> f64) -> Vec<f64> {
    let (mut play, mut out) = (Play::new(width, 0.0), vec![0.0; x.len()]);
    walk(inputs, |row, step| {
        if step.is_none() {
            play.state = start(x[row]);
        }
        out[row] = x[row] + play.slip(x[row]);
    });
    out
}

/// Greatest value so far, carried on from run to run.
pub fn running_maximum(x: &[f64]) -> Vec<f64> {
    greatest_so_far(x, f64::NEG_INFINITY).collect()
}

/// Greatest of `floor` and all values so far, row by row.
pub fn greatest_so_far(x: &[f64], floor: f64) -> impl Iterator<Item = f64> + '_ {
    x.iter().scan(floor, |greatest, &v| {
        *greatest = greatest.max(v);
        Some(*greatest)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one_run(times: &[f64]) -> Inputs {
        Inputs { time_s: Some(times.to_vec()), run: vec![1; times.len()], ..Inputs::default() }
    }

    #[test]
    fn a_lag_of_a_ramp_is_the_ramp_less_tau_with_a_decaying_start() {
        let times: Vec<f64> = (0..60).map(|i| 0.3 * f64::from(i) + 0.1 * f64::from(i % 3)).collect();
        for tau in [0.004, 2.5, 4000.0] {
            let slope = 0.7;
            let mut x: Vec<f64> = times.iter().map(|t| slope * t).collect();
            first_order_lag(&one_run(&times), tau, &mut x, |first| first);
            for (t, y) in times.iter().zip(&x) {
                let exact = slope * (t + tau * (-t / tau).exp_m1());
                approx::assert_abs_diff_eq!(*y, exact, epsilon = 1e-12);
            }
        }
    }

    #[test]
    fn a_play_follows_only_when_it_is_pushed() {
        let mut play = Play::new(1.0, 0.0);
        let states: Vec<f64> = [0.0, 0.5, 3.0, 2.5, 0.0].map(|x| x + play.slip(x)).to_vec();
        assert_eq!(states, vec![0.0, 0.0, 2.0, 2.0, 1.0]);
    }

    #[test]
    fn a_set_of_plays_slips_by_one_mean_width_on_a_long_rise() {
        let inputs = one_run(&[0.0, 1.0, 2.0]);
        let (mut slips, x) = (vec![], [0.0, 5.0, 0.0]);
        play_set(&inputs, 0.5, |row| x[row], |first| first, |_, slip| slips.push(slip));
        // the ratios of the set have mean 1
        approx::assert_abs_diff_eq!(slips[1], -1.0, epsilon = 1e-14);
        approx::assert_abs_diff_eq!(slips[2], 1.0, epsilon = 1e-14);
    }

    #[test]
    fn memory_starts_afresh_with_each_run() {
        let inputs = Inputs { time_s: Some(vec![0.0, 1.0, 2.0, 3.0]), run: vec![1, 1, 2, 2], ..Inputs::default() };
        let mut x = vec![0.0, 1.0, 5.0, 5.0];
        first_order_lag(&inputs, 10.0, &mut x, |first| first);
        assert_eq!(&x[2..], &[5.0, 5.0]);
    }

    /// Between two runs the column stands at the value of the second.
    #[test]
    fn what_is_slow_beside_a_pause_remembers_and_what_is_quick_has_come_to_rest() {
        let inputs = Inputs { time_s: Some(vec![0.0, 1.0, 101.0, 102.0]), run: vec![1, 1, 2, 2], ..Inputs::default() };
        let lagged = |tau_s: f64| {
            let mut x = vec![0.0, 0.0, 1.0, 1.0];
            lag_through_runs(&inputs, tau_s, &mut x);
            x
        };
        // 1 - exp(-t / tau) after 100 s and after 101 s
        for tau_s in [4.0, 50.0, 9000.0] {
            let risen = |t: f64| -(-t / tau_s).exp_m1();
            approx::assert_abs_diff_eq!(lagged(tau_s)[2..], [risen(100.0), risen(101.0)], epsilon = 1e-14);
        }
    }

    #[test]
    fn the_greatest_value_so_far_never_falls() {
        assert_eq!(greatest_so_far(&[-1.0, 2.0, 1.0, 3.0], 0.0).collect::<Vec<_>>(), [0.0, 2.0, 2.0, 3.0]);
        assert_eq!(running_maximum(&[-1.0, 2.0, 1.0]), [-1.0, 2.0, 2.0]);
    }
}
