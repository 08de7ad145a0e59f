use super::*;
use crate::effects::composed::words::Action;

/// What is added to the reading, along a straight line of a driver.
fn sentence(driver: Driver, kinetics: Kinetics) -> Sentence {
    let (even, below, passing) = (false, false, false);
    Sentence {
        quantity: Quantity::Reading,
        driver,
        kinetics,
        form: Form::Linear,
        action: Action::Adds,
        even,
        below,
        passing,
        sum: None,
    }
}

/// Promises of 100, 60 and 20, of which the first was fitted and kept 40: the second promises no more than that, the third what it did.
#[test]
fn no_sentence_promises_more_than_the_best_that_was_fitted_has_kept() {
    let of = |deviance: f64, beyond: f64| Screened {
        sentence: sentence(Driver::Time, Kinetics::Static),
        numbers: Numbers::default(),
        swing: 1.0,
        deviance,
        beyond,
        log_prior: 0.0,
        grid: vec![(deviance.sqrt(), 1.0)],
    };
    let sentences = vec![of(100.0, -60.0), of(60.0, 0.0), of(20.0, 0.0)];
    let mut screen = Screen { sentences, control: Vec::new(), control_of_tones: Vec::new(), columns: 3 };
    screen.promise_no_more_than(&[0]);
    let promised: Vec<f64> = screen.sentences.iter().map(|s| s.deviance + s.beyond).collect();
    assert_eq!(promised, [40.0, 40.0, 20.0]);
}

/// Turned about, a wave over one sweep of a driver is the same wave, as a tone is: freedom alone seemed to do as well.
#[test]
fn a_wave_over_a_driver_is_controlled_as_a_tone() {
    let of_the_angle = |kinetics: Kinetics| sentence(Driver::Recorded("angle".into()), kinetics);
    let screen = Screen { sentences: Vec::new(), control: vec![100.0; 99], control_of_tones: vec![6.0; 99], columns: 1 };
    approx::assert_relative_eq!(screen.control_p_value(&of_the_angle(Kinetics::Periodic), 100.0), 0.01, max_relative = 1e-12);
    approx::assert_relative_eq!(screen.control_p_value(&of_the_angle(Kinetics::Static), 100.0), 1.0, max_relative = 1e-12);
}

#[test]
fn a_tone_is_the_same_turned_about_and_falls_apart_reversed() {
    let tone = DVector::from_fn(960, |row, _| (row as f64 * std::f64::consts::TAU / 12.0).sin());
    let other = DVector::from_fn(960, |row, _| (row as f64 * std::f64::consts::TAU / 12.0).cos());
    // power of the tone over its own
    let kept = |all: &DMatrix<f64>| {
        all.column_iter().map(|c| (c.dot(&tone).powi(2) + c.dot(&other).powi(2)) / 480f64.powi(2)).sum::<f64>()
            / PERMUTATIONS as f64
    };
    approx::assert_abs_diff_eq!(kept(&turned(&tone)), 1.0, epsilon = 1e-9);
    // 16 stretches of random sign keep one part in 16 on average
    assert!(kept(&reversed(&tone)) < 0.1, "{}", kept(&reversed(&tone)));
}
