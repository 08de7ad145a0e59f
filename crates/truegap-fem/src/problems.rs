//! Deterministic problems of any size, shared by benches, examples and tests.
//!
//! Meshes are graded by the same rule at every size, so that times and errors of different sizes form one curve.

use crate::elasticity::{self, Component, Condition, Formulation, LawKind, Material, Temperature};
use crate::electrostatics::{Conductor, Goal, Problem, Quantity, VACUUM_PERMITTIVITY, dielectric};
use crate::error::FemError;
use crate::mesh::{Geometry, Mesh, MeshOptions, Outline, Point, Topology, mesh_geometry, plane};
use crate::mesh::{bisect, longest_edge_first};
use crate::space::{ElementDofs, Nodes, Numbering, P2, ShapeTable, triangle_rule};
use crate::symmetry::Symmetry;

/// `C / (eps0 a)` of the disc capacitor, distance / radius = 0.1, by Love's equation.
pub const DISC_CAPACITOR: f64 = 36.932_321_942_12;

const HALF_GAP: f64 = 0.05;

/// `E_a / E` of the rubber disc of [`rubber_disc_problem`], both faces bonded, by hp finite elements of another program.
pub const RUBBER_DISC: f64 = 1.966_213_370_23;

/// Radius and height of the rubber disc (m).
pub const RUBBER_SIZE: [f64; 2] = [291.5e-6, 198e-6];

/// The drawing of two coaxial discs of radius 1 m, 0.1 m apart, in an open box of 5 m.
pub fn disc_capacitor_geometry() -> Geometry {
    let far = [[0.0, -5.0], [5.0, -5.0], [5.0, 5.0], [0.0, 5.0]];
    Geometry::default()
        .region("space", Outline::rectangle([0.0, -5.0], [5.0, 5.0]))
        .boundary("upper", &[[0.0, HALF_GAP], [1.0, HALF_GAP]])
        .boundary("lower", &[[0.0, -HALF_GAP], [1.0, -HALF_GAP]])
        .boundary("far", &far)
}

/// The discs at plus and minus half a volt, and their capacitance as the goal.
pub fn disc_capacitor_problem() -> (Problem, Vec<Quantity>) {
    let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    let problem = Problem {
        symmetry: Symmetry::Axisymmetric,
        permittivity: vec![("space".into(), VACUUM_PERMITTIVITY)],
        conductors: vec![conductor("upper", 0.5), conductor("lower", -0.5)],
        open: vec!["far".into()],
    };
    let goal = Goal::Capacitance { boundary: "upper".into() };
    (problem, vec![Quantity { name: "C".into(), goal }])
}

/// A mesh of the disc capacitor with about `unknowns` quadratic nodes, graded into the rims.
pub fn disc_capacitor_mesh(unknowns: usize) -> Result<Mesh, FemError> {
    // h = edge * d^(5/6) for a distance d to a rim spreads the error of a field that grows as 1 / sqrt d evenly over quadratic
    // elements; more beyond the gap, where it fades. The rim itself stops at a size whose share of the error is a few 1e-8, and
    // which programs that keep corners on a grid of integers still resolve.
    let size = |d: f64| (d.powf(5.0 / 6.0) * (d / (2.0 * HALF_GAP)).max(1.0).sqrt(), 3e-7);
    let rims = [[1.0, HALF_GAP], [1.0, -HALF_GAP]];
    graded_mesh(&disc_capacitor_geometry(), &rims, size, unknowns / 2)
}

/// The drawing of a rubber disc, diameter 583 um and height 198 um, between two plates.
pub fn rubber_disc_geometry() -> Geometry {
    let [radius, height] = RUBBER_SIZE;
    Geometry::default()
        .region("disc", Outline::rectangle([0.0, 0.0], RUBBER_SIZE))
        .boundary("bottom", &[[0.0, 0.0], [radius, 0.0]])
        .boundary("top", &[[0.0, height], [radius, height]])
}

/// The rubber disc (E = 1 MPa, Poisson's ratio 0.49), both faces bonded, pressed by 0.1 % of its height; the force on the plate.
pub fn rubber_disc_problem(mesh: Mesh, formulation: Formulation) -> (elasticity::Problem, Vec<elasticity::Quantity>) {
    let both = [Component::First, Component::Second];
    let mut conditions: Vec<Condition> = both.iter().map(|c| Condition::fix("bottom", *c)).collect();
    conditions.push(Condition::fix("top", Component::First));
    conditions.push(Condition::displace("top", Component::Second, -1e-3 * RUBBER_SIZE[1]));
    let rubber = Material { young: 1e6, poisson: 0.49, expansion: 0.0, law: LawKind::Linear, formulation };
    let problem = elasticity::Problem {
        mesh,
        symmetry: Symmetry::Axisymmetric,
        materials: vec![rubber],
        conditions,
        temperature: Temperature::uniform(0.0),
        body_force: None,
        order: elasticity::Order::Quadratic,
    };
    let goal = elasticity::Goal::Reaction { boundary: "top".into(), component: Component::Second };
    (problem, vec![elasticity::Quantity { name: "F".into(), goal }])
}

