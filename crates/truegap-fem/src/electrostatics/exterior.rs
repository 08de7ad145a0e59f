//! The unbounded space outside an open boundary, as one infinite element behind each of its edges.
//!
//! With `c` the centre and `x(t)` a point of the edge, the space behind it is `c + (x(t) - c) / s` for s in (0, 1]:
//! straight rays away from the centre. A potential that decays as 1/r, 1/r², ... is a polynomial in s along each ray
//! (s = distance of the edge / distance), so powers of s represent every multipole exactly in the radial direction and
//! the quadratic shapes of the edge represent it along the edge. No truncation error is left but that of the highest
//! power. The boundary must be star-shaped as seen from the centre, and the material goes on unchanged along the rays.
//!
//! **Source:** mapped infinite elements (Bettess & Zienkiewicz), here with hierarchic radial polynomials.

use super::error::ElectrostaticsError;
use crate::mesh::{Mesh, NONE, Point, Topology, plane};
use crate::space::{edge_rule, edge_shape};
use crate::symmetry::Symmetry;

/// Powers of s per node: multipoles up to this order leave no radial error.
pub(super) const POWERS: usize = 8;

/// Where the rays come from, and the edges they pass.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Exterior {
    pub centre: Point,
    /// Corners of the open edges, the domain to the left.
    pub edges: Vec<[u32; 2]>,
    /// The triangle inside of each edge.
    pub triangles: Vec<u32>,
}

impl Exterior {
    pub fn new(
        mesh: &Mesh,
        topology: &Topology,
        symmetry: Symmetry,
        open: &[u16],
    ) -> Result<Option<Exterior>, ElectrostaticsError> {
        let mut edges = Vec::new();
        let mut triangles = Vec::new();
        for e in mesh.boundary_edges.iter().filter(|e| open.contains(&e.boundary)) {
            let Some(edge) = topology.edge(e.nodes[0], e.nodes[1]) else { continue };
            let at = mesh.points[e.nodes[0] as usize];
            let [t, other] = topology.edge_triangles[edge];
            if other != NONE {
                let remedy = "set `open = true` on the outer rim only";
                return Err(ElectrostaticsError::OpenBoundary { reason: "it runs through the inside of the domain", at, remedy });
            }
            let k = topology.triangle_edges[t as usize].iter().position(|&x| x as usize == edge).unwrap_or(0);
            let c = mesh.triangles[t as usize];
            let nodes = [c[k], c[(k + 1) % 3]];
            // Edges on the axis have no far side.
            if symmetry == Symmetry::Axisymmetric && nodes.iter().all(|&i| mesh.points[i as usize][0] == 0.0) {
                continue;
            }
            edges.push(nodes);
            triangles.push(t);
        }
        if edges.is_empty() {
            return Ok(None);
        }
        let centre = centre(mesh, topology, symmetry, &edges)?;
        if symmetry == Symmetry::Axisymmetric && centre[0].abs() > 1e-9 * plane::length(mesh.points[edges[0][0] as usize]) {
            let remedy = "let it run from the axis to the axis, or to one ground plane";
            return Err(ElectrostaticsError::OpenBoundary { reason: "its rays do not start on the axis", at: centre, remedy });
        }
        let exterior = Exterior { centre, edges, triangles };
        exterior.check(mesh)?;
        Ok(Some(exterior))
    }

    fn check(&self, mesh: &Mesh) -> Result<(), ElectrostaticsError> {
        for &[a, b] in &self.edges {
            let [p, q] = [a, b].map(|i| plane::minus(mesh.points[i as usize], self.centre));
            if !(plane::cross(p, q) > 1e-6 * plane::length(p) * plane::length(plane::minus(q, p))) {
                return Err(ElectrostaticsError::OpenBoundary {
                    reason: "it is not star-shaped as seen from its centre",
                    at: mesh.points[a as usize],
                    remedy: "use a rectangle or a circle around the conductors, its ends on the axis or on one ground plane",
                });
            }
        }
        Ok(())
    }
}

