//! Mechanisms that no library lists: what follows what, how sure each word is, and what it could be.
//!
//! Limits: tells what was composed; whether the verdict stands behind it is said first.

use super::subject::Subject;
use super::text::{percent, spoken};
use super::wording;
use std::collections::BTreeMap;
use truegap_diagnose::answer::DiscoveredFacts;
use truegap_scene::page::{Page, Table};

/// Names of the files of mechanisms that no library lists, where some were found.
pub(in crate::diagnosis) const DISCOVERED: [&str; 2] = ["discovered.toml", "discovered_second.toml"];

/// Probability of a word's value below which it is not listed.
const LISTED: f64 = 0.02;

/// One part a mechanism; nothing where none was composed.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let all = &subject.diagnosis.discovered;
    if all.is_empty() {
        return page;
    }
    let (heading, why) = match all.iter().any(|m| m.in_other_words) {
        _ if all.iter().any(|m| m.carried) => (
            "Composed of words, beside what is named",
            "Rows left out are predicted better with it, and what is named removes more: it is carried, and not claimed as a cause.",
        ),
        true => (
            "Composed of words, as if no effect had a name",
            "The library has an answer. It may lack the effect that acts, and then its nearest one explains as much: words do not depend on what it holds.",
        ),
        false => ("Composed of words, beyond the library", "No effect of the library explains all of this recording."),
    };
    let weighed = "Thousands of sentences were weighed: where something acts, what it follows, how in time, by which law. \
         A word is as sure as all sentences together that hold it.";
    let page = page.section(heading).text(&format!("{why} {weighed}"));
    all.iter().zip(DISCOVERED).fold(page, |page, (mechanism, file)| one(page, subject, mechanism, file))
}

/// A mechanism, which is in `file`.
fn one(page: Page, subject: &Subject<'_>, m: &DiscoveredFacts, file: &str) -> Page {
    let heading = format!("{} follows {}", spoken(&m.place), spoken(&m.driver));
    let stands = match (m.named, m.in_other_words) {
        _ if m.carried => "The model carries it. ",
        (true, _) => "",
        (false, true) => "The verdict does not rest on it. ",
        (false, false) => "The verdict does not stand behind it; it is what comes nearest. ",
    };
    let mut page = page.subsection(&heading).text(&format!("{stands}{}.", super::text::capitalised(&m.says))).table(&words(m));
    let parameters = m.parameters.iter().fold(Table::new(&["number", "fitted"]), |table, p| {
        table.row(&[spoken(&p.name), wording::number(p) + &wording::of_fit_alone(p)])
    });
    page = page.table(&parameters);
    let error = |value| wording::error_if_any(subject.diagnosis, value);
    page = page.text(&format!(
        "Error on rows left out, of the calibrated model and with this: {} → {}. Of 100 turns of the recording against its own history, the recording as it is \
         counted, {:.0} let the same freedom remove as much ({} columns weighed).",
        error(m.held_out.rmse_before),
        error(m.held_out.rmse_after),
        100.0 * m.control_p_value,
        m.weighed
    ));
    if !m.could_be.is_empty() {
        page = page.text("Known physics that these words fit; a hint, no claim:").list(&m.could_be);
    }
    page.text(&format!(
        "{file} beside this page holds it: `truegap diagnose OTHER --effect {file}` tries it on another recording."
    ))
}

fn words(m: &DiscoveredFacts) -> Table {
    let p = &m.probability;
    let rows: [(&str, &BTreeMap<String, f64>); 5] =
        [("where", &p.place), ("follows", &p.driver), ("in time", &p.kinetics), ("law", &p.form), ("acts", &p.action)];
    rows.iter().fold(Table::new(&["word", "values with their probability"]), |table, (word, values)| {
        let mut values: Vec<(&String, f64)> = values.iter().map(|(v, p)| (v, *p)).filter(|(_, p)| *p >= LISTED).collect();
        values.sort_by(|a, b| b.1.total_cmp(&a.1));
        let told: Vec<String> = values.iter().map(|(v, p)| format!("{} {}", spoken(v), percent(*p))).collect();
        table.row(&[(*word).to_owned(), told.join(", ")])
    })
}
