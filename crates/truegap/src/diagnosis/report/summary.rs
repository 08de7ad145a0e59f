//! The top of the report: the verdict, what is missing with its size, how sure, and the residual at a glance.
//!
//! Limits: whoever reads nothing else has read the answer; details follow in the other sections.

use super::draw::{self, AFTER, BEFORE, NOISE};
use super::text::{Scale, capitalised, significant};
use super::{axis::Axis, subject::Subject, wording};
use truegap_diagnose::answer::{Confirmed, Diagnosis, Verdict};
use truegap_scene::figure::{Figure, FigureError, Stack};
use truegap_scene::page::{Page, Tone};

/// Name of the calibrated base model in figures and their legends.
const BASE: &str = "calibrated model";
/// Name of the model with the findings.
pub(super) const FULLER: &str = "with what was missing";

/// Verdict, findings, numbers and figure.
pub(super) fn add(page: Page, subject: &Subject<'_>, axis: &Axis) -> Page {
    let diagnosis = subject.diagnosis;
    let page = page.raw_html("<div class=\"verdict\">").callout(tone(diagnosis.verdict), &wording::headline(diagnosis));
    let mut page = page.raw_html("</div>\n");
    for notice in &diagnosis.notices {
        let tone = if notice.withholds { Tone::Bad } else { Tone::Watch };
        page = page.callout(tone, &format!("{}.", capitalised(&notice.says)));
    }
    for finding in &diagnosis.findings {
        let says = capitalised(&finding.says);
        page =
            page.raw_html("<div class=\"says\">").text(&format!("{says} – {}.", wording::how_sure(finding))).raw_html("</div>\n");
    }
    let withheld = diagnosis.notices.iter().any(|n| n.withholds);
    if wording::adds(diagnosis) && !withheld {
        page = page.text(&format!("{}.", capitalised(&diagnosis.says.replace('_', " "))));
    }
    if let Some(text) = wording::concealed(diagnosis) {
        page = page.callout(Tone::Watch, &text);
    }
    if subject.provenance.interrupted {
        page = page.callout(Tone::Watch, "The search was stopped before its end; this is what was known by then.");
    }
    page = draw::tiles(page, &tiles(diagnosis));
    draw::figure(page, residuals(subject, axis), &caption(subject))
}

fn tone(verdict: Verdict) -> Tone {
    match verdict {
        Verdict::Agrees => Tone::Good,
        Verdict::Explained | Verdict::Ambiguous | Verdict::WrongForm => Tone::Watch,
        Verdict::Unexplained | Verdict::Undecided => Tone::Bad,
    }
}

fn tiles(diagnosis: &Diagnosis) -> Vec<(String, String)> {
    let fit = &diagnosis.fit;
    let error = |value| wording::error(diagnosis, value);
    let mut tiles = vec![(error(fit.in_sample.rmse_before), "misfit of the calibrated model (RMSE)".to_owned())];
    if !diagnosis.findings.is_empty() {
        tiles.push((error(fit.in_sample.rmse_after), "with what was missing added".to_owned()));
        let if_any = |value| wording::error_if_any(diagnosis, value);
        let held = format!("{} → {}", if_any(fit.held_out.rmse_before), if_any(fit.held_out.rmse_after));
        tiles.push((held, "on data the fit did not see".to_owned()));
    }
    if let Some(term) = &diagnosis.prediction_only {
        let held = format!("{} → {}", error(term.held_out.rmse_before), error(term.held_out.rmse_after));
        tiles.push((held, "on data the fit did not see, with a flexible term that names no cause".to_owned()));
    }
    tiles.push((error(fit.noise_floor), "noise of one reading".to_owned()));
    if let Some(share) = fit.held_out.misfit_removed.filter(|s| s.is_finite() && *s >= 0.0) {
        let share = if share >= 0.995 { "> 99 %".to_owned() } else { format!("{:.0} %", 100.0 * share) };
        tiles.push((share, "of the reproducible misfit removed on unseen data".to_owned()));
    }
    tiles.extend(diagnosis.confirmation.as_ref().map(confirmed));
    tiles
}

/// What a recording that took no part says.
fn confirmed(confirmation: &Confirmed) -> (String, String) {
    match confirmation {
        Confirmed::Judged(c) => {
            let [before, after] = [c.base.rmse, c.augmented.rmse].map(|error| significant(error, 3));
            (c.verdict.words().to_owned(), format!("on a recording that took no part: {before} → {after} {}", c.unit))
        }
        Confirmed::Refused { .. } => ("not judged".to_owned(), "on a recording that took no part".to_owned()),
    }
}

/// Residual before and after over the recording, one scale, with the noise band.
pub(super) fn residuals(subject: &Subject<'_>, axis: &Axis) -> Result<String, FigureError> {
    let before = (BASE, subject.traces.before.as_slice());
    let after = (FULLER, subject.traces.after.as_slice());
    let both = [before, after];
    residual_stack(subject, axis, if subject.is_augmented() { &both } else { &both[..1] })
}

/// Residuals of several predictions in panels of one height and scale.
pub(super) fn residual_stack(subject: &Subject<'_>, axis: &Axis, predictions: &[(&str, &[f64])]) -> Result<String, FigureError> {
    let scale = subject.error_scale();
    let residuals: Vec<Vec<f64>> = predictions.iter().map(|(_, p)| subject.residual(p, &scale)).collect();
    let largest = residuals.iter().flatten().filter(|r| r.is_finite()).fold(0.0, |m: f64, r| m.max(r.abs()));
    let mut stack = Stack::new("Recorded less predicted");
    // a model has the same colour in every figure
    let colour = |label: &str| if label == BASE { BEFORE } else { AFTER };
    for (number, ((label, _), residual)) in predictions.iter().zip(&residuals).enumerate() {
        let height = if predictions.len() == 1 { 170.0 } else { 130.0 };
        let panel = axis.on(noise_panel(subject, axis, &scale).height(height), number == 0);
        let panel = panel.points(label, axis.x(), &axis.lift(residual)).colour(colour(label));
        stack = stack.panel(if largest > 0.0 { panel.y_range(-1.08 * largest, 1.08 * largest) } else { panel });
    }
    stack.to_svg()
}

fn noise_panel(subject: &Subject<'_>, axis: &Axis, scale: &Scale) -> Figure {
    let figure = Figure::new("").y("residual", &scale.unit);
    if subject.traces.noise_sd.len() != subject.response.len() {
        return figure.mark_y(0.0, "");
    }
    let upper: Vec<f64> = subject.traces.noise_sd.iter().map(|sd| 2.0 * scale.factor * sd).collect();
    let lower: Vec<f64> = upper.iter().map(|u| -u).collect();
    figure.band("noise, ± 2 sd", axis.x(), &axis.lift(&lower), &axis.lift(&upper)).colour(NOISE).mark_y(0.0, "")
}

fn caption(subject: &Subject<'_>) -> String {
    if subject.is_augmented() {
        "At a glance: what the calibrated model leaves over, and what is left once the missing physics is added. \
         Points inside the band are noise."
            .into()
    } else {
        "At a glance: what the calibrated model leaves over. Points inside the band are noise.".into()
    }
}
