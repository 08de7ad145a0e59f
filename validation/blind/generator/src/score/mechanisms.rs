//! Mechanisms composed of words against what was concealed, and what a bath and wild protocols make of nulls, single causes and several.
//!
//! Limits: of several mechanisms the first is judged, by the likeliest value of each word, whether it is named or listed only.

use super::Scored;
use super::claim::Composed;
use super::judge::Outcome;
use super::targets::{Row, Target, line, middle, share};
use super::words::Words;
use serde::Serialize;
use std::fmt::Write;

/// Share of left-out effects whose driver and kinetics should be right: 24 of 29, rounded down so that 24 are enough.
const LEFT_OUT: f64 = 0.827;

/// What a mechanism is judged by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Judged {
    /// Driver and kinetics are right together.
    pub law: bool,
    /// The place is right.
    pub place: bool,
    /// The driver is right with some kinetics.
    pub driver: bool,
    /// The kinetics is right with some driver.
    pub kinetics: bool,
}

/// Judges the mechanism of a case; all false where none is listed, nothing where no words are asked for.
pub fn judged(case: &Scored) -> Option<Judged> {
    let words = case.truth.words.as_ref()?;
    Some(words_right(case.claim.mechanism.as_ref(), words))
}

/// The same of the whole answer in words, whether a mechanism says them or an effect of the library under another name.
fn in_words(case: &Scored) -> Option<Judged> {
    let words = case.truth.words.as_ref()?;
    Some(words_right(case.claim.in_words.as_ref(), words))
}

fn words_right(said: Option<&Composed>, words: &Words) -> Judged {
    said.map_or(Judged { law: false, place: false, driver: false, kinetics: false }, |said| Judged {
        law: words.laws.contains(&(said.driver.clone(), said.kinetics.clone())),
        place: words.places.contains(&said.place),
        driver: words.has_driver(&said.driver),
        kinetics: words.has_kinetics(&said.kinetics),
    })
}

/// The rows of the wild tier, or of a study that leaves one effect out at a time; only those of words where a stranger has some.
pub fn rows(cases: &[Scored]) -> Vec<Row> {
    let mut rows = Vec::new();
    if cases.iter().any(|case| case.truth.left_out) {
        rows.extend(words(cases, |case| case.truth.left_out, [LEFT_OUT, 0.0, 0.0, 0.0]));
        return rows;
    }
    if cases.iter().any(|case| !case.truth.bath.is_empty()) {
        rows.extend(wild(cases));
    }
    if cases.iter().any(|case| case.truth.words.is_some()) {
        rows.extend(words(cases, |case| case.truth.words.is_some(), [0.0, 0.8, 0.8, 0.65]));
    }
    rows
}

fn wild(cases: &[Scored]) -> Vec<Row> {
    let count = |n: usize| move |case: &Scored| case.truth.causes.len() == n && case.truth.stranger.is_none();
    let good = |case: &Scored| matches!(case.outcome, Outcome::Right | Outcome::WithinSet);
    let named = |case: &Scored| case.outcome == Outcome::Wrong;
    vec![
        share("nulls with bath and any logger: right", Target::AtLeast(0.9), cases, count(0), good),
        share("nulls with bath and any logger: named", Target::AtMost(0.0), cases, count(0), named),
        share("single causes: right or within the set", Target::AtLeast(0.9), cases, count(1), good),
        share("pairs: right or within the set", Target::AtLeast(0.85), cases, count(2), good),
        share("triples: right or within the set", Target::AtLeast(0.65), cases, count(3), good),
    ]
}

