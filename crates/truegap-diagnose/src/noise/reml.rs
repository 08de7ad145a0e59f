//! Restricted maximum likelihood of white plus autoregressive noise in blocks whose slow course is taken out.
//!
//! Limits: a grid over correlation and share, which is finer than the data can tell.
//!
//! **Source:** Patterson & Thompson, Biometrika 58 (1971) 545.

use crate::{
    noise::{
        slow_parts::slow_parts,
        tuning::{FEWEST_BLOCKS, OUTLYING_BLOCK, WORTH_A_PARAMETER},
    },
    whitening::whitener::{InputError, Noise, Whitener},
};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;

/// Rows that share one slow course.
pub struct Block {
    /// rows of the recording
    pub rows: Vec<usize>,
    /// columns of the slow course, each as long as `rows`
    course: Vec<Vec<f64>>,
    /// whether neighbouring rows follow one another in time
    ordered: bool,
}

impl Block {
    /// A stretch at rest: constant, line, parabola and the logarithm of dwell are taken out.
    pub fn at_rest(rows: Range<usize>) -> Self {
        let n = rows.len() as f64;
        let dwell = |i: usize| (1.0 + i as f64).ln();
        Self::with(rows, move |i| vec![1.0, i as f64 / n, (i as f64 / n).powi(2), dwell(i)], true)
    }

    /// A short stretch: a cubic is taken out. What is correlated over more than a few rows goes with it.
    pub fn stretch(rows: Range<usize>) -> Self {
        let n = rows.len() as f64;
        Self::with(rows, move |i| (0..4).map(|k| (i as f64 / n).powi(k)).collect(), true)
    }

    /// Rows at the same inputs: their mean is taken out.
    pub fn replicate(rows: Vec<usize>) -> Self {
        Self { course: vec![vec![1.0; rows.len()]], rows, ordered: false }
    }

    /// Rows in any order, with the columns that are taken out of them.
    pub fn unordered(rows: Vec<usize>, course: Vec<Vec<f64>>) -> Self {
        Self { rows, course, ordered: false }
    }

    fn with(rows: Range<usize>, course: impl Fn(usize) -> Vec<f64>, ordered: bool) -> Self {
        let table: Vec<Vec<f64>> = (0..rows.len()).map(&course).collect();
        let columns = table.first().map_or(0, Vec::len);
        let course = (0..columns).map(|k| table.iter().map(|row| row[k]).collect()).collect();
        Self { rows: rows.collect(), course, ordered }
    }

    /// Columns of the slow course; of rows in any order orthonormal where [`crate::noise::neighbours`] made them.
    pub(crate) fn course(&self) -> &[Vec<f64>] {
        &self.course
    }

    /// Keeps the first rows only.
    pub fn truncate(&mut self, rows: usize) {
        self.rows.truncate(rows);
        self.course.iter_mut().for_each(|c| c.truncate(rows));
    }
}

/// Sums over blocks at one correlation and share: residual squares, log determinants, degrees of freedom.
#[derive(Default)]
struct Sums {
    squares: f64,
    log_determinant: f64,
    freedom: f64,
}

impl Sums {
    /// Log likelihood with the scale profiled out.
    fn log_likelihood(&self) -> f64 {
        -0.5 * (self.freedom * (self.squares / self.freedom).ln() + self.log_determinant)
    }
}

/// Blocks whose scatter is not far above that of the others: a jump or a burst inside a stretch at rest is no noise.
pub fn without_outliers(response: &[f64], blocks: Vec<Block>) -> Vec<Block> {
    let scatter = |block: &Block| {
        let sums = sums(response, std::slice::from_ref(block), &WHITE, 0.0);
        sums.squares / sums.freedom.max(1.0)
    };
    let all: Vec<f64> = blocks.iter().map(scatter).collect();
    let mut sorted = all.clone();
    sorted.sort_by(f64::total_cmp);
    let Some(median) = sorted.get(sorted.len() / 2).copied().filter(|_| sorted.len() >= FEWEST_BLOCKS) else { return blocks };
    blocks.into_iter().zip(all).filter(|(_, scatter)| *scatter <= OUTLYING_BLOCK * median).map(|(block, _)| block).collect()
}

/// Noise of `response` in these blocks, and the relative standard deviation of its weight in the mean of many rows: how far the noises that the blocks
/// allow differ there.
pub fn estimate(response: &[f64], blocks: &[Block]) -> (Noise, f64) {
    let ordered = blocks.iter().any(|b| b.ordered);
    let white = sums(response, blocks, &WHITE, 0.0);
    let of_white = OneMemory {
        log_likelihood: white.log_likelihood(),
        correlation: 0.0,
        share: 0.0,
        variance: white.squares / white.freedom.max(1.0),
    };
    let mut allowed = vec![(of_white.log_likelihood, of_white.variance)];
    let mut best = OneMemory { log_likelihood: of_white.log_likelihood + WORTH_A_PARAMETER, ..of_white };
    let coloured = if ordered { of_one_memory(response, blocks) } else { Vec::new() };
    for one in coloured {
        allowed.push((one.log_likelihood, one.level()));
        if one.log_likelihood > best.log_likelihood {
            best = one;
        }
    }
    if !best.variance.is_finite() {
        best.variance = 0.0;
    }
    (best.noise(), spread(&allowed, best.level()).hypot((2.0 / white.freedom.max(1.0)).sqrt()))
}

/// White noise with noise of one memory, as loud as blocks have it.
#[derive(Clone, Copy)]
pub(super) struct OneMemory {
    /// log likelihood in the blocks
    pub log_likelihood: f64,
    correlation: f64,
    /// share of the variance that has the memory
    share: f64,
    variance: f64,
}

