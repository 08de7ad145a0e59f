//! The targets of `diagnosis.md`, each with its count, interval and whether it is met.
//!
//! Limits: "met" compares the estimate with the target; the interval says how sure that is. Times are not scored here.

use super::Scored;
use super::calibration::{by_chance, expected_calibration_error, interval};
use super::interval::{median, wilson};
use super::judge::Outcome;
use super::told::told_family;
use serde::Serialize;
use std::collections::BTreeSet;

/// One row of the table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// What is measured.
    pub says: String,
    /// The target, e.g. `<= 0.01`; empty where there is none.
    pub target: String,
    /// Count, where it is a share.
    pub hits: Option<usize>,
    /// Out of how many.
    pub of: usize,
    /// Share, median or error; null for no cases.
    pub value: Option<f64>,
    /// 95 % interval.
    pub interval: [f64; 2],
    /// Target met; null for no cases or no target.
    pub met: Option<bool>,
}

/// A row as text in fixed-width columns.
pub(super) fn line(row: &Row) -> String {
    let count = row.hits.map_or(format!("n={}", row.of), |hits| format!("{hits}/{}", row.of));
    let value = row.value.map_or("-".to_owned(), |value| format!("{value:.3}"));
    let interval = row.value.map_or(String::new(), |_| format!("{:.3} to {:.3}", row.interval[0], row.interval[1]));
    let met = row.met.map_or("", |met| if met { "yes" } else { "NO" });
    format!("{:<52} {:>8} {count:>9} {value:>8}  {interval:<17} {met}", row.says, row.target)
}

/// Which way a target points.
#[derive(Debug, Clone, Copy)]
pub(super) enum Target {
    AtMost(f64),
    AtLeast(f64),
    None,
}

impl Target {
    fn text(self) -> String {
        match self {
            Self::AtMost(limit) => format!("<= {limit}"),
            Self::AtLeast(limit) => format!(">= {limit}"),
            Self::None => String::new(),
        }
    }
    fn met(self, value: Option<f64>) -> Option<bool> {
        match self {
            Self::AtMost(limit) => value.map(|v| v <= limit),
            Self::AtLeast(limit) => value.map(|v| v >= limit),
            Self::None => None,
        }
    }
}

/// Share of the cases that pass `of` which also pass `hit`.
pub(super) fn share(
    says: &str,
    target: Target,
    cases: &[Scored],
    of: impl Fn(&Scored) -> bool,
    hit: impl Fn(&Scored) -> bool,
) -> Row {
    let chosen: Vec<&Scored> = cases.iter().filter(|case| of(case)).collect();
    let hits = chosen.iter().filter(|case| hit(case)).count();
    counted(says, target, hits, chosen.len())
}

/// The share that `hits` are of so many.
pub(super) fn counted(says: &str, target: Target, hits: usize, of: usize) -> Row {
    let value = (of > 0).then(|| hits as f64 / of as f64);
    Row {
        says: says.to_owned(),
        target: target.text(),
        hits: Some(hits),
        of,
        value,
        interval: wilson(hits, of),
        met: target.met(value),
    }
}

/// Every row, in the order of `diagnosis.md`.
pub fn rows(cases: &[Scored]) -> Vec<Row> {
    let mut rows = false_alarms(cases);
    rows.extend(naming(cases));
    rows.extend(claims(cases));
    rows.extend(calibration(cases));
    rows.extend(medians(cases));
    rows
}

/// Detection and naming of single library causes in bands of detectability.
pub fn by_detectability(cases: &[Scored]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (from, to) in [(4.0, 6.0), (6.0, 10.0), (10.0, 16.0), (16.0, 40.0), (40.0, f64::INFINITY)] {
        let within = |case: &Scored| case.truth.causes.len() == 1 && (from..to).contains(&case.truth.detectability);
        let set = |case: &Scored| matches!(case.outcome, Outcome::Right | Outcome::WithinSet);
        let band = if to.is_finite() { format!("d {from} to {to}") } else { format!("d above {from}") };
        rows.push(share(&format!("{band}: detected"), Target::None, cases, within, |case| case.claim.verdict != "agrees"));
        rows.push(share(&format!("{band}: family"), Target::None, cases, within, same_family));
        rows.push(share(&format!("{band}: exact"), Target::None, cases, within, |case| case.outcome == Outcome::Right));
        rows.push(share(&format!("{band}: exact or within its set"), Target::None, cases, within, set));
        rows.push(share(&format!("{band}: wrong"), Target::None, cases, within, |case| case.outcome == Outcome::Wrong));
    }
    rows
}

fn false_alarms(cases: &[Scored]) -> Vec<Row> {
    let null = |colour: bool| move |case: &Scored| case.truth.is_null() && case.truth.coloured == Some(colour);
    let alarm = |case: &Scored| case.outcome == Outcome::Wrong;
    let any = |case: &Scored| case.truth.is_null();
    vec![
        share("false alarms, white noise", Target::AtMost(0.01), cases, null(false), alarm),
        share("false alarms, coloured noise", Target::AtMost(0.02), cases, null(true), alarm),
        share("false alarms, all nulls", Target::AtMost(0.02), cases, any, alarm),
        share("nulls not said to agree (named or not)", Target::None, cases, any, |case| case.outcome != Outcome::Right),
    ]
}

