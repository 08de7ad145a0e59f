//! Fit, evidence and stated deviations.

use super::{
    FITTED, World,
    effects::{Line, course},
    exact::{Exact, below, log_mean},
    normals,
};
use crate::{
    calibration::{Fit, FitOptions, Noise, fit},
    fit::{
        importance::sampled,
        maximum_a_posteriori::{fit_apart, fit_where_promising},
        score_test::scores,
        tuning::{SIZE_SCALES, WIDER_PRIOR, WRONG_PRIOR},
        ways::Ways,
    },
};
use nalgebra::{DMatrix, DVector};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

fn fitted<T>(world: &World, terms: &[usize], y: &[f64], then: impl FnOnce(&Fit) -> T) -> T {
    fitted_from(0.0, world, terms, y, then)
}

/// A fit that starts with all numbers `start` standard deviations off.
fn fitted_from<T>(start: f64, world: &World, terms: &[usize], y: &[f64], then: impl FnOnce(&Fit) -> T) -> T {
    world.search(y, |search, _| {
        let model = search.model(terms);
        then(&fit(&model, search.whitener, &vec![start; model.parameters.len()], &FitOptions::default()).unwrap())
    })
}

/// Three terms under coloured noise in two runs.
fn coloured() -> (World, Vec<f64>) {
    let mut world = World::new(2, 24, &[0.5, 1.0, 3.0]);
    world.noise = Noise { white_sd: 0.6, ar_sd: 0.8, ar_correlation: 0.7 };
    let y = world.drawn(&[0, 1, 2], &[0.7, -1.2, 0.4], &mut ChaCha8Rng::seed_from_u64(3));
    (world, y)
}

#[test]
fn posterior_and_evidence_are_those_of_the_covariance_of_all_rows() {
    let (world, y) = coloured();
    let exact = world.exact(&[0, 1, 2], &y);
    let (mean, covariance) = (exact.mean(), exact.covariance());
    for start in [0.0, 2.0] {
        fitted_from(start, &world, &[0, 1, 2], &y, |fit| {
            for k in 0..3 {
                approx::assert_abs_diff_eq!(fit.z[k], mean[k], epsilon = FITTED);
                approx::assert_relative_eq!(fit.sd[k], covariance[(k, k)].sqrt(), max_relative = FITTED);
            }
            approx::assert_relative_eq!(fit.log_evidence, exact.log_evidence(), max_relative = FITTED);
            approx::assert_relative_eq!(fit.objective(), exact.objective(), max_relative = FITTED);
        });
    }
}

#[test]
fn scores_are_those_of_the_covariance_of_all_rows() {
    let (world, y) = coloured();
    let exact = world.exact(&[0, 2], &y);
    let b = course(3, world.rows());
    let (score, variance) = exact.score(&DVector::from_column_slice(&b));
    let whitened = world.whitener(1.0).matrix(vec![b]);
    fitted(&world, &[0, 2], &y, |fit| {
        let found = scores(&fit.linearised(), &whitened);
        approx::assert_relative_eq!(found.scores[0], score, max_relative = FITTED);
        approx::assert_relative_eq!(found.covariance[(0, 0)], variance, max_relative = FITTED);
        assert_eq!(found.joint().freedom, 1);
        approx::assert_relative_eq!(found.joint().statistic, score * score / variance, max_relative = FITTED);
    });
}

#[test]
fn an_open_size_has_the_evidence_of_all_its_scales() {
    let mut world = World::new(1, 40, &[1.0]);
    world.terms[0].foreseen = false;
    for truth in [0.0, 0.05, 0.6, 4.0] {
        let y = world.drawn(&[0], &[truth], &mut ChaCha8Rng::seed_from_u64(5));
        let of = |scale: f64| {
            let columns = world.columns(&[0]) * scale;
            Exact::new(world.noise_covariance(), columns, DVector::from_column_slice(&y)).log_evidence()
        };
        let exact = log_mean(&SIZE_SCALES.map(of));
        fitted(&world, &[0], &y, |fit| approx::assert_abs_diff_eq!(fit.log_evidence, exact, epsilon = 1e-4));
    }
}

/// Evidence of a size that cannot be negative, beside another: the Gaussian's, times the share of the posterior above 0 over that of the prior.
fn one_sided(exact: &Exact) -> f64 {
    exact.log_evidence() + (below(exact.mean()[0] / exact.covariance()[(0, 0)].sqrt()) / 0.5).ln()
}

