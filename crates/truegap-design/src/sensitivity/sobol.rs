//! First-order and total Sobol indices of any function of a cube, with bootstrap intervals.
//!
//! Limits: independent inputs; rows with an answer that is not finite are left out and counted.

use crate::error::DesignError;
use crate::sample::{BATCH, mix, uniform};
use rayon::prelude::*;
use serde::Serialize;

/// How many evaluations, and which.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SobolOptions {
    /// rows; the function is evaluated rows x (inputs + 2) times
    pub rows: usize,
    /// resamples of the rows for the intervals
    pub resamples: usize,
    /// seed
    pub seed: u64,
}

impl Default for SobolOptions {
    fn default() -> Self {
        Self { rows: 8192, resamples: 200, seed: 1 }
    }
}

/// An index with its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Index {
    /// estimate from all rows
    pub value: f64,
    /// 2.5 % of the resamples lie below
    pub low: f64,
    /// 2.5 % of the resamples lie above
    pub high: f64,
}

/// Indices of `outputs` functions: `first[input][output]`, `total[input][output]`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Indices {
    /// share of the variance that goes when the input is known
    pub first: Vec<Vec<Index>>,
    /// share of the variance that stays when all other inputs are known
    pub total: Vec<Vec<Index>>,
    /// rows evaluated
    pub rows: usize,
    /// of these, left out because an answer was not finite
    pub refused: usize,
}

/// Values of one row: f(A), f(B), and f(A with column i of B) for each input.
type Row<const M: usize> = (Vec<[f64; M]>, [f64; M], [f64; M]);

/// Rows between two calls of whoever watches.
const WATCHED: usize = 512;

/// Sobol indices of `function` on the unit cube of `inputs` dimensions. `watch` is told how many rows are done; where it answers `false` these rows are all
/// there will be.
///
/// **Source:** sampling of Saltelli (2002); first order by Saltelli et al. (2010), total by Jansen (1999). **Accuracy:** the Ishigami function's indices lie in the intervals,
/// `the_indices_of_ishigamis_function_are_found`.
///
/// # Errors
/// [`DesignError::TooFewSamples`], [`DesignError::TooManySamples`], [`DesignError::Refused`] where more than 1 % of the rows have no answer.
pub(super) fn watched_indices<const M: usize>(
    function: impl Fn(&[f64]) -> [f64; M] + Sync,
    inputs: usize,
    options: SobolOptions,
    watch: impl Fn(usize) -> bool,
) -> Result<Indices, DesignError> {
    let SobolOptions { rows: samples, resamples, seed } = options;
    if samples < 64 {
        return Err(DesignError::TooFewSamples { samples, least: 64 });
    }
    if samples > BATCH {
        return Err(DesignError::TooManySamples { samples, most: BATCH });
    }
    let row = |point: usize| -> Row<M> {
        let a: Vec<f64> = (0..inputs).map(|d| uniform(seed, point, d)).collect();
        let b: Vec<f64> = (0..inputs).map(|d| uniform(seed, point, inputs + d)).collect();
        let mixed = |i: usize| function(&(0..inputs).map(|d| if d == i { b[d] } else { a[d] }).collect::<Vec<_>>());
        ((0..inputs).map(mixed).collect(), function(&a), function(&b))
    };
    let finite = |r: &Row<M>| r.0.iter().flatten().chain(&r.1).chain(&r.2).all(|v| v.is_finite());
    let (mut rows, mut done): (Vec<Row<M>>, usize) = (Vec::with_capacity(samples), 0);
    while done < samples {
        let next = (done + WATCHED).min(samples);
        rows.par_extend((done..next).into_par_iter().map(row).filter(finite));
        done = next;
        if !watch(done) {
            break;
        }
    }
    let samples = done;
    let refused = samples - rows.len();
    if refused * 100 > samples {
        return Err(DesignError::Refused { refused, samples });
    }
    let all: Vec<usize> = (0..rows.len()).collect();
    let again = |resample: usize| -> Vec<usize> {
        let draw = |k: usize| mix(mix(seed ^ 0x5eed ^ ((resample as u64) << 32)) ^ k as u64) as usize % rows.len();
        (0..rows.len()).map(draw).collect()
    };
    let resampled: Vec<_> = (0..resamples).into_par_iter().map(|r| estimate(&rows, &again(r), inputs)).collect();
    let whole = estimate(&rows, &all, inputs);
    let index = |i: usize, m: usize, which: usize| {
        let mut others: Vec<f64> = resampled.iter().map(|e| e[i][m][which]).collect();
        others.sort_unstable_by(f64::total_cmp);
        let value = whole[i][m][which];
        let quantile =
            |p: f64| others.get((p * others.len().saturating_sub(1) as f64).round() as usize).copied().unwrap_or(value);
        Index { value, low: quantile(0.025), high: quantile(0.975) }
    };
    let table = |which: usize| (0..inputs).map(|i| (0..M).map(|m| index(i, m, which)).collect()).collect();
    Ok(Indices { first: table(0), total: table(1), rows: samples, refused })
}

