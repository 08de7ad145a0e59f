//! The whole search on histories that are not the recording's: how often does it find as much where there is nothing to find?
//!
//! What the calibrated base model leaves over keeps its size and its memory, and loses its place: runs are exchanged and each is turned about. Base model, candidates, pairs, triples and
//! evidence then see that recording as they saw the true one. The control beside a finding permutes the columns of what was found; here the choice is made again as well.
//!
//! Limits: noise and thresholds stay those of the recording; a cause that follows the clock alone (drift, a change of regime) goes with what is turned about, and is not tested.
//!
//! **Source:** Phipson & Smyth, Stat. Appl. Genet. Mol. Biol. 9, 39 (2010): a p-value of permutations counts the recording itself.

use crate::{
    answer::PermutedSearches,
    data::{error::DiagnoseError, problem::Problem},
    fit::model::Model,
    pipeline::{judged::Told, on_means::examined, prepare::Prepared},
    seeds::SEEDS,
    selection::{candidates::Progress, posterior::Selection, prior::log_prior},
    validation::permutation::permute,
};
use nalgebra::DMatrix;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::sync::atomic::Ordering;

/// Searches `count` permuted recordings; `None` where it was asked to stop before the first was done.
///
/// # Errors
/// Those of the simulator.
pub(super) fn permuted_searches(
    prepared: &Prepared<'_>,
    selection: &Selection,
    told: &Told<'_>,
    count: usize,
) -> Result<Option<PermutedSearches>, DiagnoseError> {
    let problem = prepared.problem;
    let model = Model::new(problem, &prepared.context, Vec::new());
    let misfit = model.misfit(&selection.base().fit.z)?;
    let predicted: Vec<f64> = problem.response.iter().zip(&misfit).map(|(reading, misfit)| reading - misfit).collect();
    let (runs, misfit) = (problem.runs_of_recordings(), DMatrix::from_vec(misfit.len(), 1, misfit));
    let random = &mut ChaCha8Rng::seed_from_u64(SEEDS.permuted_searches);
    let quiet = |_: Progress| {};
    let unheard = Told { options: told.options, progress: &quiet, asked: told.asked, stop: told.stop };
    let mut gains = Vec::new();
    while gains.len() < count && !told.stop.load(Ordering::Relaxed) {
        (told.progress)(under_way(gains.len(), count));
        let elsewhere = permute(&misfit, &runs, random);
        let response: Vec<f64> = predicted.iter().zip(elsewhere.iter()).map(|(value, misfit)| value + misfit).collect();
        let permuted = Problem { response: &response, ..*problem };
        let mut again = Prepared::new(&permuted, prepared.noise.clone(), told.options)?;
        let found = gain(&examined(&mut again, &unheard)?.selection, prepared.testable.len());
        // a search that was ended has not seen all that it could have found
        if !told.stop.load(Ordering::Relaxed) {
            gains.push(found);
        }
    }
    Ok((!gains.is_empty()).then(|| PermutedSearches::new(gain(selection, prepared.testable.len()), gains)))
}

/// How far it is: each search is one step, whatever it goes through itself.
fn under_way(searched: usize, count: usize) -> Progress {
    let what = format!("{} of {count}", searched + 1);
    Progress { step: "permuted histories", what, done: searched as f64 / count as f64 }
}

/// Log odds of the likeliest model that names something over the base model, evidence as it is; below 0 where nothing is likelier.
fn gain(selection: &Selection, library: usize) -> f64 {
    let log_odds = |effects: usize, log_evidence: f64| log_evidence + log_prior(effects, library);
    let nothing = log_odds(0, selection.base().fit.log_evidence);
    let named = selection.models.iter().filter(|m| !m.effects.is_empty());
    named.map(|m| log_odds(m.effects.len(), m.fit.log_evidence) - nothing).fold(f64::NEG_INFINITY, f64::max)
}
