//! A plane of cells coloured by value, with a colour bar.

use super::error::FigureError;
use super::scale::extent;
use crate::colour::ColourMap;

/// Cells between rising edges, coloured by value. Cells without a finite value stay grey.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatMap {
    pub(super) title: String,
    pub(super) x: (String, String),
    pub(super) y: (String, String),
    pub(super) value: (String, String),
    pub(super) x_edges: Vec<f64>,
    pub(super) y_edges: Vec<f64>,
    pub(super) cells: Vec<f64>,
    pub(super) map: ColourMap,
    pub(super) range: Option<(f64, f64)>,
    pub(super) bend: Option<f64>,
    pub(super) height: f64,
}

/// What the colours span and what the values span.
pub(super) struct Spans {
    pub colours: (f64, f64),
    pub values: (f64, f64),
}

impl HeatMap {
    /// A map of `cells`, row by row from the lowest y up: `cells[j * columns + i]` lies between `x_edges[i]`, `x_edges[i + 1]`
    /// and `y_edges[j]`, `y_edges[j + 1]`.
    pub fn new(title: &str, x_edges: &[f64], y_edges: &[f64], cells: &[f64]) -> Self {
        Self {
            title: title.into(),
            x: Default::default(),
            y: Default::default(),
            value: Default::default(),
            x_edges: x_edges.to_vec(),
            y_edges: y_edges.to_vec(),
            cells: cells.to_vec(),
            map: ColourMap::Sequential,
            range: None,
            bend: None,
            height: 320.0,
        }
    }

    /// Names the x axis and its unit.
    pub fn x(mut self, label: &str, unit: &str) -> Self {
        self.x = (label.into(), unit.into());
        self
    }

    /// Names the y axis and its unit.
    pub fn y(mut self, label: &str, unit: &str) -> Self {
        self.y = (label.into(), unit.into());
        self
    }

    /// Names the coloured value and its unit.
    pub fn value(mut self, label: &str, unit: &str) -> Self {
        self.value = (label.into(), unit.into());
        self
    }

    /// Blue below zero, brown above, white at zero: for differences.
    pub fn diverging(mut self) -> Self {
        self.map = ColourMap::Diverging;
        self
    }

    /// Colours even up to about `unit` on both sides of zero and logarithmic beyond, so that one huge cell does not leave the others white.
    pub fn bent(mut self, unit: f64) -> Self {
        self.bend = Some(unit);
        self
    }

    /// Place of a value between the ends of the colours: 0 to 1 within them.
    pub(super) fn place(&self, value: f64, (low, high): (f64, f64)) -> f64 {
        let bent = |v: f64| self.bend.map_or(v, |unit| (v / unit).asinh());
        (bent(value) - bent(low)) / (bent(high) - bent(low))
    }

    /// Colours from `low` to `high`; values beyond take the end colour and the colour bar says so.
    pub fn value_range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// Height of the plane in CSS pixels (320 if not set).
    pub fn height(mut self, pixels: f64) -> Self {
        self.height = pixels;
        self
    }

    /// Ends of the colours and extent of the values, of a map whose edges and cells fit.
    pub(super) fn checked(&self) -> Result<Spans, FigureError> {
        self.rising("x edges", &self.x_edges)?;
        self.rising("y edges", &self.y_edges)?;
        let wanted = (self.x_edges.len() - 1) * (self.y_edges.len() - 1);
        if wanted != self.cells.len() {
            return Err(FigureError::Lengths {
                figure: self.title.clone(),
                series: self.value.0.clone(),
                left: wanted,
                left_name: "cells between the edges",
                right: self.cells.len(),
                right_name: "values",
            });
        }
        let found =
            extent(self.cells.iter().copied(), false).ok_or(FigureError::Empty { figure: self.title.clone(), axis: "value" })?;
        let (low, high) = self.range.unwrap_or(self.map.span(found.0, found.1));
        if !(low < high && low.is_finite() && high.is_finite()) {
            return Err(FigureError::Range { figure: self.title.clone(), axis: "value", low, high });
        }
        Ok(Spans { colours: (low, high), values: found })
    }

    fn rising(&self, name: &str, edges: &[f64]) -> Result<(), FigureError> {
        let bad = edges.windows(2).position(|pair| pair[0].is_nan() || pair[1].is_nan() || pair[0] >= pair[1]);
        if edges.len() < 2 {
            return Err(FigureError::Empty { figure: self.title.clone(), axis: "x or y" });
        }
        bad.map_or(Ok(()), |index| {
            Err(FigureError::NotOrdered { figure: self.title.clone(), series: name.into(), index: index + 1 })
        })
    }
}
