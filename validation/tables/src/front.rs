//! The small table of the README: how good the diagnosis is, with its misses.
//!
//! Limits: a choice of rows; the whole tables are in `docs/results.md`.

use crate::{
    csv,
    error::TablesError,
    markdown::Markdown,
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

/// Rows of the study that the page of what it cannot do shows.
const LIMITS: [&str; 4] = [
    "weak mismatch (d = 6) is noticed",
    "two causes, each d >= 16: both are named",
    "a single name stated without a rival is wrong",
    "unmodelled cause, d >= 16: gets a name of the library",
];

/// Keys of the times that the README shows.
const TIMES: [&str; 2] = ["example", "million"];

/// The table.
pub(crate) fn table(root: &Path) -> Result<Markdown, TablesError> {
    let mut table = of_the_study(root, &SHOWN)?;
    let recordings = Real::read(root)?.recordings;
    let question = format!("{} real recordings: answers", recordings.len());
    table.rows.push(vec![question, String::new(), verdicts(&recordings), String::new()]);
    let first_runs = root.join("validation/recordings/first-runs.csv");
    let table_of_packages = csv::read(&root.join("validation/recordings/packages.csv"))?;
    let Some((question, result)) = packaged(&table_of_packages, &csv::read(&first_runs)?) else {
        return Err(TablesError::NoRow { path: first_runs, row: ALL.into() });
    };
    table.rows.push(vec![question, String::new(), result, String::new()]);
    for key in TIMES {
        let (what, time) = speed::of(root, key)?;
        table.rows.push(vec![what, String::new(), time, String::new()]);
    }
    Ok(table)
}

/// The same rows as those of the README, in the page of what it cannot do.
pub(crate) fn limits(root: &Path) -> Result<Markdown, TablesError> {
    of_the_study(root, &LIMITS)
}

/// These rows of the study.
fn of_the_study(root: &Path, shown: &[&str]) -> Result<Markdown, TablesError> {
    let mut table = Markdown::new(&["question", "wanted", "result", "met"]);
    let score = Score::quoted(root)?;
    for row in ROWS.iter().filter(|row| shown.contains(&row.means)) {
        let target = score.target(row)?;
        table.rows.push(vec![row.means.to_owned(), Row::wanted(row, target), row.result(target), met(target).to_owned()]);
    }
    Ok(table)
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

/// Error on rows left out, over that of a model that was built by hand for the recording, up to which it is as near.
const AS_NEAR: f64 = 1.1;

/// The set of `first-runs.csv` that is the sum of all.
const ALL: &str = "all";

/// How many of the packaged recordings are predicted as a model built by hand predicts them: by the version that has seen them, counted here, and by those that had not, as the sum of the `first_runs` has it. These were
/// counted on the rows that each version left out, which later ones may leave out otherwise. `None` where there is no such sum.
fn packaged(table: &Markdown, first_runs: &Markdown) -> Option<(String, String)> {
    let cell = |of: &Markdown, row: &[String], column: &str| {
        let at = of.header.iter().position(|name| name == column)?;
        Some(row.get(at)?.trim().to_owned())
    };
    let number = |row: &[String], column: &str| cell(table, row, column)?.parse::<f64>().ok();
    let is_near = |row: &Vec<String>| Some(number(row, "held out")? <= AS_NEAR * number(row, "hand-built, held out")?);
    let now = table.rows.iter().filter(|row| is_near(row) == Some(true)).count();
    let all = first_runs.rows.iter().find(|row| cell(first_runs, row, "set").as_deref() == Some(ALL))?;
    let (near, of) = (cell(first_runs, all, "within 1.1")?, cell(first_runs, all, "recordings")?);
    let question = format!(
        "{} more recordings by other people: the error on rows left out is at most {AS_NEAR} times that of a model built by hand for the recording",
        table.rows.len()
    );
    Some((question, format!("at the first diagnosis {near} of {of}; now, after work on what went wrong, {now}")))
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
    fn verdicts_are_counted_and_the_most_frequent_is_first() {
        let recordings =
            [recording("a", "agrees", Some(0.5)), recording("b", "wrong_form", Some(2.0)), recording("c", "wrong_form", None)];
        assert_eq!(verdicts(&recordings), "2 `wrong_form`, 1 `agrees`");
    }

    #[test]
    fn a_packaged_recording_is_near_where_its_error_is_within_a_tenth_and_one_without_a_number_is_not() {
        let cells = |row: [&str; 3]| row.map(str::to_owned).to_vec();
        let header = cells(["hand-built, held out", "held out before", "held out"]);
        let rows = vec![cells(["1.0", "1.2", "1.09"]), cells(["2", " 1.5", "-"]), cells(["0.5", "0.56", "0.56"])];
        let sums = vec![cells(["first", "2", "1"]), cells(["all", "3", " 2"])];
        let first_runs = Markdown { header: cells(["set", "recordings", "within 1.1"]), rows: sums };
        let (question, result) = packaged(&Markdown { header, rows }, &first_runs).unwrap();
        assert!(
            question.starts_with("3 more") && result == "at the first diagnosis 2 of 3; now, after work on what went wrong, 1",
            "{question}: {result}"
        );
    }

    #[test]
    fn every_shown_row_is_one_of_the_study() {
        assert!(LIMITS.iter().all(|shown| SHOWN.contains(shown)));
        assert!(SHOWN.iter().all(|shown| ROWS.iter().any(|row| row.means == *shown)));
    }
}
