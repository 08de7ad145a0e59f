//! Bisection: what it must keep, and how bad its angles may become.

#![allow(clippy::unwrap_used)]

use truegap_fem::mesh::*;

fn stack() -> Mesh {
    let dome = Outline { start: [0.0, 1.0], steps: vec![Step::Arc { via: [0.8, 0.6], to: [1.0, 0.0] }, Step::Line([0.0, 0.0])] };
    let g = Geometry::default()
        .region("air", Outline::rectangle([0.0, 0.0], [2.0, 2.0]))
        .region("dome", dome)
        .boundary("surface", &[[1.0, 0.0], [2.0, 0.0]])
        .boundary_of("rim", "dome");
    mesh_geometry(&g, &MeshOptions::default()).unwrap()
}

fn area(mesh: &Mesh) -> f64 {
    (0..mesh.triangles.len()).map(|t| mesh.corners(t)).map(|[a, b, c]| 0.5 * plane::twice_area(a, b, c)).sum()
}

#[test]
fn local_bisection_keeps_area_angles_boundaries_and_arcs() {
    let mut mesh = stack();
    let first = mesh.quality().least_angle_degrees;
    longest_edge_first(&mut mesh);
    for _ in 0..25 {
        let near = |t: usize| mesh.corners(t).iter().any(|p| plane::distance(*p, [1.0, 0.0]) < 1e-12);
        let marked: Vec<bool> = (0..mesh.triangles.len()).map(near).collect();
        let (next, parents) = bisect(&mesh, &Topology::new(&mesh), &marked);
        for (t, &parent) in parents.iter().enumerate() {
            assert_eq!(next.triangle_regions[t], mesh.triangle_regions[parent as usize]);
        }
        mesh = next;
        mesh.check().unwrap();
    }
    assert!((area(&mesh) - 4.0).abs() < 1e-12);
    assert!(mesh.quality().shortest_edge < 1e-6 && mesh.triangles.len() < 5000);
    assert!(mesh.quality().least_angle_degrees > 0.4 * first, "{} after {first}", mesh.quality().least_angle_degrees);
    let length = |name: &str| -> f64 {
        let b = mesh.boundary(name).unwrap();
        mesh.edges_of(b).map(|[i, j]| plane::distance(mesh.points[i as usize], mesh.points[j as usize])).sum()
    };
    assert!((length("surface") - 1.0).abs() < 1e-12);
    for e in &mesh.curved_edges {
        for i in e.nodes {
            let p = mesh.points[i as usize];
            assert!((p[0].hypot(p[1]) - 1.0).abs() < 1e-13);
        }
    }
}

#[test]
fn a_hanging_node_would_be_seen_as_an_open_edge() {
    let mut mesh = stack();
    longest_edge_first(&mut mesh);
    let marked: Vec<bool> = (0..mesh.triangles.len()).map(|t| t % 7 == 3).collect();
    let (mesh, _) = bisect(&mesh, &Topology::new(&mesh), &marked);
    let topology = Topology::new(&mesh);
    // Edges with one triangle lie on the square's sides only, or the mesh does not conform.
    for (edge, triangles) in topology.edges.iter().zip(&topology.edge_triangles) {
        if triangles[1] == NONE {
            let [p, q] = edge.map(|i| mesh.points[i as usize]);
            let on_side = (0..2).any(|k| [0.0, 2.0].iter().any(|&x| (p[k] - x).abs() < 1e-12 && (q[k] - x).abs() < 1e-12));
            assert!(on_side, "{p:?} - {q:?}");
        }
    }
}

#[test]
fn marking_takes_the_fewest_that_carry_the_share() {
    assert_eq!(mark_largest(&[1.0, 5.0, 3.0, 1.0], 0.75), [false, true, true, false]);
    assert_eq!(mark_largest(&[0.0, 0.0], 0.75), [false, false]);
}
