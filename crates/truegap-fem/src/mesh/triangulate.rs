//! From a drawing to a graded, labelled triangulation by constrained Delaunay refinement.
//!
//! Angles below the limit remain only where the drawing itself has them.

use super::arrangement::Arrangement;
use super::constrained::{Cdt, constrained, failed};
use super::error::MeshError;
use super::estimate::check_size;
use super::inside::Inside;
use super::label::label_faces;
use super::mesh::Mesh;
use super::options::MeshOptions;
use super::outline::Geometry;
use super::plane::{Point, along, distance};
use spade::{AngleLimit, Point2, RefinementParameters, Triangulation};

/// Meshes a drawing.
pub fn mesh_geometry(geometry: &Geometry, options: &MeshOptions) -> Result<Mesh, MeshError> {
    if !(options.size.max_edge > 0.0) || options.size.sources.iter().any(|s| !(s.size > 0.0)) {
        return Err(MeshError::BadSize {
            size: options.size.sources.iter().map(|s| s.size).fold(options.size.max_edge, f64::min),
        });
    }
    let drawing = Arrangement::new(geometry)?;
    check_size(&drawing, options)?;
    let (mut cdt, chords) = constrained(&drawing, options)?;
    refine(&mut cdt, &drawing, options)?;
    let mut mesh = label_faces(&cdt, &drawing, &chords)?;
    // dividing an edge of the axis rounds to one side or the other
    mesh.points.iter_mut().for_each(|p| *p = drawing.on_coordinate_lines(*p));
    Ok(mesh)
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
    let inside = Inside::new(drawing, options.arc_step_degrees);
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
