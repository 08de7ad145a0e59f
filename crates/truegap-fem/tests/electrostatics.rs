//! Electrostatics by routes that share no code with it: manufactured fields, Love's integral equation, closed forms,
//! reciprocity and energy; and planted errors that these checks must notice.

#![allow(clippy::unwrap_used)]

use truegap_fem::algebra::{Direct, Kind};
use truegap_fem::algebra::{Pattern, assemble_vector, element_residual};
use truegap_fem::electrostatics::*;
use truegap_fem::mesh::*;
use truegap_fem::space::*;
use truegap_fem::{FemError, Symmetry};

type Form = fn(f64, Shape, Shape) -> f64;
/// Name, form, weight.
type Mutant<'a> = (&'a str, Form, fn(f64) -> f64);

/// u = sin(2 z) (1 + r^2 cos r): no polynomial, even in r as fields of bodies with an axis are.
fn exact([r, z]: Point) -> f64 {
    (2.0 * z).sin() * (1.0 + r * r * r.cos())
}

fn exact_gradient([r, z]: Point) -> [f64; 2] {
    [(2.0 * z).sin() * (2.0 * r * r.cos() - r * r * r.sin()), 2.0 * (2.0 * z).cos() * (1.0 + r * r * r.cos())]
}

/// -div(3 grad u) = -3 (u_rr + u_r / r + u_zz).
fn source([r, z]: Point) -> f64 {
    let (s, c) = r.sin_cos();
    let radial = (2.0 * c - 4.0 * r * s - r * r * c) + (2.0 * c - r * s);
    -3.0 * ((2.0 * z).sin() * radial - 4.0 * exact([r, z]))
}

/// H1-seminorm errors (weighted with 2 pi r) of the solution and of the nodal interpolant on meshes of falling size.
fn manufactured(form: Form, weight: fn(f64) -> f64) -> Vec<[f64; 2]> {
    [0.4, 0.2, 0.1, 0.05].iter().map(|&edge| on_mesh(form, weight, edge)).collect()
}

fn on_mesh(form: Form, weight: fn(f64) -> f64, edge: f64) -> [f64; 2] {
    let g = Geometry::default()
        .region("body", Outline::rectangle([0.0, 0.0], [1.0, 1.3]))
        .boundary("walls", &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.3], [0.0, 1.3]]);
    let mesh = mesh_geometry(&g, &MeshOptions { size: SizeField::uniform(edge), ..Default::default() }).unwrap();
    let topology = Topology::new(&mesh);
    let nodes = Nodes::new(&mesh, &topology);
    let dofs = ElementDofs::quadratic(&nodes);
    let mut fixed = vec![false; dofs.count];
    mesh.edges_of(0).for_each(|e| nodes.edge(&topology, e).unwrap().iter().for_each(|&i| fixed[i as usize] = true));
    let table = P2::table(&triangle_rule(6));
    let matrix = |e: usize, out: &mut [f64]| {
        for q in &table {
            let map = nodes.element(e).map(q);
            let shapes = map.shapes(q);
            for j in 0..6 {
                for i in 0..6 {
                    out[6 * j + i] += q.weight * map.jacobian * weight(map.at[0]) * form(3.0, shapes[i], shapes[j]);
                }
            }
        }
    };
    let load = assemble_vector(&dofs, |e, out| {
        for q in &table {
            let map = nodes.element(e).map(q);
            (0..6).for_each(|i| {
                out[i] += q.weight * map.jacobian * std::f64::consts::TAU * map.at[0] * source(map.at) * q.value[i]
            });
        }
    });
    let interpolant: Vec<f64> = nodes.points.iter().map(|&p| exact(p)).collect();
    let mut u: Vec<f64> = (0..dofs.count).map(|i| if fixed[i] { interpolant[i] } else { 0.0 }).collect();
    let lift = element_residual(&dofs, &u, matrix);
    let numbering = Numbering::new(&fixed);
    let pattern = Pattern::new(&dofs, &numbering).unwrap();
    let mut system = pattern.matrix();
    pattern.assemble(&mut system, matrix);
    let rhs: Vec<f64> = load.iter().zip(&lift).map(|(f, l)| f - l).collect();
    // A planted error may make the system unsolvable; that counts as noticed.
    let Ok(solution) = Direct::new(&system, Kind::Llt).and_then(|mut d| d.solve(&system, &numbering.restrict(&rhs))) else {
        return [f64::INFINITY; 2];
    };
    numbering.scatter(&solution.x, &mut u);
    [&u, &interpolant].map(|u| h1_error(&nodes, u))
}

