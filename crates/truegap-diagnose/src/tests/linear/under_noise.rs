//! A fit weighed under another noise than its own.

use super::World;
use crate::{calibration::Noise, fit::under_noise::UnderNoise};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Log density of a response by the covariance of its rows, but for the constant of the Gaussian.
fn exact(world: &World, terms: &[usize], y: &[f64]) -> f64 {
    let noise = world.noise_covariance().cholesky().unwrap();
    let log_determinant: f64 = noise.l_dirty().diagonal().iter().map(|d| 2.0 * d.ln()).sum();
    world.exact(terms, y).log_evidence() - 0.5 * log_determinant
}

#[test]
fn a_model_is_as_likely_under_another_noise_as_the_covariance_of_its_rows_has_it() {
    let sizes = [1.5, 0.8];
    let world = World::new(2, 40, &sizes);
    let y = world.drawn(&[0, 1], &[1.0, -0.7], &mut ChaCha8Rng::seed_from_u64(9));
    world.search(&y, |search, _| {
        let one = search.add_each(&search.base().unwrap(), &[0], 1, "test").pop().unwrap();
        let both = search.add_each(&one, &[1], 1, "test").pop().unwrap();
        let weighed = UnderNoise::of(&search.model(&both.effects), &both.fit).unwrap();
        for (white_sd, ar_sd, ar_correlation) in [(1.0, 0.0, 0.0), (0.6, 1.3, 0.9), (0.2, 2.0, 0.5)] {
            let other = World { noise: Noise { white_sd, ar_sd, ar_correlation }, ..World::new(2, 40, &sizes) };
            let (found, _) = weighed.log_density(&other.whitener(1.0));
            approx::assert_relative_eq!(found, exact(&other, &[0, 1], &y), max_relative = 1e-6);
        }
    });
}
