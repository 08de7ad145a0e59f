//! The models beside a straight line and a smooth curve through the recorded inputs.
//!
//! Limits: the figures and the sentence are the diagnosis's.

use super::text::{capitalised, listed};
use super::{subject::Subject, wording};
use truegap_diagnose::answer::{Diagnosis, Reference};
use truegap_scene::page::{Page, Table, Tone};

/// Base model, fuller model, line, curve and noise in one table.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let diagnosis = subject.diagnosis;
    let Some(first) = diagnosis.reference.first() else { return page };
    let page = page.subsection("Beside a line and a curve").text(&format!(
        "A straight line and a smooth curve in {}, each fitted to the same rows: what needs no physics at all.",
        listed(&first.inputs, "and")
    ));
    let page = match &diagnosis.reference_says {
        Some(says) => page.callout(Tone::Watch, &format!("{}.", capitalised(says))),
        None => page,
    };
    let table = rows(diagnosis).iter().fold(Table::new(&["model", "in sample", "rows left out"]), |table, row| table.row(row));
    page.table(&table)
}

/// Name, error in sample and held out, with unit.
fn rows(diagnosis: &Diagnosis) -> Vec<[String; 3]> {
    let fit = &diagnosis.fit;
    let error = |value| wording::error_if_any(diagnosis, value);
    let row = |name: &str, inside: f64, unseen: Option<f64>| [name.to_owned(), error(Some(inside)), error(unseen)];
    let mut rows = vec![row("calibrated model", fit.in_sample.rmse_before, fit.held_out.rmse_before)];
    if !diagnosis.findings.is_empty() {
        rows.push(row("with what was missing", fit.in_sample.rmse_after, fit.held_out.rmse_after));
    }
    rows.extend(diagnosis.reference.iter().map(|r| row(name(r), r.rmse, r.held_out)));
    rows.push(["noise of one reading".to_owned(), error(Some(fit.noise_floor)), "–".to_owned()]);
    rows
}

/// What a reader calls it.
pub(super) fn name(reference: &Reference) -> &'static str {
    if reference.name == "straight_line" { "straight line" } else { "smooth curve" }
}