fn naming(cases: &[Scored]) -> Vec<Row> {
    let seen = |case: &Scored| case.claim.verdict != "agrees";
    let single = |case: &Scored| case.truth.causes.len() == 1 && case.truth.detectability >= 10.0;
    let near_six = |case: &Scored| !case.truth.is_null() && (5.0..7.2).contains(&case.truth.detectability);
    let near_six_beside_inputs =
        |case: &Scored| !case.truth.is_null() && case.truth.beside_input_noise.is_some_and(|d| (5.0..7.2).contains(&d));
    let pair = |case: &Scored| case.truth.causes.len() == 2 && case.truth.weakest >= 16.0;
    let separable = |case: &Scored| pair(case) && case.truth.weakest_apart >= 16.0;
    let exact = |case: &Scored| case.outcome == Outcome::Right;
    let set = |case: &Scored| matches!(case.outcome, Outcome::Right | Outcome::WithinSet);
    vec![
        share("mismatch detected at d = 6 (5 to 7.2)", Target::AtLeast(0.90), cases, near_six, seen),
        share("the same where d counts the noise of the inputs", Target::None, cases, near_six_beside_inputs, seen),
        share("family named, singles at d >= 10", Target::AtLeast(0.95), cases, single, same_family),
        share("exact effect named, singles at d >= 10", Target::AtLeast(0.60), cases, single, exact),
        share("exact or within its set, singles at d >= 10", Target::None, cases, single, set),
        share("pairs, both found, each d >= 16", Target::AtLeast(0.90), cases, pair, holds_all),
        share("pairs, both found, each d >= 16 beside the other", Target::None, cases, separable, holds_all),
        share("pairs, both found or within their sets, each d >= 16", Target::None, cases, pair, |case| {
            holds_all(case) || set(case)
        }),
    ]
}

fn claims(cases: &[Scored]) -> Vec<Row> {
    let claim = |case: &Scored| case.claim.verdict == "explained" && case.claim.named().len() == 1;
    let wrong = |case: &Scored| {
        case.claim.named().iter().any(|name| !case.truth.causes.contains(*name)) && case.outcome == Outcome::Wrong
    };
    let stranger = |case: &Scored| case.truth.stranger.is_some() && case.truth.detectability >= 16.0;
    let incomplete = |case: &Scored| case.outcome == Outcome::Partial;
    vec![
        share("wrong single claims", Target::AtMost(0.02), cases, claim, wrong),
        share("incomplete single claims (one of several)", Target::None, cases, claim, incomplete),
        share("strangers called by a library name, d >= 16", Target::AtMost(0.05), cases, stranger, |case| {
            case.outcome == Outcome::Wrong
        }),
    ]
}

/// Findings that are effects of a library; the bath is left out, since naming it is neither right nor wrong.
fn of_library(case: &Scored) -> impl Iterator<Item = &(String, Option<f64>)> {
    case.claim.findings.iter().filter(|(effect, _)| !effect.starts_with("discovered") && !case.truth.bath.contains(effect))
}

/// The families named, as a reader is told them, are those of the causes.
fn same_family(case: &Scored) -> bool {
    let named: BTreeSet<_> = case.claim.named().into_iter().map(told_family).collect();
    let causes: BTreeSet<_> = case.truth.causes.iter().map(|cause| told_family(cause)).collect();
    named == causes
}

fn holds_all(case: &Scored) -> bool {
    let named = case.claim.named();
    case.truth.causes.iter().all(|cause| named.contains(cause.as_str()))
}

fn calibration(cases: &[Scored]) -> [Row; 2] {
    let target = Target::AtMost(0.05);
    let stated: Vec<(f64, bool)> = cases
        .iter()
        .flat_map(|case| of_library(case).map(|(effect, p)| (*p, case.truth.causes.contains(effect))))
        .filter_map(|(probability, right)| Some((probability?, right)))
        .collect();
    let value = (!stated.is_empty()).then(|| expected_calibration_error(&stated));
    let error = Row {
        says: "calibration error of stated probabilities (ECE)".to_owned(),
        target: target.text(),
        hits: None,
        of: stated.len(),
        value,
        interval: interval(&stated),
        met: target.met(value),
    };
    let (mean, between) = by_chance(&stated);
    let chance = Row {
        says: "the same by chance, were each of them true (mean)".to_owned(),
        target: String::new(),
        value: value.map(|_| mean),
        interval: between,
        met: None,
        ..error.clone()
    };
    [error, chance]
}

/// Rows that are a median rather than a share.
fn medians(cases: &[Scored]) -> [Row; 3] {
    let strong = |case: &&Scored| !case.truth.causes.is_empty() && case.truth.detectability >= 16.0;
    let stated = cases.iter().filter(strong).filter_map(|case| case.claim.misfit_removed);
    let fresh = cases.iter().filter(strong).filter_map(|case| case.fresh_misfit_removed);
    let seconds = cases.iter().filter_map(|case| case.seconds);
    [
        middle("held-out misfit removed as stated, d >= 16 (median)", Target::AtLeast(0.90), stated.collect()),
        middle("misfit removed on fresh histories, d >= 16 (median)", Target::AtLeast(0.90), fresh.collect()),
        middle("seconds for a diagnosis (median)", Target::None, seconds.collect()),
    ]
}

pub(super) fn middle(says: &str, target: Target, values: Vec<f64>) -> Row {
    let found = median(&values);
    let value = found.map(|(middle, _)| middle);
    Row {
        says: says.to_owned(),
        target: target.text(),
        hits: None,
        of: values.len(),
        value,
        interval: found.map_or([0.0, 0.0], |(_, interval)| interval),
        met: target.met(value),
    }
}
