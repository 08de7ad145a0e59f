//! From a drawing to a graded, labelled triangulation by constrained Delaunay refinement.
//!
//! The domain is enclosed in a larger box whose triangles are dropped afterwards: refining up to a boundary that is
//! not parallel to an axis makes the triangulation library panic otherwise. Angles below the limit remain only where
//! the drawing itself has them.

use super::arrangement::{Arrangement, Piece};
use super::label::label_faces;
use super::plane::{Point, along, distance};
use super::size::SizeField;
use super::{Geometry, Mesh, MeshError};
use spade::{AngleLimit, ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation};

pub(crate) type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// How to mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshOptions {
    /// Wanted edge lengths.
    pub size: SizeField,
    /// Smallest inner angle aimed at, degrees; refinement ends for certain up to about 30.
    pub least_angle_degrees: f64,
    /// Largest angle that one edge of an arc spans, degrees.
    pub arc_step_degrees: f64,
    /// Most triangles before the mesher gives up.
    pub max_triangles: usize,
}

impl Default for MeshOptions {
    fn default() -> Self {
        MeshOptions { size: SizeField::default(), least_angle_degrees: 28.0, arc_step_degrees: 10.0, max_triangles: 8_000_000 }
    }
}

/// A straight constraint edge and the piece of the drawing it stands for.
pub(crate) struct Chord {
    pub ends: [Point; 2],
    pub piece: usize,
}

/// Meshes a drawing.
pub fn mesh_geometry(geometry: &Geometry, options: &MeshOptions) -> Result<Mesh, MeshError> {
    if !(options.size.max_edge > 0.0) || options.size.sources.iter().any(|s| !(s.size > 0.0)) {
        return Err(MeshError::BadSize {
            size: options.size.sources.iter().map(|s| s.size).fold(options.size.max_edge, f64::min),
        });
    }
    let drawing = Arrangement::new(geometry)?;
    let (mut cdt, chords) = constrained(&drawing, options)?;
    refine(&mut cdt, &drawing, options)?;
    label_faces(&cdt, &drawing, &chords)
}

fn constrained(drawing: &Arrangement, options: &MeshOptions) -> Result<(Cdt, Vec<Chord>), MeshError> {
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

fn failed(reason: impl std::fmt::Display) -> MeshError {
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

fn refine(cdt: &mut Cdt, drawing: &Arrangement, options: &MeshOptions) -> Result<(), MeshError> {
    let quality = RefinementParameters::<f64>::new()
        .with_angle_limit(AngleLimit::from_deg(options.least_angle_degrees))
        .with_min_required_area(drawing.tolerance * drawing.tolerance * 1e4)
        .with_max_additional_vertices(options.max_triangles / 2);
    let first = cdt.refine(quality.clone());
    if !first.refinement_complete {
        return Err(MeshError::TooManyTriangles { limit: options.max_triangles });
    }
    if !options.size.max_edge.is_finite() && options.size.is_uniform() {
        return Ok(());
    }
    fill_by_size(cdt, drawing, options)?;
    if !cdt.refine(quality).refinement_complete {
        return Err(MeshError::TooManyTriangles { limit: options.max_triangles });
    }
    Ok(())
}

/// Inserts circumcentres of triangles that are too large for the size field, largest excess first, until none is left.
fn fill_by_size(cdt: &mut Cdt, drawing: &Arrangement, options: &MeshOptions) -> Result<(), MeshError> {
    let inside = super::label::Inside::new(drawing, options.arc_step_degrees);
    for _pass in 0..60 {
        let mut wanted: Vec<(f64, Point, spade::handles::FixedVertexHandle)> = Vec::new();
        for face in cdt.inner_faces() {
            let (centre, squared) = face.circumcircle();
            let middle = face.center();
            if inside.region([middle.x, middle.y]).is_none() {
                continue;
            }
            // An equilateral triangle of edge h has the circumradius h / sqrt 3.
            let excess = squared.sqrt() / (0.62 * options.size.at([middle.x, middle.y]));
            if excess > 1.0 {
                let place =
                    if inside.region([centre.x, centre.y]).is_some() { [centre.x, centre.y] } else { [middle.x, middle.y] };
                wanted.push((excess, place, face.vertices()[0].fix()));
            }
        }
        if wanted.is_empty() {
            return Ok(());
        }
        wanted.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut inserted = 0;
        for (_, place, hint) in wanted {
            if clear(cdt, place, hint, 0.55 * options.size.at(place)) {
                cdt.insert_with_hint(Point2::new(place[0], place[1]), hint).map_err(failed)?;
                inserted += 1;
            }
            if 2 * cdt.num_vertices() > options.max_triangles {
                return Err(MeshError::TooManyTriangles { limit: options.max_triangles });
            }
        }
        if inserted == 0 {
            return Ok(());
        }
    }
    Ok(())
}

/// Whether a point keeps its distance from the corners of the triangle it falls into and encroaches no constraint.
fn clear(cdt: &Cdt, place: Point, hint: spade::handles::FixedVertexHandle, room: f64) -> bool {
    use spade::PositionInTriangulation::OnFace;
    let OnFace(face) = cdt.locate_with_hint(Point2::new(place[0], place[1]), hint) else {
        return false;
    };
    let face = cdt.face(face);
    let far = face.positions().iter().all(|q| distance(place, [q.x, q.y]) >= room);
    far && face.adjacent_edges().iter().all(|edge| {
        let [a, b] = edge.positions().map(|p| [p.x, p.y]);
        !edge.as_undirected().data().is_constraint_edge() || distance(along(a, b, 0.5), place) > 0.5 * distance(a, b)
    })
}
