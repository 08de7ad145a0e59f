//! The recovery bank: what this tool answers when the cause is known, for the protocol, noise and priors of *this* recording.
//!
//! Recordings are simulated on its own inputs (a third with nothing missing, single effects in the library's and in sibling equations, pairs, unmodelled causes),
//! sent through the same search, and the stated probabilities are corrected by how often they were right.
//!
//! Limits: the noise is taken as known; rows are merged further than for the recording itself; memory effects start fresh as they do there.

use crate::{
    adequacy::{directions::directions, lack_of_fit::LackOfFitTests},
    data::problem::Problem,
    fit::tuning::LOOSE,
    noise::block_average::block_averages,
    selection::{
        candidates::{Progress, Search},
        examine::{Examined, examine},
    },
    validation::recovery::{case::BankCase, confusion::Bank, key::key},
    validation::tuning::{BANK_ROWS, LIKELY_EFFECTS, LIKELY_FROM, STORE_EVERY},
    whitening::noise_model::NoiseModel,
};
use rayon::prelude::*;
use std::{
    collections::BTreeMap,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
};
use truegap_core::SimulationError;

/// Keeps finished recordings of a bank between runs of the program.
pub trait BankStore: Send + Sync {
    /// Recordings stored under a key, by their number.
    fn load(&self, key: &str) -> BTreeMap<usize, BankCase>;
    /// Stores them; what cannot be stored is computed again next time.
    fn save(&self, key: &str, cases: &BTreeMap<usize, BankCase>);
}

/// What a caller may choose of the bank.
pub struct BankOptions {
    /// simulated recordings
    pub recordings: usize,
    /// where finished ones are kept
    pub store: Box<dyn BankStore>,
}

impl std::fmt::Debug for BankOptions {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("BankOptions").field("recordings", &self.recordings).finish_non_exhaustive()
    }
}

/// Every row of the recording, and its noise.
#[derive(Clone, Copy)]
pub struct Whole<'a> {
    /// inputs, denoised, and simulator
    pub problem: &'a Problem<'a>,
    /// noise of every row
    pub noise: &'a NoiseModel,
}

/// Simulates and searches the bank's recordings (those not stored yet), and counts.
///
/// # Errors
/// Those of the simulator at the centre of the prior.
pub fn fill(search: &Search<'_>, whole: Whole<'_>, found: &Examined, options: &BankOptions) -> Result<Bank, SimulationError> {
    let started = std::time::Instant::now();
    let averages = block_averages(whole.problem, whole.noise, BANK_ROWS)?;
    let (inputs, noise) =
        averages.as_ref().map_or_else(|| (whole.problem.inputs, whole.noise.clone()), |t| (&t.inputs, t.noise(whole.noise)));
    let whitener = noise.whitener(&inputs.runs(), None);
    let loose = noise.scaled(LOOSE).whitener(&inputs.runs(), None);
    let directions = directions(inputs, whole.problem.simulator);
    let likely = likely(search, found);
    let key = key(search, inputs, &noise, &likely);
    let known = options.store.load(&key);
    let open: Vec<usize> = (0..options.recordings).filter(|i| !known.contains_key(i)).collect();
    let cases = Mutex::new(known);
    let done = AtomicUsize::new(options.recordings - open.len());
    let quiet = |_: Progress| {};
    let blank = vec![0.0; inputs.len()];
    let template = Problem { inputs, response: &blank, simulator: whole.problem.simulator };
    // the bank's noise is taken as known
    let known_noise = NoiseModel { uncertainty: 0.0, ..noise.clone() };
    let lack_of_fit = LackOfFitTests::of(&template, &known_noise, &whitener, &directions, None);
    open.par_iter().with_max_len(1).for_each(|index| {
        if search.stop.load(Ordering::Relaxed) {
            return;
        }
        let maker =
            crate::validation::recovery::truth::Maker { search, template: &template, whitener: &whitener, likely: &likely };
        let Some((truth, response)) = maker.make(*index) else { return };
        let problem = Problem { inputs, response: &response, simulator: template.simulator };
        let library = search.library.clone();
        let own = Search {
            problem: &problem,
            context: search.context,
            library,
            whitener: &whitener,
            loose: &loose,
            scout: None,
            progress: &quiet,
            stop: search.stop,
        };
        let Ok(answer) = examine(&own, &lack_of_fit) else { return };
        if search.stop.load(Ordering::Relaxed) {
            return;
        }
        let mut cases = cases.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        cases.insert(*index, BankCase::of(truth, &answer, &own));
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        if cases.len().is_multiple_of(STORE_EVERY) {
            options.store.save(&key, &cases);
        }
        let done = count as f64 / options.recordings as f64;
        (search.progress)(Progress { step: "recovery bank", what: format!("recording {count}"), done });
    });
    let cases = cases.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    options.store.save(&key, &cases);
    let wanted: Vec<BankCase> = cases.into_iter().filter(|(i, _)| *i < options.recordings).map(|(_, c)| c).collect();
    Ok(Bank::of(wanted, key, inputs.len(), started.elapsed().as_secs_f64()))
}

/// Effects that this recording's answer turns on: named, or close to it; half of the bank's single effects are drawn from them.
fn likely(search: &Search<'_>, found: &Examined) -> Vec<usize> {
    let selection = &found.selection;
    let mut order: Vec<usize> = (0..search.library.len()).filter(|e| selection.effect_probability[*e] > LIKELY_FROM).collect();
    order.sort_by(|a, b| selection.effect_probability[*b].total_cmp(&selection.effect_probability[*a]));
    order.truncate(LIKELY_EFFECTS);
    order.sort_unstable();
    order
}
