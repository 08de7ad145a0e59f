//! How both models predict rows that the fit did not see.
//!
//! Limits: the parts left out are those of the diagnosis; more than [`DRAWN`] parts are listed, not drawn.

use super::axis::Axis;
use super::draw;
use super::text::{capitalised, percent, significant, spoken};
use super::{subject::Subject, summary, wording};
use truegap_diagnose::answer::{HeldOut, SelectedAgain};
use truegap_scene::figure::{Bars, FigureError};
use truegap_scene::page::{Page, Table};

const DRAWN: usize = 24;

/// Errors before, after and noise, per part left out.
pub(super) fn add(page: Page, subject: &Subject<'_>, axis: &Axis) -> Page {
    let held = &subject.diagnosis.fit.held_out;
    let page = page.section("On data the fit did not see").text(&sentence(subject));
    if held.parts.is_empty() {
        return page;
    }
    let page = if held.parts.len() <= DRAWN {
        draw::figure(page, bars(subject, held), "Error on each part left out; the line is the noise of one reading.")
    } else {
        page
    };
    let unseen = &subject.traces.held_out_before;
    let page = if unseen.len() == subject.response.len() && unseen.iter().any(|v| v.is_finite()) {
        draw::figure(page, residuals(subject, axis), "Recorded less predicted, each row predicted by a fit that did not see it.")
    } else {
        page.text("No row has a prediction by a fit that did not see it.")
    };
    let page = page.details("Errors per part left out").table(&table(subject, held)).end_details();
    let page = match &subject.diagnosis.permuted_searches {
        Some(permuted) => page.text(&format!("{}.", capitalised(&permuted.says))),
        None => page,
    };
    match &held.selected_again {
        None => page,
        Some(again) => page
            .text(&format!("{}.", capitalised(&wording::chosen_again(subject.diagnosis, again))))
            .details("What is named without each part")
            .table(&chosen_again(subject, again))
            .end_details(),
    }
}

/// What is named without each part, and the error of that choice on it.
fn chosen_again(subject: &Subject<'_>, again: &SelectedAgain) -> Table {
    let named = |ids: &[String]| {
        if ids.is_empty() { "nothing".into() } else { ids.iter().map(|id| spoken(id)).collect::<Vec<_>>().join(", ") }
    };
    let table = Table::new(&["without", "verdict", "named", "error on it"]);
    again.parts.iter().fold(table, |table, part| {
        let error = wording::error_if_any(subject.diagnosis, part.rmse);
        table.row(&[part.part.clone(), spoken(part.verdict.word()), named(&part.named), error])
    })
}

fn sentence(subject: &Subject<'_>) -> String {
    let held = &subject.diagnosis.fit.held_out;
    let error = |value| wording::error_if_any(subject.diagnosis, value);
    let mut text = format!("Left out: {}. The calibrated model predicts the rest to {}", held.how, error(held.rmse_before));
    if subject.is_augmented() {
        text += &format!(", with the missing physics to {}", error(held.rmse_after));
    }
    text += &format!("; the noise of one reading is {}.", error(Some(subject.diagnosis.fit.noise_floor)));
    if let Some(share) = wording::misfit_removed(subject.diagnosis) {
        text += &format!(" Share of the reproducible misfit removed: {share}.");
    }
    if let Some(control) = held.permutation_control {
        let removes =
            if control < 0.0 { "makes the prediction worse".to_owned() } else { format!("removes {}", percent(control)) };
        text += &format!(" A term of equal freedom driven by a permuted history {removes}.");
    }
    text
}

fn residuals(subject: &Subject<'_>, axis: &Axis) -> Result<String, FigureError> {
    let before = ("calibrated model", subject.traces.held_out_before.as_slice());
    let after = ("with what was missing", subject.traces.held_out_after.as_slice());
    let all = [before, after];
    let drawn = if subject.is_augmented() { &all[..] } else { &all[..1] };
    summary::residual_stack(subject, axis, drawn)
}

fn bars(subject: &Subject<'_>, held: &HeldOut) -> Result<String, FigureError> {
    let scale = subject.error_scale();
    let labels: Vec<&str> = held.parts.iter().map(|(name, ..)| name.as_str()).collect();
    let before: Vec<f64> = held.parts.iter().map(|(_, before, _)| scale.factor * before).collect();
    let after: Vec<f64> = held.parts.iter().map(|(.., after)| scale.factor * after).collect();
    let bars = Bars::new("Error on the part left out", &labels).x("RMSE", &scale.unit);
    let bars = bars.series("calibrated model", &before);
    let bars = if subject.is_augmented() { bars.series("with what was missing", &after) } else { bars };
    bars.mark(scale.factor * subject.diagnosis.fit.noise_floor, "noise").to_svg()
}

fn table(subject: &Subject<'_>, held: &HeldOut) -> Table {
    let scale = subject.error_scale();
    let heading = |what: &str| format!("{what}, {}", scale.unit);
    let (before, after, noise) = (heading("calibrated model"), heading("with what was missing"), heading("noise"));
    let number = |value: f64| significant(scale.factor * value, 3);
    let floor = number(subject.diagnosis.fit.noise_floor);
    if !subject.is_augmented() {
        return held.parts.iter().fold(Table::new(&["left out", &before, &noise]), |table, (name, b, _)| {
            table.row(&[name.clone(), number(*b), floor.clone()])
        });
    }
    held.parts.iter().fold(Table::new(&["left out", &before, &after, &noise]), |table, (name, b, a)| {
        table.row(&[name.clone(), number(*b), number(*a), floor.clone()])
    })
}
