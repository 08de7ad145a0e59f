//! Rows at an end of the converter's range, asked of the model that a diagnosis ends with: does it go on there?
//!
//! Limits: one recording by itself; where the model has no answer for the rows that were left out, nothing is added.

use super::Diagnosed;
use super::screen::Clipped;
use crate::models::ModelFileError;
use std::path::Path;
use truegap_diagnose::ceiling::{Ceiling, ceiling};

/// Puts the ceiling of the reading, where there is one, among what is missing.
pub(super) fn ceiling_named(diagnosed: &mut Diagnosed, clipped: &Clipped) {
    if let Ok(Some(found)) = asked(diagnosed, clipped) {
        diagnosed.outcome.with_ceiling(&found);
    }
}

/// What the fuller model says of the rows at one end, else of those at the other.
fn asked(diagnosed: &Diagnosed, clipped: &Clipped) -> Result<Option<Ceiling>, ModelFileError> {
    let model = diagnosed.model_file()?.build_of(Path::new("augmented.toml"), &diagnosed.programs)?;
    let mut inputs = clipped.whole.inputs.clone();
    model.as_followed(&mut inputs);
    let response = &clipped.whole.response;
    let respond = |knee: Option<f64>| match knee {
        None => model.respond(&inputs),
        Some(knee) => model.respond_with(&diagnosed.outcome.effects_with_ceiling(knee), &inputs),
    };
    // a range has two ends
    let greatest = clipped.rows.iter().map(|row| response[*row]).fold(f64::NEG_INFINITY, f64::max);
    let (upper, lower): (Vec<usize>, Vec<usize>) = clipped.rows.iter().partition(|row| response[**row] == greatest);
    match ceiling(response, &upper, respond) {
        Ok(Some(found)) => Ok(Some(found)),
        _ => ceiling(response, &lower, respond),
    }
}
