//! Fronts, the minimisation vector, and what the constraints exclude.
//!
//! Limits: fronts of two as plots; the front of three as three plots of its shadows.

use super::{number, spoken, values};
use crate::study::StudyError;
use crate::study::answer::optimise::{FrontAnswer, OptimiseAnswer};
use truegap_core::ends;
use truegap_design::METRICS;
use truegap_design::optimise::{Candidate, Choice, OBJECTIVES};
use truegap_scene::figure::{Figure, FigureError};
use truegap_scene::page::{Page, Table, Tone};

const PAIRS: [[usize; 2]; 3] = [[0, 1], [0, 2], [1, 2]];

/// A figure a pair of objectives.
pub(in crate::study) fn figures(answer: &OptimiseAnswer) -> Result<Vec<(String, String)>, StudyError> {
    PAIRS.iter().map(|&[a, b]| Ok((format!("{}_{}.svg", OBJECTIVES[a], OBJECTIVES[b]), plot(answer, a, b)?))).collect()
}

/// All designs that are known, in the plane of two objectives; the axes end around them, wherever the starting design lies.
fn plot(answer: &OptimiseAnswer, a: usize, b: usize) -> Result<String, FigureError> {
    let column = |designs: &[Candidate], o: usize| -> Vec<f64> { designs.iter().map(|d| d.ratios[o]).collect() };
    let axis = |o: usize| format!("{} over that of the starting design", spoken(OBJECTIVES[o]));
    let mut figure = Figure::new("").x(&axis(a), "").y(&axis(b), "").height(340.0);
    let fronts = [("front of all three", vec![0, 1, 2]), ("front of these two", vec![a, b])];
    let mut shown: Vec<&Candidate> = answer.vector.iter().collect();
    for (label, places) in fronts {
        let Some(front) = answer.fronts.iter().find(|f| f.places == places) else { continue };
        figure = figure.points(label, &column(&front.designs, a), &column(&front.designs, b));
        shown.extend(&front.designs);
    }
    if let Some(vector) = &answer.vector {
        figure = figure.points("along the vector", &[vector.ratios[a]], &[vector.ratios[b]]);
        figure = figure.dashed_line("minimisation vector", &[1.0, vector.ratios[a]], &[1.0, vector.ratios[b]]);
    }
    let [x, y] = windows([a, b].map(|o| shown.iter().map(|d| d.ratios[o]).collect()));
    let (label, start) = start(x, y, answer.vector.as_ref().map(|v| [v.ratios[a], v.ratios[b]]));
    figure.points(label, &[start[0]], &[start[1]]).x_range(x.0, x.1).y_range(y.0, y.1).to_svg()
}

/// Ends of both axes around designs, with the starting design at (1, 1) where that costs less than two thirds of the room of either: on one axis alone it would
/// cost room and not be seen.
fn windows(ratios: [Vec<f64>; 2]) -> [(f64, f64); 2] {
    let ends = ratios.map(|r| ends(r.iter().copied()));
    let with_start = |(low, high): (f64, f64)| (low.min(1.0), high.max(1.0));
    let length = |(low, high): (f64, f64)| high - low;
    let is_near = ends.iter().all(|ends| length(with_start(*ends)) < 3.0 * length(*ends));
    ends.map(|ends| if is_near { with_start(ends) } else { ends }).map(with_margin)
}

/// Ends with some room beyond; of no designs those of an axis that holds the starting design.
fn with_margin((low, high): (f64, f64)) -> (f64, f64) {
    if low > high {
        return (0.0, 1.1);
    }
    let margin = (0.08 * (high - low)).max(1e-3 * high.abs().max(1e-9));
    ((low - margin).max(0.0), high + margin)
}

/// Where the starting design is drawn: at (1, 1), or at the edge on the way to it, which its name then says.
fn start(x: (f64, f64), y: (f64, f64), from: Option<[f64; 2]>) -> (&'static str, [f64; 2]) {
    let from = from.unwrap_or([0.5 * (x.0 + x.1), 0.5 * (y.0 + y.1)]);
    let way = |from: f64, (low, high): (f64, f64)| {
        let edge = if from < 1.0 { high } else { low };
        if (low..=high).contains(&1.0) { 1.0 } else { (edge - from) / (1.0 - from) }
    };
    let share = way(from[0], x).min(way(from[1], y));
    let label = if share < 1.0 { "to the starting design, beyond the edge at (1, 1)" } else { "starting design" };
    (label, from.map(|f| f + share * (1.0 - f)))
}

/// The page.
pub(in crate::study) fn html(answer: &OptimiseAnswer) -> Result<String, StudyError> {
    let mut page = Page::new(&format!("Designs with smaller temperature coefficients than {}", answer.sensor));
    if !answer.complete {
        page = page.callout(Tone::Watch, "Stopped before all searches were done; this is what was found by then.");
    }
    page = match &answer.vector {
        Some(vector) => with_vector(page, answer, vector),
        None => page.text("The front of all three coefficients was not searched, so there is no minimisation vector yet."),
    };
    page = page.section("Fronts").text(
        "Each point is a design that no other found one beats in the coefficients of its front. Coefficients count by their size, over those of the starting design at (1, 1); \
         left and below is better. The axes end around the designs; where the starting design lies beyond, a point at the edge shows the way to it.",
    );
    for [a, b] in PAIRS {
        let third = OBJECTIVES[3 - a - b];
        let caption = worse(answer, &[a, b], 3 - a - b).map_or_else(String::new, |(worse, all)| {
            format!(
                "{worse} of {all} designs of the front of these two have a larger {} than the starting design.",
                spoken(third)
            )
        });
        page = page.figure(&plot(answer, a, b)?, &caption);
    }
    Ok(space(searches(page, answer), answer).to_html())
}

