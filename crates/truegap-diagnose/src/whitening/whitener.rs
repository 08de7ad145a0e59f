//! Noise of a row: white, first-order autoregressive, the error of denoised inputs, and that of rounded columns, taken out exactly by a Kalman filter with a
//! state for each.
//!
//! Inputs that were replaced by straight lines err little, but alike over the whole line: per row that error is small, in the mean of many rows it is that of
//! the noise as recorded. It is taken as autoregressive with the memory that gives both.
//!
//! A row may stand for the mean of several rows of the recording (see [`crate::noise::block_average`]); its noise is that of the mean.
//!
//! **Source:** Durbin & Koopman, Time Series Analysis by State Space Methods, ch. 4 (Kalman filter, innovations).
//! **Accuracy:** 1e-10 of the dense covariance, `the_filter_equals_the_dense_covariance` and its like; errors of denoised inputs, which an autoregression copies, 5 %.
//!
//! Limits: correlation runs from row to row, whatever the time between them, and starts afresh with each run.

pub use crate::whitening::kinds::{InputError, Lasting, Noise};
use crate::whitening::{
    parts::{Part, Parts},
    shape::Shape,
};
use nalgebra::DMatrix;
use std::ops::Range;

/// A linear filter that turns noise of a known kind into unit white noise; rows that are left out come out as 0.
#[derive(Clone, Debug)]
pub struct Whitener {
    /// states of a row
    states: usize,
    /// gains of the states, row by row
    gain: Vec<f64>,
    inverse_sd: Vec<f64>,
    /// factors from a row's states to those of the row after
    carry: Vec<f64>,
    runs: Vec<Range<usize>>,
    /// shapes of the error, whitened by all that comes before them
    shapes: Vec<Shape>,
    /// sum of the logarithms of the innovation variances
    pub log_determinant: f64,
    /// rows that count
    pub rows: usize,
}

/// Most states that the loop over the rows knows as a constant; very long recordings with slow noise, read to steps, have more.
const MOST: usize = 10;

/// Runs `$body` with the number of states, up to [`MOST`], as a constant, which is much faster where the loop over the rows knows it.
macro_rules! with_states {
    ($states:expr, $count:ident => $body:expr) => {
        with_states!($states, $count => $body, 1, 2, 3, 4, 5, 6, 7, 8, 9)
    };
    ($states:expr, $count:ident => $body:expr, $($few:literal),*) => {
        match $states {
            $($few => { const $count: usize = $few; $body })*
            _ => { const $count: usize = MOST; $body }
        }
    };
}

fn squared(column: &[f64]) -> f64 {
    column.iter().map(|v| v * v).sum()
}

impl Whitener {
    /// Filter for `noise`, with the error of the inputs (carried through the model) added row by row.
    ///
    /// `weights[row]` is the number of rows whose mean a row is (all 1 where absent); `keep[row] = false` leaves a row out.
    pub fn new(noise: &Noise, input: &InputError, weights: Option<&[f64]>, runs: &[Range<usize>], keep: Option<&[bool]>) -> Self {
        Self::by_run(&|_| *noise, input, weights, runs, keep)
    }

    /// As [`Whitener::new`], with the noise that `of_run` gives each run.
    pub fn by_run(
        of_run: &dyn Fn(&Range<usize>) -> Noise,
        input: &InputError,
        weights: Option<&[f64]>,
        runs: &[Range<usize>],
        keep: Option<&[bool]>,
    ) -> Self {
        let n = input.variance.len();
        let parts = Parts { input, weights };
        let states = parts.count();
        let mut filter = Self {
            states,
            gain: vec![0.0; n * states],
            inverse_sd: vec![0.0; n],
            carry: vec![0.0; n * states],
            runs: runs.to_vec(),
            shapes: Vec::new(),
            log_determinant: 0.0,
            rows: 0,
        };
        for run in runs {
            let noise = &of_run(run);
            let mut predicted = Predicted::new(states, |k| parts.first(noise, k, run.start));
            for row in run.clone() {
                if keep.is_none_or(|k| k[row]) {
                    let white = noise.white_sd * noise.white_sd + input.louder.get(row).copied().unwrap_or(0.0);
                    filter.observe(row, &mut predicted, white / parts.weight(row));
                }
                if row + 1 < run.end {
                    filter.step(row, &mut predicted, |k| parts.part(noise, k, row));
                }
            }
        }
        filter.forget_silent_states();
        for shape in &input.shapes {
            let mut column = shape.clone();
            filter.apply(&mut column);
            let length = squared(&column);
            filter.log_determinant += length.ln_1p();
            filter.shapes.push(Shape { column, length });
        }
        filter
    }

