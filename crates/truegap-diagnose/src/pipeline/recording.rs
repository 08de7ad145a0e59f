//! A recording as it was read, and a simulator: the shortest way to a diagnosis.
//!
//! Limits: one recording of one sensor, and nobody who watches or stops; for more there is [`diagnose`].

use super::{Options, diagnose};
use crate::{
    answer::{diagnosis::RecordingFacts, outcome::Outcome},
    data::{error::DiagnoseError, problem::Problem},
};
use std::sync::atomic::AtomicBool;
use truegap_core::{Recording, Simulator};

/// Diagnoses `recording` against `simulator`, whose unit must be the recording's; `examples/diagnose_csv.rs` is a whole program around it.
///
/// # Errors
/// [`DiagnoseError`] where the recording cannot tell anything or the simulator has no answer.
pub fn diagnose_recording(recording: &Recording, simulator: &dyn Simulator, options: &Options) -> Result<Outcome, DiagnoseError> {
    let problem = Problem { inputs: &recording.inputs, response: &recording.response, simulator };
    diagnose(&problem, facts(recording), options, &|_| (), &AtomicBool::new(false))
}

fn facts(recording: &Recording) -> RecordingFacts {
    RecordingFacts {
        rows: recording.len(),
        runs: recording.inputs.runs().len(),
        sha256: recording.sha256.clone(),
        source: recording.path.display().to_string(),
        ..RecordingFacts::default()
    }
}
