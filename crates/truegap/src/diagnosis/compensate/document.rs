//! The answer: its document, its sentence, and the CSV of corrected readings.
//!
//! Limits: decides nothing.

use super::CompensateError;
use crate::models::LeftOut;
use serde::Serialize;
use std::fmt::Write;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use truegap_diagnose::answer::{ModelFacts, OtherFacts};
use truegap_diagnose::compensation::Stopped;
use truegap_diagnose::text::{significant, spoken_list};

/// Identifier of the document.
pub const SCHEMA: &str = "truegap.compensation/1";
/// What is left over the noise of a reading, from where on it is not called noise.
const MORE_THAN_NOISE: f64 = 2.0;
/// Columns by which an earlier result is known.
const COLUMNS: &str = "reading,corrected";
/// Bytes of a first line that are looked at.
const LONGEST_HEADER: u64 = 4096;

/// The input that was estimated.
#[derive(Clone, Debug, Serialize)]
pub struct Estimated {
    /// the column
    pub input: String,
    /// its unit; empty where it is not known
    pub unit: String,
    /// rows whose reading no input of the base model gives: what was added is taken at the nearest
    pub rows_outside: usize,
}

/// Errors against what the base model says at the recorded input.
#[derive(Clone, Debug, Serialize)]
pub struct Gained {
    /// of the reading as it was recorded, root mean square, response unit
    pub before: f64,
    /// of the corrected reading
    pub after: f64,
}

/// The answer.
#[derive(Clone, Debug, Serialize)]
pub struct Compensation {
    /// always `truegap.compensation/1`
    pub schema: &'static str,
    /// program and version
    pub made_by: String,
    /// the model
    pub model: ModelFacts,
    /// the recording
    pub recording: OtherFacts,
    /// unit of the reading
    pub unit: String,
    /// effects for which the reading is corrected
    pub corrected_for: Vec<String>,
    /// the other added effects
    pub left_out: Vec<LeftOut>,
    /// the input that was estimated from the reading; absent where nothing had to be
    #[serde(skip_serializing_if = "Option::is_none")]
    pub estimated: Option<Estimated>,
    /// passes that were made
    pub passes: usize,
    /// why there was no further pass
    pub stopped: Stopped,
    /// root mean square of the reading less what the augmented model gives at the estimated input, response unit
    pub left: f64,
    /// noise of the reading that the model file states, response unit
    pub noise: f64,
    /// noise of a corrected reading over that of a reading, where it is white
    pub noise_growth: f64,
    /// errors with and without the correction; absent where the true input was not recorded
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<Gained>,
    /// the answer in a sentence
    pub says: String,
    /// what a reader should know beside it
    pub notes: Vec<String>,
}

impl Compensation {
    /// Whether the augmented model explains the reading as far as its noise allows to see, and the correction does no harm where that is known.
    pub fn explains(&self) -> bool {
        let at_noise = match self.stopped {
            Stopped::AtNoise => !self.leaves_more_than_noise(),
            stopped => stopped == Stopped::Balanced,
        };
        at_noise && !self.harms()
    }

    /// Whether the corrected readings are farther from the truth, where that was recorded, than the readings were.
    pub fn harms(&self) -> bool {
        self.error.as_ref().is_some_and(|error| error.after > error.before)
    }

    /// Whether more than the noise is left although no more is than noise would leave on its way through the model: the model makes it larger than it is.
    fn leaves_more_than_noise(&self) -> bool {
        self.noise > 0.0 && self.left > MORE_THAN_NOISE * self.noise
    }

    pub(super) fn sentence(&self) -> String {
        let names = spoken_list(&self.corrected_for, "and");
        let unit = &self.unit;
        let passes = if self.passes == 1 { "1 pass".to_owned() } else { format!("{} passes", self.passes) };
        let mut says = format!("Corrected for {names} in {passes}");
        if let Some(Gained { before, after }) = self.error {
            let [before, after] = [before, after].map(|error| significant(error, 3));
            let _ = write!(says, ": error {before} {unit} before and {after} {unit} after"); // writing to a String cannot fail
        }
        let left = significant(self.left, 3);
        let ends = match self.stopped {
            Stopped::AtNoise if self.leaves_more_than_noise() => {
                let times = significant(self.left / self.noise, 2);
                format!(
                    "the model leaves {left} {unit} of the reading, {times} times its noise, and makes the noise so large on the way that no pass can tell the two apart"
                )
            }
            Stopped::AtNoise => "the model leaves no more of the reading than its noise".to_owned(),
            Stopped::Balanced => "a further pass would bring more noise than it takes error away".to_owned(),
            Stopped::NoLongerFalls => {
                format!("the model leaves {left} {unit} of the reading, and a further pass would leave no less")
            }
            Stopped::NoiseGrows => {
                format!("the model leaves {left} {unit} of the reading, and a further pass would bring too much noise")
            }
            Stopped::LastPass => format!("the model leaves {left} {unit} of the reading after the last pass that is made"),
        };
        let (noise, grown) = (significant(self.noise, 3), significant(self.noise_growth, 3));
        let harm = if self.harms() {
            " The corrected readings are farther from what the base model gives at the recorded input than the readings were: the correction does harm here, and should not be used."
        } else {
            ""
        };
        says + &format!("; {ends}. The noise, {noise} {unit}, has grown by a factor of {grown}.{harm}")
    }
}

/// The answer and its rows.
pub struct Compensated {
    /// the answer
    pub document: Compensation,
    pub(super) run: Vec<u32>,
    /// everything behind the run
    pub(super) columns: Vec<(String, Vec<f64>)>,
}

