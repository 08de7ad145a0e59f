//! What may be predicted although nothing may be named: the flexible term, its parts, its errors, and what it leaves.
//!
//! Limits: told only where the diagnosis holds such a term.

use super::axis::Axis;
use super::text::{capitalised, percent, significant, spoken, spoken_list};
use super::{draw, subject::Subject, summary, wording};
use truegap_diagnose::answer::{BeforeAfter, PredictionOnly};
use truegap_scene::page::{Page, Table};

/// Sentences of what remains.
const LISTED: usize = 4;

/// Errors, figure, parts, what remains; nothing where there is no such term.
pub(super) fn add(page: Page, subject: &Subject<'_>, axis: &Axis) -> Page {
    let Some(term) = &subject.diagnosis.prediction_only else { return page };
    let page = page.section("What can be predicted all the same").text(&sentence(subject, term)).table(&errors(subject, term));
    let unseen = [
        ("calibrated model", subject.traces.held_out_before.as_slice()),
        ("with the flexible term", &subject.traces.held_out_flexible),
    ];
    let page = if subject.traces.held_out_flexible.len() == subject.response.len() {
        let caption = "Recorded less predicted, each row predicted by a fit that did not see it.";
        draw::figure(page, summary::residual_stack(subject, axis, &unseen), caption)
    } else {
        page
    };
    let page = parts(page, term);
    if term.remains.is_empty() {
        return page;
    }
    let remains: Vec<&str> = term.remains.iter().take(LISTED).map(|m| m.says.as_str()).collect();
    page.text("With it, recording and prediction still differ; what is left is where a cause has to be looked for:")
        .list(&remains)
}

fn sentence(subject: &Subject<'_>, term: &PredictionOnly) -> String {
    let control = term.permutation_control.map_or(String::new(), |share| {
        format!(" A term of equal freedom driven by a permuted history removes {}.", percent(share))
    });
    let removed = term.misfit_removed.map_or(String::new(), |share| {
        format!(" It removes {} of the reproducible misfit on rows that the fit did not see.", percent(share))
    });
    format!(
        "A flexible term shaped like {} serves prediction only: its equation is not adequate, and no cause is claimed.{removed}{control} The noise of one reading is {}.",
        spoken_list(term.terms.iter().map(|t| &t.shaped_like), "and"),
        wording::error(subject.diagnosis, subject.diagnosis.fit.noise_floor),
    )
}

fn errors(subject: &Subject<'_>, term: &PredictionOnly) -> Table {
    let error = |value| wording::error(subject.diagnosis, value);
    let row = |what: String, errors: &BeforeAfter| [what, error(errors.rmse_before), error(errors.rmse_after)];
    let unseen = format!("left out: {}", subject.diagnosis.fit.held_out.how);
    Table::new(&["RMSE", "calibrated model", "with the flexible term"])
        .row(&row("all rows fitted".to_owned(), &term.in_sample))
        .row(&row(unseen, &term.held_out))
}

fn parts(page: Page, term: &PredictionOnly) -> Page {
    let lines: Vec<String> =
        term.terms.iter().map(|t| format!("{}: as if {}", capitalised(&spoken(&t.shaped_like)), t.says)).collect();
    let numbers = term.terms.iter().flat_map(|t| &t.parameters);
    let table = numbers.fold(Table::new(&["parameter", "fitted", ""]), |table, p| {
        let limit = if p.at_limit { "at its limit" } else { "" };
        let value = format!("{} {}", significant(p.value, 4), p.unit);
        table.row(&[spoken(&p.name), value, limit.to_owned()])
    });
    page.list(&lines).details("The numbers of the term").table(&table).end_details()
}