fn h1_error(nodes: &Nodes, u: &[f64]) -> f64 {
    let table = P2::table(&triangle_rule(8));
    let mut sum = 0.0;
    for (e, t) in nodes.triangles.iter().enumerate() {
        for q in &table {
            let map = nodes.element(e).map(q);
            let g = (0..6).fold([0.0; 2], |s, k| {
                let g = map.gradient(q.slope[k]);
                [s[0] + u[t[k] as usize] * g[0], s[1] + u[t[k] as usize] * g[1]]
            });
            let d = plane::minus(g, exact_gradient(map.at));
            sum += q.weight * map.jacobian * std::f64::consts::TAU * map.at[0] * plane::dot(d, d);
        }
    }
    sum.sqrt()
}

/// Second order, and the curve of the interpolant: Galerkin solutions are at least as good, and of the same order.
fn converges(curve: &[[f64; 2]]) -> bool {
    let on_curve = curve.iter().all(|[e, i]| *e < 1.02 * i && *e > 0.5 * i);
    let order = (curve[0][0] / curve[curve.len() - 1][0]).log2() / (curve.len() - 1) as f64;
    on_curve && (1.8..2.3).contains(&order)
}

fn around_the_axis(r: f64) -> f64 {
    std::f64::consts::TAU * r
}

#[test]
fn smooth_fields_converge_with_order_and_curve() {
    let curve = manufactured(dielectric, around_the_axis);
    println!("{curve:?}");
    assert!(converges(&curve), "{curve:?}");
}

#[test]
fn planted_errors_in_the_form_are_noticed() {
    let no_axis: fn(f64) -> f64 = |_| 1.0;
    let half_turn: fn(f64) -> f64 = |r| std::f64::consts::PI * r;
    let squared: fn(f64) -> f64 = |r| std::f64::consts::TAU * r * r;
    let mutants: [Mutant; 8] = [
        ("no 2 pi r", dielectric, no_axis),
        ("pi r", dielectric, half_turn),
        ("2 pi r^2", dielectric, squared),
        ("no permittivity", |_, v, u| dielectric(1.0, v, u), around_the_axis),
        ("permittivity squared", |e, v, u| dielectric(e * e, v, u), around_the_axis),
        (
            "radial part only",
            |e, v, u| e * v.gradient[0] * u.gradient[0] + 1e-3 * e * v.gradient[1] * u.gradient[1],
            around_the_axis,
        ),
        ("minus sign", |e, v, u| e * (v.gradient[0] * u.gradient[0] - v.gradient[1] * u.gradient[1]), around_the_axis),
        ("mass added", |e, v, u| dielectric(e, v, u) + e * v.value * u.value, around_the_axis),
    ];
    for (name, form, weight) in mutants {
        let curve: Vec<_> = [0.2, 0.1].iter().map(|&h| on_mesh(form, weight, h)).collect();
        assert!(!converges(&curve), "{name} passes: {curve:?}");
    }
}

fn discs(distance: f64, size: f64, open: bool) -> (Mesh, Problem) {
    let (h, w) = (0.5 * distance, size);
    let rim = [[0.0, -w], [w, -w], [w, w], [0.0, w]];
    let g = Geometry::default()
        .region("air", Outline::rectangle([0.0, -w], [w, w]))
        .boundary("upper", &[[0.0, h], [1.0, h]])
        .boundary("lower", &[[0.0, -h], [1.0, -h]])
        .boundary("far", &rim);
    let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    let problem = Problem {
        symmetry: Symmetry::Axisymmetric,
        permittivity: vec![("air".into(), 1.0)],
        conductors: vec![conductor("upper", 0.5), conductor("lower", -0.5)],
        open: if open { vec!["far".into()] } else { vec![] },
    };
    (mesh_geometry(&g, &MeshOptions::default()).unwrap(), problem)
}

fn capacitance(name: &str) -> Vec<Quantity> {
    vec![Quantity { name: "C".into(), goal: Goal::Capacitance { boundary: name.into() } }]
}

/// Love's integral equation by Simpson's rule.
fn love(k: f64) -> f64 {
    let n = 600;
    let h = 2.0 / n as f64;
    let weight = |j: usize| {
        h / 3.0
            * if j == 0 || j == n {
                1.0
            } else if j % 2 == 1 {
                4.0
            } else {
                2.0
            }
    };
    let x = |i: usize| -1.0 + h * i as f64;
    let matrix = nalgebra::DMatrix::from_fn(n + 1, n + 1, |i, j| {
        let kernel = k / (k * k + (x(i) - x(j)).powi(2)) / std::f64::consts::PI;
        f64::from(u8::from(i == j)) - weight(j) * kernel
    });
    let f = matrix.lu().solve(&nalgebra::DVector::from_element(n + 1, 1.0)).unwrap();
    2.0 * (0..=n).map(|j| weight(j) * f[j]).sum::<f64>()
}

