//! A column that was hidden on purpose, opened, beside the slow course that was recovered without it.
//!
//! Limits: two courses on two panels, each in its own unit; the line between them is told, not drawn.

use super::draw::{self, AFTER, NOISE, RECORDED};
use super::text::{Scale, capitalised, significant};
use super::{axis::Axis, subject::Subject, wording};
use truegap_diagnose::answer::CourseTrace;
use truegap_diagnose::answer::{ConcealedColumn, CourseErrors};
use truegap_scene::figure::{Figure, FigureError, Stack};
use truegap_scene::page::{Page, Table};

/// Sentence, figure, table by run; nothing where no column was hidden.
pub(super) fn add(page: Page, subject: &Subject<'_>, axis: &Axis) -> Page {
    let Some(column) = &subject.diagnosis.concealed_column else { return page };
    let page = page.section("The hidden column").text(&format!("{}.", capitalised(&column.says)));
    let page = match &subject.traces.course {
        Some(trace) => draw::figure(page, courses(column, trace, axis), &caption(column)),
        None => page,
    };
    page.table(&table(subject, column))
}

fn caption(column: &ConcealedColumn) -> String {
    format!(
        "Above, the course that the recording asks for, recovered without the column for {}; below, the column itself.",
        column.column
    )
}

fn courses(column: &ConcealedColumn, trace: &CourseTrace, axis: &Axis) -> Result<String, FigureError> {
    let scale = scale(trace);
    let course = scale.column(&trace.course);
    let reach: Vec<f64> = trace.sd.iter().map(|sd| 2.0 * scale.factor * sd).collect();
    let edge = |sign: f64| course.iter().zip(&reach).map(|(c, r)| c + sign * r).collect::<Vec<f64>>();
    let above = axis.on(Figure::new("").y("recovered course", &scale.unit).height(170.0), true);
    let above = above.band("± 2 sd", axis.x(), &axis.lift(&edge(-1.0)), &axis.lift(&edge(1.0))).colour(NOISE);
    let above = above.line("recovered course", axis.x(), &axis.lift(&course)).colour(AFTER);
    let below = axis.on(Figure::new("").y(&column.column, &column.unit).height(170.0), false);
    let below = below.line(&format!("{}, hidden", column.column), axis.x(), &axis.lift(&trace.hidden)).colour(RECORDED);
    Stack::new("").panel(above).panel(below).to_svg()
}

fn scale(trace: &CourseTrace) -> Scale {
    let largest = trace.course.iter().filter(|c| c.is_finite()).fold(0.0, |m: f64, c| m.max(c.abs()));
    match trace.course_unit.as_str() {
        "1" => Scale { factor: 100.0, unit: "%".into() },
        unit => Scale::of(unit, largest),
    }
}

fn table(subject: &Subject<'_>, column: &ConcealedColumn) -> Table {
    let opened = format!("{} opened", column.column);
    let head = ["run", "rows", "correlation", "without the column", "with the recovered course", &opened];
    let cells = |name: String, rows: usize, correlation: Option<f64>, errors: &CourseErrors| {
        let error = |value| wording::error_if_any(subject.diagnosis, value);
        [
            name,
            rows.to_string(),
            correlation.map_or("–".into(), |c| significant(c, 3)),
            error(errors.rmse_before),
            error(errors.rmse_after),
            error(errors.rmse_opened),
        ]
    };
    let rows = column.runs.iter().map(|r| cells(r.run.to_string(), r.rows, r.correlation, &r.errors));
    let all = cells("all".into(), subject.response.len(), column.correlation, &column.all);
    rows.chain([all]).fold(Table::new(&head), |table, row| table.row(&row))
}
