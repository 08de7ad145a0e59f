//! Infinite elements behind straight open edges, for shapes of any degree along the edge.
//!
//! Along a straight edge position and its derivative are linear and constant, so that every integral is a product of one along the edge
//! and one along the ray: the matrix is a sum of four such products. The rays and radial shapes are those of [`super::exterior`].

use super::exterior::{Exterior, POWERS, radial};
use crate::hp::{Space, line_shapes};
use crate::mesh::plane;
use crate::space::{ElementDofs, edge_rule};
use crate::symmetry::Symmetry;
use std::collections::HashMap;

/// Radial functions: the trace, the higher powers, and `1 - s`, which is the potential at infinity.
const RADIAL: usize = POWERS + 1;
type Rays = [[f64; RADIAL]; RADIAL];

/// A point of a rule along an edge, and the shapes there: values and slopes.
struct EdgePoint {
    at: f64,
    weight: f64,
    shapes: Vec<[f64; 2]>,
}

/// All infinite elements of a space.
pub(super) struct InfiniteEdges<'a> {
    exterior: &'a Exterior,
    space: &'a Space<'a>,
    symmetry: Symmetry,
    permittivity: &'a [f64],
    /// Integrals of radial functions: values, value and slope, slopes.
    rays: [Rays; 3],
    /// Points along an edge, by the number of shapes.
    along: HashMap<usize, Vec<EdgePoint>>,
}

impl<'a> InfiniteEdges<'a> {
    pub fn new(exterior: &'a Exterior, space: &'a Space<'a>, symmetry: Symmetry, permittivity: &'a [f64]) -> InfiniteEdges<'a> {
        let counts = exterior.edges.iter().map(|&e| space.on_edge(e).len());
        let points = |n: usize| {
            edge_rule(2 * n + 2)
                .into_iter()
                .map(|(at, weight)| EdgePoint { at, weight, shapes: line_shapes(n - 1, at) })
                .collect()
        };
        let mut along = HashMap::new();
        counts.for_each(|n| {
            along.entry(n).or_insert_with(|| points(n));
        });
        InfiniteEdges { exterior, space, symmetry, permittivity, rays: rays(symmetry), along }
    }

    /// Appends the unknowns of the elements: powers of every trace, then the potential at infinity, the last of all.
    pub fn number(&self, dofs: &mut ElementDofs) {
        let mut sites = HashMap::<u32, u32>::new();
        let mut next = dofs.count as u32;
        let traces: Vec<Vec<u32>> =
            self.exterior.edges.iter().map(|&e| self.space.on_edge(e).into_iter().map(|(u, _)| u).collect()).collect();
        for &u in traces.iter().flatten() {
            sites.entry(u).or_insert_with(|| {
                next += POWERS as u32 - 1;
                next + 1 - POWERS as u32
            });
        }
        for trace in traces {
            let powers = |u: &u32| std::iter::once(*u).chain((0..POWERS as u32 - 1).map(|k| sites[u] + k)).collect::<Vec<_>>();
            let mut local: Vec<u32> = trace.iter().flat_map(powers).collect();
            local.push(next);
            dofs.push(&local);
        }
        dofs.count = next as usize + 1;
    }

    /// Matrix of the element behind the edge `k`, lower triangle, column by column of the full one.
    pub fn matrix(&self, k: usize) -> Vec<f64> {
        let edge = self.exterior.edges[k];
        let [a, b] = edge.map(|n| plane::minus(self.space.mesh.points[n as usize], self.exterior.centre));
        let tangent = plane::minus(b, a);
        let cross = plane::cross(a, tangent).abs();
        let signs: Vec<f64> = self.space.on_edge(edge).iter().map(|(_, s)| *s).collect();
        let n = signs.len();
        // the last function along the edge is 1, for the potential at infinity
        let mut along = vec![[0.0; 4]; (n + 1) * (n + 1)];
        for EdgePoint { at, weight: w, shapes } in &self.along[&n] {
            let d = plane::along(a, b, *at);
            let weight = match self.symmetry {
                Symmetry::Axisymmetric => w * std::f64::consts::TAU * d[0] / cross,
                Symmetry::Planar => w / cross,
            };
            let mut shapes = shapes.clone();
            shapes.iter_mut().zip(&signs).for_each(|(s, sign)| *s = s.map(|x| x * sign));
            shapes.push([1.0, 0.0]);
            let metric = [plane::dot(d, d), plane::dot(d, tangent), plane::dot(tangent, tangent)].map(|m| m * weight);
            for (i, u) in shapes.iter().enumerate() {
                for (j, v) in shapes.iter().enumerate() {
                    let sum = &mut along[i * (n + 1) + j];
                    sum[0] += metric[0] * u[1] * v[1];
                    sum[1] += metric[1] * u[1] * v[0];
                    sum[2] += metric[1] * u[0] * v[1];
                    sum[3] += metric[2] * u[0] * v[0];
                }
            }
        }
        let region = self.space.mesh.triangle_regions[self.exterior.triangles[k] as usize];
        let permittivity = self.permittivity[region as usize];
        let functions: Vec<(usize, usize)> = (0..n).flat_map(|i| (0..POWERS).map(move |p| (i, p))).chain([(n, POWERS)]).collect();
        let [values, mixed, slopes] = &self.rays;
        let entry = |&(i, p): &(usize, usize), &(j, q): &(usize, usize)| {
            let t = along[i * (n + 1) + j];
            permittivity * (t[0] * values[p][q] + t[1] * mixed[p][q] + t[2] * mixed[q][p] + t[3] * slopes[p][q])
        };
        let m = functions.len();
        let mut out = vec![0.0; m * m];
        for (j, g) in functions.iter().enumerate() {
            functions.iter().enumerate().skip(j).for_each(|(i, f)| out[j * m + i] = entry(f, g));
        }
        out
    }
}

/// Integrals over s in (0, 1] of `q_k q_l / s^2`, `q_k q_l' / s`, `q_k' q_l'`, in planar bodies with one s more in each.
fn rays(symmetry: Symmetry) -> [Rays; 3] {
    let mut out = [[[0.0; RADIAL]; RADIAL]; 3];
    for (s, w) in edge_rule(2 * POWERS + 3) {
        let w = if symmetry == Symmetry::Planar { w * s } else { w };
        let mut q = [[0.0, -1.0]; RADIAL];
        q[..POWERS].copy_from_slice(&radial(s));
        for k in 0..RADIAL {
            for l in 0..RADIAL {
                out[0][k][l] += w * q[k][0] * q[l][0] / (s * s);
                out[1][k][l] += w * q[k][0] * q[l][1] / s;
                out[2][k][l] += w * q[k][1] * q[l][1];
            }
        }
    }
    out
}
