//! Every effect tried, and how small an effect would have been seen.
//!
//! Limits: a bar chart of the first dozen; the table holds all.

use super::draw;
use super::subject::Subject;
use super::text::{percent, rounded, significant, spoken};
use truegap_diagnose::answer::{Candidate, SmallestVisible, UnmodelledCause};
use truegap_scene::figure::{Bars, FigureError};
use truegap_scene::page::{Page, Table};

const DRAWN: usize = 12;

/// Chart, table, lists.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let diagnosis = subject.diagnosis;
    let page = page.section("Everything that was tried");
    let page = chart(page, &diagnosis.candidates);
    let page = page.details("All candidates as a table").table(&table(&diagnosis.candidates)).end_details();
    let page = outside(page, &diagnosis.unmodelled);
    if diagnosis.smallest_visible.is_empty() {
        return page;
    }
    page.subsection("What would have been seen")
        .text("An effect of this size would stand six standard deviations out of the noise, after calibration took its share; a smaller one may be there unseen.")
        .table(&visible(&diagnosis.smallest_visible))
}

fn chart(page: Page, candidates: &[Candidate]) -> Page {
    if candidates.is_empty() {
        return page.text("No effect could be tried.");
    }
    let first = &candidates[..candidates.len().min(DRAWN)];
    let page = page.text(
        "Probability that each effect belongs to the model, and how much it alone improves the evidence (natural logarithm; 5 is strong). \
         An effect can gain much alone and still not belong, when another one does the same better.",
    );
    let page = draw::figure(page, probabilities(first), "Probability of belonging to the model.");
    draw::figure(page, scores(first), "Gain in log evidence of each effect alone over the calibrated model.")
}

/// Causes that the library does not hold, where they are not negligible.
fn outside(page: Page, causes: &[UnmodelledCause]) -> Page {
    if causes.is_empty() {
        return page;
    }
    let beside = |cause: &UnmodelledCause| cause.beside.iter().map(|e| spoken(e)).collect::<Vec<_>>().join(", ");
    let row =
        |table: Table, cause: &UnmodelledCause| table.row(&[cause.says.to_owned(), beside(cause), percent(cause.probability)]);
    page.subsection("Outside the library")
        .text("Causes that no effect of the library makes, weighed beside it, alone or together with effects of it.")
        .table(&causes.iter().fold(Table::new(&["what the reading does", "together with", "probability"]), row))
}

fn labels(candidates: &[Candidate]) -> Vec<String> {
    candidates.iter().map(|c| spoken(&c.effect)).collect()
}

fn probabilities(candidates: &[Candidate]) -> Result<String, FigureError> {
    let names = labels(candidates);
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    // a tenth of a per cent is as fine as a probability is known, at either end
    let values: Vec<f64> = candidates.iter().map(|c| ((1000.0 * c.probability).round() / 10.0).min(99.9)).collect();
    Bars::new("", &names).x("probability", "%").series("probability", &values).mark(50.0, "").to_svg()
}

fn scores(candidates: &[Candidate]) -> Result<String, FigureError> {
    let names = labels(candidates);
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let values: Vec<f64> = candidates.iter().map(|c| c.score).collect();
    Bars::new("", &names).x("gain in log evidence", "").series("gain", &values).to_svg()
}

fn table(candidates: &[Candidate]) -> Table {
    candidates.iter().fold(Table::new(&["effect", "probability", "gain in log evidence, alone"]), |table, c| {
        table.row(&[spoken(&c.effect), percent(c.probability), significant(c.score, 4)])
    })
}

fn visible(sizes: &[SmallestVisible]) -> Table {
    sizes.iter().fold(Table::new(&["effect", "parameter", "smallest size that would be seen"]), |table, s| {
        let size = if s.size.is_finite() { rounded(s.size, &s.unit) } else { "none, however large".into() };
        table.row(&[spoken(&s.effect), spoken(&s.parameter), size])
    })
}
