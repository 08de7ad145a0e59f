//! Parameters of the base model before and after, against what was known of them, and what their conflict means.
//!
//! Limits: distances are in standard deviations of the prior; parameters without a proper prior are listed, not drawn.

use super::draw;
use super::subject::Subject;
use super::text::{capitalised, measured, significant, spoken};
use super::wording;
use truegap_diagnose::answer::ParameterFacts;
use truegap_scene::figure::{Bars, FigureError};
use truegap_scene::page::{Page, Table, Tone};

/// From here on a parameter is said to be pushed.
pub(super) const PUSHED: f64 = 3.0;

/// Conflicts, figure of distances, table.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let base = &subject.diagnosis.base;
    let mut page = page.section("What calibration did to the parameters");
    for conflict in subject.diagnosis.conflicts.iter().filter(|conflict| !conflict.between_parts) {
        page = page.callout(Tone::Watch, &format!("{}.", capitalised(&conflict.says)));
    }
    page = page.text(&reading(subject));
    if base.parameters.is_empty() {
        return page;
    }
    page = draw::figure(
        page,
        distances(subject),
        "How far calibration moved each parameter from what was known of it, in standard deviations of what was known (sd).",
    );
    let mut shown = base.parameters.iter().chain(base.parameters_after.iter().filter(|_| subject.is_augmented()));
    let has_two = shown.any(|p| !wording::of_fit_alone(p).is_empty());
    let page = page.table(&table(subject));
    between_parts(if has_two { page.text(wording::TWO_DEVIATIONS) } else { page }, subject)
}

/// Parameters that would be one number in one part of the recording and another in the rest, whether or not either is at odds with what was known.
fn between_parts(page: Page, subject: &Subject<'_>) -> Page {
    let apart: Vec<String> =
        subject.diagnosis.conflicts.iter().filter(|c| c.between_parts).map(|c| format!("{}.", capitalised(&c.says))).collect();
    if apart.is_empty() {
        return page;
    }
    let apart: Vec<&str> = apart.iter().map(String::as_str).collect();
    page.subsection(wording::BETWEEN_PARTS).list(&apart)
}

fn reading(subject: &Subject<'_>) -> String {
    let base = &subject.diagnosis.base;
    let pushed = |list: &[ParameterFacts]| list.iter().filter(|p| z(p).is_some_and(|z| z.abs() >= PUSHED)).count();
    let (before, after) = (pushed(&base.parameters), pushed(&base.parameters_after));
    let sensor = base.sensor.as_ref().map_or(String::new(), |s| format!(", sensor {s}"));
    let mut text = format!("Base model {}{sensor}. ", base.model);
    text += &match (before, subject.is_augmented(), after) {
        (0, _, _) => "No parameter had to leave what was known of it.".to_owned(),
        (n, false, _) => format!("To fit, {} beyond {PUSHED:.0} standard deviations of what is known.", moved(n)),
        (n, true, 0) => {
            format!(
                "To fit without the missing physics, {} beyond {PUSHED:.0} standard deviations of what is known; with it, none has to.",
                moved(n)
            )
        }
        (n, true, m) => format!(
            "To fit without the missing physics, {} beyond {PUSHED:.0} standard deviations of what is known; with it, {m}.",
            moved(n)
        ),
    };
    text
}

fn moved(count: usize) -> String {
    if count == 1 { "one parameter had to move".into() } else { format!("{count} parameters had to move") }
}

/// Prior standard deviations from the centre, where the prior says anything.
pub(super) fn z(parameter: &ParameterFacts) -> Option<f64> {
    let [centre, sd] = parameter.prior;
    let z = (parameter.value - centre) / sd;
    (sd > 0.0 && z.is_finite()).then_some(z)
}

fn after<'a>(subject: &'a Subject<'_>, name: &str) -> Option<&'a ParameterFacts> {
    subject.diagnosis.base.parameters_after.iter().find(|p| p.name == name).filter(|_| subject.is_augmented())
}

fn distances(subject: &Subject<'_>) -> Result<String, FigureError> {
    let drawn: Vec<&ParameterFacts> = subject.diagnosis.base.parameters.iter().filter(|p| z(p).is_some()).collect();
    let labels: Vec<String> = drawn.iter().map(|p| spoken(&p.name)).collect();
    let labels: Vec<&str> = labels.iter().map(String::as_str).collect();
    let before: Vec<f64> = drawn.iter().filter_map(|p| z(p)).collect();
    let bars =
        Bars::new("", &labels).x("distance from what was known", "standard deviations of it").series("calibrated alone", &before);
    let bars = if subject.is_augmented() {
        let with: Vec<f64> = drawn.iter().map(|p| after(subject, &p.name).and_then(z).unwrap_or(f64::NAN)).collect();
        bars.series("with what was missing", &with)
    } else {
        bars
    };
    let furthest = before.iter().fold(0.0, |m: f64, z| m.max(z.abs()));
    let bars = if furthest > 0.6 * PUSHED { bars.mark(-PUSHED, "").mark(PUSHED, "") } else { bars };
    bars.to_svg()
}

fn table(subject: &Subject<'_>) -> Table {
    let head = ["parameter", "known beforehand", "calibrated alone", "sd off", "with what was missing", "sd off"];
    let columns = if subject.is_augmented() { 6 } else { 4 };
    subject.diagnosis.base.parameters.iter().fold(Table::new(&head[..columns]), |table, before| {
        let with = after(subject, &before.name);
        let cells = [
            spoken(&before.name),
            measured(before.prior[0], before.prior[1], &before.unit),
            value(before),
            distance(before),
            with.map_or(String::new(), value),
            with.map_or(String::new(), distance),
        ];
        table.row(&cells[..columns])
    })
}

fn value(parameter: &ParameterFacts) -> String {
    let limit = if parameter.at_limit { " (at its limit)" } else { "" };
    format!("{}{limit}{}", wording::number(parameter), wording::of_fit_alone(parameter))
}

fn distance(parameter: &ParameterFacts) -> String {
    z(parameter).map_or("–".into(), |z| {
        let mark = if z.abs() >= PUSHED { " !" } else { "" };
        format!("{}{mark}", significant(z, 2))
    })
}
