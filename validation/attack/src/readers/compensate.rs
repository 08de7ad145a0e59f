//! A model file and a recording that is to be corrected by it, in one text.
//!
//! Limits: a base model that is a program is not started, as a changed word of it would be another program.

use std::path::Path;
use truegap::diagnosis::compensate::firmware::{Asked, firmware_of};
use truegap::diagnosis::compensate::{Compensated, Wanted, compensate_with};
use truegap::model::BaseModel;
use truegap::models::{ModelFile, Programs};
use truegap_core::Recording;

/// Lines behind which the TOML of the recording and its rows stand.
const PARTS: [&str; 2] = ["=== recording\n", "=== rows\n"];

/// Whether readings are corrected, or what is unsound in the answer.
pub(super) fn compensate(text: &str) -> Result<bool, String> {
    let (model, rest) = text.split_once(PARTS[0]).unwrap_or((text, ""));
    let (toml, rows) = rest.split_once(PARTS[1]).unwrap_or((rest, ""));
    let Ok(recording) = Recording::from_text("r", toml, rows) else { return Ok(false) };
    let file = Path::new("m.toml");
    let model = ModelFile::parse(model, file);
    if model.as_ref().is_ok_and(|model| matches!(model.base, BaseModel::Command { .. })) {
        return Ok(false);
    }
    let model = match model {
        Ok(model) => model,
        Err(refused) => return told(&refused.to_string()).map(|()| false),
    };
    in_c(&model, file)?;
    // what follows the clock and what is only carried as well, so that the most is corrected for
    let everything = Wanted { of_the_clock: true, carried: true };
    match compensate_with(&model, file, recording, None, everything, &Programs::default()) {
        Ok(found) => sound(&found).map(|()| true),
        Err(refused) => told(&refused.to_string()).map(|()| false),
    }
}

/// Bytes of a table that is made for each changed text.
const BYTES: usize = 256;

/// The same model for a microcontroller: written with finite numbers, or refused with a remedy.
fn in_c(model: &ModelFile, file: &Path) -> Result<(), String> {
    match firmware_of(model, file, &Asked { bytes: BYTES, carried: true, ..Asked::default() }) {
        Ok(made) => match ["NaN", "inf"].into_iter().find(|word| made.source.contains(&format!("{word}f"))) {
            Some(word) => Err(format!("the firmware holds {word}")),
            None => Ok(()),
        },
        Err(refused) => told(&refused.to_string()),
    }
}

/// Every number is one, in the rows, in the document and in its sentences.
fn sound(found: &Compensated) -> Result<(), String> {
    if let Some((name, _)) = found.table().iter().find(|(_, column)| column.iter().any(|value| !value.is_finite())) {
        return Err(format!("column {name} is not finite, and nothing says so"));
    }
    let document = &found.document;
    let error = document.error.as_ref();
    let errors = error.into_iter().flat_map(|error| [error.before, error.after]);
    let mut numbers = [document.left, document.noise, document.noise_growth].into_iter().chain(errors);
    if let Some(number) = numbers.find(|number| !number.is_finite() || *number < 0.0) {
        return Err(format!("a size of {number}: {}", document.says));
    }
    Ok(())
}

/// A refusal is one paragraph that ends with what to do.
fn told(refusal: &str) -> Result<(), String> {
    match refusal.contains("; ") && !refusal.contains('\n') {
        true => Ok(()),
        false => Err(format!("a refusal without a remedy, or of several lines: {refusal}")),
    }
}
