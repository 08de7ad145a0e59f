//! What a caller describes.

use super::error::VtuError;

/// Corners of the cells, as point indices.
#[derive(Debug, Clone, PartialEq)]
pub enum Cells {
    /// Triangles by their corners.
    Triangles(Vec<[usize; 3]>),
    /// Quadratic triangles: corners 0, 1, 2, then the points between 0-1, 1-2, 2-0.
    QuadraticTriangles(Vec<[usize; 6]>),
}

impl Cells {
    /// Number of cells.
    pub fn len(&self) -> usize {
        match self {
            Self::Triangles(cells) => cells.len(),
            Self::QuadraticTriangles(cells) => cells.len(),
        }
    }

    /// Whether there is no cell.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Points a cell.
    pub(super) fn width(&self) -> usize {
        match self {
            Self::Triangles(_) => 3,
            Self::QuadraticTriangles(_) => 6,
        }
    }

    /// All point indices, cell after cell.
    pub(super) fn flat(&self) -> &[usize] {
        match self {
            Self::Triangles(cells) => cells.as_flattened(),
            Self::QuadraticTriangles(cells) => cells.as_flattened(),
        }
    }
}

/// Values of one field; NaN means "not known" and is kept.
#[derive(Debug, Clone, PartialEq)]
pub enum Data {
    /// One number each.
    Scalar(Vec<f64>),
    /// In-plane vectors (r, z); written with a zero third component, as `Warp By Vector` wants it.
    Vector(Vec<[f64; 2]>),
    /// Symmetric axisymmetric tensors (rr, zz, θθ, rz); written as VTK's XX, YY, ZZ, XY, YZ, XZ.
    Tensor(Vec<[f64; 4]>),
    /// Whole numbers, for instance region labels.
    Label(Vec<i32>),
}

impl Data {
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Scalar(values) => values.len(),
            Self::Vector(values) => values.len(),
            Self::Tensor(values) => values.len(),
            Self::Label(values) => values.len(),
        }
    }
}

/// A triangulated section with fields, built up and then written by [`Grid::to_vtu`].
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) cells: Cells,
    pub(super) on_points: Vec<(String, Data)>,
    pub(super) on_cells: Vec<(String, Data)>,
    pub(super) notes: Vec<(String, String)>,
    pub(super) legend: Vec<(String, i32)>,
}

impl Grid {
    /// A grid of `cells` over `points` (r, z) or (x, y), m.
    pub fn new(points: Vec<[f64; 2]>, cells: Cells) -> Self {
        Self { points, cells, on_points: Vec::new(), on_cells: Vec::new(), notes: Vec::new(), legend: Vec::new() }
    }

    /// Adds a field with a value for each point; the unit belongs into the name, as `temperature (K)`.
    pub fn on_points(mut self, name: &str, data: Data) -> Self {
        self.on_points.push((name.into(), data));
        self
    }

    /// Adds a field with a value for each cell.
    pub fn on_cells(mut self, name: &str, data: Data) -> Self {
        self.on_cells.push((name.into(), data));
        self
    }

    /// Adds a fact about the file (source, command, version), kept in its field data as the codes of its UTF-8 text.
    ///
    /// meshio 5.3.5 refuses a whole file that holds VTK's own text arrays, so none is written.
    pub fn note(mut self, name: &str, text: &str) -> Self {
        self.notes.push((name.into(), text.into()));
        self
    }

    /// Says what the numbers of a label field mean: `names[k]` is the name of `k`.
    ///
    /// Kept in the field data as one number called `field: name` for each, which VTK and meshio both read.
    pub fn legend(mut self, field: &str, names: &[String]) -> Self {
        self.legend.extend(names.iter().zip(0..).map(|(name, number)| (format!("{field}: {name}"), number)));
        self
    }

    pub(super) fn check(&self) -> Result<(), VtuError> {
        if self.cells.is_empty() {
            return Err(VtuError::Empty);
        }
        if let Some(point) = self.points.iter().position(|p| !(p[0].is_finite() && p[1].is_finite())) {
            return Err(VtuError::NotFinite { point });
        }
        let points = self.points.len();
        if let Some(place) = self.cells.flat().iter().position(|&p| p >= points) {
            let (cell, point) = (place / self.cells.width(), self.cells.flat()[place]);
            return Err(VtuError::NoSuchPoint { cell, point, points });
        }
        check_fields(&self.on_points, points, "points")?;
        check_fields(&self.on_cells, self.cells.len(), "cells")
    }
}

fn check_fields(fields: &[(String, Data)], wanted: usize, of: &'static str) -> Result<(), VtuError> {
    for (i, (field, data)) in fields.iter().enumerate() {
        if data.len() != wanted {
            return Err(VtuError::Lengths { field: field.clone(), found: data.len(), wanted, of });
        }
        if fields[..i].iter().any(|(other, _)| other == field) {
            return Err(VtuError::SameName { field: field.clone(), of });
        }
    }
    Ok(())
}
