//! Part of a mesh: some of its triangles, the points they use, the boundary edges they have.
//!
//! Limits: straight edges.

use truegap_fem::mesh::{BoundaryEdge, Mesh, NONE, Topology};

/// A part of a mesh and where its points came from.
#[derive(Clone, Debug)]
pub struct Part {
    /// the part, with the names of the whole
    pub mesh: Mesh,
    /// point of the whole for every point of the part
    pub origin: Vec<u32>,
}

/// The triangles whose region `keep` names, with all region and boundary names kept in their order.
pub(super) fn part(mesh: &Mesh, keep: impl Fn(&str) -> bool) -> Part {
    let kept: Vec<bool> = mesh.region_names.iter().map(|n| keep(n)).collect();
    let chosen = || (0..mesh.triangles.len()).filter(|&t| kept[mesh.triangle_regions[t] as usize]);
    let mut number = vec![NONE; mesh.points.len()];
    let mut origin = Vec::new();
    for &p in chosen().flat_map(|t| &mesh.triangles[t]) {
        if number[p as usize] == NONE {
            number[p as usize] = origin.len() as u32;
            origin.push(p);
        }
    }
    let mut part = Mesh {
        points: origin.iter().map(|&p| mesh.points[p as usize]).collect(),
        triangles: chosen().map(|t| mesh.triangles[t].map(|p| number[p as usize])).collect(),
        triangle_regions: chosen().map(|t| mesh.triangle_regions[t]).collect(),
        region_names: mesh.region_names.clone(),
        boundary_names: mesh.boundary_names.clone(),
        ..Mesh::default()
    };
    let topology = Topology::new(&part);
    let moved = mesh.boundary_edges.iter().map(|e| BoundaryEdge { nodes: e.nodes.map(|p| number[p as usize]), ..*e });
    part.boundary_edges =
        moved.filter(|e| e.nodes.iter().all(|&p| p != NONE) && topology.edge(e.nodes[0], e.nodes[1]).is_some()).collect();
    drop_unused_regions(&mut part, &kept);
    Part { mesh: part, origin }
}

fn drop_unused_regions(mesh: &mut Mesh, kept: &[bool]) {
    let mut number = Vec::new();
    let mut next = 0;
    for &k in kept {
        number.push(next);
        next += u16::from(k);
    }
    mesh.triangle_regions.iter_mut().for_each(|r| *r = number[*r as usize]);
    let mut place = kept.iter();
    mesh.region_names.retain(|_| place.next().copied().unwrap_or(false));
}