fn worse(answer: &OptimiseAnswer, places: &[usize], third: usize) -> Option<(usize, usize)> {
    let front = answer.fronts.iter().find(|f| f.places == places)?;
    Some((front.designs.iter().filter(|d| d.ratios[third] > 1.0).count(), front.designs.len()))
}

fn with_vector(page: Page, answer: &OptimiseAnswer, vector: &Candidate) -> Page {
    let gains: Vec<String> =
        OBJECTIVES.iter().zip(vector.ratios).map(|(o, r)| format!("{} by {:.1} %", spoken(*o), 100.0 * (1.0 - r))).collect();
    let design =
        answer.axes.iter().zip(&vector.values).fold(Table::new(&["quantity", "symbol", "value"]), |table, (axis, value)| {
            let (unit, factor) = axis.quantity.unit();
            table.row(&[
                axis.quantity.says().to_owned(),
                axis.quantity.symbol().to_owned(),
                format!("{} {unit}", number(value * factor)),
            ])
        });
    let page = page
        .section("Along the minimisation vector")
        .callout(Tone::Good, &format!("All three coefficients fall in size: {}.", gains.join(", ")))
        .text("The design whose worst coefficient, relative to the starting design, is smallest.")
        .table(&design);
    let Some(found) = vector.metrics else { return page };
    let rows = METRICS.iter().zip(values(&answer.base).into_iter().zip(values(&found)));
    page.table(&rows.fold(Table::new(&["number", "before", "after", "unit"]), |table, (metric, (before, after))| {
        table.row(&[spoken(*metric).to_owned(), number(before), number(after), metric.unit().to_owned()])
    }))
}

fn searches(page: Page, answer: &OptimiseAnswer) -> Page {
    let row = |table: Table, front: &FrontAnswer| {
        let names: Vec<&str> = front.places.iter().map(|&o| spoken(OBJECTIVES[o])).collect();
        table.row(&[
            names.join(", "),
            front.searches.to_string(),
            front.evaluations.to_string(),
            format!("{:.4}", front.hypervolume),
        ])
    };
    let table = answer.fronts.iter().fold(Table::new(&["front of", "searches", "evaluations", "hypervolume"]), row);
    page.section("Searches").table(&table).text(&format!(
        "Hypervolume: share of the box between no drift at all and the starting design that the front beats. Seed {}; the k-th search of a front has this seed plus k, from 0.",
        answer.search.seed
    ))
}

fn space(page: Page, answer: &OptimiseAnswer) -> Page {
    let axes = answer.axes.iter().fold(Table::new(&["quantity", "may be"]), |table, axis| {
        let (unit, factor) = axis.quantity.unit();
        let told = match &axis.choice {
            Choice::Continuous(low, high) => format!("{} to {} {unit}", number(low * factor), number(high * factor)),
            Choice::Whole(low, high) => format!("whole, {low} to {high}"),
            Choice::Levels(levels) => {
                format!("{} {unit}", levels.iter().map(|l| number(l * factor)).collect::<Vec<_>>().join(", "))
            }
        };
        table.row(&[axis.quantity.says().to_owned(), told])
    });
    let excluded = answer.exclusions.iter().fold(Table::new(&["constraint", "excludes", "alone"]), |table, e| {
        table.row(&[e.constraint.says().to_owned(), format!("{:.1} %", 100.0 * e.share), format!("{:.1} %", 100.0 * e.alone)])
    });
    let useful = &answer.useful;
    page.section("The space, and what keeps a sensor useful").table(&axes).table(&excluded).text(&format!(
        "{:.1} % of the space meets all constraints: baseline at least {} and span at least {} of the starting design's, linearity error at most {} times its, beads on at most {} of the electrode, \
         plates apart from 20 to 50 °C up to full load. \"Alone\" is what no other constraint excludes. The paper keeps \"useful\" designs without giving numbers; these are ours.",
        100.0 * answer.feasible, useful.baseline, useful.span, useful.linearity, useful.covered
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The front sat in a corner of an axis from 0 to the starting design at 1.
    #[test]
    fn a_front_far_from_the_start_fills_its_axes() {
        let [(low, high), _] = windows([vec![0.10, 0.12, 0.14], vec![0.1, 0.2]]);
        assert!(low > 0.08 && high < 0.16, "{low} {high}");
        let (label, at) = start((low, high), (low, high), Some([0.12, 0.12]));
        assert!(label.contains("beyond the edge") && (at[0] - high).abs() < 1e-12 && (at[1] - high).abs() < 1e-12, "{at:?}");
    }

    #[test]
    fn a_front_near_the_start_shows_it_where_it_is() {
        let [(low, high), other] = windows([vec![0.4, 0.9], vec![0.4, 0.9]]);
        assert_eq!(other, (low, high));
        assert!(low < 0.4 && high > 1.0);
        assert_eq!(start((low, high), (low, high), None), ("starting design", [1.0, 1.0]));
    }

    /// An axis reached to the starting design though the other one did not, and the front lay in the lower third of it.
    #[test]
    fn a_start_that_is_not_seen_takes_no_room() {
        let [x, y] = windows([vec![0.0, 0.09], vec![0.0, 0.35]]);
        assert!(x.1 < 0.1 && y.1 < 0.4, "{x:?} {y:?}");
        assert_eq!(windows([Vec::new(), Vec::new()]), [(0.0, 1.1); 2]);
    }

    #[test]
    fn a_start_beyond_one_axis_only_lies_on_the_edge_of_that_axis() {
        let (_, at) = start((0.1, 0.2), (0.4, 1.1), Some([0.15, 0.5]));
        assert!((at[0] - 0.2).abs() < 1e-12 && at[1] > 0.5 && at[1] < 1.0, "{at:?}");
    }
}
