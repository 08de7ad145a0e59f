//! A whole diagnosis in the linear world: numbers as they are stated, in their units.

use super::{
    World,
    effects::{Line, course},
    exact::Exact,
};
use crate::{
    Library, Options, Problem, RecordingFacts, Verdict, answer::NoiseFacts, calibration::Noise, diagnose,
    selection::candidates::Progress,
};
use nalgebra::{DMatrix, DVector};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::sync::atomic::{AtomicBool, Ordering};

/// Covariance of slow noise of this standard deviation: four parts of one size, with memories of 1.5 x 8^k rows, of each run anew.
fn slow(run: &[u32], sd: f64) -> DMatrix<f64> {
    let alike = |i: usize, j: usize| (0..4).map(|k| (-(i.abs_diff(j) as f64) / (1.5 * 8_f64.powi(k))).exp() / 4.0).sum::<f64>();
    DMatrix::from_fn(run.len(), run.len(), |i, j| if run[i] == run[j] { sd * sd * alike(i, j) } else { 0.0 })
}

/// A level and one term, noise that is measured: values and deviations are those of the covariance of all rows at the noise that is stated.
#[test]
fn values_and_deviations_are_stated_in_their_units() {
    let mut world = World::new(6, 40, &[3.0, 3.0]);
    world.line = Line::with(vec![(5.0, course(4, 240))]);
    world.noise.white_sd = 0.2;
    let y = world.drawn(&[0], &[0.4, 0.5], &mut ChaCha8Rng::seed_from_u64(13));
    let library = world.terms.iter().fold(Library::empty(), |all, t| all.with(Box::new(t.clone())));
    let options = Options { library, compose: false, ..Options::default() };
    let problem = Problem { inputs: &world.inputs, response: &y, simulator: &world.line };
    let facts = RecordingFacts { rows: y.len(), runs: 6, ..RecordingFacts::default() };
    let found = diagnose(&problem, facts, &options, &|_| (), &AtomicBool::new(false)).unwrap().diagnosis;
    assert_eq!(found.verdict, Verdict::Explained, "{}", found.says);
    // nothing rests here, so that part of the term is taken for slow noise: deviations are right for the noise that is stated
    let NoiseFacts { white_sd, ar_sd, ar_correlation, lasting_sd, .. } = found.noise;
    world.noise = Noise { white_sd, ar_sd, ar_correlation };
    let exact = |terms: &[usize]| {
        let noise = world.noise_covariance() + slow(&world.inputs.run, lasting_sd);
        Exact::new(noise, world.columns(terms), DVector::from_column_slice(&y))
    };
    let (alone, exact) = (exact(&[]).mean()[0], exact(&[0]));
    let (mean, covariance) = (exact.mean(), exact.covariance());
    let (level, size) = (&found.base.parameters_after[0], &found.findings[0].parameters[0]);
    for (facts, k, unit) in [(level, 0, 5.0), (size, 1, 3.0)] {
        approx::assert_abs_diff_eq!(facts.value, unit * mean[k], epsilon = 0.02 * facts.sd);
        // the base model's prior is a little wider than its Gaussian, which 1 / sd^2 of some thousand does not feel
        approx::assert_relative_eq!(facts.sd_of_fit, unit * covariance[(k, k)].sqrt(), max_relative = 1e-3);
        // what else may act makes it wider
        assert!((1.0 - 1e-9..1.9).contains(&(facts.sd / facts.sd_of_fit)), "{} beside {}", facts.sd, facts.sd_of_fit);
    }
    let findings = found.findings.iter().chain(&found.carried).flat_map(|finding| &finding.parameters);
    for number in found.base.parameters.iter().chain(&found.base.parameters_after).chain(findings) {
        assert!(number.sd >= number.sd_of_fit * (1.0 - 1e-9) && number.sd_of_fit > 0.0, "{number:?}");
    }
    approx::assert_abs_diff_eq!(found.base.parameters[0].value, 5.0 * alone, epsilon = 0.02 * level.sd);
    let fit = &found.fit;
    let left = |p: &[f64]| p.iter().zip(&y).map(|(p, y)| (p - y).powi(2)).sum::<f64>() / y.len() as f64;
    let after: DVector<f64> = &exact.columns * &mean;
    approx::assert_relative_eq!(fit.in_sample.rmse_after, left(after.as_slice()).sqrt(), max_relative = 1e-4);
    let held = &fit.held_out;
    let [before, after] = [held.rmse_before.unwrap(), held.rmse_after.unwrap()].map(|e| e * e - fit.noise_floor.powi(2));
    approx::assert_relative_eq!(held.misfit_removed.unwrap(), 1.0 - after / before, max_relative = 1e-9);
}

/// A search that is ended in its midst has not seen all that it could have found, and says nothing of chance.
#[test]
fn a_permuted_search_that_was_ended_does_not_count() {
    let world = World::new(4, 24, &[3.0, 3.0]);
    let y = world.drawn(&[0], &[0.5], &mut ChaCha8Rng::seed_from_u64(14));
    let library = world.terms.iter().fold(Library::empty(), |all, t| all.with(Box::new(t.clone())));
    let options = Options { library, compose: false, permuted_searches: 3, ..Options::default() };
    let problem = Problem { inputs: &world.inputs, response: &y, simulator: &world.line };
    let stop = AtomicBool::new(false);
    let ended = |progress: Progress| {
        if progress.what == "2 of 3" {
            stop.store(true, Ordering::Relaxed);
        }
    };
    let found = diagnose(&problem, RecordingFacts::default(), &options, &ended, &stop).unwrap().diagnosis;
    assert_eq!(found.permuted_searches.unwrap().gains.len(), 1);
}
