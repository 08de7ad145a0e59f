//! Bodies that several tests share.

use std::sync::Arc;
use truegap_fem::Symmetry;
use truegap_fem::elasticity::*;
use truegap_fem::mesh::*;

pub use Component::{First, Second};

pub fn steel() -> Material {
    Material { young: 200e9, poisson: 0.3, expansion: 1.2e-5, law: LawKind::Linear, formulation: Formulation::Displacement }
}

pub fn rubber(poisson: f64, formulation: Formulation) -> Material {
    Material { young: 1e6, poisson, expansion: 2e-4, law: LawKind::Linear, formulation }
}

pub fn options(size: SizeField) -> MeshOptions {
    MeshOptions { size, arc_step_degrees: 90.0, ..Default::default() }
}

/// The rectangle (r0, z0) - (r1, z1) with sides `inner`, `outer`, `bottom`, `top`.
pub fn rectangle(low: Point, high: Point, size: SizeField) -> Mesh {
    let drawing = Geometry::default()
        .region("body", Outline::rectangle(low, high))
        .boundary("bottom", &[low, [high[0], low[1]]])
        .boundary("outer", &[[high[0], low[1]], high])
        .boundary("top", &[high, [low[0], high[1]]])
        .boundary("inner", &[[low[0], high[1]], low])
        .boundary_of("rim", "body");
    mesh_geometry(&drawing, &options(size)).unwrap()
}

/// Moves inner corners by a smooth bump that vanishes on the rectangle's sides.
pub fn distort(mesh: &mut Mesh, low: Point, high: Point) {
    for p in &mut mesh.points {
        let s = [0, 1].map(|k| (p[k] - low[k]) / (high[k] - low[k]));
        let bump = s[0] * (1.0 - s[0]) * s[1] * (1.0 - s[1]);
        *p = [p[0] + 0.9 * bump * (high[0] - low[0]), p[1] - 0.7 * bump * (high[1] - low[1])];
    }
    mesh.check().unwrap();
}

pub fn problem(mesh: Mesh, material: Material) -> Problem {
    Problem {
        mesh,
        symmetry: Symmetry::Axisymmetric,
        materials: vec![material],
        conditions: Vec::new(),
        temperature: Temperature::uniform(0.0),
        body_force: None,
        order: Order::Quadratic,
    }
}

/// Prescribes `field` at every node of the rim, one by one.
pub fn pin_rim(problem: &mut Problem, field: impl Fn(Point) -> [f64; 2]) {
    let topology = Topology::new(&problem.mesh);
    let rim = problem.mesh.boundary("rim").unwrap();
    let middles = topology.middles(&problem.mesh);
    let mut nodes = std::collections::BTreeMap::new();
    for e in problem.mesh.edges_of(rim) {
        for c in e {
            nodes.insert((0, c as usize), problem.mesh.points[c as usize]);
        }
        if problem.order == Order::Quadratic {
            let edge = topology.edge(e[0], e[1]).unwrap();
            nodes.insert((1, edge), middles[edge]);
        }
    }
    assert!(!nodes.is_empty());
    for (_, at) in nodes {
        for component in [First, Second] {
            problem.conditions.push(Condition::Displacement {
                place: Place::Point(at),
                component,
                value: field(at)[component.index()],
            });
        }
    }
}

