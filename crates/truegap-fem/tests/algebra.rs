//! Assembly and solvers: a patch test, the same bits for any number of threads, and matrices that must be refused.

#![allow(clippy::unwrap_used)]

use truegap_fem::algebra::{Direct, Kind, SolveError};
use truegap_fem::algebra::{Pattern, element_residual};
use truegap_fem::mesh::*;
use truegap_fem::space::*;

struct Square {
    mesh: Mesh,
    nodes: Nodes,
    dofs: ElementDofs,
}

fn square(edge: f64) -> Square {
    let drawing = Geometry::default().region("square", Outline::rectangle([0.0, 0.0], [1.0, 1.0])).boundary_of("rim", "square");
    let mut mesh = mesh_geometry(&drawing, &MeshOptions { size: SizeField::uniform(edge), ..Default::default() }).unwrap();
    // Distort the inside: a patch test on a regular mesh would not see wrong Jacobians.
    for p in &mut mesh.points {
        let bump = p[0] * (1.0 - p[0]) * p[1] * (1.0 - p[1]);
        *p = [p[0] + 0.9 * bump, p[1] - 0.7 * bump];
    }
    mesh.check().unwrap();
    let nodes = Nodes::new(&mesh, &Topology::new(&mesh));
    let dofs = ElementDofs::quadratic(&nodes);
    Square { mesh, nodes, dofs }
}

fn laplace(nodes: &Nodes) -> impl Fn(usize, &mut [f64]) + Sync + '_ {
    let table = P2::table(&triangle_rule(4));
    move |e, out| {
        for q in &table {
            let map = nodes.element(e).map(q);
            let shapes = map.shapes(q);
            for j in 0..6 {
                for i in 0..6 {
                    out[6 * j + i] += q.weight * map.jacobian * plane::dot(shapes[i].gradient, shapes[j].gradient);
                }
            }
        }
    }
}

fn rim(s: &Square) -> Vec<bool> {
    let topology = Topology::new(&s.mesh);
    let mut fixed = vec![false; s.dofs.count];
    for edge in s.mesh.edges_of(0) {
        s.nodes.edge(&topology, edge).unwrap().iter().for_each(|&i| fixed[i as usize] = true);
    }
    fixed
}

#[test]
fn linear_fields_pass_the_patch_test_on_a_distorted_mesh() {
    let s = square(0.2);
    let field = |p: Point| 3.0 - 2.0 * p[0] + 5.0 * p[1];
    let fixed = rim(&s);
    let numbering = Numbering::new(&fixed);
    let mut u: Vec<f64> = (0..s.dofs.count).map(|i| if fixed[i] { field(s.nodes.points[i]) } else { 0.0 }).collect();
    let pattern = Pattern::new(&s.dofs, &numbering).unwrap();
    let mut matrix = pattern.matrix();
    pattern.assemble(&mut matrix, laplace(&s.nodes));
    let load: Vec<f64> = element_residual(&s.dofs, &u, laplace(&s.nodes)).iter().map(|x| -x).collect();
    let mut direct = Direct::new(&matrix, Kind::Llt).unwrap();
    let solution = direct.solve(&matrix, &numbering.restrict(&load)).unwrap();
    numbering.scatter(&solution.x, &mut u);
    assert!(numbering.free.len() > 50);
    for (i, &p) in s.nodes.points.iter().enumerate() {
        // Rounding of a system with a condition number of a few hundred.
        assert!((u[i] - field(p)).abs() < 1e-12, "node {i}: {} against {}", u[i], field(p));
    }
    // Reaction of the whole rim: a closed surface carries no net flux, but each quarter does.
    let reaction = element_residual(&s.dofs, &u, laplace(&s.nodes));
    assert!(reaction.iter().sum::<f64>().abs() < 1e-12);
    assert!(reaction.iter().map(|x| x.abs()).sum::<f64>() > 1.0);
}

#[test]
fn the_number_of_threads_does_not_change_a_bit() {
    let s = square(0.01);
    let numbering = Numbering::new(&rim(&s));
    let with = |threads: usize| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| {
            let pattern = Pattern::new(&s.dofs, &numbering).unwrap();
            let mut matrix = pattern.matrix();
            pattern.assemble(&mut matrix, laplace(&s.nodes));
            pattern.assemble(&mut matrix, laplace(&s.nodes));
            matrix
        })
    };
    let one = with(1);
    assert!(one.nnz() > 100_000);
    for threads in [2, 5] {
        let many = with(threads);
        assert_eq!(one.pattern(), many.pattern());
        assert!(one.values().iter().zip(many.values()).all(|(a, b)| a.to_bits() == b.to_bits()));
    }
}

