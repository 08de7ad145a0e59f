//! One plotting area: axes, grid, guides, series.

use super::chart::{Axis, Figure};
use super::error::FigureError;
use super::scale::{Scale, extent, padded};
use super::series::{Guide, Mark, Series, colour_of};
use super::svg::{Anchor, Area, Svg, TEXT, WIDTH, px, text_width};
use super::ticks::Ticks;
use crate::colour::Rgb;

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
    figure: &'a Figure,
    x_axis: &'a Axis,
    pub(super) x: Scale,
    pub(super) y: Scale,
    y_ticks: Ticks,
    hidden: usize,
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
        Ok(Self { figure, x_axis, x, y, y_ticks, hidden: hidden(figure, x_axis) })
    }

    /// Room that the y axis needs.
    pub fn left_margin(&self) -> f64 {
        let widest = self.y_ticks.major.iter().map(|(_, label)| text_width(label, TEXT)).fold(0.0, f64::max);
        widest + 38.0
    }

    pub fn draw(mut self, svg: &mut Svg, area: Area, colours: &[(String, Rgb)], x_axis: XAxis) {
        self.x.pixels = area.width;
        let x_ticks = Ticks::new(&self.x, (area.width / 95.0) as usize);
        self.draw_grid(svg, area, &x_ticks);
        svg.open_window(area);
        self.figure.guides.iter().for_each(|guide| self.draw_span(svg, area, guide));
        // Bands first: they must not cover lines.
        let is_band = |s: &&Series| matches!(s.mark, Mark::Band { .. });
        for series in self.figure.series.iter().filter(is_band) {
            self.draw_band(svg, series, &colour_of(colours, &series.label).css());
        }
        for series in self.figure.series.iter().filter(|s| !is_band(s)) {
            self.draw_series(svg, series, &colour_of(colours, &series.label).css());
        }
        self.figure.guides.iter().for_each(|guide| self.draw_guide(svg, area, guide));
        svg.close_window();
        svg.rect(area, r#"fill="none" stroke="currentColor" stroke-opacity="0.55""#);
        self.draw_y_axis(svg, area);
        if x_axis == XAxis::Labelled {
            self.draw_x_axis(svg, area, &x_ticks);
        }
    }

    fn draw_grid(&self, svg: &mut Svg, area: Area, x_ticks: &Ticks) {
        let mut strokes = String::new();
        for (value, _) in &x_ticks.major {
            strokes += &format!("M{} {}v{}", px(area.left + self.x.at(*value)), px(area.top), px(area.height));
        }
        for (value, _) in &self.y_ticks.major {
            strokes += &format!("M{} {}h{}", px(area.left), px(area.top + self.y.at(*value)), px(area.width));
        }
        svg.raw(&format!("<path d=\"{strokes}\" stroke=\"currentColor\" stroke-opacity=\"0.12\" fill=\"none\"/>\n"));
        let mut small = String::new();
        for value in &x_ticks.minor {
            small += &format!("M{} {}v-4", px(area.left + self.x.at(*value)), px(area.bottom()));
        }
        for value in &self.y_ticks.minor {
            small += &format!("M{} {}h4", px(area.left), px(area.top + self.y.at(*value)));
        }
        if !small.is_empty() {
            svg.raw(&format!("<path d=\"{small}\" stroke=\"currentColor\" stroke-opacity=\"0.45\" fill=\"none\"/>\n"));
        }
    }

    fn draw_y_axis(&self, svg: &mut Svg, area: Area) {
        for (value, label) in &self.y_ticks.major {
            svg.text(area.left - 7.0, area.top + self.y.at(*value) + 4.0, Anchor::End, label);
        }
        let axis = &self.figure.y;
        let (x, y) = (15.0, area.top + area.height / 2.0);
        let turn = format!(r#"transform="rotate(-90 {} {})""#, px(x), px(y));
        svg.styled_text(x, y, Anchor::Middle, &self.y_ticks.title(&axis.label, &axis.unit), &turn);
        if self.hidden > 0 {
            let note = format!("{} values ≤ 0 not drawn (logarithmic axis)", self.hidden);
            let style = r#"font-size="10.5" opacity="0.75""#;
            svg.styled_text(area.right() - 6.0, area.top + 14.0, Anchor::End, &note, style);
        }
    }

    fn draw_x_axis(&self, svg: &mut Svg, area: Area, ticks: &Ticks) {
        for (value, label) in &ticks.major {
            svg.text(area.left + self.x.at(*value), area.bottom() + 17.0, Anchor::Middle, label);
        }
        let title = ticks.title(&self.x_axis.label, &self.x_axis.unit);
        svg.text(area.left + area.width / 2.0, area.bottom() + 36.0, Anchor::Middle, &title);
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
fn hidden(figure: &Figure, x_axis: &Axis) -> usize {
    let lost = |log: bool, v: f64| log && v.is_finite() && v <= 0.0;
    let count = |s: &Series| s.x.iter().zip(&s.y).filter(|(x, y)| lost(x_axis.log, **x) || lost(figure.y.log, **y)).count();
    figure.series.iter().filter(|s| !matches!(s.mark, Mark::Band { .. })).map(count).sum()
}
