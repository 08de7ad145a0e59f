//! Rows left out: predictions from the other rows alone.

use super::{World, noise, normals};
use crate::{
    selection::{candidates::Tried, examine::examine},
    validation::{
        all_rows::AllRows,
        cross_validation::{HeldOutFit, PartError, compared, held_out, misfit_removed},
        selected_again::selected_again,
        step_back::{Known, step_back},
        veto::Against,
    },
};
use nalgebra::{DMatrix, DVector};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Predictions of one run from the others, and their variances, by the covariance of all rows.
fn predicted(world: &World, terms: &[usize], y: &[f64], run: u32) -> (DVector<f64>, DVector<f64>) {
    let (out, rest): (Vec<usize>, Vec<usize>) = (0..world.rows()).partition(|row| world.inputs.run[*row] == run);
    let columns = world.columns(terms);
    let course = &columns * columns.transpose();
    let all = world.noise_covariance() + &course;
    let known = all.select_rows(&rest).select_columns(&rest).cholesky().unwrap();
    let cross: DMatrix<f64> = course.select_rows(&out).select_columns(&rest);
    let mean = &cross * known.solve(&DVector::from_iterator(rest.len(), rest.iter().map(|r| y[*r])));
    let taken = (&cross * known.solve(&cross.transpose())).diagonal();
    let variance = all.select_rows(&out).select_columns(&out).diagonal() - taken;
    (mean, variance)
}

#[test]
fn rows_left_out_are_predicted_from_the_others_alone() {
    let world = World::new(5, 8, &[1.0, 0.7]);
    let y = world.drawn(&[0, 1], &[1.0, -0.8], &mut ChaCha8Rng::seed_from_u64(31));
    let noise = noise(&world, &y);
    world.search(&y, |search, _| {
        let all = AllRows { problem: search.problem, first: None, untold: &[] };
        let base = search.base().unwrap();
        let one = search.add_each(&base, &[0], 1, "test").pop().unwrap();
        let both = search.polished(&search.add_each(&one, &[1], 1, "test").pop().unwrap()).unwrap();
        let (before, after) = (held_out(search, &noise, &base, all), held_out(search, &noise, &both, all));
        let mut squares = 0.0;
        for run in 1..=5 {
            let (mean, _) = predicted(&world, &[0, 1], &y, run);
            for k in 0..8 {
                let row = (run as usize - 1) * 8 + k;
                approx::assert_abs_diff_eq!(after.prediction[row], mean[k], epsilon = 1e-3);
                squares += (mean[k] - y[row]).powi(2);
            }
        }
        let found = compared(&before, &after).unwrap();
        let plain = y.iter().map(|y| y * y).sum::<f64>() / 40.0;
        approx::assert_relative_eq!(found.rmse[0], plain.sqrt(), max_relative = 1e-9);
        approx::assert_relative_eq!(found.rmse[1], (squares / 40.0).sqrt(), max_relative = 1e-3);
        assert_eq!(found.parts.len(), 5);
    });
}

/// The mean square of an error on rows left out is noise and what the other rows do not know, when truths are drawn as the prior has them.
#[test]
fn the_error_on_rows_left_out_is_noise_and_what_the_others_do_not_know() {
    let world = World::new(4, 5, &[2.0, 2.0]);
    let random = &mut ChaCha8Rng::seed_from_u64(5);
    let expected: f64 = (1..=4).map(|run| predicted(&world, &[0, 1], &[0.0; 20], run).1.sum()).sum::<f64>() / 20.0;
    let draws = 150;
    let mut squares = 0.0;
    for _ in 0..draws {
        let y = world.drawn(&[0, 1], &normals::<2>(random), random);
        let noise = noise(&world, &y);
        squares += world.search(&y, |search, _| {
            let base = search.base().unwrap();
            let one = search.add_each(&base, &[0], 1, "test").pop().unwrap();
            let both = search.add_each(&one, &[1], 1, "test").pop().unwrap();
            let all = AllRows { problem: search.problem, first: None, untold: &[] };
            let found = held_out(search, &noise, &both, all);
            found.parts.iter().map(|p| p.squares.unwrap()).sum::<f64>() / 20.0
        });
    }
    let mean = squares / f64::from(draws);
    // of 3000 rows, errors alike inside of a part: a mean square scatters by 4 % or less
    assert!((mean / expected - 1.0).abs() < 0.12, "{mean} {expected}");
    assert!(expected > 1.05, "the tolerance would hide a fit that saw its rows: {expected}");
}

