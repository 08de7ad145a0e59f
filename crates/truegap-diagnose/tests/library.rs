//! An effect that a caller brings along: one file, one line, and every stage takes it up.

#![allow(clippy::unwrap_used)]

mod common;
mod toy;

use common::{Plate, page::page, recording};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::{
    collections::BTreeMap,
    sync::{Arc, atomic::AtomicBool},
};
use toy::GainRipple;
use truegap_core::{Inputs, Simulator};
use truegap_diagnose::{
    Context, Effect, Known, Library, Options, Outcome, Problem, Verdict, diagnose,
    recovery::{BankCase, BankOptions, BankStore},
};

/// Noise of the reading, pF.
const NOISE: f64 = 0.004;
/// The ripple concealed.
const RIPPLE: f64 = 0.03;

/// Keeps nothing.
struct Nowhere;

impl BankStore for Nowhere {
    fn load(&self, _: &str) -> BTreeMap<usize, BankCase> {
        BTreeMap::new()
    }
    fn save(&self, _: &str, _: &BTreeMap<usize, BankCase>) {}
}

/// A recording of the plate with a ripple and white noise.
fn rippled(plate: &Plate) -> (Inputs, Vec<f64>) {
    let inputs = recording();
    let context = Context::new(&inputs, plate, 2.0, NOISE);
    let stage = GainRipple.with(&[RIPPLE], &context);
    let mut response = plate.respond(&plate.centre(), &inputs, &[stage.as_ref()]).unwrap();
    let random = &mut ChaCha8Rng::seed_from_u64(12);
    response.iter_mut().for_each(|r| *r += NOISE * <StandardNormal as Distribution<f64>>::sample(&StandardNormal, random));
    (inputs, response)
}

fn answer(library: Library, bank: Option<usize>) -> Outcome {
    let plate = Plate::new(Some(true));
    let (inputs, response) = rippled(&plate);
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let bank = bank.map(|recordings| Arc::new(BankOptions { recordings, store: Box::new(Nowhere) }));
    let few = ["gain_ripple", "gain_drift", "viscoelastic_creep", "offset_drift"];
    let effects = few.iter().filter(|id| library.find(id).is_some()).map(|id| (*id).to_owned()).collect();
    let options = Options { library, effects, bank, ..Options::default() };
    diagnose(&problem, Known::default(), &options, &|_| {}, &AtomicBool::new(false)).unwrap()
}

#[test]
fn an_effect_of_the_callers_own_is_fitted_named_told_and_put_into_the_bank() {
    let library = Library::default().with(Box::new(GainRipple));
    let outcome = answer(library.clone(), Some(18));
    let diagnosis = &outcome.diagnosis;
    assert_eq!(diagnosis.verdict, Verdict::Explained, "{}", diagnosis.says);
    let [finding] = &diagnosis.findings[..] else { panic!("{}", diagnosis.says) };
    let [ripple] = &finding.parameters[..] else { panic!("{finding:?}") };
    // fit: the planted size within four standard deviations, and these are small
    assert_eq!(finding.effect, "gain_ripple");
    assert!((ripple.value - RIPPLE).abs() < 4.0 * ripple.sd && ripple.sd < 0.1 * RIPPLE, "{ripple:?}");
    assert!(finding.says.contains("ripples by"), "{}", finding.says);
    // facts of a report: first of the candidates; the model to be written rebuilds its stage
    assert_eq!(diagnosis.candidates[0].effect, "gain_ripple");
    let held_out = &diagnosis.fit.held_out;
    assert!(held_out.rmse_after.unwrap() < 0.5 * held_out.rmse_before.unwrap(), "{held_out:?}");
    let (plate, inputs) = (Plate::new(Some(true)), recording());
    let context = Context::new(&inputs, &plate, 2.0, NOISE);
    assert_eq!(outcome.augmented.stages(&library, &context).unwrap().len(), 1);
    assert!(outcome.augmented.stages(&Library::default(), &context).is_err());
    // bank: it is concealed in recordings of its own, and its row is told
    let bank = diagnosis.bank.as_ref().unwrap();
    let concealed = bank["recovered"].as_array().unwrap().iter().find(|row| row["concealed"] == "gain_ripple");
    assert!(concealed.is_some_and(|row| row["exact"].as_u64() >= Some(1)), "{bank}");
}

#[test]
fn without_it_nothing_is_called_by_its_name() {
    let outcome = answer(Library::default(), None);
    assert!(outcome.diagnosis.findings.iter().all(|f| f.effect != "gain_ripple"));
    assert_ne!(outcome.diagnosis.verdict, Verdict::Agrees, "{}", outcome.diagnosis.says);
}

#[test]
fn the_page_of_effects_has_a_section_for_it_and_the_library_keeps_the_order_of_the_chain() {
    let library = Library::default().with(Box::new(GainRipple));
    let text = page(&library);
    assert!(text.contains("## gain_ripple\n\nthe gain of the amplifier ripples") && text.contains("| `gain_ripple` | 1 |"));
    // a readout effect stands behind all others of the readout; a second one of the same id replaces the first
    assert_eq!(library.ids().last(), Some(&"gain_ripple"));
    assert_eq!(library.clone().with(Box::new(GainRipple)), library);
    assert_eq!(library.ids().len(), Library::default().ids().len() + 1);
}

/// Words are those of the grammar of mechanisms; a constant follows nothing.
#[test]
fn every_effect_but_a_constant_says_what_it_is_in_words() {
    let (inputs, plate) = (recording(), Plate::new(Some(true)));
    let context = Context::new(&inputs, &plate, 2.0, 0.004);
    let library = Library::default();
    let silent: Vec<_> = library.iter().filter(|e| e.in_words(&context).is_none()).map(|e| e.id().0).collect();
    assert_eq!(silent, ["parasitic_capacitance"]);
}
