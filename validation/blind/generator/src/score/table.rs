//! The scores as text that a person reads.
//!
//! Limits: fixed-width columns; the same rows are available as values from `targets::rows`.

use super::Scored;
use super::judge::Outcome;
use super::targets::{by_detectability, line, rows};
use super::{coverage, mechanisms};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Targets, naming against detectability, outcomes by cause, the wrong claims one by one.
pub fn table(cases: &[Scored]) -> String {
    let mut text = format!("{:<52} {:>8} {:>9} {:>8}  {:<17} met\n", "target", "wanted", "count", "value", "95 % interval");
    for row in rows(cases).into_iter().chain(coverage::rows(cases)) {
        // Writing to a string cannot fail, here and below.
        let _ = writeln!(text, "{}", line(&row));
    }
    text += "\nsingle causes by detectability\n";
    for row in by_detectability(cases).iter().filter(|row| row.of > 0) {
        let _ = writeln!(text, "{}", line(row));
    }
    text.push('\n');
    text += &by_cause(cases);
    text += &by_logger(cases);
    text += &mechanisms::table(cases);
    text += &wrong_claims(cases);
    text
}

fn by_cause(cases: &[Scored]) -> String {
    const ORDER: [Outcome; 6] =
        [Outcome::Right, Outcome::WithinSet, Outcome::Partial, Outcome::Unnamed, Outcome::Wrong, Outcome::Missed];
    let mut counts: BTreeMap<String, [usize; 6]> = BTreeMap::new();
    for case in cases {
        let place = ORDER.iter().position(|outcome| *outcome == case.outcome).unwrap_or(0);
        counts.entry(cause(case)).or_default()[place] += 1;
    }
    let head = format!("{:<52} right  set  part  unnamed  wrong  missed\n", "concealed");
    counts.into_iter().fold(head, |mut text, (cause, [right, set, partial, unnamed, wrong, missed])| {
        let _ = writeln!(text, "{cause:<52} {right:>5} {set:>4} {partial:>5} {unnamed:>8} {wrong:>6} {missed:>7}");
        text
    })
}

/// What a recording in which nothing is missing was taken for, by the logger that wrote it; empty where no such case has one.
fn by_logger(cases: &[Scored]) -> String {
    let mut counts: BTreeMap<_, [usize; 4]> = BTreeMap::new();
    for case in cases.iter().filter(|case| case.truth.is_null()) {
        let Some(logger) = case.truth.logger else { continue };
        let place = match (case.claim.named().is_empty() && case.claim.ambiguity.is_empty(), case.claim.verdict.as_str()) {
            (false, _) => 0,
            (true, "agrees") => 1,
            (true, "undecided") => 3,
            (true, _) => 2,
        };
        counts.entry(logger).or_default()[place] += 1;
    }
    if counts.is_empty() {
        return String::new();
    }
    let all = counts.values().fold([0; 4], |sum, one| std::array::from_fn(|k| sum[k] + one[k]));
    let rows = counts.iter().map(|(logger, count)| (logger.name(), *count)).chain(std::iter::once(("all".to_owned(), all)));
    let head = format!("\n{:<52} named agrees unexplained undecided\n", "nothing missing, written down by");
    rows.fold(head, |mut text, (logger, [named, agrees, unexplained, undecided])| {
        let _ = writeln!(text, "{logger:<52} {named:>5} {agrees:>6} {unexplained:>11} {undecided:>9}");
        text
    })
}

/// A readable name of what was concealed.
fn cause(case: &Scored) -> String {
    match (&case.truth.stranger, case.truth.causes.len()) {
        (Some(stranger), _) => format!("stranger: {stranger}"),
        (None, 0) => "nothing".to_owned(),
        (None, 1) => case.truth.causes.iter().cloned().collect(),
        (None, count) => format!("{count} causes"),
    }
}

fn wrong_claims(cases: &[Scored]) -> String {
    let mut text = String::from("\nwrong claims\n");
    for case in cases.iter().filter(|case| case.outcome == Outcome::Wrong) {
        let causes: Vec<&str> = case.truth.causes.iter().map(String::as_str).chain(case.truth.stranger.as_deref()).collect();
        let named: Vec<String> =
            case.claim.findings.iter().map(|(effect, p)| format!("{effect} {:.2}", p.unwrap_or(f64::NAN))).collect();
        let _ = writeln!(
            text,
            "{} d={:.1} {}: was [{}], named [{}] ({})",
            case.truth.case,
            case.truth.detectability,
            case.truth.protocol,
            causes.join(", "),
            named.join(", "),
            case.claim.verdict
        );
    }
    text
}
