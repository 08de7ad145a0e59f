//! First-order lags, one or many of one input, exact for an input that is linear between rows.
//!
//! Limits: an input that is linear between rows.

use super::clock::{Clock, Steps};
use std::{cell::RefCell, collections::VecDeque, rc::Rc};
use truegap_core::{Inputs, asked_last};

/// Below this ratio of step to time constant the weights of a lag come from their series.
const SERIES_BELOW: f64 = 0.1;

/// `1 / (k + 2)!`, k from 0: nine terms leave 0.1^9 / 11! = 3e-17.
const SERIES: [f64; 9] =
    [1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0, 1.0 / 5040.0, 1.0 / 40320.0, 1.0 / 362_880.0, 1.0 / 3_628_800.0];

/// Tables that a thread remembers: those of a model at a point, and those a step away.
const TABLES: usize = 8;

/// Weights beyond which a table is not worth its room, 3 MB.
const LARGEST: usize = 1 << 17;

/// Weights of the old output, of the input before and of the input now, each a column over the lags.
#[derive(Clone, Copy, Debug)]
pub struct Weights<'a> {
    old: &'a [f64],
    before: &'a [f64],
    now: &'a [f64],
}

/// Calls `visit(row, weights)` down the rows: what lags with these time constants, s, make of the step from the row before; `None` at the first row of a run.
///
/// Derivatives by all that is no time constant ask for the same weights again, so that they are remembered.
pub fn walk_lags(inputs: &Inputs, taus_s: &[f64], visit: impl FnMut(usize, Option<Weights<'_>>)) {
    walk_clock(inputs, false, taus_s, visit);
}

/// The same on the clock that runs through all runs: `None` at the very first row.
pub(super) fn walk_lags_through(inputs: &Inputs, taus_s: &[f64], visit: impl FnMut(usize, Option<Weights<'_>>)) {
    walk_clock(inputs, true, taus_s, visit);
}

fn walk_clock(inputs: &Inputs, through: bool, taus_s: &[f64], visit: impl FnMut(usize, Option<Weights<'_>>)) {
    if inputs.len() * taus_s.len() > LARGEST {
        return walk_anew(inputs, through, taus_s, visit);
    }
    let clock = Clock::remembered(inputs, through);
    remembered(&clock, taus_s).walk(visit);
}

/// As [`walk_clock`], with no more room than for the steps that a clock keeps.
fn walk_anew(inputs: &Inputs, through: bool, taus_s: &[f64], mut visit: impl FnMut(usize, Option<Weights<'_>>)) {
    let mut steps = Steps::<Columns>::default();
    for row in 0..inputs.len() {
        let step = Clock::step(inputs, through, row);
        visit(row, step.map(|step| steps.known(step, |of| of.learn(&[step], taus_s)).weights(0, taus_s.len())));
    }
}

/// The weights of every step of a clock.
struct Table {
    clock: Rc<Clock>,
    taus_s: Vec<f64>,
    columns: Columns,
}

thread_local! {
    static KNOWN: RefCell<VecDeque<Rc<Table>>> = const { RefCell::new(VecDeque::new()) };
}

/// The table of these lags on this clock, with what was asked before on the same thread.
fn remembered(clock: &Rc<Clock>, taus_s: &[f64]) -> Rc<Table> {
    let is_asked = |table: &Rc<Table>| Rc::ptr_eq(&table.clock, clock) && table.taus_s == taus_s;
    KNOWN.with_borrow_mut(|known| {
        asked_last(known, TABLES, is_asked, || {
            let mut columns = Columns::default();
            columns.learn(&clock.steps_s, taus_s);
            Rc::new(Table { clock: Rc::clone(clock), taus_s: taus_s.to_vec(), columns })
        })
        .clone()
    })
}

impl Table {
    fn walk(&self, mut visit: impl FnMut(usize, Option<Weights<'_>>)) {
        let lags = self.taus_s.len();
        for (row, step) in self.clock.of_row.iter().enumerate() {
            visit(row, step.map(|step| self.columns.weights(step as usize, lags)));
        }
    }
}

/// Weights of lags, those of a step behind those of the step before.
#[derive(Clone, Debug, Default)]
struct Columns {
    /// steps over time constants
    ratio: Vec<f64>,
    old: Vec<f64>,
    before: Vec<f64>,
    now: Vec<f64>,
}

impl Columns {
    /// Those of these steps; what was known before leaves its room.
    fn learn(&mut self, steps_s: &[f64], taus_s: &[f64]) {
        let Self { ratio, old, before, now } = self;
        ratio.clear();
        steps_s.iter().for_each(|step| ratio.extend(taus_s.iter().map(|tau| step / tau)));
        [&mut *old, &mut *before, &mut *now].into_iter().for_each(|column| column.resize(ratio.len(), 0.0));
        // the series of all side by side, then those that take another form
        for (((ratio, old), before), now) in ratio.iter().zip(&mut *old).zip(&mut *before).zip(&mut *now) {
            [*old, *before, *now] = by_series(*ratio);
        }
        for (((ratio, old), before), now) in ratio.iter().zip(old).zip(before).zip(now) {
            if !takes_series(*ratio) {
                [*old, *before, *now] = in_closed_form(*ratio);
            }
        }
    }

    fn weights(&self, step: usize, lags: usize) -> Weights<'_> {
        let here = step * lags..(step + 1) * lags;
        let [old, before, now] = [&self.old, &self.before, &self.now].map(|column| &column[here.clone()]);
        Weights { old, before, now }
    }
}

/// First-order lag `tau y' + y = x`, exact for `x` linear between rows, on any sequence of steps.
#[derive(Clone, Copy, Debug, Default)]
pub struct Lag {
    /// output at the last row
    pub state: f64,
    /// what `x` does between two rows: 0 straight, 1 it has the value of the later row, -1 that of the earlier one; mixed in between
    between: f64,
    before: f64,
}

impl Lag {
    /// A lag of an input that does this `between` its rows.
    pub fn of(between: f64) -> Self {
        Self { between, ..Self::default() }
    }

    /// Starts a run with input `x` and output `state`.
    pub fn start(&mut self, x: f64, state: f64) -> f64 {
        self.before = x;
        self.state = state;
        state
    }

    /// Output a step later, where the input is `x`; the weights are those of lag `index`.
    #[inline]
    pub fn next(&mut self, x: f64, weights: Weights<'_>, index: usize) -> f64 {
        let (before, now) = (weights.before[index], weights.now[index]);
        let moved = self.between * if self.between > 0.0 { before } else { now };
        self.state = weights.old[index] * self.state + (before - moved) * self.before + (now + moved) * x;
        self.before = x;
        self.state
    }
}

/// A weighted sum of lags of one input, each as [`Lag`]; a column over the lags a quantity.
#[derive(Clone, Debug)]
pub struct LagSum<'a> {
    weights: &'a [f64],
    /// outputs at the last row
    states: Vec<f64>,
    before: f64,
}

impl<'a> LagSum<'a> {
    /// Lags with these weights.
    pub fn new(weights: &'a [f64]) -> Self {
        Self { states: vec![0.0; weights.len()], weights, before: 0.0 }
    }

    /// Starts a run with input `x` and every output 0.
    pub fn start(&mut self, x: f64) -> f64 {
        self.before = x;
        self.states.fill(0.0);
        0.0
    }

    /// The sum a step later, where the input is `x`.
    #[inline]
    pub fn next(&mut self, x: f64, Weights { old, before, now }: Weights<'_>) -> f64 {
        for (((state, old), before), now) in self.states.iter_mut().zip(old).zip(before).zip(now) {
            *state = old * *state + before * self.before + now * x;
        }
        self.before = x;
        self.weights.iter().zip(&self.states).fold(0.0, |sum, (weight, state)| sum + weight * state)
    }
}

/// Whether the weights for step over time constant `ratio` come from the series.
fn takes_series(ratio: f64) -> bool {
    ratio > 0.0 && ratio < SERIES_BELOW
}

/// Weights of the old output, the input before and the input now, for a short step over time constant: the series of `1 - (1 - exp(-r)) / r`, from which the other weights follow without
/// cancellation. No exponential, and no digit lost.
#[inline]
fn by_series(ratio: f64) -> [f64; 3] {
    let mut sum = 0.0;
    for factor in SERIES.iter().rev() {
        sum = factor - ratio * sum;
    }
    let now = sum * ratio;
    let risen = ratio - ratio * now;
    [1.0 - risen, risen - now, now]
}

/// The same for a step that is not short, or none.
fn in_closed_form(ratio: f64) -> [f64; 3] {
    if ratio <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let decay = (-ratio).exp();
    let mean = (1.0 - decay) / ratio;
    [decay, mean - decay, 1.0 - mean]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::memory::clock::KEPT;

    /// What is done at a row with the weights of its step.
    type Visit<'a> = dyn FnMut(usize, Option<Weights<'_>>) + 'a;

    fn weights(ratio: f64) -> [f64; 3] {
        if takes_series(ratio) { by_series(ratio) } else { in_closed_form(ratio) }
    }

    /// Runs on an uneven clock, with more steps than are kept, a row that stands still and one that is long.
    fn uneven(rows: u32) -> Inputs {
        let mut time = 0.0;
        let step = |row: u32| {
            if row == 40 {
                0.0
            } else if row == 41 {
                900.0
            } else {
                0.1 * f64::from(1 + row % (KEPT as u32 + 3))
            }
        };
        let times = (0..rows).map(|row| {
            time += step(row);
            time
        });
        Inputs { time_s: Some(times.collect()), run: (0..rows).map(|row| 1 + row / 50).collect(), ..Inputs::default() }
    }

    fn drawn(row: usize) -> f64 {
        (1.3 * row as f64).sin()
    }

    #[test]
    fn a_sum_of_lags_is_the_sum_of_each_by_itself_and_each_has_the_weights_of_its_step() {
        let (taus, sizes) = ([0.3, 4.0, 90.0], [0.5, -0.2, 1.5]);
        let inputs = uneven(130);
        let mut sum = LagSum::new(&sizes);
        let (mut each, mut by_step) = ([Lag::default(); 3], [Lag::default(); 3]);
        let mut rows = 0;
        walk_lags(&inputs, &taus, |row, given| {
            rows += 1;
            let x = drawn(row);
            let Some(given) = given else {
                sum.start(x);
                each.iter_mut().chain(&mut by_step).for_each(|lag| _ = lag.start(x, 0.0));
                return;
            };
            let found = sum.next(x, given);
            let expected: f64 = each.iter_mut().enumerate().map(|(k, lag)| sizes[k] * lag.next(x, given, k)).sum();
            approx::assert_relative_eq!(found, expected, max_relative = 1e-13);
            // and each lag is that of a step nobody has seen
            let time = inputs.time_s.as_ref().unwrap();
            for (k, lag) in by_step.iter_mut().enumerate() {
                let [old, before, now] = weights((time[row] - time[row - 1]) / taus[k]);
                lag.state = old * lag.state + before * lag.before + now * x;
                lag.before = x;
                approx::assert_relative_eq!(lag.state, each[k].state, max_relative = 1e-7, epsilon = 1e-9);
            }
        });
        assert_eq!(rows, 130);
    }

    /// More lags and clocks than are remembered, asked over and over: the weights are those of a walk without memory, to the last bit.
    #[test]
    fn what_is_remembered_is_what_is_learned_anew() {
        let one_run = Inputs { run: vec![1; 130], ..uneven(130) };
        let clocks = [uneven(130), one_run, uneven(70), Inputs { time_s: None, ..uneven(60) }];
        for _ in 0..2 {
            for (inputs, through) in clocks.iter().flat_map(|inputs| [(inputs, false), (inputs, true)]) {
                for lags in 1..2 * TABLES {
                    let taus: Vec<f64> = (0..lags).map(|k| 0.2 * 3f64.powi(k as i32)).collect();
                    let all = |walk: &dyn Fn(&mut Visit<'_>)| {
                        let mut all = Vec::new();
                        walk(&mut |row, given| match given {
                            None => all.push(row as u64),
                            Some(Weights { old, before, now }) => {
                                all.extend(old.iter().chain(before).chain(now).map(|w| w.to_bits()));
                            }
                        });
                        all
                    };
                    let known = all(&|visit| walk_clock(inputs, through, &taus, visit));
                    assert_eq!(known, all(&|visit| walk_anew(inputs, through, &taus, visit)));
                }
            }
        }
    }

    #[test]
    fn the_series_of_the_weights_meets_the_closed_form_where_they_change_over() {
        let (below, above) = (weights(SERIES_BELOW.next_down()), weights(SERIES_BELOW));
        for (b, a) in below.iter().zip(above) {
            // rounding of 1 - mean at a ratio of 0.1
            approx::assert_abs_diff_eq!(*b, a, epsilon = 1e-14);
        }
        approx::assert_abs_diff_eq!(below.iter().sum::<f64>(), 1.0, epsilon = 1e-15);
    }
}
