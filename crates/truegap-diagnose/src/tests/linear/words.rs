//! Sentences of a screen: their evidence, and the probabilities of their words.

use super::{
    World,
    effects::course,
    exact::{Exact, log_mean},
};
use crate::{
    discovery::{
        compose::describe,
        discover::{IDS, discover},
        marginals::marginals,
        screen::{Screen, Screened},
    },
    effects::composed::mechanism::Sentence,
    mechanism::{Action, Driver, Form, Kinetics, Numbers, Quantity},
    selection::posterior::select,
};
use nalgebra::DVector;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

fn sentence(driver: Driver, kinetics: Kinetics) -> Sentence {
    Sentence {
        quantity: Quantity::Reading,
        action: Action::Adds,
        driver,
        kinetics,
        form: Form::Linear,
        even: false,
        below: false,
        passing: false,
        sum: None,
    }
}

fn screened(sentence: Sentence, grid: Vec<(f64, f64)>) -> Screened {
    Screened { sentence, numbers: Numbers::default(), swing: 1.0, deviance: 9.0, beyond: 0.0, log_prior: -3.0, grid }
}

/// Two points of a grid beside a fitted term, at seven lengths: the mean of fourteen Gaussian evidences over that without.
#[test]
fn a_sentence_has_the_evidence_of_its_columns() {
    let world = World::new(1, 48, &[1.0]);
    let y = world.drawn(&[0], &[0.8], &mut ChaCha8Rng::seed_from_u64(3));
    let lengths = [3.0, 8.0, 20.0, 50.0, 130.0, 350.0, 1000.0];
    for temper in [1.0, 2.5] {
        // noise and what is known beforehand are both `temper` times as wide, as all differences of evidence are divided by it
        let noise = world.noise_covariance() * temper;
        let own = world.columns(&[0]) * f64::sqrt(temper);
        let y = DVector::from_column_slice(&y);
        let without = Exact::new(noise.clone(), own.clone(), y.clone());
        let mut evidence = Vec::new();
        let mut grid = Vec::new();
        for k in [1, 2] {
            let column = DVector::from_vec(course(k, 48));
            let (score, variance) = without.score(&column);
            grid.push((score * temper, variance * temper));
            for length in lengths {
                let scaled = &column * (length / (variance * temper).sqrt());
                let mut both = own.clone().insert_column(1, 0.0);
                both.set_column(1, &scaled);
                evidence.push(Exact::new(noise.clone(), both, y.clone()).log_evidence() - without.log_evidence());
            }
        }
        let found = screened(sentence(Driver::Time, Kinetics::Static), grid);
        approx::assert_abs_diff_eq!(found.evidence(temper), log_mean(&evidence), epsilon = 1e-8);
        let fitted = Screened { beyond: 4.0, ..found };
        approx::assert_abs_diff_eq!(fitted.weight(temper), log_mean(&evidence) + 2.0 / temper - 3.0, epsilon = 1e-8);
    }
}

#[test]
fn words_have_the_probabilities_of_their_sentences() {
    let (late, now) = (Kinetics::FirstOrder, Kinetics::Static);
    let all = vec![
        screened(sentence(Driver::Time, now), vec![(3.0, 1.0)]),
        Screened { log_prior: -1.5, ..screened(sentence(Driver::Time, late), vec![(2.5, 1.0)]) },
        screened(sentence(Driver::Temperature, late), vec![(2.0, 1.0), (3.2, 1.0)]),
    ];
    let temper = 2.0;
    let weights: Vec<f64> = all.iter().map(|s| s.weight(temper).exp()).collect();
    let total: f64 = weights.iter().sum();
    let words = marginals(&all, temper);
    let close = |found: f64, known: f64| approx::assert_relative_eq!(found, known / total, max_relative = 1e-12);
    close(words.driver[&Driver::Time.word()], weights[0] + weights[1]);
    close(words.driver[&Driver::Temperature.word()], weights[2]);
    close(words.kinetics[late.word()], weights[1] + weights[2]);
    close(words.kinetics[now.word()], weights[0]);
    close(words.place["readout"], total);
    assert!(words.sure(0.2) && !words.sure(0.95), "{words:?}");
}

/// Of 99 turns three reach it; the recording itself is one of a hundred ways.
#[test]
fn a_control_counts_the_recording_itself() {
    let control = (0..99).map(f64::from).collect();
    let screen = Screen { sentences: Vec::new(), control, control_of_tones: vec![0.0; 99], columns: 0 };
    let law = sentence(Driver::Load, Kinetics::Static);
    assert_eq!(screen.control_p_value(&law, 96.0), 0.04);
    assert_eq!(screen.control_p_value(&law, 1e9), 0.01);
    // a tone has a control of its own
    let tone = sentence(Driver::Time, Kinetics::Periodic);
    assert_eq!(screen.control_p_value(&tone, 96.0), 0.01);
}

/// Noise alone, and a reading that drifts with the clock.
#[test]
fn a_mechanism_is_discovered_where_there_is_one_and_by_chance_one_time_in_twenty() {
    let world = World::new(2, 40, &[]);
    let found = |response: &[f64]| {
        world.search(response, |search, _| discover(search, &search.base().unwrap(), 1.0, IDS[0]).map(|d| d.control_p_value))
    };
    let of_noise = |seed: u64| found(&world.drawn(&[], &[], &mut ChaCha8Rng::seed_from_u64(seed)));
    // more than two of ten have a probability of 1 %
    assert!((0..10).filter_map(of_noise).count() < 3);
    let drifting: Vec<f64> = (0..80).map(|row| 0.1 * f64::from(row)).collect();
    let noise = world.drawn(&[], &[], &mut ChaCha8Rng::seed_from_u64(3));
    let read: Vec<f64> = drifting.iter().zip(noise).map(|(d, n)| d + n).collect();
    assert!(found(&read).is_some_and(|p| p <= 0.05), "{:?}", found(&read));
}

/// A reading that levels off, by a law that several sentences tell, and a tone that one does. The tone is told first, and what both gain is counted once: log odds are never more than what the fit explains.
#[test]
fn what_two_mechanisms_gain_is_counted_once_in_whatever_order_they_are_told() {
    let world = World::new(1, 240, &[]);
    let noise = world.drawn(&[], &[], &mut ChaCha8Rng::seed_from_u64(5));
    let read = |(row, noise): (usize, f64)| {
        let time = row as f64;
        12.0 * (1.0 - (-time / 60.0).exp()) + 4.0 * (time * std::f64::consts::TAU / 12.0).sin() + noise
    };
    let response: Vec<f64> = noise.into_iter().enumerate().map(read).collect();
    world.search(&response, |search, lack_of_fit| {
        let selection = select(search, lack_of_fit, search.base().unwrap());
        let found = describe(search, &selection, lack_of_fit, false).unwrap();
        let told: Vec<Kinetics> = found.mechanisms.iter().map(|m| m.effect.sentence.kinetics).collect();
        assert_eq!((told.len(), told[0]), (2, Kinetics::Periodic), "{told:?}");
        let explained =
            (selection.base().fit.objective() - found.tried.fit.objective()) / (selection.temper * lack_of_fit.slack());
        assert!(found.log_odds < explained, "{} of {explained}", found.log_odds);
    });
}
