//! What words say of causes that the library does not hold (or was not allowed to): counts, and case by case with the misses first.
//!
//! Limits: which words are right is the scorer's, from the table of the generator; nothing is judged again here.

use crate::{error::TablesError, markdown::Markdown, number::whole_percent};
use serde::Deserialize;
use std::path::Path;

#[derive(Deserialize)]
struct Score {
    targets: Vec<Target>,
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Target {
    says: String,
    target: String,
    hits: Option<u64>,
    of: u64,
    value: Option<f64>,
    interval: (f64, f64),
    met: Option<bool>,
}

#[derive(Deserialize)]
struct Case {
    case: String,
    protocol: String,
    concealed: Vec<String>,
    detectability: f64,
    verdict: String,
    named: Vec<(String, Option<f64>)>,
    words: Option<Worded>,
}

#[derive(Deserialize)]
struct Worded {
    said: Option<Said>,
    right: Right,
}

#[derive(Deserialize)]
struct Said {
    place: String,
    driver: String,
    kinetics: String,
    named: bool,
    misfit_removed: Option<f64>,
}

#[derive(Clone, Copy, Deserialize, PartialEq, Eq, PartialOrd, Ord)]
struct Right {
    law: bool,
    place: bool,
    driver: bool,
    kinetics: bool,
}

fn read(path: &Path) -> Result<Score, TablesError> {
    let text = std::fs::read_to_string(path).map_err(TablesError::at(path))?;
    serde_json::from_str(&text).map_err(|source| TablesError::Json { path: path.to_owned(), source })
}

/// Begin of the rows of a score that are about mechanisms and what lies beside them.
pub(crate) const OF_MECHANISMS: [&str; 6] = ["mechanisms", "words of", "nulls with", "single causes:", "pairs:", "triples:"];

/// Begin of the rows of a score that say how often stated intervals cover.
pub(crate) const OF_NUMBERS: [&str; 1] = ["numbers of"];

/// Begin of the rows of a score that say how far stated probabilities are off.
pub(crate) const OF_PROBABILITIES: [&str; 2] = ["calibration error", "the same by chance"];

/// Rows of a score that begin with one of these.
pub(crate) fn counts(path: &Path, begin: &[&str]) -> Result<Markdown, TablesError> {
    let mut table = Markdown::new(&["question", "wanted", "result", "95 % interval", "met"]);
    let ours = |row: &&Target| begin.iter().any(|s| row.says.starts_with(s));
    for row in read(path)?.targets.iter().filter(ours) {
        // errors of probabilities are wanted below 0.05: to a whole percent nothing would be left of them
        let is_error = OF_PROBABILITIES.iter().any(|begin| row.says.starts_with(begin));
        let shown = |value: f64| if is_error { format!("{value:.3}") } else { format!("{} %", whole_percent(value)) };
        let value = row.value.map_or("-".to_owned(), shown);
        let result = row.hits.map_or(format!("{value} (of {})", row.of), |hits| format!("{hits} of {} ({value})", row.of));
        let interval = match row.interval {
            (low, high) if is_error => format!("{low:.3} to {high:.3}"),
            (low, high) => format!("{} to {} %", whole_percent(low), whole_percent(high)),
        };
        let met = row.met.map_or("", |met| if met { "yes" } else { "**no**" });
        table.rows.push(vec![row.says.clone(), row.target.clone(), result, interval, met.to_owned()]);
    }
    Ok(table)
}

/// Every mechanism of a score, misses first.
pub(crate) fn one_by_one(path: &Path) -> Result<Markdown, TablesError> {
    let mut table = Markdown::new(&[
        "concealed",
        "d",
        "protocol",
        "verdict",
        "driver",
        "kinetics",
        "place",
        "misfit removed",
        "names of the library",
    ]);
    let cases = read(path)?.cases;
    let mut worded: Vec<(&Case, &Worded)> = cases.iter().filter_map(|case| Some((case, case.words.as_ref()?))).collect();
    worded.sort_by(|(a, of_a), (b, of_b)| (of_a.right, &a.concealed, &a.case).cmp(&(of_b.right, &b.concealed, &b.case)));
    table.rows.extend(worded.into_iter().map(|(case, worded)| row(case, worded)));
    Ok(table)
}

fn row(case: &Case, worded: &Worded) -> Vec<String> {
    let concealed = case.concealed.join(", ").replace("stranger:", "");
    let said = |word: fn(&Said) -> &str, right: bool| match &worded.said {
        None => "-".to_owned(),
        Some(said) if right => word(said).to_owned(),
        Some(said) => format!("**{}**", word(said)),
    };
    let removed = worded.said.as_ref().and_then(|said| said.misfit_removed);
    let listed = if worded.said.as_ref().is_some_and(|said| !said.named) { ", listed only" } else { "" };
    let of_library = case.named.iter().map(|(name, _)| name.as_str()).filter(|name| !name.starts_with("discovered"));
    vec![
        format!("`{concealed}`"),
        format!("{:.0}", case.detectability),
        case.protocol.clone(),
        format!("`{}`{listed}", case.verdict),
        said(|s| &s.driver, worded.right.driver),
        said(|s| &s.kinetics, worded.right.kinetics),
        said(|s| &s.place, worded.right.place),
        removed.map_or(String::new(), |share| format!("{} %", whole_percent(share))),
        of_library.collect::<Vec<_>>().join(", "),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCORE: &str = r#"{
      "targets": [
        {"says": "false alarms, all nulls", "target": "<= 0.02", "hits": 0, "of": 4, "value": 0.0, "interval": [0.0, 0.5], "met": true},
        {"says": "mechanisms: driver right", "target": ">= 0.8", "hits": 1, "of": 2, "value": 0.5, "interval": [0.1, 0.9], "met": false},
        {"says": "calibration error of stated probabilities (ECE)", "target": "<= 0.05", "hits": null, "of": 52, "value": 0.2551, "interval": [0.192, 0.412], "met": false}],
      "cases": [
        {"case": "case-001", "protocol": "full", "concealed": ["stranger:hum"], "detectability": 30.2, "verdict": "explained", "named": [["discovered", 0.9]],
         "words": {"said": {"place": "readout", "driver": "time", "kinetics": "periodic", "named": true, "misfit_removed": 0.98},
                   "right": {"law": true, "place": true, "driver": true, "kinetics": true}}},
        {"case": "case-002", "protocol": "full", "concealed": ["ageing"], "detectability": 30.2, "verdict": "explained", "named": [["ageing", 0.9]]},
        {"case": "case-003", "protocol": "full", "concealed": ["stranger:latch"], "detectability": 28.0, "verdict": "explained", "named": [["dead_gap", 0.9]],
         "words": {"said": null, "right": {"law": false, "place": false, "driver": false, "kinetics": false}}}]}"#;

    #[test]
    fn misses_come_first_and_what_has_no_words_does_not_come() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("score.json");
        std::fs::write(&path, SCORE).unwrap();
        let rows = one_by_one(&path).unwrap().rows;
        assert_eq!(rows.len(), 2);
        assert_eq!((rows[0][0].as_str(), rows[0][8].as_str()), ("`latch`", "dead_gap"));
        assert_eq!((rows[1][4].as_str(), rows[1][7].as_str(), rows[1][8].as_str()), ("time", "98 %", ""));
        let counts = counts(&path, &OF_MECHANISMS).unwrap().rows;
        assert_eq!(counts, [["mechanisms: driver right", ">= 0.8", "1 of 2 (50 %)", "10 to 90 %", "**no**"]]);
    }

    #[test]
    fn errors_of_probabilities_keep_three_digits() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("score.json");
        std::fs::write(&path, SCORE).unwrap();
        let rows = counts(&path, &OF_PROBABILITIES).unwrap().rows;
        assert_eq!(rows.len(), 1);
        assert_eq!(rows[0][1..], ["<= 0.05", "0.255 (of 52)", "0.192 to 0.412", "**no**"]);
    }
}
