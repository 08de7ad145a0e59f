//! How much less evidence counts where equations may be off.

use super::{
    World,
    exact::{Exact, log_mean},
};
use crate::{
    fit::{score_test::JointTest, tuning::SIZE_SCALES},
    selection::{
        candidates::Tried,
        posterior::select,
        tempering::temper_of,
        tuning::{ABSORBED_PART, FORM_ERROR, FORM_SHAPES, NUMBER_PRIOR},
    },
};
use nalgebra::{DMatrix, DVector};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::sync::Arc;

/// Terms without a computation beforehand.
fn open() -> World {
    let mut world = World::new(1, 64, &[30.0, 30.0]);
    world.terms.iter_mut().for_each(|t| t.foreseen = false);
    // of a period between one and two stretches, so that calibration takes up part of their means and part of what is inside of them
    world.terms[0].column = Arc::new((0..64).map(|row| (0.5 * f64::from(row) + 1.0).cos()).collect());
    world
}

/// Base model and first term alone.
fn temper(world: &World, y: &[f64]) -> f64 {
    world.search(y, |search, tests| {
        let base = search.base().unwrap();
        let one = search.polished(&search.add_each(&base, &[0], 1, "test").pop().unwrap()).unwrap();
        let models: [Tried; 2] = [base, one];
        temper_of(models.iter(), &search.library, tests)
    })
}

/// Means over eight stretches of eight rows, as a quadratic form of the covariance of all rows: statistic less its freedom.
fn left_in_stretches(exact: &Exact) -> f64 {
    let cells = DMatrix::from_fn(64, 8, |row, cell| f64::from(u8::from(row / 8 == cell)));
    let (scores, covariance) = exact.scores(&cells);
    scores.dot(&covariance.cholesky().unwrap().solve(&scores)) - 8.0
}

#[test]
fn a_clear_signal_is_divided_by_what_a_wrong_form_would_leave_of_it() {
    let world = open();
    let y = world.drawn(&[0], &[0.08], &mut ChaCha8Rng::seed_from_u64(1));
    let signal = 2.0 * (world.exact(&[], &y).objective() - world.exact(&[0], &y).objective());
    let error = FORM_ERROR * FORM_ERROR * signal;
    assert!(error > 1.0 && error < ABSORBED_PART, "{error}");
    approx::assert_relative_eq!(temper(&world, &y), 1.0 + error / FORM_SHAPES, max_relative = 1e-4);
}

/// The second term acts too and is not in the model: how wrong the equations are shows in what is left.
#[test]
fn a_large_signal_is_divided_by_no_more_than_shows_in_what_is_left() {
    let world = open();
    let y = world.drawn(&[0, 1], &[5.0, 0.05], &mut ChaCha8Rng::seed_from_u64(1));
    let exact = world.exact(&[0], &y);
    let error = FORM_ERROR * FORM_ERROR * 2.0 * (world.exact(&[], &y).objective() - exact.objective());
    let left = left_in_stretches(&exact);
    assert!(left > 1.0 && ABSORBED_PART * left < error, "{left} {error}");
    approx::assert_relative_eq!(temper(&world, &y), 1.0 + ABSORBED_PART * left / FORM_SHAPES, max_relative = 1e-3);
}

#[test]
fn noise_that_may_be_louder_makes_a_test_weaker() {
    let test = JointTest { statistic: 30.0, freedom: 8, p_value: 2e-4 };
    let louder = test.over(1.5);
    // half an integer number of freedoms: the tail is exp(-x / 2) times a short series
    let tail = |x: f64| (-0.5 * x).exp() * (0..4).map(|k| (0.5 * x).powi(k) / [1.0, 1.0, 2.0, 6.0][k as usize]).sum::<f64>();
    approx::assert_relative_eq!(louder.p_value, tail(20.0), max_relative = 1e-9);
    approx::assert_relative_eq!(louder.excess(), 12.0, max_relative = 1e-12);
}

/// An open size against nothing: odds are those of the evidence over all scales to the power 1 / temper, and of the prior.
#[test]
fn differences_of_evidence_are_divided_and_those_of_priors_are_not() {
    let mut world = World::new(1, 64, &[30.0]);
    world.terms[0].foreseen = false;
    let y = world.drawn(&[0], &[0.03], &mut ChaCha8Rng::seed_from_u64(1));
    let selection = world.search(&y, |search, tests| select(search, tests, search.base().unwrap()));
    let of = |scale: f64| {
        let columns = world.columns(&[0]) * scale;
        Exact::new(world.noise_covariance(), columns, DVector::from_column_slice(&y)).log_evidence()
    };
    let gain = log_mean(&SIZE_SCALES.map(of)) - world.exact(&[], &y).log_evidence();
    let odds = (gain / selection.temper).exp() * NUMBER_PRIOR[1] / NUMBER_PRIOR[0];
    assert!(selection.temper > 1.01 && gain > 2.0, "{} {gain}", selection.temper);
    approx::assert_relative_eq!(selection.effect_probability[0], odds / (1.0 + odds), max_relative = 1e-4);
}