/// Thick cylinder 1 < r < 2 of unit length in plane strain, or a quarter of a thick sphere.
pub fn thick_sphere(edge: f64) -> Mesh {
    let s = std::f64::consts::FRAC_1_SQRT_2;
    let outline = Outline {
        start: [1.0, 0.0],
        steps: vec![
            Step::Line([2.0, 0.0]),
            Step::Arc { via: [2.0 * s, 2.0 * s], to: [0.0, 2.0] },
            Step::Line([0.0, 1.0]),
            Step::Arc { via: [s, s], to: [1.0, 0.0] },
        ],
    };
    let mut drawing = Geometry::default()
        .region("body", outline)
        .boundary("equator", &[[1.0, 0.0], [2.0, 0.0]])
        .boundary("cut", &[[0.0, 1.0], [0.0, 2.0]]);
    drawing.boundaries.push(Boundary {
        name: "inside".into(),
        path: BoundaryPath::Path(Outline { start: [0.0, 1.0], steps: vec![Step::Arc { via: [s, s], to: [1.0, 0.0] }] }),
    });
    mesh_geometry(&drawing, &MeshOptions { size: SizeField::uniform(edge), arc_step_degrees: 6.0, ..Default::default() }).unwrap()
}

pub fn field<T>(f: impl Fn(Point) -> T + Send + Sync + 'static) -> Field<T> {
    Arc::new(f)
}

/// Rubber disc of diameter 583 um and height 198 um, graded into both rims.
pub fn rubber_disc(max_edge: f64, rim: f64) -> Mesh {
    let (a, h) = (291.5e-6, 198e-6);
    let sources = [[a, 0.0], [a, h]].map(|at| SizeSource { at, size: rim });
    rectangle([0.0, 0.0], [a, h], SizeField { max_edge, growth: 0.25, sources: sources.to_vec() })
}

/// Apparent over true modulus of the rubber disc with its lower face bonded and its upper one pressed, bonded or not.
pub fn apparent_modulus(mesh: Mesh, material: Material, order: Order, bonded_top: bool) -> f64 {
    let mut p = problem(mesh, material);
    p.order = order;
    let (a, h) = (291.5e-6, 198e-6);
    let press = -1e-3 * h;
    p.conditions =
        vec![Condition::fix("bottom", First), Condition::fix("bottom", Second), Condition::displace("top", Second, press)];
    if bonded_top {
        p.conditions.push(Condition::fix("top", First));
    }
    let force = Solver::new(p).unwrap().solve().unwrap().reaction("top", Second).unwrap();
    let stress = force / (std::f64::consts::PI * a * a);
    stress / (press / h) / material.young
}

/// Free disc of 17 um copper under 5 um tin, radius 7.5 mm, at 1 K: load factors are kelvins.
pub fn bimetal(law: LawKind) -> Problem {
    let (radius, step) = (7.5e-3, 150e-6);
    // Columns halve towards the rim, where an edge layer as wide as the disc is thick ends the bending.
    let mut columns: Vec<f64> = (0..=48).map(|i| step * f64::from(i)).collect();
    let mut gap = radius - columns[48];
    while gap > 3e-6 {
        gap *= 0.6;
        columns.push(radius - gap);
    }
    columns.push(radius);
    let layer = |name: &str, thickness, rows| Layer { name: name.into(), thickness, rows };
    let mesh = layered_grid(&columns, 0.0, &[layer("copper", 17e-6, 3), layer("tin", 5e-6, 1)]).unwrap();
    let metal = |young, poisson, expansion| Material { young, poisson, expansion, law, formulation: Formulation::Displacement };
    let mut p = problem(mesh, metal(117e9, 0.34, 16.7e-6));
    p.materials.push(metal(41.6e9, 0.36, 22.4e-6));
    p.temperature = Temperature::uniform(1.0);
    p.conditions = vec![Condition::pin([0.0, 0.0], Second)];
    p
}

/// Height of the rim's mid-plane above the centre's, magnitude (um).
pub fn rim_um(s: &Solution) -> f64 {
    let at = |r: f64| s.displacement_at([r, 11e-6]).unwrap()[1];
    1e6 * (at(7.5e-3) - at(0.0)).abs()
}

/// A unit square of triangles that are out of shape.
pub fn patch(edge: f64) -> Mesh {
    let (low, high) = ([0.0, 0.0], [1.0, 1.0]);
    let mut mesh = rectangle(low, high, SizeField::uniform(edge));
    distort(&mut mesh, low, high);
    mesh
}
