//! The constrained Delaunay triangulation of a drawing before it is refined.
//!
//! The domain is enclosed in a larger box whose triangles are dropped afterwards: refining up to a boundary that is
//! not parallel to an axis makes the triangulation library panic otherwise.

use super::arrangement::{Arrangement, Piece};
use super::error::MeshError;
use super::options::MeshOptions;
use super::plane::{Point, along, distance};
use spade::{ConstrainedDelaunayTriangulation, Point2};

/// The triangulation that the mesher refines.
pub(crate) type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// A straight constraint edge and the piece of the drawing it stands for.
pub(crate) struct Chord {
    pub ends: [Point; 2],
    pub piece: usize,
}

/// Triangulates the pieces of a drawing, divided by the size field.
pub(crate) fn constrained(drawing: &Arrangement, options: &MeshOptions) -> Result<(Cdt, Vec<Chord>), MeshError> {
    let mut points = enclosing_box(drawing);
    let first = points.len();
    points.extend_from_slice(&drawing.vertices);
    let mut edges = Vec::new();
    let mut chords = Vec::new();
    for (index, piece) in drawing.pieces.iter().enumerate() {
        let stops = stops(piece, options);
        let mut at = first + piece.ends[0];
        for (k, pair) in stops.windows(2).enumerate() {
            let next = if k + 2 == stops.len() {
                first + piece.ends[1]
            } else {
                points.push(pair[1]);
                points.len() - 1
            };
            edges.push([at, next]);
            chords.push(Chord { ends: [points[at], points[next]], piece: index });
            at = next;
        }
    }
    let vertices = points.iter().map(|p| Point2::new(p[0], p[1])).collect();
    let mut conflict = None;
    let cdt = Cdt::try_bulk_load_cdt(vertices, edges, |e| conflict = Some(e)).map_err(failed)?;
    match conflict {
        // Lines that cross were cut; only coarse arcs can still cross a neighbour.
        Some([a, _]) => Err(MeshError::CrossingOutline { name: "an arc and its neighbour".into(), at: points[a] }),
        None => Ok((cdt, chords)),
    }
}

pub(crate) fn failed(reason: impl std::fmt::Display) -> MeshError {
    MeshError::Triangulation { reason: reason.to_string() }
}

fn enclosing_box(drawing: &Arrangement) -> Vec<Point> {
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    let middles = drawing.pieces.iter().flat_map(|p| [0.25, 0.5, 0.75].map(|t| p.curve.point(t)));
    for p in drawing.vertices.iter().copied().chain(middles) {
        for k in 0..2 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    let margin = 0.6 * distance(low, high);
    let (a, b) = ([low[0] - margin, low[1] - margin], [high[0] + margin, high[1] + margin]);
    vec![a, [b[0], a[1]], b, [a[0], b[1]]]
}

/// Points that divide a piece: arcs by angle, then everything by the size field.
fn stops(piece: &Piece, options: &MeshOptions) -> Vec<Point> {
    let curve = &piece.curve;
    let parts = curve.arc.map_or(1, |(_, sweep)| (sweep.abs().to_degrees() / options.arc_step_degrees).ceil().max(1.0) as usize);
    let mut fractions = vec![0.0];
    for k in 0..parts {
        divide(piece, options, [k as f64 / parts as f64, (k + 1) as f64 / parts as f64], &mut fractions, 0);
    }
    fractions.into_iter().map(|t| curve.point(t)).collect()
}

fn divide(piece: &Piece, options: &MeshOptions, [t0, t1]: [f64; 2], out: &mut Vec<f64>, depth: u32) {
    let (a, b) = (piece.curve.point(t0), piece.curve.point(t1));
    let wanted = [a, along(a, b, 0.5), b].map(|p| options.size.at(p)).into_iter().fold(f64::INFINITY, f64::min);
    if distance(a, b) <= 1.2 * wanted || depth > 40 {
        out.push(t1);
        return;
    }
    let middle = 0.5 * (t0 + t1);
    divide(piece, options, [t0, middle], out, depth + 1);
    divide(piece, options, [middle, t1], out, depth + 1);
}
