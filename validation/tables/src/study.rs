//! The blind study to quote, the one before it, and the controls: what `truegap prove` wrote to `score.json`.
//!
//! Limits: counts are the scorer's; nothing is counted again but the causes one by one.

use crate::{error::TablesError, markdown::Markdown, number::whole_percent};
use serde::Deserialize;
use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

/// The study to quote, and the one of the engine that the table shows beside it.
const QUOTED: &str = "validation/blind/prove/seed-301126/score.json";
const BEFORE: &str = "validation/blind/prove/seed-291126/score.json";

/// What a score says; see `truegap prove`.
#[derive(Deserialize)]
pub(crate) struct Score {
    targets: Vec<Target>,
    by_detectability: Vec<Target>,
    controls: Vec<Control>,
    cases: Vec<Case>,
    #[serde(skip)]
    path: PathBuf,
}

/// One count or number of a score.
#[derive(Clone, Deserialize)]
pub(crate) struct Target {
    says: String,
    target: String,
    hits: Option<u64>,
    of: u64,
    value: f64,
    interval: (f64, f64),
    /// whether the target was met; `None` where there is none
    pub met: Option<bool>,
}

#[derive(Deserialize)]
struct Control {
    says: String,
    targets: Vec<Target>,
}

#[derive(Deserialize)]
struct Case {
    concealed: Vec<String>,
    outcome: String,
}

/// How a row of the score is called in the pages.
pub(crate) struct Row {
    /// what the score calls it
    says: &'static str,
    /// what a reader is told
    pub means: &'static str,
    kind: Kind,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Count,
    Number,
    Share,
    Seconds,
}

const fn row(says: &'static str, means: &'static str, kind: Kind) -> Row {
    Row { says, means, kind }
}

/// Rows of the study's table, in order.
pub(crate) const ROWS: [Row; 14] = [
    row("false alarms, all nulls", "false alarm: a cause is named where nothing is missing", Kind::Count),
    row("mismatch detected at d = 6 (5 to 7.2)", "weak mismatch (d = 6) is noticed", Kind::Count),
    row("the same where d counts the noise of the inputs", "the same where d counts the noise of the inputs", Kind::Count),
    row("family named, singles at d >= 10", "one cause, d >= 10: its family is named", Kind::Count),
    row("exact effect named, singles at d >= 10", "one cause, d >= 10: it is named", Kind::Count),
    row("exact or within its set, singles at d >= 10", "one cause, d >= 10: it, or a set that holds it", Kind::Count),
    row("pairs, both found, each d >= 16", "two causes, each d >= 16: both are named", Kind::Count),
    row(
        "pairs, both found or within their sets, each d >= 16",
        "two causes, each d >= 16: both, or sets that hold them",
        Kind::Count,
    ),
    row("wrong single claims", "a single name stated without a rival is wrong", Kind::Count),
    row("strangers called by a library name, d >= 16", "unmodelled cause, d >= 16: gets a name of the library", Kind::Count),
    row("calibration error of stated probabilities (ECE)", "calibration error of stated probabilities", Kind::Number),
    row("the same by chance, were each of them true (mean)", "the same by chance alone", Kind::Number),
    row(
        "misfit removed on fresh histories, d >= 16 (median)",
        "misfit removed on fresh histories, d >= 16 (median)",
        Kind::Share,
    ),
    row("seconds for a diagnosis (median)", "time of a diagnosis (median; this draw two at a time, a core each)", Kind::Seconds),
];

impl Score {
    fn read(root: &Path, name: &str) -> Result<Self, TablesError> {
        let path = root.join(name);
        let text = std::fs::read_to_string(&path).map_err(TablesError::at(&path))?;
        match serde_json::from_str(&text) {
            Ok(score) => Ok(Self { path, ..score }),
            Err(source) => Err(TablesError::Json { path, source }),
        }
    }

    /// The study to quote.
    pub fn quoted(root: &Path) -> Result<Self, TablesError> {
        Self::read(root, QUOTED)
    }

    /// The count of a row.
    pub fn target(&self, row: &Row) -> Result<&Target, TablesError> {
        self.find(&self.targets, row.says)
    }

    fn find<'a>(&self, targets: &'a [Target], says: &str) -> Result<&'a Target, TablesError> {
        let missing = || TablesError::NoRow { path: self.path.clone(), row: says.to_owned() };
        targets.iter().find(|target| target.says == says).ok_or_else(missing)
    }

    fn control(&self, begins: &str) -> Result<&[Target], TablesError> {
        let missing = || TablesError::NoRow { path: self.path.clone(), row: begins.to_owned() };
        let found = self.controls.iter().find(|control| control.says.starts_with(begins)).ok_or_else(missing)?;
        Ok(&found.targets)
    }
}

impl Row {
    /// What was wanted: `<= 2 %`.
    pub fn wanted(&self, target: &Target) -> String {
        let (sign, number) = target.target.split_once(' ').unwrap_or_default();
        match (number.parse::<f64>(), self.kind) {
            (Ok(share), Kind::Count | Kind::Share) => format!("{sign} {} %", whole_percent(share)),
            _ => target.target.clone(),
        }
    }

