//! Sensors whose true readings are known by closed form; none of their physics is that of the library.

use super::*;
use crate::stats::rms;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::convert::Infallible;

const ROWS: usize = 2000;
/// Time constant over the step from row to row.
const ROWS_LATE: f64 = 12.0;

type Column = Vec<f64>;

fn noise(seed: u64, sd: f64) -> Column {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    (0..ROWS).map(|_| sd * Distribution::<f64>::sample(&StandardNormal, &mut random)).collect()
}

/// A slow course with a range of about 4.
fn input() -> Column {
    (0..ROWS).map(|row| 2.5 + 1.5 * (row as f64 / 90.0).sin() + 0.5 * (row as f64 / 37.0).sin()).collect()
}

fn each(column: &[f64], law: impl Fn(f64) -> f64) -> Column {
    column.iter().map(|x| law(*x)).collect()
}

fn sum(a: &[f64], b: &[f64]) -> Column {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

fn error(a: &[f64], b: &[f64]) -> f64 {
    rms(a.iter().zip(b).map(|(a, b)| a - b))
}

/// A low pass of steps that are held: `y' = y + (x - y) / tau`.
fn late(column: &[f64]) -> Column {
    let mut state = column[0];
    let mut next = |x: f64| {
        state += (x - state) / ROWS_LATE;
        state
    };
    column.iter().map(|x| next(*x)).collect()
}

fn line(x: f64) -> f64 {
    3.0 * x - 2.0
}

fn heat() -> Column {
    (0..ROWS).map(|row| 8.0 * (row as f64 / 400.0).sin()).collect()
}

struct Case {
    readings: Column,
    truth: Column,
    found: Compensated,
}

/// A sensor of a base and an augmented model that reads `input()` with noise, corrected.
fn corrected(base: &Reading<'_, Infallible>, augmented: &Reading<'_, Infallible>, span: Option<Span>, sd: f64) -> Case {
    let models = Models { base, augmented };
    let Ok(inverse) = match span {
        Some(span) => Inverse::curve(&models, ROWS, span),
        None => Inverse::straight(&models, ROWS, 1.0),
    };
    let (Ok(whole), Ok(truth)) = (augmented(&input()), base(&input()));
    let readings = sum(&whole, &noise(3, sd));
    let Ok(found) = compensated(&readings, &models, &inverse, &Limits::of(sd));
    Case { readings, truth, found }
}

impl Case {
    fn before(&self) -> f64 {
        error(&self.readings, &self.truth)
    }

    fn after(&self) -> f64 {
        error(&self.found.corrected, &self.truth)
    }
}

const SD: f64 = 0.02;

/// The heat adds what is known: one pass takes it away, and the noise stays as it is.
#[test]
fn a_temperature_coefficient_is_taken_away_to_the_noise() {
    let (heat, base) = (heat(), |x: &[f64]| Ok(each(x, line)));
    let case = corrected(&base, &|x| Ok(sum(&each(x, line), &each(&heat, |t| 0.05 * t))), None, SD);
    assert_eq!((case.found.passes, case.found.stopped, case.found.outside), (1, Stopped::AtNoise, 0));
    assert!(case.before() > 10.0 * SD, "{}", case.before());
    // what remains is the noise that was added, to the last digits
    approx::assert_relative_eq!(case.after(), rms(noise(3, SD).into_iter()), max_relative = 1e-9);
    approx::assert_relative_eq!(case.found.noise_growth, 1.0, max_relative = 1e-9);
}

#[test]
fn a_lag_is_taken_away_as_far_as_the_noise_allows() {
    let base = |x: &[f64]| Ok(each(x, line));
    let case = corrected(&base, &|x| Ok(late(&each(x, line))), None, SD);
    assert_eq!(case.found.stopped, Stopped::Balanced);
    // two passes: a further one leaves less of the lag and is wrong by more, 3.6 times the noise for 3.2
    assert!(case.before() > 20.0 * SD, "{}", case.before());
    assert!(case.after() < 3.4 * SD && case.after() < case.before() / 7.0, "{} of {}", case.after(), case.before());
    // each pass of a lag adds at most the noise once more
    let (growth, passes) = (case.found.noise_growth, case.found.passes);
    assert!(passes == 2 && growth > 2.0 && growth <= 3.0, "{growth} in {passes}");
}

/// Without noise the passes go on, and the true reading comes back.
#[test]
fn a_lag_without_noise_is_taken_away_whole() {
    let base = |x: &[f64]| Ok(each(x, line));
    let case = corrected(&base, &|x| Ok(late(&each(x, line))), None, 0.0);
    assert!(case.after() < 0.02 * case.before(), "{} of {}", case.after(), case.before());
    assert!(case.found.noise_growth <= 10.0, "{}", case.found.noise_growth);
}

#[test]
fn a_bent_characteristic_is_straightened() {
    let bent = |x: f64| line(x) - 0.12 * line(x) * line(x) / 3.0;
    let base = |x: &[f64]| Ok(each(x, line));
    let case = corrected(&base, &|x| Ok(each(x, bent)), None, SD);
    assert!(matches!(case.found.stopped, Stopped::AtNoise | Stopped::Balanced));
    // a bent curve is flatter at its upper end, where the noise grows by the ratio of the slopes
    let steepest = input().iter().map(|x| 1.0 / (1.0 - 0.08 * line(*x))).fold(0.0, f64::max);
    assert!(case.before() > 50.0 * SD && case.after() < steepest * SD, "{} of {}", case.after(), case.before());
    assert!((1.0..steepest).contains(&case.found.noise_growth), "{} of {steepest}", case.found.noise_growth);
}

/// A curved base, a late reading and heat at once: the input comes back as well.
#[test]
fn what_acts_together_is_taken_away_together() {
    let curve = |x: f64| (x + 1.0).ln() * 4.0;
    let (heat, base) = (heat(), |x: &[f64]| Ok(each(x, curve)));
    let augmented = |x: &[f64]| Ok(late(&sum(&each(x, curve), &each(&heat, |t| 0.05 * t))));
    let case = corrected(&base, &augmented, Some(Span { zero: 0.0, width: 5.0, ends: false }), SD);
    assert!(case.after() < 6.0 * SD && case.after() < case.before() / 3.0, "{} of {}", case.after(), case.before());
    let input_again = each(&case.found.corrected, |y| (y / 4.0).exp() - 1.0);
    case.found.input.iter().zip(&input_again).for_each(|(a, b)| approx::assert_relative_eq!(a, b, max_relative = 1e-6));
}

/// A reading that no pass can explain is not chased: the noise of the correction stays below its limit.
#[test]
fn noise_that_is_stated_too_small_does_not_run_away() {
    let base = |x: &[f64]| Ok(each(x, line));
    let models = Models::<'_, Infallible> { base: &base, augmented: &|x| Ok(late(&each(x, line))) };
    let Ok(inverse) = Inverse::straight(&models, ROWS, 1.0);
    let (Ok(whole), limits) = ((models.augmented)(&input()), Limits::of(1e-3 * SD));
    let readings = sum(&whole, &noise(3, SD));
    let Ok(found) = compensated(&readings, &models, &inverse, &limits);
    assert!(
        found.noise_growth <= limits.noise_growth && !matches!(found.stopped, Stopped::AtNoise | Stopped::Balanced),
        "{found:?}"
    );
    let after = error(&found.corrected, &each(&input(), line));
    assert!(after < limits.noise_growth * SD * 1.1, "{after}");
}

#[test]
fn a_curve_is_inverted_on_the_stretch_that_does_not_turn() {
    let parabola = |x: f64| x * (6.0 - x);
    let models = Models::<'_, Infallible> { base: &|x| Ok(each(x, parabola)), augmented: &|x| Ok(each(x, parabola)) };
    // the middle of the span is 2.5, below the turn at 3
    let Ok(inverse) = Inverse::curve(&models, 4, Span { zero: 0.0, width: 5.0, ends: true });
    let Ok((input, outside)) = inverse.input(models.base, &[0.5, 5.0, 8.0, 9.5]);
    let closed = [0.5, 5.0, 8.0].map(|y: f64| 3.0 - (9.0 - y).sqrt());
    (0..3).for_each(|row| approx::assert_relative_eq!(input[row], closed[row], max_relative = 1e-9));
    // beyond the turn there is no input: the last of the stretch stands for it
    assert!(outside == 1 && (input[3] - 3.0).abs() <= 0.1, "{input:?}");
    assert!(matches!(inverse, Inverse::Curve { turns: 4, .. }) && inverse.moves());
}

/// A model from 1 to 3 V (2 V wide) in one row and from 11 to 13 V in the other: a tenth of that is 0.2 V.
#[test]
fn a_reading_is_far_outside_from_a_part_of_the_range_on_in_its_row() {
    let answer = |x: &[f64]| Ok(vec![1.0 + 2.0 * x[0], 11.0 + 2.0 * x[1]]);
    let models = Models::<'_, Infallible> { base: &answer, augmented: &answer };
    let Ok(inverse) = Inverse::curve(&models, 2, Span { zero: 0.0, width: 1.0, ends: true });
    let [least, most] = inverse.gives().unwrap();
    assert!((least - 1.0).abs() < 1e-9 && (most - 13.0).abs() < 1e-9, "{least} {most}");
    let far = |readings: [f64; 2]| inverse.far_outside(&readings, 0.1);
    assert_eq!([far([0.9, 13.1]), far([0.7, 13.1]), far([3.3, 10.7]), far([12.0, 2.0])], [0, 1, 2, 2]);
}

/// A model that has no answer beyond some input is asked no further.
#[test]
fn a_model_that_ends_is_inverted_up_to_its_end() {
    let models = Models::<'_, f64> {
        base: &|x| x.iter().map(|x| if *x <= 1.0 { Ok(x * x + x) } else { Err(*x) }).collect(),
        augmented: &|x| x.iter().map(|x| if *x <= 0.9 { Ok(x * x) } else { Err(*x) }).collect(),
    };
    let inverse = Inverse::curve(&models, 2, Span { zero: 0.0, width: 1.0, ends: false }).unwrap();
    let (input, outside) = inverse.input(models.base, &[0.75, 5.0]).unwrap();
    assert!(outside == 1 && (input[0] - 0.5).abs() < 1e-9 && (0.88..=0.9).contains(&input[1]), "{input:?}");
}
