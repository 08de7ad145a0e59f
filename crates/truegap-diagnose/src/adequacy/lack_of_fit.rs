//! Is a fitted model adequate? Three tests that know no effect: smooth directions, means over short stretches, and lines in the spectrum.
//!
//! Limits: a mismatch shorter than a stretch, without a period, and below the noise goes unseen.

use crate::{
    adequacy::directions::Direction,
    adequacy::tuning::{ALIKE, ASKED, LACK_OF_FIT_LEVEL, MOST_UNCERTAIN, STRETCHES},
    data::problem::Problem,
    fit::{
        optimum::{Fit, Linearised},
        score_test::{JointTest, Scores, scores_with},
    },
    stats::excess_of,
    whitening::{noise_model::NoiseModel, whitener::Whitener},
};
use nalgebra::{DMatrix, DVector};
use std::{
    ops::Range,
    sync::{Arc, Mutex, PoisonError},
};

/// Whitened directions, ready for scoring any fit of the same noise model.
pub struct LackOfFitTests {
    /// n x k
    columns: DMatrix<f64>,
    /// products of the columns with one another
    gram: DMatrix<f64>,
    runs: Vec<Range<usize>>,
    /// factor by which the noise may be larger than taken, two standard deviations up
    slack: f64,
    /// amplitude of a line, in noise of a row, that the steps of the reading make by themselves
    steps: f64,
    /// fits asked last: how much evidence counts is asked of the same fit many times
    asked: Mutex<Vec<Asked>>,
}

/// A fit, and what the two tests of what calibration leaves say of it.
struct Asked {
    z: Vec<f64>,
    at_limit: Vec<bool>,
    residual: Arc<Vec<f64>>,
    jacobian: Arc<DMatrix<f64>>,
    said: (JointTest, JointTest),
}

impl Asked {
    /// Whether it is this fit or a copy of it.
    fn is(&self, fit: &Fit) -> bool {
        Arc::ptr_eq(&self.residual, &fit.residual)
            && Arc::ptr_eq(&self.jacobian, &fit.jacobian)
            && self.z == fit.z
            && self.at_limit == fit.at_limit
    }
}

/// Outcome of the three tests.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Adequacy {
    /// smooth directions
    pub smooth: JointTest,
    /// means over short stretches
    pub stretches: JointTest,
    /// strongest line in the spectrum of a run: p-value with all frequencies and runs counted
    pub line_p_value: f64,
    /// run with the strongest line, and its frequency in cycles a row
    pub line_at: (usize, f64),
    /// root mean square of what is left of a row, over its noise
    pub left_over_noise: f64,
}

impl Adequacy {
    /// Probability below which the three tests together reject a model.
    pub const LEVEL: f64 = LACK_OF_FIT_LEVEL;

    /// Smallest of the p-values, for having tried three.
    pub fn p_value(&self) -> f64 {
        (3.0 * self.smooth.p_value.min(self.stretches.p_value).min(self.line_p_value)).min(1.0)
    }

    /// What the test that finds most finds above expectation, in units of the noise variance; of a line, what its p-value is worth.
    pub fn left(&self) -> f64 {
        let line = if self.line_p_value < LACK_OF_FIT_LEVEL { excess_of(self.line_p_value) } else { 0.0 };
        self.smooth.excess().max(self.stretches.excess()).max(line)
    }

    /// The same without the line, where it is what a tone of so many cycles a row looks like on these rows.
    pub fn without_line(self, per_row: f64) -> Self {
        let folded = (per_row - per_row.round()).abs();
        match (folded - self.line_at.1).abs() < ALIKE {
            true => Self { line_p_value: 1.0, ..self },
            false => self,
        }
    }

    /// Level of what is left beside calibration where it is slow, in units of the noise variance: along the smooth directions or in means over stretches, whichever is louder.
    pub fn slow_level(&self) -> f64 {
        let level = |test: &JointTest| if test.freedom > 0 { test.statistic / test.freedom as f64 } else { 0.0 };
        level(&self.smooth).max(level(&self.stretches))
    }

    /// Whether something is left that noise does not make.
    pub fn fires(&self) -> bool {
        self.p_value() < LACK_OF_FIT_LEVEL
    }
}