#[test]
fn loves_equation_agrees_at_a_ratio_that_no_table_has() {
    assert!((love(1.0) - 7.28313993133).abs() < 1e-8);
    let (mut mesh, problem) = discs(0.37, 4.0, true);
    let accuracy = Accuracy { target: 2e-5, ..Accuracy::default() };
    let c = solve_adaptive(&problem, &capacitance("upper"), &mut mesh, &accuracy).unwrap().answers[0].value;
    // Tolerance: the accuracy asked for; Simpson's rule with h/k = 0.01 is good to 1e-8.
    assert!((c / love(0.37) - 1.0).abs() < 2e-5, "{c} against {}", love(0.37));
}

#[test]
fn the_size_of_the_open_box_does_not_matter_and_that_of_a_closed_one_does() {
    let solve = |size: f64, open: bool| {
        let (mut mesh, problem) = discs(1.0, size, open);
        solve_adaptive(&problem, &capacitance("upper"), &mut mesh, &Accuracy { target: 1e-5, ..Accuracy::default() })
            .unwrap()
            .answers[0]
            .value
    };
    let (small, large) = (solve(1.5, true), solve(5.0, true));
    assert!((small / large - 1.0).abs() < 1e-5, "{small} {large}");
    // A closed box of 5 radii without normal field costs a quarter per cent or more.
    assert!((solve(5.0, false) / large - 1.0).abs() > 1e-3);
}

/// Three conductors in a grounded box with two dielectrics: 2 x 1 m, planar.
fn three_conductors() -> (Mesh, Problem) {
    let g = Geometry::default()
        .region("air", Outline::rectangle([0.0, 0.0], [2.0, 1.0]))
        .region("oil", Outline::rectangle([0.0, 0.0], [2.0, 0.45]))
        .region("bar", Outline::rectangle([1.4, 0.6], [1.7, 0.8]))
        .boundary("strip", &[[0.3, 0.5], [0.9, 0.6]])
        .boundary("wire", &[[0.5, 0.25], [1.1, 0.25]])
        .boundary_of("bar", "bar")
        .boundary_of("box", "air");
    let potentials = [("strip", 1.0), ("wire", -2.0), ("bar", 0.7), ("box", 0.0)];
    let problem = Problem {
        symmetry: Symmetry::Planar,
        permittivity: vec![("air".into(), 1.0), ("oil".into(), 2.2), ("bar".into(), 1.0)],
        conductors: potentials.iter().map(|&(b, potential)| Conductor { boundary: b.into(), potential }).collect(),
        open: vec![],
    };
    (mesh_geometry(&g, &MeshOptions { size: SizeField::uniform(0.05), ..Default::default() }).unwrap(), problem)
}

#[test]
fn capacitances_are_reciprocal_shielded_and_carry_the_energy() {
    let (mesh, problem) = three_conductors();
    let solved = Solved::new(&problem, &mesh).unwrap();
    let c = solved.capacitance_matrix();
    let v: Vec<f64> = problem.conductors.iter().map(|c| c.potential).collect();
    let n = v.len();
    for i in 0..n {
        assert!(c[i][i] > 0.5);
        // A closed box: what leaves one conductor arrives at the others. Rounding of sums of 1e4 terms.
        assert!(c[i].iter().sum::<f64>().abs() < 1e-10 * c[i][i]);
        for j in 0..n {
            // Charge on i by the consistent residual of a run of its own in which only j is at 1 V.
            let mut single = problem.clone();
            single.conductors.iter_mut().enumerate().for_each(|(k, c)| c.potential = f64::from(u8::from(k == j)));
            let charge = Solved::new(&single, &mesh).unwrap().charges()[i];
            assert!((charge - c[i][j]).abs() < 1e-10 * c[i][i], "{i} {j}: {charge} {}", c[i][j]);
            assert!(i == j || c[i][j] < 0.0);
        }
    }
    let sum: f64 = (0..n).map(|i| (0..n).map(|j| 0.5 * v[i] * c[i][j] * v[j]).sum::<f64>()).sum();
    assert!((solved.energy() / sum - 1.0).abs() < 1e-11);
    // Energy by integrating the density of the differentiated field: another route to the same number.
    let rule = triangle_rule(4);
    let density = |t: usize| {
        rule.iter()
            .map(|q| q.weight * solved.nodes.element(t).map_at(q.at).jacobian * solved.sample_in(t, q.at).energy_density)
            .sum::<f64>()
    };
    let integral: f64 = (0..mesh.triangles.len()).map(density).sum();
    assert!((integral / sum - 1.0).abs() < 1e-11, "{integral} {sum}");
}