/// `[input][output][first, total]` from some rows.
fn estimate<const M: usize>(rows: &[Row<M>], chosen: &[usize], inputs: usize) -> Vec<[[f64; 2]; M]> {
    let count = chosen.len() as f64;
    let mut mean = [0.0; M];
    for &k in chosen {
        (0..M).for_each(|m| mean[m] += (rows[k].1[m] + rows[k].2[m]) / (2.0 * count));
    }
    let mut variance = [0.0; M];
    let mut sums = vec![[[0.0; 2]; M]; inputs];
    for &k in chosen {
        let (mixed, a, b) = &rows[k];
        for m in 0..M {
            variance[m] += ((a[m] - mean[m]).powi(2) + (b[m] - mean[m]).powi(2)) / 2.0;
            for i in 0..inputs {
                let moved = mixed[i][m] - a[m];
                sums[i][m][0] += (b[m] - mean[m]) * moved;
                sums[i][m][1] += 0.5 * moved * moved;
            }
        }
    }
    for row in &mut sums {
        (0..M).for_each(|m| row[m] = row[m].map(|s| if variance[m] > 0.0 { s / variance[m] } else { 0.0 }));
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn sobol_indices<const M: usize>(
        function: impl Fn(&[f64]) -> [f64; M] + Sync,
        inputs: usize,
        options: SobolOptions,
    ) -> Result<Indices, DesignError> {
        watched_indices(function, inputs, options, |_| true)
    }

    #[test]
    fn the_indices_of_ishigamis_function_are_found() {
        let (a, b) = (7.0, 0.1);
        let ishigami = |u: &[f64]| {
            let x: Vec<f64> = u.iter().map(|u| PI * (2.0 * u - 1.0)).collect();
            [x[0].sin() + a * x[1].sin().powi(2) + b * x[2].powi(4) * x[0].sin()]
        };
        let one = 0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2);
        let two = a * a / 8.0;
        let both = b * b * PI.powi(8) * (1.0 / 18.0 - 1.0 / 50.0);
        let variance = one + two + both;
        let known = [[one, one + both], [two, two], [0.0, both]].map(|pair| pair.map(|v| v / variance));
        let found = sobol_indices(ishigami, 3, SobolOptions::default()).unwrap();
        for (i, [first, total]) in known.into_iter().enumerate() {
            for (index, known) in [(found.first[i][0], first), (found.total[i][0], total)] {
                approx::assert_abs_diff_eq!(index.value, known, epsilon = 0.02);
                assert!(
                    index.low - 0.02 < known && known < index.high + 0.02 && index.low < index.high + 1e-12,
                    "{i}: {index:?} {known}"
                );
                // an index of the third input alone, 0, may have an end at its value
                assert!(known == 0.0 || (index.low < index.value && index.value < index.high), "{i}: {index:?}");
            }
        }
    }

    #[test]
    fn a_study_that_is_stopped_is_one_with_fewer_rows() {
        let function = |u: &[f64]| [u[0] + u[1] * u[1]];
        let options = SobolOptions { rows: 4096, resamples: 20, seed: 9 };
        let stopped = watched_indices(function, 2, options, |done| done < 1024).unwrap();
        assert_eq!(stopped, sobol_indices(function, 2, SobolOptions { rows: 1024, ..options }).unwrap());
    }

    #[test]
    fn the_number_of_threads_changes_nothing() {
        let function = |u: &[f64]| [u[0] + u[1] * u[1]];
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| sobol_indices(function, 2, SobolOptions { rows: 256, resamples: 20, seed: 9 }).unwrap())
        };
        assert_eq!(run(1), run(3));
    }
}
