//! gmsh `.msh` 4.1 ASCII out: one surface and physical group a region, one curve and physical group a boundary.
//!
//! Meshes with arcs are written as quadratic elements, so that the middle nodes keep the arcs.

use crate::mesh::{Mesh, Topology};
use crate::space::Nodes;
use std::io::{Result, Write};

/// Writes a mesh (coordinates in m).
pub fn write_msh(out: &mut impl Write, mesh: &Mesh) -> Result<()> {
    let topology = Topology::new(mesh);
    let quadratic = !mesh.curved_edges.is_empty();
    let nodes = Nodes::new(mesh, &topology);
    let count = if quadratic { nodes.points.len() } else { nodes.corners };
    writeln!(out, "$MeshFormat\n4.1 0 8\n$EndMeshFormat")?;
    names(out, mesh)?;
    entities(out, mesh)?;
    writeln!(out, "$Nodes\n1 {count} 1 {count}\n2 1 0 {count}")?;
    for i in 1..=count {
        writeln!(out, "{i}")?;
    }
    for p in &nodes.points[..count] {
        // Shortest decimal that reads back to the same bits.
        writeln!(out, "{:?} {:?} 0", p[0], p[1])?;
    }
    writeln!(out, "$EndNodes")?;
    elements(out, mesh, &topology, &nodes, quadratic)
}

fn names(out: &mut impl Write, mesh: &Mesh) -> Result<()> {
    writeln!(out, "$PhysicalNames\n{}", mesh.boundary_names.len() + mesh.region_names.len())?;
    for (i, name) in mesh.boundary_names.iter().enumerate() {
        writeln!(out, "1 {} \"{name}\"", i + 1)?;
    }
    for (i, name) in mesh.region_names.iter().enumerate() {
        writeln!(out, "2 {} \"{name}\"", i + 1)?;
    }
    writeln!(out, "$EndPhysicalNames")
}

fn entities(out: &mut impl Write, mesh: &Mesh) -> Result<()> {
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for p in &mesh.points {
        for k in 0..2 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    let bounds = format!("{:?} {:?} 0 {:?} {:?} 0", low[0], low[1], high[0], high[1]);
    writeln!(out, "$Entities\n0 {} {} 0", mesh.boundary_names.len(), mesh.region_names.len())?;
    for i in 1..=mesh.boundary_names.len() + mesh.region_names.len() {
        // Tags start at 1 in each dimension; the physical group has the tag of its entity.
        let tag = if i > mesh.boundary_names.len() { i - mesh.boundary_names.len() } else { i };
        writeln!(out, "{tag} {bounds} 1 {tag} 0")?;
    }
    writeln!(out, "$EndEntities")
}

fn elements(out: &mut impl Write, mesh: &Mesh, topology: &Topology, nodes: &Nodes, quadratic: bool) -> Result<()> {
    let edges = |b: usize| mesh.edges_of(b as u16).collect::<Vec<_>>();
    let triangles = |r: usize| (0..mesh.triangles.len()).filter(move |&t| mesh.triangle_regions[t] as usize == r);
    let total = mesh.boundary_edges.len() + mesh.triangles.len();
    let blocks = mesh.boundary_names.len() + mesh.region_names.len();
    writeln!(out, "$Elements\n{blocks} {total} 1 {total}")?;
    let mut tag = 0;
    for b in 0..mesh.boundary_names.len() {
        let edges = edges(b);
        writeln!(out, "1 {} {} {}", b + 1, if quadratic { 8 } else { 1 }, edges.len())?;
        for e in edges {
            tag += 1;
            let of = nodes.edge(topology, e).unwrap_or([e[0], e[1], e[0]]);
            element(out, tag, &of[..if quadratic { 3 } else { 2 }])?;
        }
    }
    for r in 0..mesh.region_names.len() {
        writeln!(out, "2 {} {} {}", r + 1, if quadratic { 9 } else { 2 }, triangles(r).count())?;
        for t in triangles(r) {
            tag += 1;
            element(out, tag, &nodes.triangles[t][..if quadratic { 6 } else { 3 }])?;
        }
    }
    writeln!(out, "$EndElements")
}

fn element(out: &mut impl Write, tag: usize, nodes: &[u32]) -> Result<()> {
    write!(out, "{tag}")?;
    for n in nodes {
        write!(out, " {}", n + 1)?;
    }
    writeln!(out)
}
