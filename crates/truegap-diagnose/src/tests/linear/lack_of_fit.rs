//! Lack-of-fit tests that reject a right model no more often than they say; noise that is as large as it is.

use super::World;
use crate::{
    Problem,
    adequacy::{
        directions::{self, Direction},
        lack_of_fit::{Adequacy, LackOfFitTests},
        tuning::ASKED,
    },
    fit::optimum::Fit,
    noise::{
        reml::{Block, estimate},
        rescale::{not_above, quieter_than},
        several::measured,
    },
    stats::rms,
    whitening::noise_model::NoiseModel,
};
use nalgebra::{DMatrix, DVector};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use truegap_core::Driver;

/// A right model, tested along six directions: one false alarm in ten thousand recordings.
#[test]
fn a_right_model_sets_off_no_alarm_and_a_course_beside_it_does() {
    let world = World::new(1, 96, &[1.0]);
    let random = &mut ChaCha8Rng::seed_from_u64(41);
    let directions = || -> Vec<Direction> {
        let of = |k: usize| Direction { driver: directions::Driver::Clock, column: super::effects::course(k + 1, 96) };
        (0..4).map(of).collect()
    };
    let tests = LackOfFitTests::new(&directions(), &world.whitener(1.0), world.inputs.runs(), 0.0);
    let (mut alarms, mut small) = (0, 0);
    for _ in 0..400 {
        let y = world.drawn(&[0], &[0.5], random);
        let adequacy = world.search(&y, |search, _| {
            let base = search.base().unwrap();
            tests.adequacy(&search.add_each(&base, &[0], 1, "test").pop().unwrap().fit)
        });
        alarms += usize::from(adequacy.fires());
        small += usize::from(adequacy.p_value() < 0.1);
    }
    // at 1e-4, three in 400 has a probability of 1e-5; p-values themselves are uniform or above: 40 +- 6 of 400 below 0.1, fewer as three tests overlap
    assert!(alarms < 3, "{alarms}");
    assert!((10..65).contains(&small), "{small}");
    let y: Vec<f64> = world.drawn(&[0], &[0.5], random).iter().zip(super::effects::course(2, 96)).map(|(y, c)| y + c).collect();
    let fires = world.search(&y, |search, _| tests.adequacy(&search.base().unwrap().fit).fires());
    assert!(fires, "a course of 8 deviations");
}

/// White noise beside a cubic: squares of what least squares leaves over the freedom, not over the rows.
#[test]
fn noise_is_the_residual_of_least_squares_over_its_freedom() {
    let world = World::new(1, 12, &[]);
    let mut rows = Vec::new();
    let random = &mut ChaCha8Rng::seed_from_u64(12);
    (0..40).for_each(|_| rows.extend(world.drawn(&[], &[], random)));
    let cubic = DMatrix::from_fn(12, 4, |row, k| (row as f64).powi(k as i32));
    let left = |block: &[f64]| {
        let y = DVector::from_column_slice(block);
        let q = cubic.clone().qr().q();
        (&y - &q * q.tr_mul(&y)).norm_squared()
    };
    let exact = rows.chunks(12).map(left).sum::<f64>() / (40.0 * 8.0);
    let blocks: Vec<Block> = (0..40).map(|k| Block::stretch(12 * k..12 * (k + 1))).collect();
    let (found, uncertainty) = estimate(&rows, &blocks);
    assert_eq!(found.ar_sd, 0.0);
    approx::assert_relative_eq!(found.white_sd, exact.sqrt(), max_relative = 1e-9);
    // 320 degrees of freedom, and what coloured noises the blocks would allow
    assert!(uncertainty > 0.079, "{uncertainty}");
    // rows measured again allow no coloured noise: squares about the means of four, over three each
    let four: Vec<Block> = (0..120).map(|k| Block::replicate((4 * k..4 * (k + 1)).collect())).collect();
    let about = |rows: &[f64]| rows.iter().map(|y| (y - rows.iter().sum::<f64>() / 4.0).powi(2)).sum::<f64>();
    let (found, uncertainty) = estimate(&rows, &four);
    approx::assert_relative_eq!(found.white_sd, (rows.chunks(4).map(about).sum::<f64>() / 360.0).sqrt(), max_relative = 1e-9);
    approx::assert_relative_eq!(uncertainty, (2.0f64 / 360.0).sqrt(), max_relative = 1e-9);
}

fn model(problem: &Problem<'_>, white_sd: f64) -> NoiseModel {
    let (_, noise) = measured(problem).unwrap();
    let response = crate::calibration::Noise { white_sd, ar_sd: 0.0, ar_correlation: 0.0 };
    NoiseModel { response, measured: true, ..noise }
}

#[test]
fn a_right_noise_is_not_lowered_and_one_three_times_too_loud_is_by_three() {
    let world = World::new(1, 200, &[]);
    for seed in 0..4 {
        let y = world.drawn(&[], &[], &mut ChaCha8Rng::seed_from_u64(seed));
        let problem = Problem { inputs: &world.inputs, response: &y, simulator: &world.line };
        let right = model(&problem, 1.0);
        assert_eq!(not_above(&problem, &y, right.clone()).response, right.response, "{seed}");
        assert!(quieter_than(&problem, &y, &right).is_none(), "{seed}");
        // three quarters of the variance may be chance, two thirds are not
        let of_square = |square: f64| {
            let mean = y.iter().map(|y| y * y).sum::<f64>() / 200.0;
            let scaled: Vec<f64> = y.iter().map(|y| y * (square / mean).sqrt()).collect();
            not_above(&problem, &scaled, right.clone()).response.white_sd
        };
        assert_eq!(of_square(0.75), 1.0);
        assert!(of_square(0.66) < 0.9);
        let lowered = not_above(&problem, &y, model(&problem, 3.0)).response;
        let exact = rms(y.iter().copied());
        // factors of the grid stand a quarter apart
        assert!((lowered.white_sd / exact).ln().abs() < 0.3, "{} {exact}", lowered.white_sd);
    }
}