/// Where the rays start: walls that reach the open boundary must go on as rays, so the centre is where their lines
/// meet; on one common line, or without walls, it is the middle.
fn centre(mesh: &Mesh, topology: &Topology, symmetry: Symmetry, edges: &[[u32; 2]]) -> Result<Point, ElectrostaticsError> {
    let ends = ends(edges);
    match ends.as_slice() {
        [] => Ok(middle(mesh, symmetry, edges)),
        [a, b] => {
            let (p, q) = (mesh.points[*a as usize], mesh.points[*b as usize]);
            let (u, v) = (wall(mesh, topology, edges, *a), wall(mesh, topology, edges, *b));
            let d = plane::minus(q, p);
            let parallel = plane::cross(u, v).abs() <= 1e-9;
            if !parallel {
                return Ok(plane::along(p, [p[0] + u[0], p[1] + u[1]], plane::cross(d, v) / plane::cross(u, v)));
            }
            if plane::cross(u, d).abs() <= 1e-9 * plane::length(d) {
                return Ok(plane::along(p, q, 0.5));
            }
            let remedy = "walls that leave the domain must lie on lines that meet; move one, or close the domain there";
            Err(ElectrostaticsError::OpenBoundary { reason: "the walls at its two ends are parallel", at: p, remedy })
        }
        many => Err(ElectrostaticsError::OpenBoundary {
            reason: "it consists of several separate parts",
            at: mesh.points[many[0] as usize],
            remedy: "make it one connected path; side walls that are cut off need no boundary at all",
        }),
    }
}

/// Nodes that only one open edge has.
fn ends(edges: &[[u32; 2]]) -> Vec<u32> {
    let mut nodes: Vec<u32> = edges.iter().flatten().copied().collect();
    nodes.sort_unstable();
    let single = |i: usize| (i == 0 || nodes[i - 1] != nodes[i]) && nodes.get(i + 1) != Some(&nodes[i]);
    (0..nodes.len()).filter(|&i| single(i)).map(|i| nodes[i]).collect()
}

/// Direction of the other outer edge at an end of the open boundary.
fn wall(mesh: &Mesh, topology: &Topology, edges: &[[u32; 2]], end: u32) -> Point {
    let is_open = |e: &[u32; 2]| edges.iter().any(|o| (o[0].min(o[1]), o[0].max(o[1])) == (e[0], e[1]));
    let mut outer = topology.edges.iter().zip(&topology.edge_triangles).filter(|(e, t)| t[1] == NONE && e.contains(&end));
    let Some((e, _)) = outer.find(|(e, _)| !is_open(e)) else {
        return [0.0, 1.0];
    };
    let d = plane::minus(mesh.points[e[1] as usize], mesh.points[e[0] as usize]);
    let l = plane::length(d);
    [d[0] / l, d[1] / l]
}

