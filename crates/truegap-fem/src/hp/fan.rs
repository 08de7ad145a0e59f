//! What lies around a corner of a mesh: sectors of material between conditions.

use crate::mesh::{Mesh, NONE, Topology, plane};

/// What holds on an edge that a wedge ends at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Edge {
    /// Nothing: no flux, no traction.
    Free,
    /// The value is given: a conductor, a bonded face.
    Held,
    /// Half of what is whole: displacement along the edge is free, across it is not.
    Mirror,
    /// Something that no exponent is known for.
    Other,
    /// The body goes on beyond it, unchanged.
    Continued,
}

/// Sectors of one material each, counter-clockwise, and what they end at; `ends` is `None` for a full turn.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Wedge {
    /// Angle (rad) and region.
    pub sectors: Vec<(f64, u16)>,
    pub ends: Option<[Edge; 2]>,
}

impl Wedge {
    /// Whether another one differs by no more than rounding.
    pub fn is_like(&self, other: &Wedge) -> bool {
        let alike = |(a, b): (&(f64, u16), &(f64, u16))| a.1 == b.1 && (a.0 - b.0).abs() < 1e-12;
        self.ends == other.ends && self.sectors.len() == other.sectors.len() && self.sectors.iter().zip(&other.sectors).all(alike)
    }
}

/// The wedges around every corner of the mesh that has a condition, an interface or the end of the domain.
///
/// `edge` gives the condition on an edge, `None` where the inside goes on.
pub(super) fn wedges(mesh: &Mesh, topology: &Topology, edge: &dyn Fn(usize) -> Option<Edge>) -> Vec<(u32, Vec<Wedge>)> {
    let mut around: Vec<Vec<(u32, u8)>> = vec![Vec::new(); mesh.points.len()];
    for (t, nodes) in mesh.triangles.iter().enumerate() {
        (0..3).for_each(|k| around[nodes[k] as usize].push((t as u32, k as u8)));
    }
    let special: Vec<Option<Edge>> = (0..topology.edges.len()).map(edge).collect();
    let fan = Fan { mesh, topology, special };
    let is_corner = |w: &Vec<Wedge>| !w.is_empty() && !w.iter().any(|w| w.ends.is_some_and(|e| e.contains(&Edge::Continued)));
    (0..mesh.points.len()).map(|n| (n as u32, fan.at(&around[n]))).filter(|(_, w)| is_corner(w)).collect()
}

struct Fan<'a> {
    mesh: &'a Mesh,
    topology: &'a Topology,
    special: Vec<Option<Edge>>,
}

impl Fan<'_> {
    /// Edge at which a triangle begins counter-clockwise around its corner `k`, and the one at which it ends.
    fn sides(&self, (t, k): (u32, u8)) -> [usize; 2] {
        let edges = self.topology.triangle_edges[t as usize];
        [edges[k as usize] as usize, edges[(k as usize + 2) % 3] as usize]
    }

    /// The condition on an edge, where a wedge ends.
    fn end(&self, edge: usize) -> Option<Edge> {
        self.special[edge].or((self.topology.edge_triangles[edge][1] == NONE).then_some(Edge::Free))
    }

    fn at(&self, around: &[(u32, u8)]) -> Vec<Wedge> {
        let starts: Vec<_> = around.iter().copied().filter(|&c| self.end(self.sides(c)[0]).is_some()).collect();
        if starts.is_empty() {
            let whole = around.first().map(|&c| self.walk(around, c));
            // a full turn of one material is no corner
            return whole.into_iter().filter(|w| w.sectors.len() > 1).collect();
        }
        starts.into_iter().map(|c| self.walk(around, c)).collect()
    }

    fn walk(&self, around: &[(u32, u8)], start: (u32, u8)) -> Wedge {
        let begin = self.end(self.sides(start)[0]);
        let mut sectors: Vec<(f64, u16)> = Vec::new();
        let mut at = start;
        loop {
            let region = self.mesh.triangle_regions[at.0 as usize];
            match sectors.last_mut() {
                Some(last) if last.1 == region => last.0 += self.angle(at),
                _ => sectors.push((self.angle(at), region)),
            }
            let side = self.sides(at)[1];
            let end = self.end(side);
            let next = around.iter().copied().find(|&c| self.sides(c)[0] == side);
            match (begin, end, next) {
                (Some(begin), Some(end), _) => return Wedge { sectors, ends: Some([begin, end]) },
                (None, None, Some(next)) if next == start => return closed(sectors),
                (_, None, Some(next)) if sectors.len() <= around.len() => at = next,
                _ => return Wedge { sectors, ends: Some([Edge::Other; 2]) },
            }
        }
    }

    fn angle(&self, (t, k): (u32, u8)) -> f64 {
        let c = self.mesh.corners(t as usize);
        let [a, b, d] = [0, 1, 2].map(|i| c[(k as usize + i) % 3]);
        let (u, v) = (plane::minus(b, a), plane::minus(d, a));
        plane::cross(u, v).atan2(plane::dot(u, v))
    }
}

/// A full turn, begun anywhere: the last sector and the first are one where their material is.
fn closed(mut sectors: Vec<(f64, u16)>) -> Wedge {
    if sectors.len() > 1 && sectors[0].1 == sectors[sectors.len() - 1].1 {
        let last = sectors.pop().map_or(0.0, |s| s.0);
        sectors[0].0 += last;
    }
    Wedge { sectors, ends: None }
}
