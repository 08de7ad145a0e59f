//! Figures for reports: self-contained SVG text, no script, no font file, readable on paper and for any colour vision.
//!
//! [`Figure`] draws lines, points, steps, bands and error bars; [`Stack`] puts figures under one x axis; [`Bars`] ranks;
//! [`HeatMap`] and [`Matrix`] colour a plane and a table. All check what they are given in `to_svg`.
//!
//! Why own code: plotters 0.3.7 draws on whole pixels (`BackendCoord = (i32, i32)`), which turns a slow drift into stairs,
//! and writes colours into each element, which rules out dark pages; kuva 0.6 is too young to lean on. Each panel carries its
//! axes as attributes (`data-x`, `data-y`), from which the script of a page reads values and zooms. What is missing
//! here: polar and 3D axes, more than one y axis.

mod bars;
mod chart;
mod chart_draw;
mod decimate;
mod error;
mod guides;
mod heat;
mod heat_draw;
mod legend;
mod marks;
mod matrix;
mod panel;
mod panel_draw;
mod scale;
mod series;
mod stack;
mod svg;
mod ticks;

pub use bars::Bars;
pub use chart::Figure;
pub use error::FigureError;
pub use heat::HeatMap;
pub use matrix::Matrix;
pub use stack::Stack;
