//! Which region a triangle belongs to, and which boundary an edge: from the triangulation to a `Mesh`.
//!
//! Faces are labelled component by component between constraint edges, so that one point-in-outline test decides for
//! all of them.

use super::arrangement::Arrangement;
use super::constrained::{Cdt, Chord};
use super::error::MeshError;
use super::inside::Inside;
use super::mesh::{BoundaryEdge, CurvedEdge, Mesh};
use super::plane::{Point, along, distance, dot, minus};
use super::topology::Topology;
use spade::Triangulation;
use spade::handles::FixedVertexHandle;
use std::collections::HashMap;

const OUTSIDE: u16 = u16::MAX;

pub(crate) fn label_faces(cdt: &Cdt, drawing: &Arrangement, chords: &[Chord]) -> Result<Mesh, MeshError> {
    let faces = face_regions(cdt, drawing);
    let mut mesh = Mesh {
        region_names: drawing.regions.iter().map(|(name, _)| name.clone()).collect(),
        boundary_names: drawing.boundaries.clone(),
        ..Mesh::default()
    };
    let mut number: HashMap<FixedVertexHandle, u32> = HashMap::new();
    for face in cdt.inner_faces() {
        let region = faces[face.fix().index()];
        if region == OUTSIDE {
            continue;
        }
        let corners = face.vertices().map(|v| {
            *number.entry(v.fix()).or_insert_with(|| {
                let p = v.position();
                mesh.points.push([p.x, p.y]);
                (mesh.points.len() - 1) as u32
            })
        });
        mesh.triangles.push(corners);
        mesh.triangle_regions.push(region);
    }
    check_regions(&mesh)?;
    label_edges(cdt, drawing, chords, &number, &mut mesh)?;
    mesh.check()?;
    Ok(mesh)
}

fn check_regions(mesh: &Mesh) -> Result<(), MeshError> {
    let mut seen = vec![false; mesh.region_names.len()];
    mesh.triangle_regions.iter().for_each(|&r| seen[r as usize] = true);
    match seen.iter().position(|s| !s) {
        Some(i) => Err(MeshError::RegionVanished { region: mesh.region_names[i].clone() }),
        None => Ok(()),
    }
}

fn face_regions(cdt: &Cdt, drawing: &Arrangement) -> Vec<u16> {
    let inside = Inside::new(drawing, 1.0);
    let mut region = vec![None; cdt.num_all_faces()];
    for seed in cdt.inner_faces() {
        if region[seed.fix().index()].is_some() {
            continue;
        }
        let mut component = vec![seed.fix()];
        let (mut largest, mut at) = (0.0, [0.0; 2]);
        let mut next = 0;
        region[seed.fix().index()] = Some(OUTSIDE);
        while next < component.len() {
            let face = cdt.face(component[next]);
            next += 1;
            if face.area() > largest {
                largest = face.area();
                let c = face.center();
                at = [c.x, c.y];
            }
            for edge in face.adjacent_edges() {
                if edge.as_undirected().data().is_constraint_edge() {
                    continue;
                }
                if let Some(other) = edge.rev().face().as_inner()
                    && region[other.fix().index()].is_none()
                {
                    region[other.fix().index()] = Some(OUTSIDE);
                    component.push(other.fix());
                }
            }
        }
        let label = inside.region(at).unwrap_or(OUTSIDE);
        component.iter().for_each(|f| region[f.index()] = Some(label));
    }
    region.into_iter().map(|r| r.unwrap_or(OUTSIDE)).collect()
}

fn label_edges(
    cdt: &Cdt,
    drawing: &Arrangement,
    chords: &[Chord],
    number: &HashMap<FixedVertexHandle, u32>,
    mesh: &mut Mesh,
) -> Result<(), MeshError> {
    let index = ChordIndex::new(chords);
    for edge in cdt.undirected_edges().filter(|e| e.data().is_constraint_edge()) {
        let [a, b] = edge.positions().map(|p| [p.x, p.y]);
        let Some(piece) = index.find(chords, a, b).map(|i| &drawing.pieces[i]) else {
            continue;
        };
        let nodes = edge.vertices().map(|v| number.get(&v.fix()).copied());
        let has_triangle = edge.as_directed().face().as_inner().is_some() || edge.as_directed().rev().face().as_inner().is_some();
        let ([Some(i), Some(j)], true) = (nodes, has_triangle) else {
            if let Some(&tag) = piece.boundaries.first() {
                return Err(MeshError::BoundaryOnNothing {
                    boundary: drawing.boundaries[tag as usize].clone(),
                    at: along(a, b, 0.5),
                });
            }
            continue;
        };
        mesh.boundary_edges.extend(piece.boundaries.iter().map(|&boundary| BoundaryEdge { nodes: [i, j], boundary }));
        if let Some((circle, _)) = piece.curve.arc {
            mesh.curved_edges.push(CurvedEdge { nodes: [i, j], circle });
            for k in [i, j] {
                mesh.points[k as usize] = circle.project(mesh.points[k as usize]);
            }
        }
    }
    drop_foreign_edges(mesh, drawing)
}

/// Removes curved edges that no triangle has; a boundary edge without a triangle is an error.
fn drop_foreign_edges(mesh: &mut Mesh, drawing: &Arrangement) -> Result<(), MeshError> {
    let topology = Topology::new(mesh);
    let known = |n: [u32; 2]| topology.edge(n[0], n[1]).is_some();
    if let Some(e) = mesh.boundary_edges.iter().find(|e| !known(e.nodes)) {
        let [a, b] = e.nodes.map(|i| mesh.points[i as usize]);
        return Err(MeshError::BoundaryOnNothing {
            boundary: drawing.boundaries[e.boundary as usize].clone(),
            at: along(a, b, 0.5),
        });
    }
    mesh.curved_edges.retain(|e| known(e.nodes));
    Ok(())
}

/// Finds the chord on which a sub-edge lies; chords are sorted by their lower end so that few are looked at.
struct ChordIndex {
    order: Vec<(f64, f64, usize)>,
    widest: f64,
}

impl ChordIndex {
    fn new(chords: &[Chord]) -> ChordIndex {
        let mut order: Vec<(f64, f64, usize)> =
            chords.iter().enumerate().map(|(i, c)| (c.ends[0][0].min(c.ends[1][0]), c.ends[0][0].max(c.ends[1][0]), i)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let widest = order.iter().map(|o| o.1 - o.0).fold(0.0, f64::max);
        ChordIndex { order, widest }
    }

    fn find(&self, chords: &[Chord], a: Point, b: Point) -> Option<usize> {
        let middle = along(a, b, 0.5);
        let slack = 1e-6 * distance(a, b);
        let first = self.order.partition_point(|o| o.0 < middle[0] - self.widest - slack);
        self.order[first..]
            .iter()
            .take_while(|o| o.0 <= middle[0] + slack)
            .filter(|o| o.1 >= middle[0] - slack)
            .map(|o| &chords[o.2])
            .find(|c| off_segment(c.ends, middle) <= slack)
            .map(|c| c.piece)
    }
}

fn off_segment([a, b]: [Point; 2], p: Point) -> f64 {
    let d = minus(b, a);
    let t = (dot(minus(p, a), d) / dot(d, d)).clamp(0.0, 1.0);
    distance(along(a, b, t), p)
}
