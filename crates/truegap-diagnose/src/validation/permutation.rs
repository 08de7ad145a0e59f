//! A control of equal freedom: the same added columns, driven by a history that is not the recording's.
//!
//! Limits: linear about the fit; what a permuted history removes on runs left out is what freedom alone can do.

use crate::{
    fit::optimum::Fit,
    seeds::SEEDS,
    validation::cross_validation::parts,
    validation::tuning::{PERMUTATIONS, THERE},
};
use nalgebra::{Cholesky, DMatrix, DVector};
use rand::{RngExt, SeedableRng, seq::SliceRandom};
use rand_chacha::ChaCha8Rng;
use std::ops::Range;

/// Share of the misfit on parts left out that columns of equal freedom remove when their history is permuted: median over permutations.
///
/// `base` and `chosen` are fits of the same whitened rows, `chosen` with more columns behind those of `base`; `recordings` are the runs of each, `numbers` as in
/// [`parts`]. `None` where nothing was added, or the base model leaves nothing above the noise.
pub fn permuted(base: &Fit, chosen: &Fit, recordings: &[Vec<Range<usize>>], numbers: &[u32]) -> Option<f64> {
    let first = base.jacobian.ncols();
    let added = chosen.jacobian.columns(first, chosen.jacobian.ncols() - first).into_owned();
    if added.ncols() == 0 {
        return None;
    }
    let (_, parts) = parts(&recordings.concat(), numbers);
    let rows: Vec<Vec<usize>> = parts.iter().map(|p| p.rows.iter().cloned().flatten().collect()).collect();
    let mut random = ChaCha8Rng::seed_from_u64(SEEDS.permutation_control);
    let mut removed: Vec<f64> =
        (0..PERMUTATIONS).filter_map(|_| removed(base, &permute(&added, recordings, &mut random), &rows)).collect();
    removed.sort_by(f64::total_cmp);
    removed.get(removed.len() / 2).copied()
}

/// Columns with their runs exchanged, each stretched to its new run and turned about by a tenth or more of its length: runs that repeat one another would
/// otherwise stand in for one another. Runs of one recording only: those of another have its noise and its size.
pub(crate) fn permute(columns: &DMatrix<f64>, recordings: &[Vec<Range<usize>>], random: &mut ChaCha8Rng) -> DMatrix<f64> {
    let mut turned = columns.clone();
    recordings.iter().for_each(|runs| exchange(columns, &mut turned, runs, random));
    turned
}

fn exchange(columns: &DMatrix<f64>, turned: &mut DMatrix<f64>, runs: &[Range<usize>], random: &mut ChaCha8Rng) {
    let mut source: Vec<usize> = (0..runs.len()).collect();
    while runs.len() > 1 && source.iter().enumerate().any(|(i, s)| i == *s) {
        source.shuffle(random);
    }
    for (run, from) in runs.iter().zip(&source) {
        let from = &runs[*from];
        let offset: f64 = random.random_range(0.1..0.9);
        for (k, row) in run.clone().enumerate() {
            let place = (k as f64 / run.len() as f64 + offset).fract() * from.len() as f64;
            turned.row_mut(row).copy_from(&columns.row(from.start + (place as usize).min(from.len() - 1)));
        }
    }
}

