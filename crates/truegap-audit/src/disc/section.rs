//! The section of the disc as a grid of columns and rows: insulator on the shield, gap, electrode.
//!
//! Limits: flat layers; beads are rings, each in the middle of its zone and covering the same share of it.

use super::columns::columns;
use super::rings::{Gap, Ring, rings};
use super::{fineness::Fineness, laminate::Laminate};
use crate::error::AuditError;
use truegap_fem::mesh::{BoundaryEdge, Layer, Mesh, Point, layered_grid};

/// A meshed section.
#[derive(Clone, Debug)]
pub struct Section {
    /// regions `facing`, `bead layer` or `ring 1` ... and `air`, then the sheets of the plate; boundaries `bottom`, `top`, `right`, `face` (the
    /// electrode at the gap) and `foot 1` ... under the rings
    pub mesh: Mesh,
    /// the rings
    pub rings: Vec<Ring>,
    /// height of the electrode's face above the bottom, m
    pub face: f64,
    /// height of the top, m
    pub top: f64,
}

/// Rows across the layers, for fineness 1.
const ROWS: usize = 2;

impl Section {
    /// Meshes a section; `facing` is the thickness (m) of an insulator below the gap.
    ///
    /// # Errors
    /// A layer without thickness.
    pub fn new(plate: &Laminate, gap: &Gap, facing: Option<f64>, fineness: Fineness) -> Result<Self, AuditError> {
        let rings = rings(gap, plate.radius);
        let stops = stops(&rings, gap, plate.radius, fineness);
        let rows = ROWS * fineness.rows;
        let mut layers = Vec::new();
        layers.extend(facing.map(|thickness| Layer { name: "facing".into(), thickness, rows: fineness.rows }));
        let height = match gap {
            Gap::None => None,
            Gap::Layer(h) => Some((*h, rows)),
            Gap::Rings { height, .. } => Some((*height, 2 * rows)),
        };
        layers.extend(height.map(|(thickness, rows)| Layer { name: "gap".into(), thickness, rows }));
        let face = layers.iter().map(|l| l.thickness).sum();
        layers.extend(plate.sheets.iter().map(|s| Layer {
            name: s.name.clone(),
            thickness: s.thickness,
            rows: if s.thickness > 0.3 * plate.thickness() { rows } else { fineness.rows },
        }));
        let step = plate.radius / fineness.columns as f64;
        let grid = columns(&stops, step, plate.thickness() / (6.0 * fineness.rows as f64));
        let mut mesh = layered_grid(&grid, 0.0, &layers).map_err(AuditError::fem("section of the disc"))?;
        let top = layers.iter().map(|l| l.thickness).sum();
        name_face(&mut mesh, if layers.len() > plate.sheets.len() { face } else { 0.0 });
        match gap {
            Gap::None => {}
            Gap::Layer(_) => rename(&mut mesh, "gap", "bead layer"),
            Gap::Rings { .. } => label_rings(&mut mesh, &rings),
        }
        Ok(Self { mesh, rings, face, top })
    }

    /// Quadratic nodes at a height (m) of the undeformed section, from the axis outwards (m).
    pub fn level(&self, height: f64) -> Vec<Point> {
        let there = |p: &&Point| (p[1] - height).abs() < 1e-12;
        let mut corners: Vec<Point> = self.mesh.points.iter().filter(there).copied().collect();
        corners.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let middle = |p: &[Point]| [0.5 * (p[0][0] + p[1][0]), 0.5 * (p[0][1] + p[1][1])];
        let mut nodes: Vec<Point> = corners.iter().copied().chain(corners.windows(2).map(middle)).collect();
        nodes.sort_by(|a, b| a[0].total_cmp(&b[0]));
        nodes
    }
}

/// Columns that must be there: edges of the rings, a few within them, and beside them where they bulge.
fn stops(rings: &[Ring], gap: &Gap, radius: f64, fineness: Fineness) -> Vec<f64> {
    let height = if let Gap::Rings { height, .. } = gap { *height } else { 0.0 };
    let within = 2 * fineness.rows;
    let mut stops = Vec::new();
    for (j, ring) in rings.iter().enumerate() {
        let before = if j == 0 { 0.0 } else { rings[j - 1].outer };
        let after = rings.get(j + 1).map_or(radius, |next| next.inner);
        let beside = |room: f64, part: f64| part * (0.45 * room).min(height);
        stops.extend([1.0, 0.4].map(|part| ring.inner - beside(ring.inner - before, part)));
        stops.extend((0..=within).map(|i| ring.inner + (ring.outer - ring.inner) * i as f64 / within as f64));
        stops.extend([0.4, 1.0].map(|part| ring.outer + beside(after - ring.outer, part)));
    }
    stops.push(radius);
    stops
}

fn rename(mesh: &mut Mesh, from: &str, to: &str) {
    mesh.region_names.iter_mut().filter(|n| *n == from).for_each(|n| *n = to.into());
}

/// Splits the region `gap` into rings and air, and names the feet of the rings on the row below.
fn label_rings(mesh: &mut Mesh, rings: &[Ring]) {
    let Some(gap) = mesh.region_names.iter().position(|n| n == "gap") else { return };
    mesh.region_names[gap] = "air".into();
    let first = mesh.region_names.len();
    mesh.region_names.extend((1..=rings.len()).map(|j| format!("ring {j}")));
    let mut low = f64::INFINITY;
    for t in (0..mesh.triangles.len()).filter(|&t| mesh.triangle_regions[t] as usize == gap).collect::<Vec<_>>() {
        let corners = mesh.corners(t);
        let r = corners.iter().map(|p| p[0]).sum::<f64>() / 3.0;
        low = corners.iter().map(|p| p[1]).fold(low, f64::min);
        if let Some(j) = rings.iter().position(|ring| ring.inner < r && r < ring.outer) {
            mesh.triangle_regions[t] = (first + j) as u16;
        }
    }
    for (j, ring) in rings.iter().enumerate() {
        let under = |p: u32| {
            let [r, z] = mesh.points[p as usize];
            (z - low).abs() < 1e-12 && r > ring.inner - 1e-12 && r < ring.outer + 1e-12
        };
        let feet = edges(mesh).into_iter().filter(|e| e.iter().all(|&p| under(p))).collect();
        add_boundary(mesh, &format!("foot {}", j + 1), feet);
    }
}

/// Names the edges at the height of the electrode's face.
fn name_face(mesh: &mut Mesh, height: f64) {
    let level = |p: u32| (mesh.points[p as usize][1] - height).abs() < 1e-12;
    let found = edges(mesh).into_iter().filter(|e| e.iter().all(|&p| level(p))).collect();
    add_boundary(mesh, "face", found);
}

/// Horizontal edges, each once.
fn edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let level = |a: u32, b: u32| mesh.points[a as usize][1] == mesh.points[b as usize][1];
    let sides = |t: &[u32; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let mut found: Vec<[u32; 2]> =
        mesh.triangles.iter().flat_map(sides).filter(|e| level(e[0], e[1])).map(|[a, b]| [a.min(b), a.max(b)]).collect();
    found.sort_unstable();
    found.dedup();
    found
}

fn add_boundary(mesh: &mut Mesh, name: &str, found: Vec<[u32; 2]>) {
    let boundary = mesh.boundary_names.len() as u16;
    mesh.boundary_names.push(name.into());
    mesh.boundary_edges.extend(found.into_iter().map(|nodes| BoundaryEdge { nodes, boundary }));
}