#[test]
fn a_size_of_one_sign_has_twice_the_evidence_or_next_to_none() {
    let mut world = World::new(1, 40, &[1.0, 1.0]);
    world.terms[0].one_sided = true;
    for truth in [2.0, 0.2, -0.3] {
        let y = world.drawn(&[0, 1], &[truth, 1.0], &mut ChaCha8Rng::seed_from_u64(9));
        let exact = one_sided(&world.exact(&[0, 1], &y));
        fitted(&world, &[0, 1], &y, |fit| approx::assert_abs_diff_eq!(fit.log_evidence, exact, epsilon = 1e-3));
    }
}

/// Soft and stiff directions together, one of them bounded.
#[test]
fn sampled_evidence_is_that_of_the_covariance_and_counts_the_mass_of_the_prior() {
    let mut world = World::new(1, 40, &[0.3, 0.2, 30.0]);
    world.terms[0].one_sided = true;
    for truth in [1.0, -0.5] {
        let y = world.drawn(&[0, 1, 2], &[truth, 0.5, 0.2], &mut ChaCha8Rng::seed_from_u64(2));
        let exact = one_sided(&world.exact(&[0, 1, 2], &y));
        let found = world.search(&y, |search, _| {
            let model = search.model(&[0, 1, 2]);
            let best = fit(&model, search.whitener, &[0.1, 0.0, 0.0], &FitOptions::default()).unwrap();
            sampled(&model, search.whitener, &best, 4000, 0.0, 1).unwrap()
        });
        // 4000 draws of an effective share above 0.2: three standard errors of the mean weight are below 0.1
        assert!(found.effective_share > 0.2, "{found:?}");
        assert!((found.log_evidence - exact).abs() < 0.1, "{found:?} {exact}");
    }
}

/// A quarter of the draws has to do where the log evidence is known well enough after it: by the error of a mean of weights, of which a share is effective.
#[test]
fn a_quarter_of_the_draws_does_where_the_evidence_is_known_well_enough() {
    let mut world = World::new(1, 40, &[0.3, 0.2, 30.0]);
    world.terms[0].one_sided = true;
    let y = world.drawn(&[0, 1, 2], &[1.0, 0.5, 0.2], &mut ChaCha8Rng::seed_from_u64(2));
    world.search(&y, |search, _| {
        let model = search.model(&[0, 1, 2]);
        let best = fit(&model, search.whitener, &[0.1, 0.0, 0.0], &FitOptions::default()).unwrap();
        let of = |draws: usize, enough: f64| sampled(&model, search.whitener, &best, draws, enough, 1).unwrap();
        // draws are the same from the first on
        let (all, quarter) = (of(4 * 200, 0.0), of(200, 0.0));
        assert_ne!(all, quarter);
        let error = ((1.0 / quarter.effective_share - 1.0) / 200.0).sqrt();
        assert_eq!(of(4 * 200, 1.001 * error), quarter);
        assert_eq!(of(4 * 200, 0.999 * error), all);
    });
}

/// A straight step of a linear model leads to its optimum, and promises what is left there.
#[test]
fn a_search_begins_where_a_straight_step_promises_what_is_wanted() {
    let (world, y) = coloured();
    let left = world.exact(&[0, 1, 2], &y).objective();
    world.search(&y, |search, _| {
        let model = search.model(&[0, 1, 2]);
        let of = |level: f64| {
            let options = FitOptions::default();
            fit_where_promising(&model, search.whitener, &[2.0; 3], &model.bounds(), &options, level).unwrap()
        };
        assert!(of(left - 1e-3).is_none());
        approx::assert_relative_eq!(of(left + 1e-3).unwrap().objective(), left, max_relative = FITTED);
    });
}

/// The first step of a linear model leads to its optimum from wherever it starts: the second search is given up there, and one from the start of the first at once.
#[test]
fn a_search_that_comes_where_another_has_been_is_given_up() {
    let (world, y) = coloured();
    world.search(&y, |search, _| {
        let model = search.model(&[0, 1, 2]);
        let from = |start: f64, been: &mut Ways| {
            fit_apart(&model, search.whitener, &[start; 3], None, &FitOptions::default(), false, been).unwrap()
        };
        let mut been = Ways::default();
        assert!(from(2.0, &mut been).is_some());
        assert!(from(2.0, &mut been).is_none());
        // one step to the optimum, where the first was after one step
        assert!(from(-1.0, &mut been).is_none());
        assert!(from(-1.0, &mut Ways::default()).is_some());
    });
}

