//! The builder of a figure with two axes.

use super::series::{Guide, Mark, Series};
use crate::colour::Rgb;

/// A plot of one or several series over two axes, built up and then drawn by [`Figure::to_svg`].
///
/// Series with the same label share colour and legend entry, so a line and its band read as one. Values that are not
/// finite leave gaps; on a logarithmic axis so do values that are not positive, and the figure says how many.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    pub(super) title: String,
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) height: f64,
    pub(super) series: Vec<Series>,
    pub(super) guides: Vec<Guide>,
}

/// Label, unit and range of an axis.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Axis {
    pub label: String,
    pub unit: String,
    pub log: bool,
    pub range: Option<(f64, f64)>,
    pub include: Vec<f64>,
}

impl Figure {
    /// An empty figure; an empty title draws none.
    pub fn new(title: &str) -> Self {
        Self {
            title: title.into(),
            x: Axis::default(),
            y: Axis::default(),
            height: 300.0,
            series: Vec::new(),
            guides: Vec::new(),
        }
    }

    /// Names the x axis and its unit (empty: dimensionless).
    pub fn x(mut self, label: &str, unit: &str) -> Self {
        (self.x.label, self.x.unit) = (label.into(), unit.into());
        self
    }

    /// Names the y axis and its unit (empty: dimensionless).
    pub fn y(mut self, label: &str, unit: &str) -> Self {
        (self.y.label, self.y.unit) = (label.into(), unit.into());
        self
    }

    /// Makes the x axis logarithmic.
    pub fn log_x(mut self) -> Self {
        self.x.log = true;
        self
    }

    /// Makes the y axis logarithmic.
    pub fn log_y(mut self) -> Self {
        self.y.log = true;
        self
    }

    /// Shows x from `low` to `high`; what lies outside is cut off.
    pub fn x_range(mut self, low: f64, high: f64) -> Self {
        self.x.range = Some((low, high));
        self
    }

    /// Shows y from `low` to `high`; what lies outside is cut off.
    pub fn y_range(mut self, low: f64, high: f64) -> Self {
        self.y.range = Some((low, high));
        self
    }

    /// Widens the y axis so that `value` (often zero) is on it.
    pub fn y_include(mut self, value: f64) -> Self {
        self.y.include.push(value);
        self
    }

    /// Height of the plotting area in CSS pixels (300 if not set).
    pub fn height(mut self, pixels: f64) -> Self {
        self.height = pixels;
        self
    }

    /// A line through the points.
    pub fn line(self, label: &str, x: &[f64], y: &[f64]) -> Self {
        self.add(label, x, y, Mark::Line { dashed: false })
    }

    /// A dashed line through the points.
    pub fn dashed_line(self, label: &str, x: &[f64], y: &[f64]) -> Self {
        self.add(label, x, y, Mark::Line { dashed: true })
    }

    /// A line that keeps each value until the next x.
    pub fn steps(self, label: &str, x: &[f64], y: &[f64]) -> Self {
        self.add(label, x, y, Mark::Steps)
    }

    /// Unconnected points.
    pub fn points(self, label: &str, x: &[f64], y: &[f64]) -> Self {
        self.add(label, x, y, Mark::Points)
    }

    /// A shaded band from `lower` to `upper`; x must not fall.
    pub fn band(self, label: &str, x: &[f64], lower: &[f64], upper: &[f64]) -> Self {
        self.add(label, x, lower, Mark::Band { upper: upper.to_vec() })
    }

    /// Points with symmetric vertical error bars of half length `error`.
    pub fn error_bars(self, label: &str, x: &[f64], y: &[f64], error: &[f64]) -> Self {
        self.add(label, x, y, Mark::Errors { below: error.to_vec(), above: error.to_vec() })
    }

    /// Gives the series added last (and all of its label) this colour instead of the next of the palette.
    pub fn colour(mut self, colour: Rgb) -> Self {
        if let Some(label) = self.series.last().map(|s| s.label.clone()) {
            self.series.iter_mut().filter(|s| s.label == label).for_each(|s| s.colour = Some(colour));
        }
        self
    }

    /// A vertical line with a label.
    pub fn mark_x(mut self, x: f64, label: &str) -> Self {
        self.guides.push(Guide::AtX(x, label.into()));
        self
    }

    /// A horizontal line with a label; the y axis is widened to show it.
    pub fn mark_y(mut self, y: f64, label: &str) -> Self {
        self.guides.push(Guide::AtY(y, label.into()));
        self
    }

    /// Shades the plot between two x values, for instance where a mismatch sits.
    pub fn shade_x(mut self, from: f64, to: f64, label: &str) -> Self {
        self.guides.push(Guide::SpanX(from, to, label.into()));
        self
    }

    /// Shades the plot between two y values, for instance a noise band or a specification.
    pub fn shade_y(mut self, from: f64, to: f64, label: &str) -> Self {
        self.guides.push(Guide::SpanY(from, to, label.into()));
        self
    }

    fn add(mut self, label: &str, x: &[f64], y: &[f64], mark: Mark) -> Self {
        self.series.push(Series { label: label.into(), x: x.to_vec(), y: y.to_vec(), mark, colour: None });
        self
    }
}
