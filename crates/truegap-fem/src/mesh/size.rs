//! How large the triangles may be, as a function of the place.

use super::plane::{Point, distance};

/// A place with a wanted edge length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeSource {
    /// Where (m).
    pub at: Point,
    /// Edge length there (m).
    pub size: f64,
}

/// Edge length wanted at every point: the least over all sources of `size + growth * distance`, at most `max_edge`.
#[derive(Debug, Clone, PartialEq)]
pub struct SizeField {
    /// Largest edge anywhere (m); infinite where only the geometry decides.
    pub max_edge: f64,
    /// Increase of the edge length per distance from a source, dimensionless; 0.2 to 0.5 is usual.
    pub growth: f64,
    /// Points of finer mesh.
    pub sources: Vec<SizeSource>,
}

impl Default for SizeField {
    fn default() -> Self {
        SizeField { max_edge: f64::INFINITY, growth: 0.3, sources: Vec::new() }
    }
}

impl SizeField {
    /// The same edge length everywhere (m).
    pub fn uniform(max_edge: f64) -> SizeField {
        SizeField { max_edge, ..SizeField::default() }
    }

    /// Wanted edge length at `p` (m).
    pub fn at(&self, p: Point) -> f64 {
        self.sources.iter().map(|s| s.size + self.growth * distance(s.at, p)).fold(self.max_edge, f64::min)
    }

    /// Whether the wanted length is the same everywhere.
    pub(crate) fn is_uniform(&self) -> bool {
        self.sources.is_empty()
    }
}