impl LackOfFitTests {
    /// Whitens the directions; `uncertainty` is the relative standard deviation of the noise's variance.
    pub fn new(directions: &[Direction], whitener: &Whitener, runs: Vec<Range<usize>>, uncertainty: f64) -> Self {
        let columns = whitener.matrix(directions.iter().map(|d| d.column.clone()).collect());
        let gram = columns.tr_mul(&columns);
        Self { columns, gram, runs, slack: 1.0 + 2.0 * uncertainty.min(MOST_UNCERTAIN), steps: 0.0, asked: Mutex::default() }
    }

    /// The tests of the searched rows of a recording under their noise; `keep[row] = false` leaves a row out. What lasts is looked for inside of runs, and where the rows are in no order nowhere.
    pub fn of(
        problem: &Problem<'_>,
        noise: &NoiseModel,
        whitener: &Whitener,
        directions: &[Direction],
        keep: Option<&[bool]>,
    ) -> Self {
        let runs = problem.runs_in_order();
        let runs = keep.map_or_else(|| runs.clone(), |keep| stretches_kept(&runs, keep));
        Self::new(directions, whitener, runs, noise.uncertainty).beside_steps(noise.line_of_steps())
    }

    /// The same, for a reading whose steps make lines of such an amplitude by themselves, in noise of a row.
    #[must_use]
    pub fn beside_steps(self, amplitude: f64) -> Self {
        Self { steps: amplitude, ..self }
    }

    /// Factor by which the noise may be larger than taken, two standard deviations up.
    pub fn slack(&self) -> f64 {
        self.slack
    }

    /// Scores along the directions.
    pub fn scores(&self, fit: &Fit) -> Scores {
        self.scores_about(&fit.linearised())
    }

    fn scores_about(&self, linearised: &Linearised) -> Scores {
        scores_with(linearised, &self.columns, &self.gram)
    }

    /// What a fit may leave over, in units of the noise variance: what the tests find above expectation, and two standard deviations of the smooth one.
    pub fn may_leave(&self, fit: &Fit) -> f64 {
        let (smooth, stretches) = self.smooth_and_stretches(fit);
        self.slack * (smooth.excess() + 2.0 * (2.0 * smooth.freedom as f64).sqrt()).max(stretches.excess())
    }

    /// The three tests.
    pub fn adequacy(&self, fit: &Fit) -> Adequacy {
        let (smooth, stretches) = self.smooth_and_stretches(fit);
        let (line_p_value, line_at) = strongest_line(&fit.residual, &self.runs, self.steps);
        let left_over_noise = (fit.chi2 / fit.residual.len().max(1) as f64).sqrt();
        Adequacy { smooth, stretches, line_p_value, line_at, left_over_noise }
    }

    /// The two tests of what calibration leaves; of a fit that was asked lately, what they said then.
    fn smooth_and_stretches(&self, fit: &Fit) -> (JointTest, JointTest) {
        let asked = || self.asked.lock().unwrap_or_else(PoisonError::into_inner);
        let known = asked().iter().find(|asked| asked.is(fit)).map(|asked| asked.said);
        known.unwrap_or_else(|| {
            let said = self.smooth_and_stretches_of(fit);
            let Fit { z, at_limit, residual, jacobian, .. } = fit.clone();
            let mut asked = asked();
            asked.truncate(ASKED - 1);
            asked.insert(0, Asked { z, at_limit, residual, jacobian, said });
            said
        })
    }

    fn smooth_and_stretches_of(&self, fit: &Fit) -> (JointTest, JointTest) {
        let linearised = fit.linearised();
        let smooth = if self.columns.ncols() == 0 { none() } else { self.scores_about(&linearised).joint() };
        (smooth.over(self.slack), stretches(&linearised, &self.runs).over(self.slack))
    }
}

/// The stretches of runs that are kept.
fn stretches_kept(runs: &[Range<usize>], keep: &[bool]) -> Vec<Range<usize>> {
    let of_run = |run: &Range<usize>| {
        let rows: Vec<usize> = run.clone().filter(|row| keep[*row]).collect();
        rows.chunk_by(|a, b| a + 1 == *b).map(|rows| rows[0]..rows[rows.len() - 1] + 1).collect::<Vec<_>>()
    };
    runs.iter().flat_map(of_run).collect()
}

