//! What a user draws: regions bounded by lines and arcs, and named boundary paths.
//!
//! A later region cuts an earlier one; no region has holes other than those cut so.

use super::curve::Curve;
use super::error::MeshError;
use super::plane::{Point, cross, distance, minus};

/// One step of an outline from the point before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// Straight to a point.
    Line(Point),
    /// Along a circular arc.
    Arc {
        /// A point that the arc passes.
        via: Point,
        /// Where it ends.
        to: Point,
    },
}

/// A start and the steps from it (m).
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// First point.
    pub start: Point,
    /// The way from there.
    pub steps: Vec<Step>,
}

impl Outline {
    /// The outline through corners joined by straight lines.
    pub fn polygon(corners: &[Point]) -> Outline {
        let start = corners.first().copied().unwrap_or([f64::NAN; 2]);
        Outline { start, steps: corners.iter().skip(1).map(|&p| Step::Line(p)).collect() }
    }

    /// The axis-parallel rectangle between two opposite corners.
    pub fn rectangle(low: Point, high: Point) -> Outline {
        Outline::polygon(&[low, [high[0], low[1]], high, [low[0], high[1]]])
    }

    /// The curves as drawn, and back to the start by a line where `closed`.
    pub(crate) fn curves(&self, closed: bool) -> Vec<Curve> {
        let mut at = self.start;
        let mut curves = Vec::with_capacity(self.steps.len() + 1);
        for step in &self.steps {
            let curve = match *step {
                Step::Line(to) => Curve::line(at, to),
                Step::Arc { via, to } => Curve::arc(at, via, to),
            };
            at = curve.to;
            curves.push(curve);
        }
        if closed && at != self.start {
            curves.push(Curve::line(at, self.start));
        }
        curves.retain(|c| c.from != c.to);
        curves
    }
}

/// A named part of the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Name, unique among the regions.
    pub name: String,
    /// Its outline, closed from the last point to the first.
    pub outline: Outline,
}

/// Where a named boundary runs.
#[derive(Debug, Clone, PartialEq)]
pub enum BoundaryPath {
    /// An open path inside or around the domain.
    Path(Outline),
    /// The whole outline of the region of this name.
    OutlineOf(String),
}

/// A named set of edges.
#[derive(Debug, Clone, PartialEq)]
pub struct Boundary {
    /// Name; several paths may share one.
    pub name: String,
    /// Where it runs.
    pub path: BoundaryPath,
}

/// The drawing that a mesh is made of.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Geometry {
    /// Regions; later ones cut earlier ones.
    pub regions: Vec<Region>,
    /// Named boundaries.
    pub boundaries: Vec<Boundary>,
}

impl Geometry {
    /// Adds a region; for use in a chain.
    pub fn region(mut self, name: &str, outline: Outline) -> Geometry {
        self.regions.push(Region { name: name.into(), outline });
        self
    }

    /// Adds a boundary along a straight path through `points`; for use in a chain.
    pub fn boundary(mut self, name: &str, points: &[Point]) -> Geometry {
        self.boundaries.push(Boundary { name: name.into(), path: BoundaryPath::Path(Outline::polygon(points)) });
        self
    }

    /// Adds the outline of a region as a boundary; for use in a chain.
    pub fn boundary_of(mut self, name: &str, region: &str) -> Geometry {
        self.boundaries.push(Boundary { name: name.into(), path: BoundaryPath::OutlineOf(region.into()) });
        self
    }
}

/// Checks that a region's outline encloses an area.
pub(crate) fn check_closed(region: &Region, curves: &[Curve]) -> Result<(), MeshError> {
    if let Some(at) = curves.iter().flat_map(|c| [c.from, c.to]).find(|p| !(p[0].is_finite() && p[1].is_finite())) {
        return Err(MeshError::NotFinite { name: region.name.clone(), at });
    }
    let chords: Vec<Point> = curves.iter().flat_map(|c| [c.point(0.0), c.point(0.25), c.point(0.5), c.point(0.75)]).collect();
    let n = chords.len();
    // Magnitudes are summed: an outline that crosses itself may enclose zero, and is reported as crossing.
    let spoke = |i: usize| minus(chords[i % n], region.outline.start);
    let area: f64 = (0..n).map(|i| 0.5 * cross(spoke(i), spoke(i + 1)).abs()).sum();
    let reach = chords.iter().map(|&p| distance(p, region.outline.start)).fold(0.0, f64::max);
    if n < 8 || area <= 1e-12 * reach * reach {
        return Err(MeshError::OpenOutline { region: region.name.clone(), corners: curves.len(), at: region.outline.start });
    }
    Ok(())
}