/// Derivatives by two of three numbers are known beforehand, a hundredth too large: good enough for a model that cannot win where its first step gains next to nothing, and computed again where it gains.
#[test]
fn derivatives_of_a_model_that_cannot_win_stay_as_known_where_nothing_is_gained() {
    let (world, y) = coloured();
    world.search(&y, |search, _| {
        let model = search.model(&[0, 1, 2]);
        let best = fit(&model, search.whitener, &[0.0; 3], &FitOptions::default()).unwrap();
        let known = best.jacobian.columns(0, 2) * 1.01;
        let first = |off: f64, hopeless: bool| {
            let start: Vec<f64> = best.z.iter().map(|z| z + off).collect();
            let (options, mut been) = (FitOptions::default(), Ways::default());
            let found = fit_apart(&model, search.whitener, &start, Some(&known), &options, hopeless, &mut been).unwrap().unwrap();
            found.jacobian.columns(0, 2).norm() / best.jacobian.columns(0, 2).norm()
        };
        approx::assert_relative_eq!(first(1e-3, true), 1.01, max_relative = FITTED);
        approx::assert_relative_eq!(first(1e-3, false), 1.0, max_relative = FITTED);
        approx::assert_relative_eq!(first(2.0, true), 1.0, max_relative = FITTED);
    });
}

/// The exact evidence is a mean of two Gaussians', over the density of the prior at its centre.
#[test]
fn a_number_of_the_base_model_may_be_grossly_wrong_at_the_stated_odds() {
    let mut world = World::new(1, 60, &[]);
    world.line = Line::with(vec![(2.0, course(0, 60))]);
    for truth in [0.0, 1.0, 2.5, 5.0, 12.0] {
        let y = world.drawn(&[], &[truth], &mut ChaCha8Rng::seed_from_u64(4));
        let of = |width: f64| {
            let columns = world.columns(&[]) * width;
            Exact::new(world.noise_covariance(), columns, DVector::from_column_slice(&y)).log_evidence()
        };
        let (right, wrong) = ((1.0 - WRONG_PRIOR).ln() + of(1.0), WRONG_PRIOR.ln() + of(WIDER_PRIOR));
        let centre = (1.0 - WRONG_PRIOR + WRONG_PRIOR / WIDER_PRIOR).ln();
        let exact = log_mean(&[right, wrong]) + 2f64.ln() - centre;
        // Laplace takes the prior as Gaussian over the posterior's deviation of 0.1: curvatures of up to 2 over a variance of 0.01
        fitted(&world, &[], &y, |fit| approx::assert_abs_diff_eq!(fit.log_evidence, exact, epsilon = 0.02));
    }
}

#[test]
fn stated_deviations_cover_what_they_say() {
    let world = World::new(1, 30, &[0.3, 1.0, 2.0]);
    let random = &mut ChaCha8Rng::seed_from_u64(17);
    let (mut squares, mut inside) = (0.0, 0);
    let draws = 300;
    for _ in 0..draws {
        let truth: [f64; 3] = normals(random);
        let y = world.drawn(&[0, 1, 2], &truth, random);
        fitted(&world, &[0, 1, 2], &y, |fit| {
            for ((z, truth), sd) in fit.z.iter().zip(truth).zip(&fit.sd) {
                let off = (z - truth) / sd;
                squares += off * off;
                inside += usize::from(off.abs() < 1.96);
            }
        });
    }
    let count = f64::from(3 * draws);
    // of 900: the mean square scatters by sqrt(2 / 900) = 0.047, the share inside by 0.0073; four of these
    assert!((squares / count - 1.0).abs() < 0.19, "{}", squares / count);
    assert!((inside as f64 / count - 0.95).abs() < 0.03, "{}", inside as f64 / count);
}

/// Two columns that are nearly alike: what is known of one is known beside the other.
#[test]
fn numbers_that_stand_in_for_one_another_are_less_sure() {
    let mut world = World::new(1, 40, &[1.0, 1.0]);
    let alike: Vec<f64> = world.terms[0].column.iter().zip(course(4, 40)).map(|(a, b)| a + 0.05 * b).collect();
    world.terms[1].column = std::sync::Arc::new(alike);
    let y = world.drawn(&[0, 1], &[1.0, -1.0], &mut ChaCha8Rng::seed_from_u64(6));
    let exact = world.exact(&[0, 1], &y);
    let alone = 1.0 / (1.0 + world.columns(&[0]).norm_squared()).sqrt();
    fitted(&world, &[0, 1], &y, |fit| {
        approx::assert_relative_eq!(fit.sd[0], exact.covariance()[(0, 0)].sqrt(), max_relative = FITTED);
        assert!(fit.sd[0] > 3.0 * alone, "{} {alone}", fit.sd[0]);
        let hessian = exact.covariance().try_inverse().unwrap();
        let known: DMatrix<f64> = &fit.hessian - hessian;
        assert!(known.norm() < 1e-4 * fit.hessian.norm());
    });
}
