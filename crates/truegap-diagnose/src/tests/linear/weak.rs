//! Numbers that a weak effect has moved: what fits alone state of them, and what is stated with weak effects counted in.

use super::{
    World,
    effects::{Line, course},
    normals,
};
use crate::{
    fit::score_test::scores,
    selection::{posterior::select, weak_effects::widened},
};
use nalgebra::DMatrix;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

const ROWS: usize = 240;
const DRAWS: usize = 60;

/// A base model whose one number takes up most of the first term: their courses differ by a third.
fn confused() -> World {
    let mut world = World::new(1, ROWS, &[10.0]);
    let own = course(0, ROWS).iter().zip(course(4, ROWS)).map(|(a, b)| a + 0.3 * b).collect();
    world.line = Line::with(vec![(50.0, own)]);
    world
}

/// The first term, so large that it stands `by` noise deviations out of what calibration of `still` leaves of it.
fn standing_out(world: &World, still: &[f64], by: f64) -> Vec<f64> {
    let unit = world.terms[0].of_one_deviation();
    // at the wanted size: first find out how far one unit of it stands out
    let size = world.search(still, |search, _| {
        let base = search.base().unwrap();
        let column = DMatrix::from_column_slice(ROWS, 1, search.whitener.matrix(vec![unit.clone()]).column(0).as_slice());
        by / scores(&base.fit.linearised(), &column).covariance[(0, 0)].sqrt()
    });
    unit.into_iter().map(|unit| size * unit).collect()
}

/// Shares of the draws in which the base model's number lies within 1.96 deviations: of the fit alone, and with weak effects counted in; the first term stands `by`
/// noise deviations out of what calibration leaves of it.
fn covered(by: f64) -> [f64; 2] {
    let world = confused();
    let random = &mut ChaCha8Rng::seed_from_u64(31);
    let mut held = [0, 0];
    for _ in 0..DRAWS {
        let [own] = normals(random);
        let still = world.drawn(&[], &[0.01 * own], random);
        let y: Vec<f64> = still.iter().zip(standing_out(&world, &still, by)).map(|(y, term)| y + term).collect();
        let within = world.search(&y, |search, lack_of_fit| {
            let selection = select(search, lack_of_fit, search.base().unwrap());
            let base = selection.base();
            let off = (base.fit.z[0] - 0.01 * own).abs();
            [base.fit.sd[0], widened(search, &selection, base, &base.fit.sd)[0]].map(|sd| off < 1.96 * sd)
        });
        held = [held[0] + usize::from(within[0]), held[1] + usize::from(within[1])];
    }
    held.map(|n| n as f64 / DRAWS as f64)
}

/// 60 draws: the share that an honest interval covers is 0.95 within 0.06.
#[test]
fn where_nothing_else_acts_a_fit_alone_covers_and_widening_costs_little() {
    let [alone, widened] = covered(0.0);
    assert!((0.88..1.0).contains(&alone) && widened >= alone, "{alone} {widened}");
}

/// Ten deviations off and more, where the fit alone is believed. What stands out by five noise deviations is all but known to act; by three it is an even chance that it
/// does, since one effect in twenty acts beforehand.
#[test]
fn a_number_that_a_weak_effect_has_moved_is_covered_as_far_as_the_effect_can_be_seen() {
    let [three, five] = [3.0, 5.0].map(covered);
    assert!(three[0] < 0.1 && five[0] < 0.1, "{three:?} {five:?}");
    assert!(three[1] > 0.35 && five[1] > 0.85, "{three:?} {five:?}");
}

/// Thirty noise deviations are known to be there, and move the number by as much as they can. Where evidence counts 900 times less they are one deviation, by which next to nothing is known.
#[test]
fn what_speaks_for_an_effect_counts_as_much_less_as_evidence_does() {
    let world = confused();
    let still = world.drawn(&[], &[0.0], &mut ChaCha8Rng::seed_from_u64(5));
    let y: Vec<f64> = still.iter().zip(standing_out(&world, &still, 30.0)).map(|(y, term)| y + term).collect();
    let added = world.search(&y, |search, lack_of_fit| {
        let mut selection = select(search, lack_of_fit, search.base().unwrap());
        let base = selection.base().clone();
        [1.0, 900.0].map(|temper| {
            selection.temper = temper;
            let known = base.fit.sd[0];
            (widened(search, &selection, &base, &base.fit.sd)[0].powi(2) - known.powi(2)).sqrt() / known
        })
    });
    // of a size that one deviation knows, one in twenty acts: some tenths of what 30 deviations did
    assert!(added[0] > 3.0 * added[1] && added[1] > 0.0, "{added:?}");
}

/// What is added is added to what is known otherwise.
#[test]
fn what_is_known_less_well_is_told_less_well() {
    let world = confused();
    let y = world.drawn(&[], &[0.0], &mut ChaCha8Rng::seed_from_u64(5));
    let [once, thrice] = world.search(&y, |search, lack_of_fit| {
        let selection = select(search, lack_of_fit, search.base().unwrap());
        let base = selection.base();
        [1.0, 3.0].map(|times| widened(search, &selection, base, &[times * base.fit.sd[0]])[0].powi(2) / base.fit.sd[0].powi(2))
    });
    approx::assert_relative_eq!(thrice - once, 8.0, max_relative = 1e-9);
}
