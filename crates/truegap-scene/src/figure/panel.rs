//! One plotting area laid out: ranges, scales and ticks; `panel_draw` draws it.

use super::chart::{Axis, Figure};
use super::error::FigureError;
use super::scale::{Scale, extent, padded};
use super::series::{Guide, Mark, Series};
use super::svg::{Area, TEXT, WIDTH, text_width};
use super::ticks::Ticks;

/// Room below a plot for tick labels and the axis title.
pub(super) const X_AXIS_HEIGHT: f64 = 46.0;
const RIGHT_MARGIN: f64 = 18.0;

/// Whether a panel carries the labels of its x axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum XAxis {
    Labelled,
    Bare,
}

/// A checked figure with its axes laid out; pixels are filled in by `draw`.
pub(super) struct Panel<'a> {
    pub(super) figure: &'a Figure,
    pub(super) x_axis: &'a Axis,
    pub(super) x: Scale,
    pub(super) y: Scale,
    pub(super) y_ticks: Ticks,
    /// Points that a logarithmic axis cannot show.
    pub(super) not_drawn: usize,
}

/// The plotting area that starts at `left`, `top`.
pub(super) fn plot_area(left: f64, top: f64, height: f64) -> Area {
    Area { left, top, width: WIDTH - left - RIGHT_MARGIN, height }
}

/// Range of the x axis over `figures`, which share it.
pub(super) fn x_range(figures: &[&Figure]) -> Result<(f64, f64), FigureError> {
    let first = figures[0];
    let values = figures.iter().flat_map(|f| f.series.iter().flat_map(|s| s.x.iter().copied()));
    let points_only =
        figures.iter().flat_map(|f| &f.series).any(|s| matches!(s.mark, Mark::Points | Mark::Errors { .. }) && s.x.len() < 200);
    range(&first.title, "x", &first.x, values, if points_only { 0.02 } else { 0.0 })
}

impl<'a> Panel<'a> {
    pub fn new(figure: &'a Figure) -> Result<Self, FigureError> {
        Self::with_x(figure, &figure.x, x_range(&[figure])?)
    }

    /// A panel whose x axis is that of another figure.
    pub fn with_x(figure: &'a Figure, x_axis: &'a Axis, (x_low, x_high): (f64, f64)) -> Result<Self, FigureError> {
        figure.series.iter().try_for_each(|s| s.check(&figure.title))?;
        let guides = || figure.guides.iter().filter_map(|g| if let Guide::AtY(y, _) = g { Some(*y) } else { None });
        let values = |from, to| figure.series.iter().flat_map(move |s| s.heights(from, to)).chain(guides());
        let between = |from, to| range(&figure.title, "y", &figure.y, values(from, to), 0.05);
        // A panel without a point inside the shown range still has lines that cross it.
        let (low, high) = between(x_low, x_high).or_else(|_| between(f64::NEG_INFINITY, f64::INFINITY))?;
        let x = Scale { low: x_low, high: x_high, log: x_axis.log, pixels: 1.0, flipped: false };
        let y = Scale { low, high, log: figure.y.log, pixels: figure.height, flipped: true };
        let y_ticks = Ticks::new(&y, (figure.height / 32.0) as usize);
        Ok(Self { figure, x_axis, x, y, y_ticks, not_drawn: not_drawn(figure, x_axis) })
    }

    /// Room that the y axis needs.
    pub fn left_margin(&self) -> f64 {
        let widest = self.y_ticks.major.iter().map(|(_, label)| text_width(label, TEXT)).fold(0.0, f64::max);
        widest + 38.0
    }
}

fn range(
    figure: &str,
    name: &'static str,
    axis: &Axis,
    values: impl Iterator<Item = f64>,
    padding: f64,
) -> Result<(f64, f64), FigureError> {
    if let Some((low, high)) = axis.range {
        let fine = low.is_finite() && high.is_finite() && low < high && (!axis.log || low > 0.0);
        return fine.then_some((low, high)).ok_or(FigureError::Range { figure: figure.into(), axis: name, low, high });
    }
    let found = extent(values.chain(axis.include.iter().copied()), axis.log)
        .ok_or(FigureError::Empty { figure: figure.into(), axis: name })?;
    let padding = if found.0 < found.1 { padding } else { 0.05 };
    Ok(padded(found, padding, axis.log))
}

/// Points that a logarithmic axis cannot show.
fn not_drawn(figure: &Figure, x_axis: &Axis) -> usize {
    let lost = |log: bool, v: f64| log && v.is_finite() && v <= 0.0;
    let count = |s: &Series| s.x.iter().zip(&s.y).filter(|(x, y)| lost(x_axis.log, **x) || lost(figure.y.log, **y)).count();
    figure.series.iter().filter(|s| !matches!(s.mark, Mark::Band { .. })).map(count).sum()
}
