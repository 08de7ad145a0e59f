//! Latin hypercube designs.
//!
//! Limits: random within the strata, not optimised for distance.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// `count` points in the unit cube, one in each of `count` slices of every axis.
///
/// **Source:** McKay, Beckman, Conover (1979).
pub fn latin_hypercube(count: usize, dimensions: usize, seed: u64) -> Vec<Vec<f64>> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut points = vec![vec![0.0; dimensions]; count];
    for d in 0..dimensions {
        let mut slices: Vec<usize> = (0..count).collect();
        for i in (1..count).rev() {
            slices.swap(i, rng.random_range(0..=i));
        }
        for (point, slice) in points.iter_mut().zip(slices) {
            point[d] = (slice as f64 + rng.random::<f64>()) / count as f64;
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_slice_of_every_axis_holds_one_point() {
        let points = latin_hypercube(37, 4, 2);
        for d in 0..4 {
            let mut slices: Vec<usize> = points.iter().map(|p| (p[d] * 37.0) as usize).collect();
            slices.sort_unstable();
            assert_eq!(slices, (0..37).collect::<Vec<_>>());
        }
    }
}
