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

/// Shares of the draws in which the base model's number lies within 1.96 deviations: of the fit alone, and with weak effects counted in; the first term stands `by`
/// noise deviations out of what calibration leaves of it.
fn covered(by: f64) -> [f64; 2] {
    let world = confused();
    let random = &mut ChaCha8Rng::seed_from_u64(31);
    let mut held = [0, 0];
    for _ in 0..DRAWS {
        let [own] = normals(random);
        let still = world.drawn(&[], &[0.01 * own], random);
        // the term at the wanted size: first find out how far one unit of it stands out
        let unit = world.terms[0].of_one_deviation();
        let size = world.search(&still, |search, _| {
            let base = search.base().unwrap();
            let column =
                DMatrix::from_column_slice(ROWS, 1, &search.whitener.matrix(vec![unit.clone()]).column(0).as_slice().to_vec());
            by / scores(&base.fit.linearised(), &column).covariance[(0, 0)].sqrt()
        });
        let y: Vec<f64> = still.iter().zip(&unit).map(|(y, u)| y + size * u).collect();
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
