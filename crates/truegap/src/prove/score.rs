//! Compares key, recordings and answers with their hashes, opens the key, and counts.
//!
//! Limits: the rules are the generator's, which shares no code with the diagnosis.

use super::answers::place;
use super::controls::RULES;
use super::error::{ProveError, json, read, write};
use super::plan::Plan;
use super::result::{CaseScore, Control, Score, Worded};
use super::seal::{Answers, commitments};
use super::{document, fresh};
use serde_json::Value;
use std::path::Path;
use truegap_generator::commitment::{COMMITMENTS, sha256};
use truegap_generator::score::folder::score_folder;
use truegap_generator::score::judge::Outcome;
use truegap_generator::score::targets::{Row, by_detectability, rows};
use truegap_generator::score::{Scored, score as judged, table};
use truegap_generator::score::{coverage, mechanisms};

/// Detectability from which a model is tried on a fresh history, as the target has it.
const STRONG: f64 = 16.0;

/// Scores the study in `folder` and writes `score.json` and `score.md`; `command` is for the record.
///
/// # Errors
/// [`ProveError`] where a file is not what was committed to, an answer not what was written down, or a file cannot be read or written.
pub fn score(folder: &Path, command: &str) -> Result<Score, ProveError> {
    let plan = Plan::read(folder)?;
    let commitments = commitments(folder, &plan.names())?;
    let answers = Answers::open(folder)?;
    let refused = answers.refused(&plan.names(), &commitments)?;
    let mut scored = score_folder(folder, &folder.join("diagnoses"))?.scored;
    let study = plan.study()?;
    let mut diagnoses = Vec::new();
    let mut others = Vec::new();
    let mut not_tried_afresh = Vec::new();
    for case in &mut scored {
        let diagnosis: Value = json(&place(folder, &case.truth.case).join("diagnosis.json"))?;
        case.seconds = diagnosis["seconds"].as_f64();
        if !case.truth.is_null()
            && (case.truth.stranger.is_none() || case.truth.words.is_some())
            && case.truth.detectability >= STRONG
        {
            match fresh::misfit(folder, &study, &case.truth.case, &commitments) {
                Ok(share) => case.fresh_misfit_removed = Some(share),
                Err(reason) => not_tried_afresh.push((case.truth.case.clone(), reason)),
            }
        }
        diagnoses.push(diagnosis);
        others.push(json(&place(folder, &case.truth.case).join("controls.json"))?);
    }
    let score = Score {
        plan,
        version: env!("CARGO_PKG_VERSION"),
        commitments_sha256: sha256(read(&folder.join(COMMITMENTS))?),
        answers_sha256: answers.sha256(),
        targets: targets(&scored),
        by_detectability: by_detectability(&scored),
        controls: controls(folder, &scored, &diagnoses, &others)?,
        process_misfit_removed: process_median(&scored, &others),
        cases: scored.iter().map(case_score).collect(),
        refused,
        not_tried_afresh,
        table: table::table(&scored),
    };
    let path = folder.join("score.json");
    let text = serde_json::to_string_pretty(&score).map_err(|source| ProveError::Json { path: path.clone(), source })?;
    write(&path, &(text + "\n"))?;
    write(&folder.join("score.md"), &document::markdown(&score, command))?;
    Ok(score)
}

/// The targets of any study, how often intervals cover, then the targets of baths and mechanisms where there are some.
fn targets(scored: &[Scored]) -> Vec<Row> {
    rows(scored).into_iter().chain(coverage::rows(scored)).chain(mechanisms::rows(scored)).collect()
}

/// The controls that claim a share; medians and probabilities are not theirs.
fn controls(folder: &Path, scored: &[Scored], diagnoses: &[Value], others: &[Value]) -> Result<Vec<Control>, ProveError> {
    let counted = |says: &str, claims: Vec<Value>| {
        let judgements = scored.iter().zip(&claims).map(|(case, claim)| {
            let path = || place(folder, &case.truth.case).join("diagnosis.json");
            judged(case.truth.clone(), claim).map_err(|source| ProveError::Claim { path: path(), source })
        });
        let targets = rows(&judgements.collect::<Result<Vec<_>, _>>()?).into_iter().filter(|row| row.hits.is_some()).collect();
        Ok(Control { says: says.to_owned(), targets })
    };
    let rules = RULES.iter().map(|rule| counted(rule.says, diagnoses.iter().map(rule.claims).collect()));
    let sparse = counted(SPARSE, others.iter().map(|o| o["sparse"].clone()).collect());
    rules.chain(std::iter::once(sparse)).collect()
}

/// What the sparse regression is.
const SPARSE: &str =
    "sparse regression on the residual (thresholded least squares over a dictionary of the inputs), its terms read as physics";

/// Median share that the Gaussian process removes where the causes are of the library and strong.
fn process_median(scored: &[Scored], others: &[Value]) -> Option<(f64, usize)> {
    let strong = |case: &Scored| !case.truth.causes.is_empty() && case.truth.detectability >= STRONG;
    let share = |(_, other): (&Scored, &Value)| other["process_misfit_removed"].as_f64();
    let mut shares: Vec<f64> = scored.iter().zip(others).filter(|(case, _)| strong(case)).filter_map(share).collect();
    shares.sort_by(f64::total_cmp);
    shares.get(shares.len() / 2).map(|median| (*median, shares.len()))
}

fn case_score(case: &Scored) -> CaseScore {
    let truth = &case.truth;
    let stranger = truth.stranger.iter().map(|name| format!("stranger:{name}"));
    CaseScore {
        case: truth.case.clone(),
        protocol: truth.protocol.clone(),
        concealed: truth.causes.iter().cloned().chain(stranger).collect(),
        detectability: truth.detectability,
        verdict: case.claim.verdict.clone(),
        named: case.claim.findings.clone(),
        outcome: outcome(case.outcome).to_owned(),
        words: mechanisms::judged(case).map(|right| Worded { said: case.claim.mechanism.clone(), right }),
        fresh_misfit_removed: case.fresh_misfit_removed,
        seconds: case.seconds,
    }
}

fn outcome(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Right => "right",
        Outcome::WithinSet => "within_set",
        Outcome::Partial => "partial",
        Outcome::Unnamed => "unnamed",
        Outcome::Wrong => "wrong",
        Outcome::Missed => "missed",
    }
}
