//! Unmodelled causes, weighed as the covariance of what they add.

use super::{
    World,
    exact::{Exact, log_mean},
};
use crate::selection::{
    posterior::select,
    tuning::{LENGTHS, NUMBER_PRIOR, UNMODELLED_PRIOR},
    unmodelled::{Cause, Causes},
};
use nalgebra::{DMatrix, DVector};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

const ROWS: usize = 64;

/// Covariance of a zero that wanders from row to row: the time that both rows have behind them.
fn brownian() -> DMatrix<f64> {
    DMatrix::from_fn(ROWS, ROWS, |i, j| i.min(j) as f64)
}

/// Evidence of additions with this covariance, its size unknown, over none.
fn added(covariance: &DMatrix<f64>, y: &[f64], temper: f64) -> f64 {
    let of = |length: f64| one_more(&(covariance * (length * length / covariance.trace())), y, temper);
    log_mean(&LENGTHS.map(of))
}

/// One term that does not act, and a zero that wanders.
#[test]
fn odds_of_an_unmodelled_cause_are_those_of_its_covariance() {
    let world = World::new(1, ROWS, &[4.0]);
    let random = &mut ChaCha8Rng::seed_from_u64(77);
    let mut y = world.drawn(&[], &[], random);
    let mut zero = 0.0;
    for (row, y) in y.iter_mut().enumerate() {
        zero += if row % 2 == 0 { 0.12 * super::normals::<1>(random)[0] } else { 0.0 };
        *y += zero;
    }
    for slack in [1.0, 1.7] {
        let (odds, agrees) = world.search(&y, |search, tests| {
            let selection = select(search, tests, search.base().unwrap());
            let causes = Causes::new(search.problem, search.whitener);
            let with = selection.with_unmodelled(&causes, &search.library, slack);
            let beside_base = |c: &Cause| with.unmodelled.iter().find(|(u, _)| u.cause == *c && u.effects.is_empty()).unwrap().1;
            (
                [Cause::WanderingZero, Cause::Jump].map(|c| beside_base(&c)),
                with.probability_agrees() - with.probability_none() * (1.0 - with.probability_unmodelled()),
            )
        });
        let weight = |exact: Exact, count: usize| exact.log_evidence() / slack + NUMBER_PRIOR[count].ln();
        let inside = log_mean(&[weight(world.exact(&[], &y), 0), weight(world.exact(&[0], &y), 1)]) + 2f64.ln();
        // beside the base model an unmodelled cause is one thing more, and each of the two has half of what unmodelled causes are worth
        let prior = NUMBER_PRIOR[1].ln() + (UNMODELLED_PRIOR / 2.0).ln();
        let base = world.exact(&[], &y).log_evidence() / slack;
        let exact = base + prior + added(&brownian(), &y, slack) - inside;
        assert!((odds[0].ln() - exact).abs() < 1e-3, "{} {exact}", odds[0].ln());
        let jump = |from: usize| DVector::from_fn(ROWS, |row, _| f64::from(u8::from(row >= from)));
        let turns = (1..64).map(|k| {
            let of = |length: f64| {
                let column = jump(k);
                let covariance = &column * column.transpose() / column.norm_squared() * (length * length);
                one_more(&covariance, &y, slack)
            };
            LENGTHS.map(of)
        });
        let by_length: Vec<[f64; 6]> = turns.collect();
        let each: Vec<f64> = (0..6).map(|l| log_mean(&by_length.iter().map(|t| t[l]).collect::<Vec<_>>())).collect();
        let exact = base + prior + log_mean(&each) - inside;
        assert!((odds[1].ln() - exact).abs() < 1e-3, "jump {} {exact}", odds[1].ln());
        assert!(agrees.abs() < 1e-9, "{agrees}");
    }
}

/// Evidence of additions with this covariance over none, at noise of `temper` times the variance; lengths count in units of that noise.
fn one_more(covariance: &DMatrix<f64>, y: &[f64], temper: f64) -> f64 {
    let y = DVector::from_column_slice(y) / temper.sqrt();
    let factor = (covariance + DMatrix::identity(ROWS, ROWS)).cholesky().unwrap();
    let log_det: f64 = factor.l_dirty().diagonal().iter().map(|d| 2.0 * d.ln()).sum();
    0.5 * y.norm_squared() - 0.5 * y.dot(&factor.solve(&y)) - 0.5 * log_det
}

/// A strong term, and a zero that wanders beside it: a little is what a wrong form leaves, much is another cause.
#[test]
fn beside_a_model_an_unmodelled_cause_has_to_be_more_than_a_wrong_form_leaves() {
    let world = World::new(1, ROWS, &[4.0]);
    let beside_the_term = |step: f64| {
        let random = &mut ChaCha8Rng::seed_from_u64(77);
        let mut y = world.drawn(&[0], &[0.5], random);
        let mut zero = 0.0;
        for y in y.chunks_mut(2) {
            zero += step * super::normals::<1>(random)[0];
            y.iter_mut().for_each(|y| *y += zero);
        }
        world.search(&y, |search, tests| {
            let selection = select(search, tests, search.base().unwrap());
            let causes = Causes::new(search.problem, search.whitener);
            let with = selection.with_unmodelled(&causes, &search.library, 1.0);
            with.unmodelled.iter().filter(|(u, _)| u.cause == Cause::WanderingZero && !u.effects.is_empty()).count()
        })
    };
    assert_eq!((beside_the_term(0.15), beside_the_term(3.0)), (0, 1));
}