impl OneMemory {
    pub fn noise(&self) -> Noise {
        let Self { correlation, share, variance, .. } = *self;
        Noise { white_sd: (variance * (1.0 - share)).sqrt(), ar_sd: (variance * share).sqrt(), ar_correlation: correlation }
    }

    /// Weight in the mean of many rows.
    fn level(&self) -> f64 {
        let Self { correlation, share, variance, .. } = *self;
        variance * (1.0 - share + share * (1.0 + correlation) / (1.0 - correlation))
    }
}

/// Noises of one memory that are tried.
pub(super) fn of_one_memory(response: &[f64], blocks: &[Block]) -> Vec<OneMemory> {
    let correlations = [0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.88, 0.94, 0.97];
    let shares = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];
    let one = |(correlation, share): (f64, f64)| {
        let (log_likelihood, variance) = likelihood(response, blocks, &mixed(correlation, share), 0.0);
        OneMemory { log_likelihood, correlation, share, variance }
    };
    correlations.into_iter().flat_map(|correlation| shares.map(|share| one((correlation, share)))).collect()
}

/// Relative root mean square by which levels, weighted by their likelihood, differ from `chosen`.
fn spread(allowed: &[(f64, f64)], chosen: f64) -> f64 {
    let best = allowed.iter().map(|a| a.0).fold(f64::NEG_INFINITY, f64::max);
    let (mut weights, mut squares) = (0.0, 0.0);
    for (log, level) in allowed {
        let weight = (log - best).exp();
        weights += weight;
        squares += weight * (level / chosen - 1.0).powi(2);
    }
    if weights > 0.0 && squares.is_finite() { (squares / weights).sqrt() } else { 0.0 }
}

/// White noise of unit variance.
pub(super) const WHITE: Noise = Noise { white_sd: 1.0, ar_sd: 0.0, ar_correlation: 0.0 };

/// White and autoregressive noise of unit variance together.
pub(super) fn mixed(correlation: f64, share: f64) -> Noise {
    Noise { white_sd: (1.0 - share).sqrt(), ar_sd: share.sqrt(), ar_correlation: correlation }
}

/// Log likelihood of `response` in these blocks under `noise` with its scale profiled out, and that scale's variance; `slow` is the variance of each part of slow
/// noise beside it.
pub(super) fn likelihood(response: &[f64], blocks: &[Block], noise: &Noise, slow: f64) -> (f64, f64) {
    let sums = sums(response, blocks, noise, slow);
    (sums.log_likelihood(), sums.squares / sums.freedom.max(1.0))
}

/// Sums with `slow` as the variance of each part of slow noise.
fn sums(response: &[f64], blocks: &[Block], noise: &Noise, slow: f64) -> Sums {
    let mut total = Sums::default();
    for block in blocks {
        let n = block.rows.len();
        let lasting = if slow > 0.0 { slow_parts(n, slow) } else { Vec::new() };
        let input = InputError { lasting, ..InputError::white(vec![0.0; n]) };
        let filter = Whitener::new(noise, &input, None, std::slice::from_ref(&(0..n)), None);
        let white = |column: Vec<f64>| {
            let mut column = column;
            filter.apply(&mut column);
            DVector::from_vec(column)
        };
        let mean = block.rows.iter().map(|r| response[*r]).sum::<f64>() / n as f64;
        let y = white(block.rows.iter().map(|r| response[*r] - mean).collect());
        let course: Vec<DVector<f64>> = block.course.iter().map(|c| white(c.clone())).collect();
        let columns = DMatrix::from_columns(&course);
        let gram = columns.tr_mul(&columns);
        let Some(factor) = gram.cholesky() else { continue };
        let fitted = factor.solve(&columns.tr_mul(&y));
        total.squares += (&y - &columns * fitted).norm_squared();
        total.log_determinant += filter.log_determinant + 2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>();
        total.freedom += (n - block.course.len()) as f64;
    }
    total
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_distr::Distribution;

    fn simulated(white: f64, ar: f64, correlation: f64, n: usize) -> Vec<f64> {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(7);
        let unit = rand_distr::Normal::new(0.0, 1.0).unwrap();
        let mut state = ar * unit.sample(&mut rng);
        (0..n)
            .map(|i| {
                state = correlation * state + ar * (1.0 - correlation * correlation).sqrt() * unit.sample(&mut rng);
                let slow = (i as f64 / n as f64).powi(2);
                slow + state + white * unit.sample(&mut rng)
            })
            .collect()
    }

    #[test]
    fn both_parts_of_the_noise_are_found_beside_a_slow_course() {
        let y = simulated(0.4, 0.3, 0.7, 3000);
        let (found, uncertainty) = estimate(&y, &[Block::at_rest(0..3000)]);
        // the level of correlated noise is known to 5 to 20 % from so many rows
        assert!((0.03..0.3).contains(&uncertainty), "{uncertainty}");
        // 3000 rows: total variance to 3 %, the split to about 15 %
        approx::assert_relative_eq!(found.white_sd.hypot(found.ar_sd), 0.5, max_relative = 0.06);
        approx::assert_relative_eq!(found.ar_sd, 0.3, max_relative = 0.35);
        assert!((0.4..=0.9).contains(&found.ar_correlation), "{found:?}");
    }

    #[test]
    fn white_noise_is_called_white() {
        let (found, _) = estimate(&simulated(0.4, 0.0, 0.0, 800), &[Block::at_rest(0..800)]);
        assert_eq!(found.ar_sd, 0.0);
        approx::assert_relative_eq!(found.white_sd, 0.4, max_relative = 0.08);
    }
}
