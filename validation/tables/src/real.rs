//! What the tool says of the real recordings: one record a recording.
//!
//! Limits: answers and errors only; no row of a recording is kept.

use crate::{
    error::TablesError,
    markdown::Markdown,
    number::{three_digits, whole_percent},
};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The result file, from the root of the repository.
pub const REAL: &str = "validation/recordings/real.json";

/// Rivals that the table spells out; more are counted.
const SPELLED_OUT: usize = 3;

/// Answers to the real recordings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Real {
    /// the command that made each answer
    pub command: String,
    /// one a recording, in order of their names
    pub recordings: Vec<Recording>,
}

/// The answer to one recording.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Recording {
    /// folder and file, `foam-insole/hold`
    pub name: String,
    /// first twelve digits of the SHA-256 of its CSV
    pub sha256: String,
    /// rows
    pub rows: u64,
    /// base model
    pub base: String,
    /// unit of the errors
    pub unit: String,
    /// verdict
    pub verdict: String,
    /// what is named
    pub findings: Vec<Finding>,
    /// root-mean-square error in sample, before and after
    pub in_sample: (f64, f64),
    /// the same on rows left out; `None` where none could be predicted
    pub held_out: Option<(f64, f64)>,
    /// share of the held-out misfit that columns of equal freedom with a permuted history remove
    pub permutation_control: Option<f64>,
    /// noise
    pub noise: f64,
    /// wall-clock time of the diagnosis, s
    pub seconds: f64,
}

/// An effect that is named.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// effect
    pub effect: String,
    /// its probability
    pub probability: f64,
    /// effects that the recording cannot tell from it
    pub rivals: Vec<String>,
}

impl Real {
    /// The result file of the repository in `root`.
    ///
    /// # Errors
    /// [`TablesError`] where it cannot be read.
    pub fn read(root: &Path) -> Result<Self, TablesError> {
        let path = root.join(REAL);
        let text = std::fs::read_to_string(&path).map_err(TablesError::at(&path))?;
        serde_json::from_str(&text).map_err(|source| TablesError::Json { path, source })
    }

    /// Writes the result file of the repository in `root`.
    ///
    /// # Errors
    /// [`TablesError::File`] where it cannot be written.
    pub fn write(&self, root: &Path) -> Result<(), TablesError> {
        let path = root.join(REAL);
        let text = serde_json::to_string_pretty(self).map_err(|source| TablesError::Json { path: path.clone(), source })?;
        std::fs::write(&path, text + "\n").map_err(TablesError::at(&path))
    }

    /// One row a recording.
    pub(crate) fn table(&self) -> Markdown {
        let header =
            ["recording", "answer", "RMSE before -> after, in sample", "held out", "noise", "permuted history removes", "time"];
        let mut table = Markdown::new(&header);
        table.rows.extend(self.recordings.iter().map(Recording::cells));
        table
    }
}

impl Recording {
    fn cells(&self) -> Vec<String> {
        let arrow = |(before, after): (f64, f64)| format!("{} -> {}", three_digits(before), three_digits(after));
        vec![
            self.name.clone(),
            self.answer(),
            format!("{} {}", arrow(self.in_sample), self.unit),
            self.held_out.map_or_else(|| "none could be predicted".to_owned(), arrow),
            three_digits(self.noise),
            self.permutation_control.map_or_else(String::new, |share| format!("{} %", whole_percent(share))),
            format!("{:.1} s", self.seconds),
        ]
    }

    /// Verdict and names: `ambiguous: clock_rate; load_cell_error or mullins_softening`.
    fn answer(&self) -> String {
        let named: Vec<String> = self.findings.iter().map(Finding::names).collect();
        if named.is_empty() { self.verdict.clone() } else { format!("{}: {}", self.verdict, named.join("; ")) }
    }
}

impl Finding {
    fn names(&self) -> String {
        let (told, rest) = self.rivals.split_at(self.rivals.len().min(SPELLED_OUT - 1));
        let mut names: Vec<&str> = vec![&self.effect];
        names.extend(told.iter().map(String::as_str));
        let others = if let [only] = rest { only.clone() } else { format!("one of {} others", rest.len()) };
        if !rest.is_empty() {
            names.push(&others);
        }
        names.join(" or ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_rivals_are_counted() {
        let named = |rivals: &[&str]| {
            let rivals = rivals.iter().map(|&rival| rival.to_owned()).collect();
            Finding { effect: "a".into(), probability: 0.5, rivals }.names()
        };
        assert_eq!(named(&[]), "a");
        assert_eq!(named(&["b", "c"]), "a or b or c");
        assert_eq!(named(&["b", "c", "d"]), "a or b or c or d");
        assert_eq!(named(&["b", "c", "d", "e"]), "a or b or c or one of 2 others");
    }
}
