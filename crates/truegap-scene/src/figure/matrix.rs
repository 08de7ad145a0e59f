//! A table of numbers coloured by size: confusion matrices, correlations.

use super::error::FigureError;
use super::scale::extent;
use super::svg::{Anchor, Area, Svg, TEXT, WIDTH, fit, px, text_width};
use super::ticks::fixed;
use crate::colour::{ColourMap, Rgb};

const CELL_HEIGHT: f64 = 24.0;
const WIDEST_CELL: f64 = 64.0;

/// Rows by columns of numbers with their labels. Values that are not finite leave the cell empty.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    title: String,
    axes: (String, String),
    rows: Vec<String>,
    columns: Vec<String>,
    values: Vec<f64>,
    map: ColourMap,
    decimals: usize,
}

impl Matrix {
    /// A matrix given row by row.
    pub fn new(title: &str, rows: &[&str], columns: &[&str], values: &[f64]) -> Self {
        Self {
            title: title.into(),
            axes: Default::default(),
            rows: rows.iter().map(|&r| r.into()).collect(),
            columns: columns.iter().map(|&c| c.into()).collect(),
            values: values.to_vec(),
            map: ColourMap::Sequential,
            decimals: 2,
        }
    }

    /// Names what the rows and the columns are, for instance "true cause" and "named cause".
    pub fn axes(mut self, rows: &str, columns: &str) -> Self {
        self.axes = (rows.into(), columns.into());
        self
    }

    /// Blue below zero, brown above: for correlations.
    pub fn diverging(mut self) -> Self {
        self.map = ColourMap::Diverging;
        self
    }

    /// Decimals of the numbers in the cells (2 if not set).
    pub fn decimals(mut self, decimals: usize) -> Self {
        self.decimals = decimals;
        self
    }

    /// Draws the matrix.
    ///
    /// # Errors
    /// A number of values that is not rows times columns; no finite value.
    pub fn to_svg(&self) -> Result<String, FigureError> {
        let wanted = self.rows.len() * self.columns.len();
        if wanted != self.values.len() {
            return Err(FigureError::Lengths {
                figure: self.title.clone(),
                series: "matrix".into(),
                left: wanted,
                left_name: "cells",
                right: self.values.len(),
                right_name: "values",
            });
        }
        let found =
            extent(self.values.iter().copied(), false).ok_or(FigureError::Empty { figure: self.title.clone(), axis: "value" })?;
        let (low, high) = match self.map {
            ColourMap::Sequential => self.map.span(found.0.min(0.0), found.1),
            ColourMap::Diverging => self.map.span(found.0, found.1),
        };
        Ok(self.draw(low, high))
    }

    fn draw(&self, low: f64, high: f64) -> String {
        let mut svg = Svg::default();
        let widest = |labels: &[String]| labels.iter().map(|l| text_width(l, 11.0)).fold(0.0, f64::max);
        let left = widest(&self.rows).min(220.0) + 38.0;
        let cell = ((WIDTH - left - 60.0) / self.columns.len() as f64).min(WIDEST_CELL);
        let top = svg.heading(&self.title) + widest(&self.columns).min(220.0) * 0.72 + 30.0;
        let bottom = top + CELL_HEIGHT * self.rows.len() as f64;
        for (j, row) in self.rows.iter().enumerate() {
            let y = top + CELL_HEIGHT * j as f64;
            svg.styled_text(left - 6.0, y + 16.0, Anchor::End, &fit(row, 11.0, 220.0), r#"font-size="11""#);
            for i in 0..self.columns.len() {
                let place = Area { left: left + cell * i as f64, top: y, width: cell, height: CELL_HEIGHT };
                self.draw_cell(&mut svg, place, (j, i), (low, high));
            }
        }
        for (i, column) in self.columns.iter().enumerate() {
            let (x, y) = (left + cell * (i as f64 + 0.5), top - 6.0);
            let turn = format!(r#"transform="rotate(-45 {} {})" font-size="11""#, px(x), px(y));
            svg.styled_text(x, y, Anchor::Start, &fit(column, 11.0, 220.0), &turn);
        }
        let middle = (top + bottom) / 2.0;
        let turn = format!(r#"transform="rotate(-90 15 {})" font-weight="600""#, px(middle));
        svg.styled_text(15.0, middle, Anchor::Middle, &self.axes.0, &turn);
        let centre = left + cell * self.columns.len() as f64 / 2.0;
        svg.styled_text(centre, bottom + 20.0, Anchor::Middle, &self.axes.1, r#"font-weight="600""#);
        svg.finish(&self.title, bottom + 32.0)
    }

    /// Amounts go from near-white to dark blue, so that nothing looks like nothing.
    fn colour(&self, t: f64) -> Rgb {
        match self.map {
            ColourMap::Sequential => ColourMap::Diverging.at(0.5 - 0.5 * t),
            ColourMap::Diverging => self.map.at(t),
        }
    }

    fn draw_cell(&self, svg: &mut Svg, place: Area, (j, i): (usize, usize), (low, high): (f64, f64)) {
        let value = self.values[j * self.columns.len() + i];
        if !value.is_finite() {
            svg.rect(place, r#"fill="currentColor" fill-opacity="0.06""#);
            return;
        }
        let colour = self.colour((value - low) / (high - low));
        let inner = Area { width: place.width - 1.0, height: place.height - 1.0, ..place };
        svg.rect(inner, &format!(r#"fill="{}""#, colour.css()));
        let text = fixed(value, self.decimals);
        let size = if text_width(&text, TEXT) < place.width - 4.0 { 11.0 } else { 8.5 };
        let ink = if colour.wants_dark_text() { "#1b1f24" } else { "#ffffff" };
        let style = format!(r#"font-size="{size}" fill="{ink}""#);
        svg.styled_text(place.left + place.width / 2.0, place.top + 16.0, Anchor::Middle, &text, &style);
    }
}