#[test]
fn a_uniform_field_passes_the_patch_test_on_a_distorted_mesh() {
    let g = Geometry::default()
        .region("gap", Outline::rectangle([0.0, 0.0], [3.0, 0.5]))
        .boundary("top", &[[0.0, 0.5], [3.0, 0.5]])
        .boundary("bottom", &[[0.0, 0.0], [3.0, 0.0]]);
    let mut mesh = mesh_geometry(&g, &MeshOptions { size: SizeField::uniform(0.25), ..Default::default() }).unwrap();
    for p in &mut mesh.points {
        let bump = p[0] * (3.0 - p[0]) * p[1] * (0.5 - p[1]);
        *p = [p[0] + 0.3 * bump, p[1] - 0.2 * bump];
    }
    mesh.check().unwrap();
    let problem = Problem {
        symmetry: Symmetry::Axisymmetric,
        permittivity: vec![("gap".into(), 2.0)],
        conductors: vec![
            Conductor { boundary: "top".into(), potential: 3.0 },
            Conductor { boundary: "bottom".into(), potential: 1.0 },
        ],
        open: vec![],
    };
    let outcome = solve_on(&problem, &capacitance("top"), &mesh).unwrap();
    let exact = 2.0 * std::f64::consts::PI * 9.0 / 0.5;
    assert!((outcome.answers[0].value / exact - 1.0).abs() < 1e-12);
    assert!(outcome.answers[0].relative_error_estimate() < 1e-12);
    let solved = Solved::new(&problem, &mesh).unwrap();
    let sample = solved.sample([1.3, 0.2]).unwrap();
    assert!((sample.potential - 1.8).abs() < 1e-12 && (sample.field[1] + 4.0).abs() < 1e-10 && sample.field[0].abs() < 1e-10);
    assert!(matches!(solved.sample([5.0, 0.2]), Err(ElectrostaticsError::PointOutside { .. })));
}

#[test]
fn problems_without_sense_are_refused() {
    let (mesh, good) = three_conductors();
    let refuse = |change: &dyn Fn(&mut Problem)| {
        let mut problem = good.clone();
        change(&mut problem);
        solve_on(&problem, &capacitance("strip"), &mesh).unwrap_err()
    };
    use ElectrostaticsError as E;
    assert!(matches!(refuse(&|p| p.conductors.clear()), FemError::Electrostatics(E::NoConductor)));
    assert!(matches!(
        refuse(&|p| p.conductors.iter_mut().for_each(|c| c.potential = 2.0)),
        FemError::Electrostatics(E::NoDifference { .. })
    ));
    assert!(matches!(refuse(&|p| p.permittivity[1].1 = -1.0), FemError::Electrostatics(E::BadPermittivity { .. })));
    assert!(matches!(refuse(&|p| p.permittivity.truncate(1)), FemError::Electrostatics(E::BadPermittivity { .. })));
    assert!(matches!(refuse(&|p| p.conductors[0].potential = f64::NAN), FemError::Electrostatics(E::BadPotential { .. })));
    assert!(matches!(
        refuse(&|p| p.conductors[0].boundary = "nowhere".into()),
        FemError::Mesh(MeshError::UnknownBoundary { .. })
    ));
    assert!(matches!(refuse(&|p| p.open.push("strip".into())), FemError::Electrostatics(E::OpenBoundary { .. })));
    assert!(matches!(refuse(&|p| drop(p.conductors.remove(0))), FemError::Electrostatics(E::NotAConductor { .. })));
    let g = Geometry::default()
        .region("air", Outline::rectangle([0.0, 0.0], [1.0, 1.0]))
        .boundary("a", &[[0.0, 0.0], [0.5, 0.0]])
        .boundary("b", &[[0.5, 0.0], [1.0, 0.0]]);
    let touching = mesh_geometry(&g, &MeshOptions::default()).unwrap();
    let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    let problem = Problem {
        symmetry: Symmetry::Planar,
        permittivity: vec![("air".into(), 1.0)],
        conductors: vec![conductor("a", 1.0), conductor("b", 0.0)],
        open: vec![],
    };
    let error = solve_on(&problem, &capacitance("a"), &touching).unwrap_err();
    assert!(matches!(error, FemError::Electrostatics(E::Touching { at: [0.5, 0.0], .. })), "{error}");
    let tight = Accuracy { target: 1e-9, max_unknowns: 5000, ..Accuracy::default() };
    let error = solve_adaptive(&good, &capacitance("strip"), &mut mesh.clone(), &tight).unwrap_err();
    assert!(matches!(error, FemError::Electrostatics(E::NotReached { .. })));
}