/// Share of the squared misfit above the noise that base and added columns together remove on rows left out, against the base alone.
fn removed(base: &Fit, added: &DMatrix<f64>, parts: &[Vec<usize>]) -> Option<f64> {
    let residual = base.linearised().residual;
    let known = base.jacobian.ncols();
    let total = known + added.ncols();
    let mut design = DMatrix::zeros(residual.len(), total);
    design.columns_mut(0, known).copy_from(&base.jacobian);
    design.columns_mut(known, added.ncols()).copy_from(added);
    let (gram, right) = (design.tr_mul(&design), design.tr_mul(&residual));
    let (mut before, mut after, mut count) = (0.0, 0.0, 0.0);
    for part in parts {
        let out = design.select_rows(part);
        let target = DVector::from_iterator(part.len(), part.iter().map(|r| residual[*r]));
        let gram = &gram - out.tr_mul(&out);
        let right = &right - out.tr_mul(&target);
        for (columns, sum) in [(known, &mut before), (total, &mut after)] {
            let mut hessian = gram.view((0, 0), (columns, columns)).into_owned();
            let ridge = 1e-9 * hessian.trace() / columns as f64;
            (0..columns).for_each(|i| hessian[(i, i)] += if i < known { 1.0 } else { ridge });
            let found = Cholesky::new(hessian)?.solve(&right.rows(0, columns).into_owned());
            *sum += (&target - out.columns(0, columns) * found).norm_squared();
        }
        count += part.len() as f64;
    }
    let there = before / count - 1.0;
    (there > THERE * (2.0 / count).sqrt()).then(|| 1.0 - (after / count - 1.0) / there)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::{model::Kinds, optimum::finish};

    const ROWS: usize = 60;

    fn course(k: usize) -> Vec<f64> {
        (0..ROWS).map(|row| (0.31 * (k + 1) as f64 * row as f64).sin()).collect()
    }

    /// A base model of one number (known to one deviation about 0) fitted to `y` in noise of unit variance.
    fn base(y: &[f64]) -> Fit {
        let column = DVector::from_vec(course(0));
        let y = DVector::from_column_slice(y);
        let z = column.dot(&y) / (1.0 + column.norm_squared());
        let residual = &y - &column * z;
        let jacobian = DMatrix::from_columns(&[column]);
        finish(
            vec![z],
            residual.as_slice().to_vec(),
            jacobian,
            &[(f64::NEG_INFINITY, f64::INFINITY)],
            Kinds::default(),
            (1, true),
        )
    }

    fn recorded() -> Vec<f64> {
        course(0)
            .iter()
            .zip(course(1))
            .enumerate()
            .map(|(row, (a, b))| 2.0 * a + 3.0 * b + (1.7 * row as f64).cos() * 1.4)
            .collect()
    }

    /// Squared error on parts left out by stacked least squares, the numbers of the base model held by a row each, over what the fit leaves.
    fn left_out(columns: &[Vec<f64>], residual: &[f64], parts: &[Vec<usize>], held: usize) -> f64 {
        let error = |part: &Vec<usize>| {
            let rest: Vec<usize> = (0..ROWS).filter(|row| !part.contains(row)).collect();
            let design = DMatrix::from_fn(rest.len() + held, columns.len(), |i, k| match i.checked_sub(rest.len()) {
                None => columns[k][rest[i]],
                Some(own) => f64::from(u8::from(own == k)),
            });
            let right = DVector::from_fn(rest.len() + held, |i, _| rest.get(i).map_or(0.0, |row| residual[*row]));
            let found = design.svd(true, true).solve(&right, 1e-12).unwrap();
            part.iter()
                .map(|row| (residual[*row] - (0..columns.len()).map(|k| columns[k][*row] * found[k]).sum::<f64>()).powi(2))
                .sum::<f64>()
        };
        parts.iter().map(error).sum()
    }

    #[test]
    fn the_share_removed_is_that_of_least_squares_without_each_part() {
        let (fit, added) = (base(&recorded()), DMatrix::from_columns(&[DVector::from_vec(course(1))]));
        let parts: Vec<Vec<usize>> = (0..6).map(|k| (10 * k..10 * (k + 1)).collect()).collect();
        let residual = fit.residual.clone();
        let [before, after] = [1, 2].map(|count| {
            let columns: Vec<Vec<f64>> = (0..count).map(course).collect();
            left_out(&columns, &residual, &parts, 1) / ROWS as f64 - 1.0
        });
        let found = removed(&fit, &added, &parts).unwrap();
        // the ridge of a billionth
        assert!((found - (1.0 - after / before)).abs() < 1e-6, "{found} {}", 1.0 - after / before);
        assert!(found > 0.7, "{found}");
    }

    /// Three runs: no run keeps its own history, and each gets rows of one other, in their order but for one turn.
    #[test]
    fn a_permuted_history_is_that_of_another_run() {
        let runs = [0..20, 20..40, 40..60];
        let column = DMatrix::from_fn(ROWS, 1, |row, _| row as f64);
        for seed in 0..10 {
            let turned = permute(&column, &[runs.to_vec()], &mut ChaCha8Rng::seed_from_u64(seed));
            for run in &runs {
                let rows: Vec<usize> = run.clone().map(|row| turned[(row, 0)] as usize).collect();
                let from = &runs[rows[0] / 20];
                assert!(from != run && rows.iter().all(|row| from.contains(row)), "{rows:?}");
                let turns = rows.windows(2).filter(|w| w[1] != w[0] + 1).count();
                assert!(turns <= 1, "{rows:?}");
            }
        }
    }

    /// Two recordings of three and of two runs: a history stays in its own.
    #[test]
    fn runs_are_exchanged_inside_of_their_recording() {
        let recordings = [vec![0..10, 10..20, 20..30], vec![30..45, 45..60]];
        let column = DMatrix::from_fn(ROWS, 1, |row, _| row as f64);
        for seed in 0..10 {
            let turned = permute(&column, &recordings, &mut ChaCha8Rng::seed_from_u64(seed));
            assert!((0..ROWS).all(|row| (row < 30) == (turned[(row, 0)] < 30.0)), "{turned}");
        }
    }

    #[test]
    fn what_acts_removes_more_than_its_permuted_history() {
        let fit = base(&recorded());
        let both = [course(0), course(1)].map(DVector::from_vec);
        let chosen = Fit { jacobian: DMatrix::from_columns(&both).into(), ..fit.clone() };
        let numbers: Vec<u32> = (0..ROWS).map(|row| 1 + row as u32 / 20).collect();
        let runs = vec![0..20, 20..40, 40..60];
        let rows: Vec<Vec<usize>> = runs.iter().map(|run| run.clone().collect()).collect();
        let control = permuted(&fit, &chosen, &[runs], &numbers).unwrap();
        let there = removed(&fit, &DMatrix::from_columns(&both[1..]), &rows).unwrap();
        assert!(control < 0.3 && there > 0.7, "{control} {there}");
    }
}
