//! Newest-vertex bisection: halves marked triangles and as few neighbours as keep the mesh conforming.
//!
//! The refinement edge of a triangle is its local edge 0, so the mesh itself carries all state. At most four shapes
//! descend from a triangle; angles stay above about half of the least angle of the first mesh. Edges on arcs are
//! halved on their circle.

use super::mesh::{BoundaryEdge, CurvedEdge, Mesh};
use super::plane::{self, Point};
use super::topology::{NONE, Topology};

/// Turns every triangle so that its longest edge is the one that is halved first. Call once, before `bisect`.
pub fn longest_edge_first(mesh: &mut Mesh) {
    for t in 0..mesh.triangles.len() {
        let c = mesh.corners(t);
        let length = |k: usize| plane::distance(c[k], c[(k + 1) % 3]);
        let longest = (1..3).fold(0, |best, k| if length(k) > length(best) * (1.0 + 1e-12) { k } else { best });
        mesh.triangles[t].rotate_left(longest);
    }
}

/// Halves all three edges of the marked triangles and closes the mesh; also returns the parent of every new triangle.
///
/// **Source:** the closure by edges of Funken, Praetorius & Wissgott (2011), which ends for any choice of the first
/// refinement edges (Karkulik, Pavlicek & Praetorius 2013).
pub fn bisect(mesh: &Mesh, topology: &Topology, marked: &[bool]) -> (Mesh, Vec<u32>) {
    let halved = closed_marks(topology, marked);
    let mut out =
        Mesh { region_names: mesh.region_names.clone(), boundary_names: mesh.boundary_names.clone(), ..Mesh::default() };
    let middles = halve_edges(mesh, topology, &halved, &mut out.points);
    let mut parents = Vec::new();
    for (t, &corners) in mesh.triangles.iter().enumerate() {
        let m = topology.triangle_edges[t].map(|e| middles[e as usize]);
        split(corners, m, &mut out.triangles);
        out.triangle_regions.resize(out.triangles.len(), mesh.triangle_regions[t]);
        parents.resize(out.triangles.len(), t as u32);
    }
    let middle = |[a, b]: [u32; 2]| topology.edge(a, b).map_or(NONE, |e| middles[e]);
    for e in &mesh.boundary_edges {
        halves(e.nodes, middle(e.nodes), |nodes| out.boundary_edges.push(BoundaryEdge { nodes, ..*e }));
    }
    for e in &mesh.curved_edges {
        halves(e.nodes, middle(e.nodes), |nodes| out.curved_edges.push(CurvedEdge { nodes, ..*e }));
    }
    (out, parents)
}

/// Halves the marked triangles once, and those that carry several times the least marked share once or twice more.
///
/// Near an edge singularity the squared error only halves with the triangle, so catching up takes several rounds; doing
/// them without solving in between saves most of the levels.
pub(crate) fn bisect_repeatedly(mesh: &Mesh, topology: &Topology, marked: &[bool], shares: &[f64]) -> Mesh {
    let least = shares.iter().zip(marked).filter(|(_, m)| **m).map(|(s, _)| *s).fold(f64::INFINITY, f64::min);
    let more = |share: f64| u8::from(share > 8.0 * least) + u8::from(share > 64.0 * least);
    let (mut out, parents) = bisect(mesh, topology, marked);
    let mut left: Vec<u8> = parents.iter().map(|&p| more(shares[p as usize])).collect();
    for _ in 0..2 {
        let again: Vec<bool> = left.iter().map(|&n| n > 0).collect();
        if !again.contains(&true) {
            break;
        }
        let (next, parents) = bisect(&out, &Topology::new(&out), &again);
        left = parents.iter().map(|&p| left[p as usize].saturating_sub(1)).collect();
        out = next;
    }
    out
}

/// Edges to halve: those of the marked triangles, and the refinement edge of every triangle that has one of them.
fn closed_marks(topology: &Topology, marked: &[bool]) -> Vec<bool> {
    let mut halved = vec![false; topology.edges.len()];
    let mut queue: Vec<u32> = Vec::new();
    for (t, _) in marked.iter().enumerate().filter(|(_, m)| **m) {
        for e in topology.triangle_edges[t] {
            if !halved[e as usize] {
                halved[e as usize] = true;
                queue.push(e);
            }
        }
    }
    while let Some(edge) = queue.pop() {
        for &t in topology.edge_triangles[edge as usize].iter().filter(|&&t| t != NONE) {
            let first = topology.triangle_edges[t as usize][0];
            if !halved[first as usize] {
                halved[first as usize] = true;
                queue.push(first);
            }
        }
    }
    halved
}

fn halve_edges(mesh: &Mesh, topology: &Topology, halved: &[bool], points: &mut Vec<Point>) -> Vec<u32> {
    points.clone_from(&mesh.points);
    let places = topology.middles(mesh);
    halved
        .iter()
        .zip(places)
        .map(|(&h, place)| {
            if !h {
                return NONE;
            }
            points.push(place);
            (points.len() - 1) as u32
        })
        .collect()
}

/// Children of a triangle whose edges have the middles `m` (`NONE` where whole); the newest corner comes last.
fn split([a, b, c]: [u32; 3], [ab, bc, ca]: [u32; 3], out: &mut Vec<[u32; 3]>) {
    if ab == NONE {
        out.push([a, b, c]);
        return;
    }
    match ca {
        NONE => out.push([c, a, ab]),
        _ => out.extend([[ab, c, ca], [a, ab, ca]]),
    }
    match bc {
        NONE => out.push([b, c, ab]),
        _ => out.extend([[ab, b, bc], [c, ab, bc]]),
    }
}

fn halves([a, b]: [u32; 2], middle: u32, mut push: impl FnMut([u32; 2])) {
    if middle == NONE {
        push([a, b]);
    } else {
        push([a, middle]);
        push([middle, b]);
    }
}