    /// What came out: `24 of 50 (48 %)`.
    pub fn result(&self, target: &Target) -> String {
        match self.kind {
            Kind::Count => format!("{} of {} ({} %)", target.hits.unwrap_or(0), target.of, whole_percent(target.value)),
            Kind::Number => format!("{:.3}", target.value),
            Kind::Share => format!("{} %", whole_percent(target.value)),
            Kind::Seconds => format!("{:.1} s", target.value),
        }
    }

    /// The 95 % interval.
    fn interval(&self, target: &Target) -> String {
        let (low, high) = target.interval;
        match self.kind {
            Kind::Count | Kind::Share => format!("{} to {} %", whole_percent(low), whole_percent(high)),
            Kind::Number => format!("{low:.3} to {high:.3}"),
            Kind::Seconds => format!("{low:.1} to {high:.1} s"),
        }
    }
}

/// `yes`, `**no**`, or nothing where there is no target.
pub(crate) fn met(target: &Target) -> &'static str {
    match target.met {
        Some(true) => "yes",
        Some(false) => "**no**",
        None => "",
    }
}

/// The study beside its controls and the engine before.
pub(crate) fn targets(root: &Path) -> Result<Markdown, TablesError> {
    let (score, before) = (Score::quoted(root)?, Score::read(root, BEFORE)?);
    let bic = score.control("BIC")?;
    let (evidence, sparse) = (score.control("best single evidence")?, score.control("sparse regression")?);
    let header = [
        "question",
        "wanted",
        "result",
        "95 % interval",
        "met",
        "engine before, another draw",
        "BIC picker",
        "best evidence",
        "sparse regression",
    ];
    let mut table = Markdown::new(&header);
    for row in &ROWS {
        let target = score.target(row)?;
        let of = |targets: &[Target]| targets.iter().find(|t| t.says == row.says).map(|t| row.result(t)).unwrap_or_default();
        let (wanted, result) = (row.wanted(target), row.result(target));
        let controls = [bic, evidence, sparse].map(of);
        let cells = [row.means, &wanted, &result, &row.interval(target), met(target), &of(&before.targets)];
        let cells = cells.into_iter().chain(controls.iter().map(String::as_str));
        table.rows.push(cells.map(str::to_owned).collect());
    }
    Ok(table)
}

/// Single causes by how large they are.
pub(crate) fn by_size(root: &Path) -> Result<Markdown, TablesError> {
    const WHAT: [&str; 5] = ["detected", "family", "exact", "exact or within its set", "wrong"];
    let score = Score::quoted(root)?;
    let mut table =
        Markdown::new(&["detectability", "detected", "family named", "named", "named, or in its set", "named wrongly"]);
    let sizes = score.by_detectability.iter().filter_map(|target| target.says.strip_suffix(": detected"));
    for size in sizes {
        let mut cells = vec![size.to_owned()];
        for what in WHAT {
            let target = score.find(&score.by_detectability, &format!("{size}: {what}"))?;
            cells.push(format!("{} of {}", target.hits.unwrap_or(0), target.of));
        }
        table.rows.push(cells);
    }
    Ok(table)
}

/// What became of each cause.
pub(crate) fn by_cause(root: &Path) -> Result<Markdown, TablesError> {
    const OUTCOMES: [&str; 6] = ["right", "within_set", "partial", "unnamed", "wrong", "missed"];
    let score = Score::quoted(root)?;
    let mut counts: BTreeMap<(usize, String), [usize; 6]> = BTreeMap::new();
    for case in &score.cases {
        let key = match case.concealed.as_slice() {
            [] => (0, "nothing".to_owned()),
            [one] => match one.strip_prefix("stranger:") {
                Some(unmodelled) => (2, format!("unmodelled cause: {}", unmodelled.replace('_', " "))),
                None => (1, format!("`{one}`")),
            },
            more => (1 + more.len(), format!("{} causes", more.len())),
        };
        let place = OUTCOMES.iter().position(|outcome| *outcome == case.outcome);
        let missing = || TablesError::NoRow { path: score.path.clone(), row: case.outcome.clone() };
        counts.entry(key).or_default()[place.ok_or_else(missing)?] += 1;
    }
    let header = ["concealed", "right", "in its set", "some of several", "found, not named", "wrong", "missed"];
    let mut table = Markdown::new(&header);
    for ((_, concealed), counts) in counts {
        table.rows.push(std::iter::once(concealed).chain(counts.iter().map(usize::to_string)).collect());
    }
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missed_target_is_said() {
        let target = Target {
            says: "x".into(),
            target: ">= 0.9".into(),
            hits: Some(24),
            of: 50,
            value: 0.48,
            interval: (0.348, 0.614),
            met: Some(false),
        };
        let row = row("x", "x", Kind::Count);
        assert_eq!((row.wanted(&target).as_str(), row.result(&target).as_str()), (">= 90 %", "24 of 50 (48 %)"));
        assert_eq!((row.interval(&target).as_str(), met(&target)), ("35 to 61 %", "**no**"));
    }
}