/// Rows of the words; `wanted` of law, driver, kinetics, place, 0 where there is no target.
fn words(cases: &[Scored], of: impl Fn(&Scored) -> bool + Copy, wanted: [f64; 4]) -> Vec<Row> {
    let target = |least: f64| if least > 0.0 { Target::AtLeast(least) } else { Target::None };
    let holds = |part: fn(Judged) -> bool| move |case: &Scored| judged(case).is_some_and(part);
    let removed = cases.iter().filter(|case| of(case)).filter_map(|case| case.claim.mechanism.as_ref()?.misfit_removed);
    let mut rows = vec![
        share("mechanisms: a wrong name of the library", Target::AtMost(0.05), cases, of, |case| case.outcome == Outcome::Wrong),
        share("mechanisms: listed", Target::None, cases, of, |case| case.claim.mechanism.is_some()),
        share("mechanisms: named", Target::None, cases, of, |case| case.claim.mechanism.as_ref().is_some_and(|m| m.named)),
        share("mechanisms: driver and kinetics right", target(wanted[0]), cases, of, holds(|j| j.law)),
        share("mechanisms: driver right", target(wanted[1]), cases, of, holds(|j| j.driver)),
        share("mechanisms: kinetics right", target(wanted[2]), cases, of, holds(|j| j.kinetics)),
        share("mechanisms: place right", target(wanted[3]), cases, of, holds(|j| j.place)),
    ];
    let whole = |part: fn(Judged) -> bool| move |case: &Scored| in_words(case).is_some_and(part);
    rows.push(share("words of the whole answer: driver and kinetics right", Target::None, cases, of, whole(|j| j.law)));
    rows.push(share("words of the whole answer: place right", Target::None, cases, of, whole(|j| j.place)));
    rows.push(middle("mechanisms: misfit removed on rows left out (median)", Target::AtLeast(0.9), removed.collect()));
    rows
}

/// The rows and every mechanism one by one, misses first; empty where no words are asked for.
pub fn table(cases: &[Scored]) -> String {
    let rows = rows(cases);
    if rows.is_empty() {
        return String::new();
    }
    let mut text = String::from("\nmechanisms and baths\n");
    for row in &rows {
        // writing to a String cannot fail, here and below
        let _ = writeln!(text, "{}", line(row));
    }
    let mut asked: Vec<(Judged, &Scored)> = cases.iter().filter_map(|case| Some((judged(case)?, case))).collect();
    asked.sort_by(|a, b| (a.0, &a.1.truth.stranger).cmp(&(b.0, &b.1.truth.stranger)));
    let _ = writeln!(
        text,
        "\nmechanisms one by one, misses first (+ right, - wrong; a word in brackets is what would have been right)"
    );
    for (judged, case) in asked {
        let _ = writeln!(text, "{}", one(judged, case));
    }
    text
}

fn one(judged: Judged, case: &Scored) -> String {
    let truth = &case.truth;
    let concealed = truth.stranger.as_deref().unwrap_or("nothing");
    let head = format!(
        "{} {concealed:<28} d={:<5.1} {:<10} {:<12}",
        truth.case, truth.detectability, truth.protocol, case.claim.verdict
    );
    let names: Vec<&str> = case.claim.of_library().into_iter().collect();
    let names = if names.is_empty() { String::new() } else { format!(" library: {}", names.join(", ")) };
    let Some((said, words)) = case.claim.mechanism.as_ref().zip(truth.words.as_ref()) else {
        return format!("{head} no mechanism{names}");
    };
    let mark = |right: bool| if right { '+' } else { '-' };
    let told = format!(
        "{} {}{} {}{} {}{}",
        if said.named { "named " } else { "listed" },
        said.driver,
        mark(judged.driver),
        said.kinetics,
        mark(judged.kinetics),
        said.place,
        mark(judged.place)
    );
    let removed = said.misfit_removed.map(|share| format!(" removes {:.0} %", 100.0 * share)).unwrap_or_default();
    format!("{head} {told}{}{removed}{names}", wanted(judged, said, words))
}

/// What would have been right, where something is not.
fn wanted(judged: Judged, said: &Composed, words: &Words) -> String {
    if judged.law && judged.place {
        return String::new();
    }
    let laws: Vec<String> = words.laws.iter().map(|(d, k)| format!("{d}+{k}")).collect();
    let places: Vec<&str> = words.places.iter().map(String::as_str).collect();
    let law = if judged.law { String::new() } else { format!(" ({})", laws.join(", ")) };
    let place = if judged.place || said.place.is_empty() { String::new() } else { format!(" (at {})", places.join(", ")) };
    law + &place
}