fn none() -> JointTest {
    JointTest { statistic: 0.0, freedom: 0, p_value: 1.0 }
}

/// Joint test of the means of the whitened residual over short stretches.
fn stretches(linearised: &Linearised, runs: &[Range<usize>]) -> JointTest {
    let rows: usize = runs.iter().map(ExactSizeIterator::len).sum();
    let length = (rows / STRETCHES).max(8);
    let pieces = || runs.iter().flat_map(|r| r.clone().step_by(length).map(move |a| a..(a + length).min(r.end)));
    let mut cells: Vec<Cell> = pieces().filter(|piece| piece.len() * 2 > length).map(|piece| vec![piece]).collect();
    // runs shorter than half a stretch are no stretch by themselves; where most rows lie in such, neighbours make one together
    if 2 * cells.iter().map(rows_of).sum::<usize>() < rows {
        cells = together(pieces(), length);
    }
    if cells.len() < 4 {
        return none();
    }
    let scores =
        DVector::from_fn(cells.len(), |i, _| cells[i].iter().map(|p| linearised.residual.rows(p.start, p.len()).sum()).sum());
    let taken = DMatrix::from_fn(linearised.taken.ncols(), cells.len(), |p, i| {
        let column = linearised.taken.column(p);
        cells[i].iter().map(|piece| column.rows(piece.start, piece.len()).sum()).sum()
    });
    let lengths = DMatrix::from_diagonal(&DVector::from_fn(cells.len(), |i, _| rows_of(&cells[i]) as f64));
    Scores { scores, covariance: lengths - taken.tr_mul(&taken) }.joint()
}

/// Pieces of runs whose rows have one mean.
type Cell = Vec<Range<usize>>;

fn rows_of(cell: &Cell) -> usize {
    cell.iter().map(ExactSizeIterator::len).sum()
}

/// Neighbouring pieces, as many as make more than half of a stretch of this length; what is left over at the end is left out.
fn together(pieces: impl Iterator<Item = Range<usize>>, length: usize) -> Vec<Cell> {
    let (mut cells, mut open) = (Vec::new(), Cell::new());
    for piece in pieces {
        open.push(piece);
        if 2 * rows_of(&open) > length {
            cells.push(std::mem::take(&mut open));
        }
    }
    cells
}

/// Fisher's test of the strongest line in the periodograms of the runs, of those above an amplitude: p-value and (run, cycles a row).
fn strongest_line(residual: &[f64], runs: &[Range<usize>], amplitude: f64) -> (f64, (usize, f64)) {
    let mut planner = rustfft::FftPlanner::<f64>::new();
    let (mut best, mut at) = (1.0, (0, 0.0));
    for (index, run) in runs.iter().enumerate().filter(|(_, r)| r.len() >= 64) {
        let n = run.len();
        let mut values: Vec<rustfft::num_complex::Complex<f64>> = residual[run.clone()].iter().map(|v| (*v).into()).collect();
        planner.plan_fft_forward(n).process(&mut values);
        // the lowest lines belong to the smooth tests
        let power: Vec<f64> = values[4..n / 2].iter().map(|c| c.norm_sqr()).collect();
        let total: f64 = power.iter().sum();
        let Some((line, strongest)) = power.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)) else { continue };
        // the periodogram of a tone of amplitude A over n rows is (n A / 2)^2
        if *strongest <= (0.5 * n as f64 * amplitude).powi(2) {
            continue;
        }
        let m = power.len() as f64;
        let p = (m * (1.0 - strongest / total).max(0.0).powf(m - 1.0) * runs.len() as f64).min(1.0);
        if p < best {
            (best, at) = (p, (index, (line + 4) as f64 / n as f64));
        }
    }
    (best, at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_end_with_their_run_and_where_a_part_is_left_out() {
        let keep: Vec<bool> = (0..12).map(|row| !(2..5).contains(&row) && !(8..10).contains(&row)).collect();
        assert_eq!(stretches_kept(&[0..6, 6..10, 10..12], &keep), [0..2, 5..6, 6..8, 10..12]);
    }
}