fn middle(mesh: &Mesh, symmetry: Symmetry, edges: &[[u32; 2]]) -> Point {
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for p in edges.iter().flatten().map(|&i| mesh.points[i as usize]) {
        for k in 0..2 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    let r = if symmetry == Symmetry::Axisymmetric { 0.0 } else { 0.5 * (low[0] + high[0]) };
    [r, 0.5 * (low[1] + high[1])]
}

/// Radial shapes at s, for the trace (value 1 at s = 1) and the higher powers (0 at s = 1): values and slopes by s.
pub(super) fn radial(s: f64) -> [[f64; 2]; POWERS] {
    let mut out = [[0.0; 2]; POWERS];
    out[0] = [s, 1.0];
    // s (1 - s) times Legendre polynomials of 2 s - 1.
    let x = 2.0 * s - 1.0;
    let (bubble, slope) = (s * (1.0 - s), 1.0 - 2.0 * s);
    let ([mut p0, mut d0], [mut p, mut d]) = ([0.0, 0.0], [1.0, 0.0]);
    for (k, entry) in out.iter_mut().enumerate().skip(1) {
        *entry = [bubble * p, slope * p + bubble * d];
        let n = (k - 1) as f64;
        let next = ((2.0 * n + 1.0) * x * p - n * p0) / (n + 1.0);
        let next_slope = ((2.0 * n + 1.0) * (2.0 * p + x * d) - n * d0) / (n + 1.0);
        ([p0, d0], [p, d]) = ([p, d], [next, next_slope]);
    }
    out
}

/// Positions of the three nodes of an open edge relative to the centre, and its form.
#[derive(Debug, Clone, Copy)]
pub(super) struct InfiniteElement {
    pub nodes: [Point; 3],
    pub symmetry: Symmetry,
    pub permittivity: f64,
}

/// Unknowns of one infinite element: for each of the three nodes its trace and powers, then the potential at infinity.
pub(super) const UNKNOWNS: usize = 3 * POWERS + 1;

impl InfiniteElement {
    /// Gradients of all shapes at (t, s), and the area factor |dx/dt x dx/ds| w.
    fn gradients(&self, t: f64, s: f64) -> ([[f64; 2]; UNKNOWNS], f64) {
        let (n, dn) = edge_shape(t);
        let sum = |w: [f64; 3], k: usize| (0..3).map(|i| w[i] * self.nodes[i][k]).sum::<f64>();
        let (d, tangent) = ([sum(n, 0), sum(n, 1)], [sum(dn, 0), sum(dn, 1)]);
        let cross = plane::cross(d, tangent);
        // Dual vectors of dx/dt = tangent / s and dx/ds = -d / s^2.
        let along = [-s * d[1] / cross, s * d[0] / cross];
        let out = [-s * s * tangent[1] / cross, s * s * tangent[0] / cross];
        let q = radial(s);
        let mut g = [[0.0; 2]; UNKNOWNS];
        for i in 0..3 {
            for k in 0..POWERS {
                let (u_t, u_s) = (dn[i] * q[k][0], n[i] * q[k][1]);
                g[i * POWERS + k] = [u_t * along[0] + u_s * out[0], u_t * along[1] + u_s * out[1]];
            }
        }
        // Infinity: 1 - s.
        g[UNKNOWNS - 1] = [-out[0], -out[1]];
        let weight = match self.symmetry {
            Symmetry::Axisymmetric => std::f64::consts::TAU * d[0] / s,
            Symmetry::Planar => 1.0,
        };
        (g, weight * cross.abs() / (s * s * s))
    }

    /// Adds the element matrix (full, column by column).
    pub fn matrix(&self, out: &mut [f64]) {
        for &(t, wt) in &edge_rule(6) {
            for &(s, ws) in &edge_rule(2 * POWERS + 1) {
                let (g, factor) = self.gradients(t, s);
                let w = wt * ws * factor * self.permittivity;
                for j in 0..UNKNOWNS {
                    for i in 0..UNKNOWNS {
                        out[j * UNKNOWNS + i] += w * plane::dot(g[i], g[j]);
                    }
                }
            }
        }
    }

    /// Gradient of a potential at the edge (s = 1).
    pub fn edge_gradient(&self, t: f64, values: &[f64]) -> [f64; 2] {
        let (g, _) = self.gradients(t, 1.0);
        g.iter().zip(values).fold([0.0; 2], |sum, (g, u)| [sum[0] + u * g[0], sum[1] + u * g[1]])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radial_shapes_have_their_ends_and_slopes() {
        assert_eq!(radial(1.0)[0][0], 1.0);
        assert!(radial(1.0)[1..].iter().chain(&radial(0.0)).all(|q| q[0] == 0.0));
        let (s, h) = (0.3, 1e-5);
        let (low, middle, high) = (radial(s - h), radial(s), radial(s + h));
        for k in 0..POWERS {
            // Central differences of polynomials of degree 9: h^2 times their third derivative (up to 1e3).
            assert!((middle[k][1] - (high[k][0] - low[k][0]) / (2.0 * h)).abs() < 1e-6, "{k}");
        }
    }
}