/// A mesh of the rubber disc with about `unknowns` displacements (two a quadratic node), graded into the bonded rims.
pub fn rubber_disc_mesh(unknowns: usize) -> Result<Mesh, FemError> {
    let [radius, height] = RUBBER_SIZE;
    // Stresses grow as d^-0.4 at the rim of nearly incompressible rubber: h = edge * d^(1 - 0.6 / 3).
    let size = |d: f64| (1e-3 * (d / height).powf(0.8), 1e-6 * height);
    graded_mesh(&rubber_disc_geometry(), &[[radius, 0.0], [radius, height]], size, unknowns / 4)
}

/// Laplace's equation on a mesh of the disc capacitor, all its boundaries fixed: the pieces that benches time.
pub struct DiscSystem {
    nodes: Nodes,
    table: Vec<ShapeTable<6>>,
    /// Unknowns of the elements.
    pub dofs: ElementDofs,
    /// Free and fixed unknowns.
    pub numbering: Numbering,
}

impl DiscSystem {
    /// Numbers the unknowns on a mesh.
    pub fn new(mesh: &Mesh) -> DiscSystem {
        let topology = Topology::new(mesh);
        let nodes = Nodes::new(mesh, &topology);
        let dofs = ElementDofs::quadratic(&nodes);
        let mut fixed = vec![false; dofs.count];
        for e in &mesh.boundary_edges {
            nodes.edge(&topology, e.nodes).into_iter().flatten().for_each(|i| fixed[i as usize] = true);
        }
        DiscSystem { nodes, table: P2::table(&triangle_rule(4)), dofs, numbering: Numbering::new(&fixed) }
    }

    /// Adds the matrix of an element (full, column by column).
    pub fn element(&self, e: usize, out: &mut [f64]) {
        for q in &self.table {
            let map = self.nodes.element(e).map(q);
            let weight = q.weight * map.jacobian * Symmetry::Axisymmetric.weight(map.at[0]);
            let shapes = map.shapes(q);
            for j in 0..6 {
                for i in j..6 {
                    out[6 * j + i] += weight * dielectric(1.0, shapes[i], shapes[j]);
                }
            }
        }
    }
}

/// A mesh of about `triangles`, each at most `edge` times the size that `size` gives for its distance to the nearest of `points`;
/// the second number of `size` is the least size of all.
fn graded_mesh(
    geometry: &Geometry,
    points: &[Point],
    size: impl Fn(f64) -> (f64, f64),
    triangles: usize,
) -> Result<Mesh, FemError> {
    let mut first = mesh_geometry(geometry, &MeshOptions::default())?;
    longest_edge_first(&mut first);
    // The number of triangles grows with the inverse square of the edge. The rule is calibrated on a coarse mesh, then once at a
    // tenth of the size.
    let wanted = triangles as f64;
    let mut edge = 0.2;
    for share in [0.1, 1.0] {
        let mesh = graded(&first, points, &size, edge);
        edge *= (mesh.triangles.len() as f64 / (share * wanted)).sqrt();
    }
    Ok(graded(&first, points, &size, edge))
}

/// Bisects until every triangle is at most as large as the place allows.
fn graded(first: &Mesh, points: &[Point], size: &impl Fn(f64) -> (f64, f64), edge: f64) -> Mesh {
    let too_large = |corners: [Point; 3]| {
        let middle: Point = std::array::from_fn(|k| (corners[0][k] + corners[1][k] + corners[2][k]) / 3.0);
        let longest = (0..3).map(|k| plane::distance(corners[k], corners[(k + 1) % 3])).fold(0.0, f64::max);
        let (allowed, least) = size(points.iter().map(|&r| plane::distance(r, middle)).fold(f64::INFINITY, f64::min));
        longest > (edge * allowed).max(least)
    };
    let mut mesh = first.clone();
    for _ in 0..60 {
        let marked: Vec<bool> = (0..mesh.triangles.len()).map(|t| too_large(mesh.corners(t))).collect();
        if !marked.contains(&true) {
            break;
        }
        mesh = bisect(&mesh, &Topology::new(&mesh), &marked).0;
    }
    mesh
}
