//! Where in the plane of load and temperature the mismatch sits, before and after, and in words.
//!
//! Limits: cells and directions are those of the diagnosis.

use super::draw;
use super::text::{listed, p_value, significant};
use super::{axis::Axis, subject::Subject, summary};
use truegap_diagnose::answer::{Map, Mismatch};
use truegap_scene::figure::{FigureError, HeatMap};
use truegap_scene::page::{Page, Table};

/// Sentences above the table.
const LISTED: usize = 5;

/// Sentences, table and maps.
pub(super) fn add(page: Page, subject: &Subject<'_>, axis: &Axis) -> Page {
    let mismatch = &subject.diagnosis.mismatch;
    let page = page.section("Where it is wrong");
    let page = if mismatch.is_empty() {
        page.text("No direction along which recording and calibrated model differ by more than noise allows.")
    } else {
        let says: Vec<&str> = mismatch.iter().take(LISTED).map(|m| m.says.as_str()).collect();
        page.list(&says).details("All of them as a table").table(&table(mismatch)).end_details()
    };
    remains(maps(page, subject), subject, axis)
}

/// Where the fuller model is still wrong, on a scale of its own; nothing where it is adequate.
fn remains(page: Page, subject: &Subject<'_>, axis: &Axis) -> Page {
    let left = &subject.diagnosis.remains;
    if left.is_empty() {
        return page;
    }
    let says: Vec<&str> = left.iter().take(LISTED).map(|m| m.says.as_str()).collect();
    let page = page.subsection("Where misfit remains").list(&says);
    let after = (summary::FULLER, subject.traces.after.as_slice());
    draw::figure(
        page,
        summary::residual_stack(subject, axis, &[after]),
        "What the fuller model leaves over, on a scale of its own.",
    )
}

fn table(mismatch: &[Mismatch]) -> Table {
    let head =
        Table::new(&["recording and model differ", "where most of it lies", "runs", "share of the mismatch", "family-wise p"]);
    mismatch.iter().fold(head, |table, m| {
        let runs: Vec<String> = m.runs.iter().map(u32::to_string).collect();
        let interval = format!("{} to {}", significant(m.interval[0], 4), significant(m.interval[1], 4));
        let share = if m.share.is_finite() { format!("{:.0} %", 100.0 * m.share) } else { "–".into() };
        table.row(&[m.along.clone(), interval, listed(&runs, "and"), share, p_value(m.p_value)])
    })
}

fn maps(page: Page, subject: &Subject<'_>) -> Page {
    let traces = subject.traces;
    let Some(before) = &traces.map_before else { return page };
    let both = [Some(before), traces.map_after.as_ref()];
    let cells = both.iter().flatten().flat_map(|map| map.values.iter().flatten());
    let largest = cells.filter(|v| v.is_finite()).fold(CHANCE, |m: f64, v| m.max(v.abs())).min(SHOWN);
    let first = draw_map("Calibrated model", before, largest);
    match traces.map_after.as_ref().filter(|_| subject.is_augmented()) {
        None => draw::figure(page, first, CAPTION),
        Some(after) => {
            let second = draw_map("With what was missing", after, largest);
            draw::pair(page, [(first, CAPTION), (second, "The same with the missing physics added, on the same scale.")])
        }
    }
}

/// Up to here a mean may be chance.
const CHANCE: f64 = 3.0;
/// Beyond this size, in noises of a mean, colours no longer tell: one cell at 2700 would leave those at 3 white.
const SHOWN: f64 = 100.0;
const CAPTION: &str = "Mean residual of each cell over the noise that such a mean has; beyond ± 3 it is not chance. Colours are even up to about ± 3 and logarithmic beyond.";

fn draw_map(title: &str, map: &Map, largest: f64) -> Result<String, FigureError> {
    let cells: Vec<f64> = map.values.iter().flatten().copied().collect();
    HeatMap::new(title, &map.x_edges, &map.y_edges, &cells)
        .x(&map.x_label, "")
        .y(&map.y_label, "")
        .value("mean residual / its noise", "")
        .diverging()
        .bent(CHANCE)
        .value_range(-largest, largest)
        .height(250.0)
        .to_svg()
}