#[test]
fn ldlt_solves_what_is_indefinite_and_llt_says_so() {
    let s = square(0.2);
    let numbering = Numbering::new(&rim(&s));
    let pattern = Pattern::new(&s.dofs, &numbering).unwrap();
    let mut matrix = pattern.matrix();
    // Laplace minus a large mass on the diagonal: some eigenvalues become negative.
    pattern.assemble(&mut matrix, laplace(&s.nodes));
    let offsets = matrix.col_offsets().to_vec();
    for &diagonal in &offsets[..numbering.free.len()] {
        matrix.values_mut()[diagonal] -= 1.5;
    }
    assert!(matches!(Direct::new(&matrix, Kind::Llt), Err(SolveError::NotPositiveDefinite { .. })));
    let mut direct = Direct::new(&matrix, Kind::Ldlt).unwrap();
    let b: Vec<f64> = (0..numbering.free.len()).map(|i| (i % 7) as f64 - 2.0).collect();
    let x = direct.solve(&matrix, &b).unwrap().x;
    let full = nalgebra_sparse::convert::serial::convert_csc_dense(&matrix);
    let x = nalgebra::DVector::from_vec(x);
    let product = &full * &x + full.transpose() * &x - nalgebra::DVector::from_fn(x.len(), |i, _| full[(i, i)] * x[i]);
    assert!((product - nalgebra::DVector::from_vec(b)).amax() < 1e-9);
}

#[test]
fn a_floating_body_is_reported_as_singular() {
    let s = square(0.2);
    let numbering = Numbering::new(&vec![false; s.dofs.count]);
    let pattern = Pattern::new(&s.dofs, &numbering).unwrap();
    let mut matrix = pattern.matrix();
    pattern.assemble(&mut matrix, laplace(&s.nodes));
    for kind in [Kind::Llt, Kind::Ldlt] {
        let refused = Direct::new(&matrix, kind).err();
        assert!(
            matches!(refused, Some(SolveError::Singular { .. } | SolveError::NotPositiveDefinite { .. })),
            "{kind:?}: {refused:?}"
        );
    }
    matrix.values_mut()[5] = f64::NAN;
    assert!(matches!(Direct::new(&matrix, Kind::Llt), Err(SolveError::NotFinite { .. })));
}

#[test]
fn a_solution_that_does_not_satisfy_its_equations_is_refused() {
    let s = square(0.2);
    let numbering = Numbering::new(&rim(&s));
    let pattern = Pattern::new(&s.dofs, &numbering).unwrap();
    let mut matrix = pattern.matrix();
    pattern.assemble(&mut matrix, laplace(&s.nodes));
    let mut direct = Direct::new(&matrix, Kind::Llt).unwrap();
    let mut b = vec![1.0; pattern.size()];
    assert!(direct.solve(&matrix, &b).unwrap().residual < 1e-14);
    for bad in [f64::NAN, f64::INFINITY] {
        b[7] = bad;
        // No finite vector satisfies that: the residual is no number, and no number is small enough.
        assert!(matches!(direct.solve(&matrix, &b), Err(SolveError::Residual { .. })), "{bad}");
    }
}

#[test]
fn a_numbering_of_other_unknowns_is_refused() {
    let s = square(0.3);
    let short = Numbering::new(&vec![false; s.dofs.count - 1]);
    let told = Pattern::new(&s.dofs, &short).unwrap_err();
    assert!(matches!(told, SolveError::WrongNumbering { numbered, .. } if numbered == s.dofs.count - 1), "{told}");
    let mut beyond = Numbering::new(&vec![false; s.dofs.count]);
    beyond.free.pop();
    let told = Pattern::new(&s.dofs, &beyond).unwrap_err();
    assert!(matches!(told, SolveError::WrongNumbering { free, .. } if free == s.dofs.count - 1), "{told}");
}

#[test]
fn an_element_with_more_unknowns_than_a_scatter_map_holds_is_refused() {
    let dofs = |unknowns: u32| {
        let mut dofs = ElementDofs::empty(unknowns as usize);
        dofs.push(&(0..unknowns).collect::<Vec<_>>());
        dofs
    };
    let told = Pattern::new(&dofs(256), &Numbering::new(&[false; 256])).unwrap_err();
    assert!(matches!(told, SolveError::ElementTooLarge { element: 0, unknowns: 256, most: 255 }), "{told}");
    // One unknown fewer is a full matrix with every entry in its place.
    let pattern = Pattern::new(&dofs(255), &Numbering::new(&[false; 255])).unwrap();
    let mut matrix = pattern.matrix();
    pattern.assemble(&mut matrix, |_, out| out.iter_mut().enumerate().for_each(|(k, x)| *x = k as f64));
    assert_eq!(matrix.nnz(), 255 * 256 / 2);
    assert!(matrix.triplet_iter().all(|(i, j, &x)| i >= j && x == (j * 255 + i) as f64));
}
