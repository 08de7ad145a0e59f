//! Points that fill a cube evenly, the same for any number of threads.
//!
//! Limits: Owen-scrambled Sobol points come in independent batches of 65 536, so errors fall as 1/samples within a batch and as 1/sqrt(batches) beyond; coordinates have
//! 24 bits, so a normal quantity never lies further out than 5.4 standard deviations.

/// Points in a batch.
pub const BATCH: usize = 1 << 16;

/// Coordinate of a point, strictly between 0 and 1.
///
/// | argument    | meaning |
/// |-------------|---------|
/// | `seed`      | of the study |
/// | `point`     | from 0; every [`BATCH`] points begin a new, independent scramble |
/// | `dimension` | below 256 |
///
/// **Source:** Burley, Practical hash-based Owen scrambling, JCGT 9 (2020).
pub fn uniform(seed: u64, point: usize, dimension: usize) -> f64 {
    let batch = (point / BATCH) as u64;
    let scramble = (mix(seed ^ mix(batch)) >> 32) as u32;
    let value = sobol_burley::sample((point % BATCH) as u32, dimension as u32, scramble);
    f64::from(value) + 1.0 / f64::from(1 << 25)
}

/// A number whose bits depend on all bits of the argument.
///
/// **Source:** the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
pub(crate) fn mix(bits: u64) -> u64 {
    let z = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Quantile of the standard normal distribution.
///
/// **Source:** the inverse complementary error function of `statrs`. **Accuracy:** 1e-9, `quantiles_lead_back_to_their_probability`.
pub fn normal_quantile(probability: f64) -> f64 {
    -std::f64::consts::SQRT_2 * statrs::function::erf::erfc_inv(2.0 * probability)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_lead_back_to_their_probability() {
        for z in [-5.4, -3.0, -1.0, 0.0, 0.3, 2.0, 5.4] {
            let probability = 0.5 * statrs::function::erf::erfc(-z / std::f64::consts::SQRT_2);
            // a probability near 1 has no more digits than its rounding: 1e-16 / density
            let tolerance = 1e-9 + 1e-15 / (-0.5_f64 * z * z).exp();
            approx::assert_abs_diff_eq!(normal_quantile(probability), z, epsilon = tolerance);
        }
    }

    #[test]
    fn a_smooth_integral_is_found_much_better_than_by_chance() {
        // mean of 12 (x - 1/2)^2 (y - 1/2)^2 over the square is 1/12; chance would be off by about 7e-4
        let points = (0..BATCH).map(|i| [uniform(5, i, 0), uniform(5, i, 1)]);
        let mean = points.map(|[x, y]| 12.0 * (x - 0.5).powi(2) * (y - 0.5).powi(2)).sum::<f64>() / BATCH as f64;
        approx::assert_abs_diff_eq!(mean, 1.0 / 12.0, epsilon = 2e-6);
    }

    #[test]
    fn batches_and_seeds_differ() {
        assert_ne!(uniform(1, 0, 0), uniform(2, 0, 0));
        assert_ne!(uniform(1, 0, 0), uniform(1, BATCH, 0));
    }
}
