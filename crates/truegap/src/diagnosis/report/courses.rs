//! Recording, base model and augmented model over time, with the inputs above, and the residual over each input.
//!
//! Limits: thinning for the screen keeps every extreme; nothing is smoothed.

use super::draw::{self, AFTER, BEFORE, RECORDED};
use super::{axis::Axis, subject::Subject, text::Scale};
use truegap_core::Role;
use truegap_scene::figure::{Figure, FigureError, Stack};
use truegap_scene::page::Page;

/// The recording against both models, and what is left over each input.
pub(super) fn add(page: Page, subject: &Subject<'_>, axis: &Axis) -> Page {
    let page = page.section("Recording and models");
    let page = draw::figure(page, courses(subject, axis), &caption(subject));
    let drivers = drivers(subject);
    if drivers.is_empty() {
        return page;
    }
    let page =
        page.text("What is left, drawn over each input: a curve is a missing law, a loop a missing memory, a cloud is noise.");
    drivers.iter().fold(page, |page, driver| {
        let caption = format!("Recorded less predicted over {}.", driver.label);
        draw::figure(page, over(subject, driver), &caption)
    })
}

/// Share of the recorded range below which two curves look like one.
const APART: f64 = 0.02;

fn caption(subject: &Subject<'_>) -> String {
    let says = "What was done (above), what was read, and what the models make of it.";
    let finite = |values: &[f64]| values.iter().copied().filter(|v| v.is_finite()).collect::<Vec<_>>();
    let (read, scale) = (finite(subject.response), subject.error_scale());
    let range = read.iter().copied().fold(f64::NEG_INFINITY, f64::max) - read.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = finite(&subject.residual(&subject.traces.before, &scale)).into_iter().fold(0.0, |m: f64, r| m.max(r.abs()));
    if largest / scale.factor < APART * range {
        let most = scale.text(largest / scale.factor);
        return format!(
            "{says} The curves lie on one another here: they differ by at most {most}, which the first figure shows."
        );
    }
    says.into()
}

/// One recorded input in its display unit.
struct Driver {
    label: String,
    unit: String,
    values: Vec<f64>,
}

fn drivers(subject: &Subject<'_>) -> Vec<Driver> {
    let inputs = subject.inputs;
    let roles = [Role::Force, Role::Pressure, Role::Gap, Role::Temperature, Role::Humidity];
    let recorded = inputs.drivers.iter().map(|d| driver(&d.name, &d.unit, &d.values));
    roles
        .into_iter()
        .filter_map(|role| Some(driver(role.key(), role.unit(), inputs.column(role)?)))
        .chain(recorded)
        .filter(|driver| driver.values.iter().any(|v| *v != driver.values[0]))
        .collect()
}

fn driver(label: &str, unit: &str, values: &[f64]) -> Driver {
    let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let scale = Scale::of(unit, largest);
    Driver { label: label.to_owned(), values: scale.column(values), unit: scale.unit }
}

fn courses(subject: &Subject<'_>, axis: &Axis) -> Result<String, FigureError> {
    let mut stack = Stack::new("");
    let mut first = true;
    for driver in drivers(subject) {
        let panel = axis.on(Figure::new("").y(&driver.label, &driver.unit).height(84.0), first);
        stack = stack.panel(panel.line("", axis.x(), &axis.lift(&driver.values)).colour(RECORDED));
        first = false;
    }
    let scale = subject.value_scale();
    let lifted = |values: &[f64]| axis.lift(&scale.column(values));
    let panel = axis.on(Figure::new("").y("reading", &scale.unit).height(240.0), first);
    // dots below lines: what lies on one another can still be told apart
    let panel = panel.points("recorded", axis.x(), &lifted(subject.response)).colour(RECORDED);
    let panel = panel.line("calibrated model", axis.x(), &lifted(&subject.traces.before)).colour(BEFORE);
    let panel = if subject.is_augmented() {
        panel.dashed_line("with what was missing", axis.x(), &lifted(&subject.traces.after)).colour(AFTER)
    } else {
        panel
    };
    stack.panel(panel).to_svg()
}

fn over(subject: &Subject<'_>, driver: &Driver) -> Result<String, FigureError> {
    let scale = subject.error_scale();
    let before = subject.residual(&subject.traces.before, &scale);
    let after = subject.residual(&subject.traces.after, &scale);
    let columns = [("calibrated model", before, BEFORE), ("with what was missing", after, AFTER)];
    let shown = &columns[..if subject.is_augmented() { 2 } else { 1 }];
    let largest = shown.iter().flat_map(|(_, r, _)| r).filter(|r| r.is_finite()).fold(0.0, |m: f64, r| m.max(r.abs()));
    let mut stack = Stack::new("");
    for (label, residual, colour) in shown {
        let figure = Figure::new("").x(&driver.label, &driver.unit).y("residual", &scale.unit).height(120.0).mark_y(0.0, "");
        let figure = figure.points(label, &driver.values, residual).colour(*colour);
        stack = stack.panel(if largest > 0.0 { figure.y_range(-1.08 * largest, 1.08 * largest) } else { figure });
    }
    stack.to_svg()
}