impl Compensated {
    /// What of the answer is no finite number; `None` where all of it is.
    pub(super) fn not_finite(&self) -> Option<String> {
        for (name, column) in &self.columns {
            if let Some(row) = column.iter().position(|value| !value.is_finite()) {
                return Some(format!("`{name}` of row {}", row + 1));
            }
        }
        let Compensation { left, noise_growth, error, .. } = &self.document;
        let errors = error.iter().flat_map(|error| [("the error before", error.before), ("the error after", error.after)]);
        let mut sizes = [("what the model leaves", *left), ("the growth of the noise", *noise_growth)].into_iter().chain(errors);
        sizes.find(|(_, size)| !size.is_finite()).map(|(name, _)| name.to_owned())
    }

    /// Every row: run, time where there is one, reading, corrected reading, and the estimated input.
    pub fn csv(&self) -> String {
        let names: Vec<&str> = self.columns.iter().map(|(name, _)| name.as_str()).collect();
        let mut text = format!("run,{}\n", names.join(","));
        for (row, run) in self.run.iter().enumerate() {
            let _ = write!(text, "{run}"); // writing to a String cannot fail
            for (_, column) in &self.columns {
                let _ = write!(text, ",{}", column[row]);
            }
            text.push('\n');
        }
        text
    }

    /// The columns of that CSV.
    pub fn table(&self) -> Vec<(String, Vec<f64>)> {
        let run = self.run.iter().map(|run| f64::from(*run)).collect();
        std::iter::once(("run".to_owned(), run)).chain(self.columns.iter().cloned()).collect()
    }

    /// Writes the rows, all or none; an earlier result is replaced.
    ///
    /// # Errors
    /// [`CompensateError`] where something else has the name, or the disk refuses.
    pub fn write(&self, file: &Path) -> Result<(), CompensateError> {
        check(file)?;
        Ok(truegap_sweep::write_atomically(file, self.csv().as_bytes())?)
    }
}

/// Whether `file` may be written: it is not there, or an earlier result. Asked before the work begins.
///
/// # Errors
/// [`CompensateError::WouldBeLost`].
pub fn check(file: &Path) -> Result<(), CompensateError> {
    if spares(file, is_header) { Ok(()) } else { Err(CompensateError::WouldBeLost { file: file.to_owned() }) }
}

/// Whether nothing but an earlier result would be lost where `file` is written; `is_ours` knows one by its first line.
pub(super) fn spares(file: &Path, is_ours: fn(&str) -> bool) -> bool {
    if !file.exists() {
        return true;
    }
    // a pipe or a device is never looked at: it may wait for ever, or never end
    if !file.metadata().is_ok_and(|of| of.is_file()) {
        return false;
    }
    let mut first = String::new();
    let read = File::open(file).and_then(|file| BufReader::new(file.take(LONGEST_HEADER)).read_line(&mut first));
    read.is_ok() && is_ours(first.trim_end())
}

/// Whether this is the first line of a result: run, time where there is one, both readings, the estimated input where there is one.
fn is_header(line: &str) -> bool {
    let Some(rest) = line.strip_prefix("run,").map(|rest| rest.strip_prefix("time_s,").unwrap_or(rest)) else { return false };
    let Some(rest) = rest.strip_prefix(COLUMNS) else { return false };
    rest.is_empty() || rest.strip_prefix(",estimated_").is_some_and(|input| !input.contains(','))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn document(left: f64, error: Option<Gained>) -> Compensation {
        let document = Compensation {
            schema: SCHEMA,
            made_by: String::new(),
            model: ModelFacts {
                file: String::new(),
                recording: String::new(),
                sha256: String::new(),
                verdict: "explained".into(),
                effects: Vec::new(),
                base_is_known: true,
            },
            recording: OtherFacts { source: String::new(), sha256: String::new(), rows: 30, runs: 1 },
            unit: "mV".into(),
            corrected_for: vec!["friction".into()],
            left_out: Vec::new(),
            estimated: None,
            passes: 1,
            stopped: Stopped::AtNoise,
            left,
            noise: 0.1,
            noise_growth: 1.0,
            error,
            says: String::new(),
            notes: Vec::new(),
        };
        Compensation { says: document.sentence(), ..document }
    }

    /// Nine times the noise was "no more than its noise", where the model makes noise so much larger.
    #[test]
    fn what_is_left_is_called_noise_where_it_is_as_large() {
        let (noise, more) = (document(0.105, None), document(0.9, None));
        assert!(noise.says.contains("leaves no more of the reading than its noise") && noise.explains(), "{}", noise.says);
        assert!(more.says.contains("leaves 0.900 mV of the reading, 9.0 times its noise") && !more.explains(), "{}", more.says);
    }

    #[test]
    fn a_correction_that_moves_away_from_the_truth_explains_nothing() {
        let worse = document(0.1, Some(Gained { before: 1.0, after: 1.2 }));
        assert!(worse.says.contains("farther from") && !worse.explains(), "{}", worse.says);
        assert!(document(0.1, Some(Gained { before: 1.0, after: 0.2 })).explains());
    }

    #[test]
    fn a_header_is_that_of_a_result_and_of_nothing_else() {
        for header in ["run,reading,corrected", "run,time_s,reading,corrected,estimated_force_n"] {
            assert!(is_header(header), "{header}");
        }
        for header in [
            "time_s,temperature_c,reading,corrected,operator_note",
            "reading,corrected notes of Friday",
            "run,time_s,force_n,reading,corrected",
            "",
        ] {
            assert!(!is_header(header), "{header}");
        }
    }
}
