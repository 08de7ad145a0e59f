//! Probabilities of models and effects, by weighing all of them.

use super::{World, exact::log_mean};
use crate::selection::{
    detectability::{detectability, visible_size},
    examine::judge,
    posterior::{Selection, select},
    tuning::NUMBER_PRIOR,
    verdict::Verdict,
};
use nalgebra::DVector;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Every set of at most three of `count` terms.
fn sets(count: usize) -> Vec<Vec<usize>> {
    let members = |bits: usize| (0..count).filter(|k| bits >> k & 1 == 1).collect::<Vec<usize>>();
    (0..1 << count).map(members).filter(|set| set.len() < 4).collect()
}

/// Probability of every set: its evidence, and its share of what its number is worth beforehand.
fn enumerated(world: &World, y: &[f64]) -> Vec<(Vec<usize>, f64)> {
    let count = world.terms.len();
    let all = sets(count);
    let weight = |set: &Vec<usize>| {
        let rivals = all.iter().filter(|other| other.len() == set.len()).count() as f64;
        world.exact(set, y).log_evidence() + (NUMBER_PRIOR[set.len()] / rivals).ln()
    };
    let weights: Vec<f64> = all.iter().map(weight).collect();
    let total = log_mean(&weights) + (weights.len() as f64).ln();
    all.into_iter().zip(weights).map(|(set, w)| (set, (w - total).exp())).collect()
}

/// Four terms, each known well where it acts, so that sampled evidence has no soft direction; Gaussian priors, so that nothing is tempered.
fn four() -> World {
    World::new(1, 60, &[4.0, 4.0, 4.0, 4.0])
}

fn selected(world: &World, y: &[f64]) -> Selection {
    world.search(y, |search, tests| select(search, tests, search.base().unwrap()))
}

#[test]
fn probabilities_are_those_of_all_sets_weighed() {
    let world = four();
    for (seed, truth) in [(1, [0.0; 4]), (2, [0.12, 0.0, 0.0, 0.0]), (3, [0.4, 0.0, 0.13, 0.0]), (4, [0.5, 0.3, 0.0, 0.2])] {
        let y = world.drawn(&[0, 1, 2, 3], &truth, &mut ChaCha8Rng::seed_from_u64(seed));
        let (found, known) = (selected(&world, &y), enumerated(&world, &y));
        assert_eq!(found.temper, 1.0, "what was computed beforehand has no error of form");
        // sets that no step leads to have no probability: the others share it
        let tried: Vec<&(Vec<usize>, f64)> = known.iter().filter(|(set, _)| found.with(set).is_some()).collect();
        let weighed: f64 = tried.iter().map(|(_, p)| p).sum();
        assert!(weighed > 0.97, "{truth:?} {weighed}");
        for (model, p) in found.models.iter().zip(&found.probability) {
            let (_, exact) = tried.iter().find(|(set, _)| model.key() == set.as_slice().into()).unwrap();
            approx::assert_abs_diff_eq!(*p, exact / weighed, epsilon = 1e-4);
        }
        for effect in 0..4 {
            let exact: f64 = tried.iter().filter(|(set, _)| set.contains(&effect)).map(|(_, p)| p).sum();
            approx::assert_abs_diff_eq!(found.effect_probability[effect], exact / weighed, epsilon = 1e-4);
        }
    }
}

/// Truths drawn as the prior has them, most of them well above the noise, so that no pair is left untried: what is stated with a probability is right as often.
#[test]
fn stated_probabilities_are_right_as_often_as_they_say() {
    let world = World::new(1, 40, &[6.0, 6.0, 6.0]);
    let random = &mut ChaCha8Rng::seed_from_u64(23);
    let (mut stated, mut right, mut variance) = (0.0, 0.0, 0.0);
    let all = sets(3);
    for draw in 0..200 {
        let place = (f64::from(draw) + 0.5) / 200.0;
        let mut reached = 0.0;
        let truth = all.iter().find(|set| {
            let rivals = all.iter().filter(|o| o.len() == set.len()).count() as f64;
            reached += NUMBER_PRIOR[set.len()] / rivals;
            place < reached
        });
        let truth = truth.unwrap_or(&all[0]).clone();
        let z: [f64; 3] = super::normals(random);
        let y = world.drawn(&truth, &z[..truth.len()], random);
        let found = selected(&world, &y);
        for effect in 0..3 {
            let p = found.effect_probability[effect];
            stated += p;
            variance += p * (1.0 - p);
            right += f64::from(u8::from(truth.contains(&effect)));
        }
    }
    // a sum of that variance; three standard deviations
    assert!((stated - right).abs() < 3.0 * variance.sqrt(), "{stated} {right} {}", variance.sqrt());
    assert!(variance > 1.0, "nothing was uncertain: {variance}");
}

#[test]
fn detectability_is_what_the_others_leave_of_a_term() {
    let world = World::new(1, 60, &[2.0, 3.0]);
    let y = world.drawn(&[0, 1], &[0.7, 0.5], &mut ChaCha8Rng::seed_from_u64(8));
    let (both, other) = (world.exact(&[0, 1], &y), world.exact(&[1], &y));
    let column = DVector::from_column_slice(world.columns(&[0]).as_slice());
    let exact = both.mean()[0] * other.score(&column).1.sqrt();
    let alone = world.exact(&[], &y).score(&column).1.sqrt();
    world.search(&y, |search, _| {
        let tried = |effects: &[usize]| {
            let from = search.base().unwrap();
            let with = |from, e| search.add_each(&from, &[e], 1, "test").pop().unwrap();
            search.polished(&effects.iter().fold(from, |from, e| with(from, *e))).unwrap()
        };
        approx::assert_relative_eq!(detectability(search, &tried(&[0, 1]), 0).unwrap(), exact, max_relative = 1e-4);
        let visible = visible_size(search, &search.base().unwrap(), &tried(&[0]), 6.0).unwrap();
        // in the unit of the size: the prior's standard deviation is 2
        approx::assert_relative_eq!(visible, 6.0 / alone * 2.0, max_relative = 1e-4);
    });
}

#[test]
fn verdicts_follow_from_probabilities() {
    let world = four();
    let verdict = |truth: [f64; 4], seed| {
        let y = world.drawn(&[0, 1, 2, 3], &truth, &mut ChaCha8Rng::seed_from_u64(seed));
        world.search(&y, |search, tests| {
            let selection = select(search, tests, search.base().unwrap());
            judge(search, tests, selection).decision
        })
    };
    assert_eq!(verdict([0.0; 4], 1).verdict, Verdict::Agrees);
    let named = verdict([0.5, 0.0, 0.0, 0.0], 2);
    assert_eq!((named.verdict, named.sets), (Verdict::Explained, vec![vec![0]]));
    // all of the misfit but what is noise
    assert!(named.removed > 0.9, "{}", named.removed);
}
