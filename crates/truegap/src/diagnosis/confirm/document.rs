//! The answer: `confirmation.json`, its sentence, and the columns of `confirmation.csv`.
//!
//! Limits: decides nothing.

use super::ConfirmError;
use crate::output::OutputFolder;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use truegap_core::Recording;
use truegap_diagnose::answer::{Confirmation, Errors};
use truegap_diagnose::confirmation::{Compared, Judgement, LEVEL, NoiseFloor};
use truegap_diagnose::text::{capitalised, p_value, significant, spoken_list};

/// Identifier of the document.
pub const SCHEMA: &str = "truegap.confirmation/1";
/// Names of the files that are written.
pub const FILES: [&str; 2] = ["confirmation.json", "confirmation.csv"];

/// The answer and its columns.
pub struct Confirmed {
    /// the answer
    pub document: Confirmation,
    pub(super) recording: Recording,
    pub(super) base: Vec<f64>,
    pub(super) augmented: Vec<f64>,
}

/// `confirmed`, `refuted` or `cannot tell`.
pub fn words(judgement: Judgement) -> &'static str {
    judgement.words()
}

pub(super) fn says(test: &Compared, errors: [&Errors; 2], noise: &NoiseFloor, unit: &str, effects: &[String]) -> String {
    let added = spoken_list(effects, "and");
    let [before, after, floor] = [errors[0].rmse, errors[1].rmse, noise.rmse].map(|error| significant(error, 3));
    let test_says = format!(
        "in {} of {} blocks with it the error is smaller, p = {}, level {:.0} %",
        test.better_in,
        test.blocks,
        p_value(test.p_value),
        100.0 * LEVEL
    );
    let errors = format!("error {before} {unit} without and {after} {unit} with it, noise {floor} {unit}");
    let predict = if effects.len() > 1 { "predict" } else { "predicts" };
    match test.judgement {
        Judgement::Confirmed => format!("{} {predict} this recording better ({errors}; {test_says}).", capitalised(&added)),
        Judgement::Refuted => format!("{} {predict} this recording worse ({errors}; {test_says}).", capitalised(&added)),
        Judgement::CannotTell => {
            format!("Whether {added} {predict} this recording better cannot be told ({errors}; {test_says}).")
        }
    }
}

impl Confirmed {
    /// Every row with both predictions, in the response's unit; gain and offset as fitted.
    pub fn csv(&self) -> String {
        let time = self.recording.inputs.time_s.as_ref();
        let mut text =
            String::from(if time.is_some() { "run,time_s,recorded,base,augmented\n" } else { "run,recorded,base,augmented\n" });
        for (row, run) in self.recording.inputs.run.iter().enumerate() {
            let clock = time.map_or_else(String::new, |t| format!("{},", t[row]));
            let (read, base, augmented) = (self.recording.response[row], self.base[row], self.augmented[row]);
            let _ = writeln!(text, "{run},{clock}{read},{base},{augmented}"); // writing to a String cannot fail
        }
        text
    }

    /// The columns of that CSV.
    pub fn table(&self) -> Vec<(String, Vec<f64>)> {
        let run = self.recording.inputs.run.iter().map(|run| f64::from(*run)).collect();
        let time = self.recording.inputs.time_s.clone().map(|time| ("time_s", time));
        let read = [("recorded", &self.recording.response), ("base", &self.base), ("augmented", &self.augmented)];
        let read = read.map(|(name, column)| (name, column.clone()));
        let columns = std::iter::once(("run", run)).chain(time).chain(read);
        columns.map(|(name, column)| (name.to_owned(), column)).collect()
    }

    /// Writes confirmation.json and confirmation.csv, both or none.
    ///
    /// # Errors
    /// [`ConfirmError`] where the disk refuses.
    pub fn write(&self, folder: &Path) -> Result<PathBuf, ConfirmError> {
        let out = OutputFolder::begin(folder)?;
        out.write(FILES[0], serde_json::to_string_pretty(&self.document)? + "\n")?;
        out.write(FILES[1], self.csv())?;
        Ok(out.publish()?)
    }
}
