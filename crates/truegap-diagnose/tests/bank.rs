//! The recovery bank on a recording whose cause is known.

#![allow(clippy::unwrap_used)]

mod common;

use common::{Plate, recording};
use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex, atomic::AtomicBool},
};
use truegap_core::Simulator;
use truegap_diagnose::{
    Context, Options, Problem, RecordingFacts, Verdict, diagnose, library,
    recovery::{BankCase, BankOptions, BankStore},
};

type Stored = Arc<Mutex<BTreeMap<String, BTreeMap<usize, BankCase>>>>;

#[derive(Clone, Default)]
struct Memory(Stored);

impl BankStore for Memory {
    fn load(&self, key: &str) -> BTreeMap<usize, BankCase> {
        self.0.lock().unwrap().get(key).cloned().unwrap_or_default()
    }
    fn save(&self, key: &str, cases: &BTreeMap<usize, BankCase>) {
        self.0.lock().unwrap().insert(key.into(), cases.clone());
    }
}

/// A recording with creep in it and noise that is white.
fn creeping() -> (truegap_core::Inputs, Vec<f64>) {
    let (plate, inputs) = (Plate::new(Some(true)), recording());
    let all = library();
    let creep = all.iter().find(|e| e.id().0 == "viscoelastic_creep").unwrap();
    let context = Context::new(&inputs, &plate, 2.0, 0.004);
    let centre: Vec<f64> = creep.parameters(&context).iter().map(|p| p.prior.at(0.5)).collect();
    let stage = creep.with(&centre, &context);
    let mut response = plate.respond(&plate.centre(), &inputs, &[stage.as_ref()]).unwrap();
    let mut state = 1u64;
    let mut uniform = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    response.iter_mut().for_each(|r| *r += 0.004 * ((0..12).map(|_| uniform()).sum::<f64>() - 6.0));
    (inputs, response)
}

#[test]
fn a_bank_recovers_what_it_conceals_is_stored_and_comes_out_the_same() {
    let plate = Plate::new(Some(true));
    let (inputs, response) = creeping();
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let memory = Memory::default();
    let stop = AtomicBool::new(false);
    let run = |recordings: usize| {
        let bank = Some(Arc::new(BankOptions { recordings, store: Box::new(memory.clone()) }));
        let effects = ["viscoelastic_creep", "rate_independent_hysteresis", "thermal_lag", "offset_drift"];
        let options = Options { effects: effects.iter().map(|e| (*e).to_owned()).collect(), bank, ..Options::default() };
        diagnose(&problem, RecordingFacts::default(), &options, &|_| {}, &stop).unwrap().diagnosis
    };
    let first = run(18);
    assert_eq!(first.verdict, Verdict::Explained, "{}", first.says);
    assert_eq!(first.findings[0].effect, "viscoelastic_creep");
    let control = first.fit.held_out.permutation_control.unwrap();
    assert!(control < 0.3, "a permuted history removes {control}");

    let bank = first.bank.unwrap();
    let counts = |field: &str| -> Vec<u64> { bank[field].as_array().unwrap().iter().map(|v| v.as_u64().unwrap()).collect() };
    assert_eq!(bank["recordings"], 18);
    let [nulls, alarms] = counts("false_alarms")[..] else { panic!() };
    assert!(nulls >= 5 && alarms == 0, "{alarms} of {nulls}");
    let [singles, _, within] = counts("singles_above_ten")[..] else { panic!() };
    // the priors of four effects that differ in kind: nearly all are told apart
    assert!(singles >= 1 && 10 * within >= 8 * singles, "{within} of {singles}");

    // six more: the eighteen stored ones are not computed again, and are the same
    let stored = memory.0.lock().unwrap().values().next().unwrap().clone();
    assert_eq!(stored.len(), 18);
    assert_eq!(run(24).bank.unwrap()["recordings"], 24);
    let more = memory.0.lock().unwrap().values().next().unwrap().clone();
    assert_eq!((more.len(), memory.0.lock().unwrap().len()), (24, 1));
    assert!(stored.iter().all(|(index, case)| more[index] == *case));
}