    /// Leaves out the states that no row moves: noise without a memory has none.
    fn forget_silent_states(&mut self) {
        let states = self.states;
        let moved: Vec<usize> =
            (0..states).filter(|k| self.gain.iter().skip(*k).step_by(states).any(|gain| *gain != 0.0)).collect();
        if moved.len() < states {
            let of_moved = |all: &[f64]| all.chunks(states).flat_map(|row| moved.iter().map(|k| row[*k])).collect::<Vec<f64>>();
            (self.gain, self.carry, self.states) = (of_moved(&self.gain), of_moved(&self.carry), moved.len());
        }
    }

    /// Gains of a row that is seen; the covariance predicted for it becomes that after it.
    fn observe(&mut self, row: usize, predicted: &mut Predicted, white: f64) {
        let states = self.states;
        let Predicted { covariance: p, sums } = predicted;
        (0..states).for_each(|k| sums[k] = p[k].iter().sum());
        let variance = sums.iter().sum::<f64>() + white;
        self.inverse_sd[row] = variance.sqrt().recip();
        self.log_determinant += variance.ln();
        self.rows += 1;
        let gain = &mut self.gain[row * states..(row + 1) * states];
        gain.iter_mut().zip(sums.iter()).for_each(|(g, s)| *g = s / variance);
        for i in 0..states {
            for j in i..states {
                p[i][j] -= gain[i] * sums[j];
                p[j][i] = p[i][j];
            }
        }
    }

    /// Takes the covariance and the factors that lead there on to the row after.
    fn step(&mut self, row: usize, predicted: &mut Predicted, part: impl Fn(usize) -> Part) {
        let states = self.states;
        let Predicted { covariance: p, sums: fresh } = predicted;
        let carry = &mut self.carry[row * states..(row + 1) * states];
        for (k, c) in carry.iter_mut().enumerate() {
            Part { carry: *c, fresh: fresh[k] } = part(k);
        }
        for i in 0..states {
            (0..states).for_each(|j| p[i][j] *= carry[i] * carry[j]);
            p[i][i] += fresh[i];
        }
    }

    /// Whitens a column in place.
    pub fn apply(&self, column: &mut [f64]) {
        match self.states {
            0 => column.iter_mut().zip(&self.inverse_sd).for_each(|(value, inverse_sd)| *value *= inverse_sd),
            states if states > MOST => self.apply_with_many(column),
            states => with_states!(states, COUNT => self.apply_with::<COUNT>(column)),
        }
        self.shapes.iter().for_each(|shape| shape.take_out(column));
    }

    /// Whitens columns in place, side by side: each as [`Whitener::apply`] does, to the last bit.
    ///
    /// The filter waits for one row before it goes to the next; four columns wait together.
    pub fn apply_each(&self, columns: &mut [Vec<f64>]) {
        for group in columns.chunks_mut(4) {
            let ([a, b, c, d], 1..=MOST) = (&mut *group, self.states) else {
                group.iter_mut().for_each(|column| self.apply(column));
                continue;
            };
            let four = [a, b, c, d].map(Vec::as_mut_slice);
            with_states!(self.states, COUNT => self.apply_to_four::<COUNT>(four));
            for column in group {
                self.shapes.iter().for_each(|shape| shape.take_out(column));
            }
        }
    }

    /// Gains and factors of each row of a run.
    fn factors<const S: usize>(&self, run: &Range<usize>) -> impl Iterator<Item = (&[f64; S], &[f64; S])> {
        let [gain, carry] = [&self.gain, &self.carry].map(|all| &all.as_chunks::<S>().0[run.clone()]);
        gain.iter().zip(carry)
    }

    fn apply_to_four<const S: usize>(&self, columns: [&mut [f64]; 4]) {
        for run in &self.runs {
            let mut state = [[0.0; 4]; S];
            for (row, (gain, carry)) in run.clone().zip(self.factors::<S>(run)) {
                let foreseen = state.iter().fold([0.0; 4], |sum, s| std::array::from_fn(|k| sum[k] + s[k]));
                let innovation: [f64; 4] = std::array::from_fn(|k| columns[k][row] - foreseen[k]);
                (0..4).for_each(|k| columns[k][row] = innovation[k] * self.inverse_sd[row]);
                for (s, (gain, carry)) in state.iter_mut().zip(gain.iter().zip(carry)) {
                    (0..4).for_each(|k| s[k] = carry * (s[k] + gain * innovation[k]));
                }
            }
        }
    }