/// Six hundred runs of eight rows, each shorter than half of the twenty rows of a stretch: what lasts over some of them is seen, and noise is not.
#[test]
fn short_runs_are_tested_together() {
    let world = World::new(600, 8, &[]);
    let random = &mut ChaCha8Rng::seed_from_u64(43);
    let mut y: Vec<f64> = (0..4800).map(|_| StandardNormal.sample(random)).collect();
    let tests = LackOfFitTests::new(&[], &world.whitener(1.0), world.inputs.runs(), 0.0);
    let of = |y: &[f64]| world.search(y, |search, _| tests.adequacy(&search.base().unwrap().fit));
    let noise = of(&y);
    // two runs make sixteen rows
    assert_eq!(noise.stretches.freedom, 300);
    assert!(!noise.fires(), "{noise:?}");
    y.iter_mut().enumerate().filter(|(row, _)| row / 480 % 2 == 0).for_each(|(_, y)| *y += 0.3);
    assert!(of(&y).stretches.p_value < 1e-9, "{:?}", of(&y).stretches);
}

/// Rows that no clock orders and whose inputs move have neither stretches nor lines, whether some are left out or not; on a clock they have both.
#[test]
fn rows_in_no_order_have_nothing_that_lasts() {
    let mut world = World::new(2, 96, &[]);
    world.inputs.drivers = vec![Driver { name: "x".into(), unit: "V".into(), values: super::effects::course(0, 192) }];
    let y: Vec<f64> = super::effects::course(3, 192).iter().map(|c| 20.0 * c).collect();
    let keep: Vec<bool> = (0..192).map(|row| !(40..56).contains(&row)).collect();
    for clock in [world.inputs.time_s.clone(), None] {
        world.inputs.time_s = clock;
        let problem = Problem { inputs: &world.inputs, response: &y, simulator: &world.line };
        let (noise, whitener) = (super::noise(&world, &y), world.whitener(1.0));
        let base = world.search(&y, |search, _| search.base().unwrap());
        for keep in [None, Some(keep.as_slice())] {
            let found = LackOfFitTests::of(&problem, &noise, &whitener, &[], keep).adequacy(&base.fit);
            let ordered = world.inputs.time_s.is_some();
            assert_eq!((found.stretches.freedom > 0, found.line_p_value < 1e-4), (ordered, ordered), "{found:?}");
        }
    }
}

/// Three tests were tried; and noise known to a tenth may have 1.2 times the variance.
#[test]
fn levels_count_the_tests_that_were_tried() {
    let world = World::new(1, 96, &[]);
    let y = world.drawn(&[], &[], &mut ChaCha8Rng::seed_from_u64(1));
    let without = world.search(&y, |search, tests| tests.adequacy(&search.base().unwrap().fit));
    let with = |line_p_value: f64| Adequacy { line_p_value, ..without };
    approx::assert_relative_eq!(with(2e-5).p_value(), 6e-5, max_relative = 1e-12);
    assert!(with(2e-5).fires() && !with(5e-5).fires());
    let tests = |uncertainty: f64| LackOfFitTests::new(&[], &world.whitener(1.0), world.inputs.runs(), uncertainty);
    let known = |uncertainty| world.search(&y, |search, _| tests(uncertainty).adequacy(&search.base().unwrap().fit));
    approx::assert_relative_eq!(known(0.1).stretches.statistic * 1.2, known(0.0).stretches.statistic, max_relative = 1e-12);
}

/// Fits asked in turn, more than are remembered, and copies of them: each has the numbers that tests which remember nothing give it.
#[test]
fn a_fit_that_is_asked_again_has_its_own_numbers_to_the_last_bit() {
    let world = World::new(1, 96, &[1.0]);
    let random = &mut ChaCha8Rng::seed_from_u64(44);
    let directions: Vec<Direction> =
        (0..4).map(|k| Direction { driver: directions::Driver::Clock, column: super::effects::course(k + 1, 96) }).collect();
    let tests = || LackOfFitTests::new(&directions, &world.whitener(1.0), world.inputs.runs(), 0.0);
    let fits: Vec<Fit> = (0..ASKED + 2)
        .map(|_| {
            let y = world.drawn(&[0], &[0.5], random);
            world.search(&y, |search, _| search.base().unwrap().fit)
        })
        .collect();
    let numbers = |tests: &LackOfFitTests, fit: &Fit| {
        let found = tests.adequacy(fit);
        [found.smooth.statistic, found.stretches.statistic, tests.may_leave(fit)].map(f64::to_bits)
    };
    let asked = tests();
    for fit in fits.iter().chain(&fits).chain(fits.iter().rev()) {
        let expected = numbers(&tests(), fit);
        assert_eq!([numbers(&asked, fit), numbers(&asked, &fit.clone())], [expected; 2]);
    }
    assert_ne!(numbers(&asked, &fits[0]), numbers(&asked, &fits[1]));
}
