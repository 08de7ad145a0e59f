//! Mesh files: what is written reads back the same, and foreign files are refused with the place.

#![allow(clippy::unwrap_used)]

use truegap_fem::io::{Field, read_msh, write_msh, write_vtu};
use truegap_fem::mesh::*;
use truegap_fem::space::Nodes;

fn drawing() -> Mesh {
    let half = |r: f64| Outline { start: [0.0, -r], steps: vec![Step::Arc { via: [r, 0.0], to: [0.0, r] }] };
    let g = Geometry::default().region("outer", half(2.0)).region("inner half", half(1.0)).boundary_of("shell", "inner half");
    mesh_geometry(&g, &MeshOptions::default()).unwrap()
}

fn written(mesh: &Mesh) -> String {
    let mut out = Vec::new();
    write_msh(&mut out, mesh).unwrap();
    String::from_utf8(out).unwrap()
}

/// Triangles as (region, corner coordinates), boundaries as (name, end coordinates): independent of the numbering.
fn described(mesh: &Mesh) -> (Vec<String>, Vec<String>) {
    let triangles = (0..mesh.triangles.len())
        .map(|t| format!("{} {:?}", mesh.region_names[mesh.triangle_regions[t] as usize], mesh.corners(t)));
    let edge =
        |e: &BoundaryEdge| format!("{} {:?}", mesh.boundary_names[e.boundary as usize], e.nodes.map(|i| mesh.points[i as usize]));
    (triangles.collect(), mesh.boundary_edges.iter().map(edge).collect())
}

#[test]
fn a_mesh_with_arcs_and_groups_survives_the_msh_file() {
    let mesh = drawing();
    let back = read_msh(&written(&mesh), "there and back").unwrap();
    let (mut a, mut b) = (described(&mesh), described(&back));
    for list in [&mut a.0, &mut a.1, &mut b.0, &mut b.1] {
        list.sort();
    }
    assert_eq!(a, b);
    assert_eq!(back.curved_edges.len(), mesh.curved_edges.len());
    for e in &back.curved_edges {
        // The circle comes back from three points of a 10 degree arc: rounding over the squared half angle.
        assert!((e.circle.radius - e.circle.radius.round()).abs() < 1e-11, "{:?}", e.circle);
    }
}

#[test]
fn foreign_and_broken_files_are_refused_with_their_line() {
    let good = written(&drawing());
    let refuse = |text: &str, line: usize, hint: &str| {
        let error = read_msh(text, "bad.msh").unwrap_err();
        let message = error.to_string();
        assert!(message.contains(hint), "{message}");
        if line > 0 {
            assert!(message.starts_with(&format!("bad.msh, line {line}:")), "{message}");
        }
    };
    refuse(&good.replacen("4.1 0 8", "2.2 0 8", 1), 2, "version is 2.2");
    refuse(&good.replacen("4.1 0 8", "4.1 1 8", 1), 2, "ASCII");
    refuse("hello", 0, "$MeshFormat");
    let lines: Vec<&str> = good.lines().collect();
    refuse(&lines[..lines.len() / 2].join("\n"), 0, "ends in the middle");
    let nodes = lines.iter().position(|l| *l == "$Nodes").unwrap();
    refuse(&good.replacen("$Nodes\n1 ", "$Nodes\none ", 1), nodes + 2, "entry 1 is `one`");
}

#[test]
fn an_inverted_triangle_is_refused_by_its_number() {
    let mut mesh = drawing();
    mesh.triangles[7].swap(0, 1);
    assert!(matches!(mesh.check(), Err(MeshError::InvertedTriangle { triangle: 7, .. })));
    assert!(matches!(read_msh(&written(&mesh), "inverted.msh"), Err(MeshError::InvertedTriangle { .. })));
}

#[test]
fn vtu_files_hold_every_node_triangle_and_value() {
    let mesh = drawing();
    let nodes = Nodes::new(&mesh, &Topology::new(&mesh));
    let potential: Vec<f64> = nodes.points.iter().map(|p| p[0] - 2.0 * p[1]).collect();
    let energy: Vec<f64> = (0..mesh.triangles.len()).map(|t| t as f64).collect();
    let mut out = Vec::new();
    let at_nodes = [Field { name: "V (V)", components: 1, values: &potential }];
    write_vtu(&mut out, &nodes, &at_nodes, &[Field { name: "w (J/m3)", components: 1, values: &energy }]).unwrap();
    let text = String::from_utf8(out).unwrap();
    assert!(text.contains(&format!("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", nodes.points.len(), mesh.triangles.len())));
    let block = |name: &str| {
        let from = text.find(&format!("Name=\"{name}\"")).unwrap();
        let body = &text[from + text[from..].find('>').unwrap() + 1..];
        body[..body.find('<').unwrap()].split_whitespace().map(|x| x.parse::<f64>().unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(block("V (V)"), potential);
    assert_eq!(block("w (J/m3)"), energy);
    assert_eq!(block("connectivity").len(), 6 * mesh.triangles.len());
}

#[test]
fn the_reference_meshes_of_the_repository_can_be_read() {
    for (name, regions, boundaries) in [("disc_capacitor_0_1", 1, 3), ("bead_cell", 3, 2)] {
        let path = format!("{}/../../meshes/{name}.msh", env!("CARGO_MANIFEST_DIR"));
        let mesh = read_msh(&std::fs::read_to_string(&path).unwrap(), &path).unwrap();
        assert_eq!((mesh.region_names.len(), mesh.boundary_names.len()), (regions, boundaries));
        assert!(mesh.quality().least_angle_degrees > 25.0 && mesh.boundary_edges.len() > 8);
    }
}
