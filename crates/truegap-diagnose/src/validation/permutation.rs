//! A control of equal freedom: the same added columns, driven by a history that is not the recording's.
//!
//! Limits: linear about the fit; what a permuted history removes on runs left out is what freedom alone can do.

use crate::{
    fit::optimum::Fit,
    validation::cross_validation::parts,
    validation::tuning::{PERMUTATIONS, THERE},
};
use nalgebra::{Cholesky, DMatrix, DVector};
use rand::{RngExt, SeedableRng, seq::SliceRandom};
use rand_chacha::ChaCha8Rng;
use std::ops::Range;

/// Share of the misfit on parts left out that columns of equal freedom remove when their history is permuted: median over permutations.
///
/// `base` and `chosen` are fits of the same whitened rows, `chosen` with more columns behind those of `base`; `runs` and `numbers` as in
/// [`parts`]. `None` where nothing was added, or the base model leaves nothing above the noise.
pub fn permuted(base: &Fit, chosen: &Fit, runs: &[Range<usize>], numbers: &[u32]) -> Option<f64> {
    let first = base.jacobian.ncols();
    let added = chosen.jacobian.columns(first, chosen.jacobian.ncols() - first).into_owned();
    if added.ncols() == 0 {
        return None;
    }
    let (_, parts) = parts(runs, numbers);
    let rows: Vec<Vec<usize>> = parts.iter().map(|p| p.rows.iter().cloned().flatten().collect()).collect();
    let mut random = ChaCha8Rng::seed_from_u64(19);
    let mut removed: Vec<f64> =
        (0..PERMUTATIONS).filter_map(|_| removed(base, &permute(&added, runs, &mut random), &rows)).collect();
    removed.sort_by(f64::total_cmp);
    removed.get(removed.len() / 2).copied()
}

/// Columns with their runs exchanged, each stretched to its new run and turned about by a tenth or more of its length: runs that repeat one another would
/// otherwise stand in for one another.
fn permute(columns: &DMatrix<f64>, runs: &[Range<usize>], random: &mut ChaCha8Rng) -> DMatrix<f64> {
    let mut source: Vec<usize> = (0..runs.len()).collect();
    while runs.len() > 1 && source.iter().enumerate().any(|(i, s)| i == *s) {
        source.shuffle(random);
    }
    let mut turned = columns.clone();
    for (run, from) in runs.iter().zip(&source) {
        let from = &runs[*from];
        let offset: f64 = random.random_range(0.1..0.9);
        for (k, row) in run.clone().enumerate() {
            let place = (k as f64 / run.len() as f64 + offset).fract() * from.len() as f64;
            turned.row_mut(row).copy_from(&columns.row(from.start + (place as usize).min(from.len() - 1)));
        }
    }
    turned
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
