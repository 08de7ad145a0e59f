//! The small table of the README: how good the diagnosis is, with its misses.
//!
//! Limits: a choice of rows; the whole tables are in `docs/results.md`.

use crate::{
    error::TablesError,
    markdown::Markdown,
    number::{median, three_digits},
    real::{Real, Recording},
    speed,
    study::{ROWS, Row, Score, met},
};
use std::path::Path;

/// Rows of the study that the README shows.
const SHOWN: [&str; 8] = [
    "false alarm: a cause is named where nothing is missing",
    "weak mismatch (d = 6) is noticed",
    "one cause, d >= 10: it is named",
    "one cause, d >= 10: it, or a set that holds it",
    "two causes, each d >= 16: both are named",
    "a single name stated without a rival is wrong",
    "unmodelled cause, d >= 16: gets a name of the library",
    "calibration error of stated probabilities",
];

/// Keys of the times that the README shows.
const TIMES: [&str; 2] = ["example", "million"];

/// The table.
pub(crate) fn table(root: &Path) -> Result<Markdown, TablesError> {
    let mut table = Markdown::new(&["question", "wanted", "result", "met"]);
    let score = Score::quoted(root)?;
    for row in ROWS.iter().filter(|row| SHOWN.contains(&row.means)) {
        let target = score.target(row)?;
        table.rows.push(vec![row.means.to_owned(), Row::wanted(row, target), row.result(target), met(target).to_owned()]);
    }
    for (question, result) in real(&Real::read(root)?.recordings) {
        table.rows.push(vec![question, String::new(), result, String::new()]);
    }
    for key in TIMES {
        let (what, time) = speed::of(root, key)?;
        table.rows.push(vec![what, String::new(), time, String::new()]);
    }
    Ok(table)
}

/// Two rows about the real recordings: what is said of them, and how well the fuller model predicts rows left out.
fn real(recordings: &[Recording]) -> [(String, String); 2] {
    let count = recordings.len();
    [
        (format!("{count} real recordings: answers"), verdicts(recordings)),
        (format!("{count} real recordings: error on rows left out, over the noise"), over_the_noise(recordings)),
    ]
}

/// How many recordings got which verdict, the most frequent first.
fn verdicts(recordings: &[Recording]) -> String {
    let mut counts: Vec<(usize, &str)> = Vec::new();
    for recording in recordings {
        match counts.iter_mut().find(|(_, verdict)| *verdict == recording.verdict) {
            Some((count, _)) => *count += 1,
            None => counts.push((1, &recording.verdict)),
        }
    }
    counts.sort_by(|a, b| b.0.cmp(&a.0).then(a.1.cmp(b.1)));
    counts.iter().map(|(count, verdict)| format!("{count} `{verdict}`")).collect::<Vec<_>>().join(", ")
}

/// Held-out errors of the fuller model over the noise: the median, and the worst with its name.
fn over_the_noise(recordings: &[Recording]) -> String {
    let ratio = |r: &Recording| r.held_out.filter(|_| r.noise > 0.0).map(|(_, after)| (after / r.noise, r.name.clone()));
    let ratios: Vec<(f64, String)> = recordings.iter().filter_map(ratio).collect();
    let middle = median(ratios.iter().map(|(ratio, _)| *ratio).collect());
    match (middle, ratios.iter().max_by(|a, b| a.0.total_cmp(&b.0))) {
        (Some(middle), Some((worst, name))) => {
            format!("median {}, worst {} ({name})", three_digits(middle), three_digits(*worst))
        }
        _ => "none could be predicted".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recording(name: &str, verdict: &str, held_out: Option<f64>) -> Recording {
        Recording {
            name: name.into(),
            sha256: String::new(),
            rows: 1,
            base: "stack".into(),
            unit: "pF".into(),
            verdict: verdict.into(),
            findings: Vec::new(),
            in_sample: (2.0, 1.0),
            held_out: held_out.map(|after| (2.0, after)),
            permutation_control: None,
            noise: 0.5,
            seconds: 1.0,
        }
    }

    #[test]
    fn the_worst_recording_is_named_and_one_without_a_prediction_is_not_counted() {
        let recordings =
            [recording("a", "agrees", Some(0.5)), recording("b", "wrong_form", Some(2.0)), recording("c", "wrong_form", None)];
        assert_eq!(verdicts(&recordings), "2 `wrong_form`, 1 `agrees`");
        assert_eq!(over_the_noise(&recordings), "median 2.50, worst 4.00 (b)");
        assert_eq!(over_the_noise(&recordings[2..]), "none could be predicted");
    }

    #[test]
    fn every_shown_row_is_one_of_the_study() {
        assert!(SHOWN.iter().all(|shown| ROWS.iter().any(|row| row.means == *shown)));
    }
}