/// Noise of variance 0.04 and a misfit of mean square 1, of which a term takes three quarters.
#[test]
fn the_misfit_removed_is_that_above_the_noise() {
    let (floor, there, left) = (0.2_f64, 1.0, 0.25);
    let error = |misfit: f64| (misfit + floor * floor).sqrt();
    let found = misfit_removed(error(there), error(left), floor, 1000).unwrap();
    approx::assert_relative_eq!(found, 0.75, max_relative = 1e-12);
    // a misfit that is not there to be removed: the square of a noise from 200 rows is known to a tenth
    assert!(misfit_removed(0.2 * 1.15, 0.2, floor, 200).is_none());
    assert!(misfit_removed(0.2 * 1.25, 0.2, floor, 200).is_some());
}

/// What a part reads is no part of the choice made without it: with nonsense in its rows, effects and predictions of it stay as they were to the last bit, and the choice
/// with all rows does not.
#[test]
fn a_choice_made_without_a_part_does_not_see_it() {
    let world = World::new(4, 30, &[3.0, 3.0]);
    let y = world.drawn(&[0], &[1.2], &mut ChaCha8Rng::seed_from_u64(5));
    let noise = noise(&world, &y);
    let chosen = |y: &[f64]| {
        world.search(y, |search, _| {
            let all = AllRows { problem: search.problem, first: None, untold: &[] };
            selected_again(search, &noise, &[], all).swap_remove(2)
        })
    };
    let mut nonsense = y.clone();
    // the second term, at ten times its noise
    nonsense.iter_mut().zip(world.columns(&[1]).column(0).iter()).skip(60).take(30).for_each(|(y, c)| *y = 10.0 * c);
    let (seen, unseen) = (chosen(&y), chosen(&nonsense));
    assert_eq!((&seen.part.name[..], &seen.effects[..]), ("run 3", &[0][..]));
    assert_eq!((seen.effects, seen.prediction), (unseen.effects, unseen.prediction));
    let whole = world.search(&nonsense, |search, lack_of_fit| examine(search, lack_of_fit).unwrap().selection.best().key());
    assert!(whole.contains(&1), "{whole:?}");
}

/// Predictions whose error depends on the effects alone: the second effect costs what it is told to.
#[test]
fn an_effect_without_which_the_rest_predicts_better_is_not_claimed() {
    let world = World::new(4, 30, &[3.0, 3.0]);
    let y = world.drawn(&[0, 1], &[1.2, 0.9], &mut ChaCha8Rng::seed_from_u64(7));
    world.search(&y, |search, lack_of_fit| {
        let selection = examine(search, lack_of_fit).unwrap().selection;
        let index = |effects: &[usize]| selection.models.iter().position(|m| m.key() == effects.into()).unwrap();
        let of_parts = |errors: [f64; 3]| {
            let part = |error: f64| PartError {
                name: "run".into(),
                squares: Some(30.0 * error * error),
                rows: 30,
                score: None,
                warned: None,
            };
            HeldOutFit { parts: errors.map(part).to_vec(), ..HeldOutFit::default() }
        };
        let of_all = |base: [f64; 3], one: [f64; 3], both: [f64; 3], free: bool| {
            let unseen = |tried: &Tried| of_parts(if tried.effects.contains(&1) { both } else { one });
            let start = (index(&[0, 1]), unseen(&selection.models[index(&[0, 1])]));
            let (model, named, left_out) = step_back(
                &selection,
                start,
                &of_parts(base),
                unseen,
                (usize::MAX, |_| free),
                Known { measured: true, enough: &|_| true, holds: &|_| true, stands_out: &|_, _| false },
            );
            (model, named.parts[0].rmse(), left_out)
        };
        let told = |second: f64, free: bool| of_all([2.0; 3], [1.0; 3], [second; 3], free);
        let (model, error, left_out) = told(3.0, false);
        assert_eq!((model, error), (index(&[0]), Some(1.0)));
        assert_eq!((left_out[0].effects.as_slice(), left_out[0].against), (&[1][..], Against::Errors([1.0, 3.0])));
        // what predicts as well stays, and so does a number for whatever happens
        assert_eq!(told(0.5, false).0, index(&[0, 1]));
        assert_eq!(told(3.0, true).0, index(&[0, 1]));
        // worse in one part of three is no reason to take an effect back, unless both together are worse than the base for it
        let (one, both) = ([1.05, 1.05, 1.4], [1.0, 1.0, 2.0]);
        assert_eq!(of_all([2.0; 3], one, both, false).0, index(&[0, 1]));
        assert_eq!(of_all([0.8, 0.8, 1.8], one, both, false).0, index(&[0]));
        // in that one part alone, which is no veto by itself
        assert_eq!(of_all([1.2, 1.2, 1.4], one, both, false).0, index(&[0]));
    });
}