    /// [`Whitener::apply`] with `S` states.
    ///
    /// The filter waits for one row before it goes to the next, but for no other run: four runs wait together.
    fn apply_with<const S: usize>(&self, column: &mut [f64]) {
        let mut runs: Vec<&Range<usize>> = self.runs.iter().collect();
        runs.sort_by_key(|run| std::cmp::Reverse(run.len()));
        let (groups, rest) = runs.as_chunks::<4>();
        groups.iter().for_each(|group| self.apply_abreast::<S, 4>(column, *group));
        match *rest {
            [a, b, c] => self.apply_abreast::<S, 3>(column, [a, b, c]),
            [a, b] => self.apply_abreast::<S, 2>(column, [a, b]),
            _ => rest.iter().for_each(|run| self.apply_abreast::<S, 1>(column, [*run])),
        }
    }

    /// The rows of these runs, the longest first, side by side as far as all have some.
    fn apply_abreast<const S: usize, const RUNS: usize>(&self, column: &mut [f64], runs: [&Range<usize>; RUNS]) {
        let [gain, carry] = [&self.gain, &self.carry].map(|all| all.as_chunks::<S>().0);
        let mut states = [[0.0; S]; RUNS];
        let mut step = |state: &mut [f64; S], row: usize| {
            let innovation = column[row] - state.iter().sum::<f64>();
            column[row] = innovation * self.inverse_sd[row];
            go_on(state, innovation, &gain[row], &carry[row]);
        };
        let common = runs.last().map_or(0, |run| run.len());
        for along in 0..common {
            states.iter_mut().zip(runs).for_each(|(state, run)| step(state, run.start + along));
        }
        for (state, run) in states.iter_mut().zip(runs) {
            (run.start + common..run.end).for_each(|row| step(state, row));
        }
    }

    /// [`Whitener::apply`] with more states than [`MOST`].
    fn apply_with_many(&self, column: &mut [f64]) {
        for run in &self.runs {
            let mut state = vec![0.0; self.states];
            for row in run.clone() {
                let innovation = column[row] - state.iter().sum::<f64>();
                column[row] = innovation * self.inverse_sd[row];
                let here = row * self.states..(row + 1) * self.states;
                go_on(&mut state, innovation, &self.gain[here.clone()], &self.carry[here]);
            }
        }
    }

    /// Columns of equal length, whitened, side by side.
    pub fn matrix(&self, columns: Vec<Vec<f64>>) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.inverse_sd.len(), columns.len());
        for (mut column, mut place) in columns.into_iter().zip(matrix.column_iter_mut()) {
            self.apply(&mut column);
            place.copy_from_slice(&column);
        }
        matrix
    }

    /// Undoes [`Whitener::apply`] in place: unit white noise becomes noise of the kind that the filter takes out. Rows left out stay 0.
    pub fn colour(&self, column: &mut [f64]) {
        self.shapes.iter().rev().for_each(|shape| shape.put_in(column));
        for run in &self.runs {
            let mut state = vec![0.0; self.states];
            for row in run.clone() {
                let seen = self.inverse_sd[row] > 0.0;
                let innovation = if seen { column[row] / self.inverse_sd[row] } else { 0.0 };
                column[row] = if seen { innovation + state.iter().sum::<f64>() } else { 0.0 };
                let here = row * self.states..(row + 1) * self.states;
                go_on(&mut state, innovation, &self.gain[here.clone()], &self.carry[here]);
            }
        }
    }

    /// Sum of the logarithms of the innovation variances plus squares of a whitened column: minus twice the log likelihood, up to a constant.
    pub fn deviance(&self, whitened: &[f64]) -> f64 {
        self.log_determinant + whitened.iter().map(|v| v * v).sum::<f64>()
    }
}

/// What is known of the states before a row.
struct Predicted {
    covariance: Vec<Vec<f64>>,
    /// room for one number a state
    sums: Vec<f64>,
}

impl Predicted {
    /// Independent states of these variances.
    fn new(states: usize, variance: impl Fn(usize) -> f64) -> Self {
        let row = |k: usize| (0..states).map(|j| if j == k { variance(k) } else { 0.0 }).collect();
        Self { covariance: (0..states).map(row).collect(), sums: vec![0.0; states] }
    }
}

/// The states after an innovation, carried into the next row.
#[inline]
fn go_on(state: &mut [f64], innovation: f64, gain: &[f64], carry: &[f64]) {
    state.iter_mut().zip(gain.iter().zip(carry)).for_each(|(s, (gain, carry))| *s = carry * (*s + gain * innovation));
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests;
