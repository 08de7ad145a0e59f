//! Rows for which no load was recorded: where the clocks of load and response differ, a model reads the load of the first or last rows from beyond the ends of a run.
//!
//! It holds the first or last load there, and its errors are those of what it made up: a shift of three seconds leaves the reading of three seconds unexplained, however right it is. So these rows tell nothing
//! of any model: they have next to no weight, and no error is taken over them.
//!
//! Limits: one recording; the clock of one model, as it was fitted with these rows.

use crate::{
    data::problem::Problem,
    noise::{beside_louder::not_louder_beside, louder::Louder},
    stats::spread,
    whitening::noise_model::{NoiseModel, tells},
};
use std::ops::Range;

/// Root mean square of what a model leaves of such rows, in noise of a row, from which on they are left out: one that predicts them all the same tells nothing wrong of itself.
const STANDS_OUT: f64 = 2.0;

/// Whether what a model leaves of `rows`, which it reads from beyond the ends, is felt: `misfit` is what it leaves of every row. No row is where all are known already.
pub fn rows_felt(rows: &[usize], misfit: &[f64], noise: &NoiseModel) -> bool {
    let squares: f64 = rows.iter().map(|row| (misfit[*row] / noise.row_sd(*row)).powi(2)).sum();
    let new = rows.iter().any(|row| tells(&noise.untold, *row));
    new && squares >= STANDS_OUT.powi(2) * rows.len() as f64
}

/// The noise under which these rows weigh next to nothing.
pub fn weightless(problem: &Problem<'_>, rows: &[usize], noise: &NoiseModel) -> NoiseModel {
    let mut input_error = noise.input_error.clone();
    input_error.louder.resize(problem.response.len(), 0.0);
    rows.iter().for_each(|row| input_error.louder[*row] = spread(problem.response).powi(2));
    NoiseModel { input_error, untold: ranges(rows), ..noise.clone() }
}

/// The noise of the other rows, taken from what a model leaves of them; never louder than it was.
pub fn with_noise_of_others(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> NoiseModel {
    let clean = mirrored(misfit, &problem.runs(), &noise.untold);
    let none = vec![0.0; misfit.len()];
    let others = Louder { variance: none, clean, wild: Vec::new(), only_wild: true, says: String::new() };
    NoiseModel { says: noise.says.clone(), ..not_louder_beside(problem, noise, others) }
}

/// Rows in a row as ranges.
fn ranges(rows: &[usize]) -> Vec<Range<usize>> {
    rows.chunk_by(|a, b| a + 1 == *b).map(|rows| rows[0]..rows[rows.len() - 1] + 1).collect()
}

/// The column itself where no row is left out; else with the rows beside them, in turned order, in the place of these at the ends of a run: they have its noise.
pub fn mirrored(column: &[f64], runs: &[Range<usize>], untold: &[Range<usize>]) -> Vec<f64> {
    let mut clean = column.to_vec();
    for rows in untold {
        let Some(run) = runs.iter().find(|run| run.contains(&rows.start)) else { continue };
        for row in rows.clone() {
            let beside = if rows.start == run.start { 2 * rows.end - row - 1 } else { (2 * rows.start).saturating_sub(row + 1) };
            clean[row] = column[beside.clamp(run.start, run.end - 1)];
        }
    }
    clean
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)] // one run
mod tests {
    use super::*;
    use crate::whitening::whitener::{InputError, Noise};

    /// Of three rows, which are off by fifty times the noise, two are known: with the third they are felt, and without it they are not.
    #[test]
    fn further_rows_are_felt_beside_those_that_are_known() {
        let white = Noise { white_sd: 1.0, ar_sd: 0.0, ar_correlation: 0.0 };
        let known = NoiseModel { untold: vec![0..2], ..NoiseModel::unmeasured(white, InputError::white(vec![0.0; 6])) };
        let misfit = [50.0, 50.0, 50.0, 0.0, 0.0, 0.0];
        assert!(rows_felt(&[0, 1, 2], &misfit, &known));
        assert!(!rows_felt(&[0, 1], &misfit, &known));
        assert!(!rows_felt(&[0, 1, 3], &[0.0; 6], &known));
    }

    #[test]
    fn rows_at_the_ends_become_those_beside_them() {
        let column: Vec<f64> = (0..10).map(f64::from).collect();
        let untold = ranges(&[0, 1, 7, 8, 9]);
        assert_eq!(untold, [0..2, 7..10]);
        assert_eq!(mirrored(&column, &[0..10], &untold), [3.0, 2.0, 2.0, 3.0, 4.0, 5.0, 6.0, 6.0, 5.0, 4.0]);
        // where no row beside them is left they stay within the run
        assert_eq!(mirrored(&column, &[0..3, 3..10], &ranges(&[0, 1, 2]))[..3], [2.0, 2.0, 2.0]);
    }
}
