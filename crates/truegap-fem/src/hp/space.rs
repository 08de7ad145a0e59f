//! Which shapes every triangle has and which unknowns they belong to, the degree free to differ from triangle to triangle.

use super::shapes::{inside, on_edge};
use crate::mesh::{Mesh, NONE, Topology};

/// A shape of an element: its unknown, its number among the shapes of the highest degree, and its sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Local {
    pub unknown: u32,
    pub shape: u16,
    pub sign: f64,
}

/// A scalar space: one unknown a corner, then those of the edges, then those inside of the triangles.
#[derive(Debug)]
pub(crate) struct Space<'a> {
    pub mesh: &'a Mesh,
    pub topology: &'a Topology,
    /// Highest degree of all.
    pub degree: usize,
    degrees: &'a [usize],
    edge_degrees: Vec<usize>,
    edge_first: Vec<u32>,
    inner_first: Vec<u32>,
    /// Number of unknowns.
    pub count: usize,
}

impl<'a> Space<'a> {
    /// The space of `degrees`, one a triangle; an edge takes the higher one of its two triangles.
    pub fn new(mesh: &'a Mesh, topology: &'a Topology, degrees: &'a [usize]) -> Space<'a> {
        let degree = degrees.iter().copied().max().unwrap_or(1);
        let of = |t: u32| if t == NONE { 1 } else { degrees[t as usize] };
        let edge_degrees: Vec<usize> = topology.edge_triangles.iter().map(|t| of(t[0]).max(of(t[1]))).collect();
        let mut next = mesh.points.len() as u32;
        let mut give = |n: usize| {
            next += n as u32;
            next - n as u32
        };
        let edge_first = edge_degrees.iter().map(|d| give(d - 1)).collect();
        let inner_first = degrees.iter().map(|&d| give(inside(degree, d).len())).collect();
        Space { mesh, topology, degree, degrees, edge_degrees, edge_first, inner_first, count: next as usize }
    }

    /// The shapes of a triangle.
    pub fn of(&self, triangle: usize) -> Vec<Local> {
        let corners = self.mesh.triangles[triangle];
        let mut out: Vec<Local> = (0..3).map(|k| Local { unknown: corners[k], shape: k as u16, sign: 1.0 }).collect();
        for k in 0..3 {
            let edge = self.topology.triangle_edges[triangle][k] as usize;
            let turned = corners[k] > corners[(k + 1) % 3];
            out.extend((2..=self.edge_degrees[edge]).map(|d| Local {
                unknown: self.edge_first[edge] + d as u32 - 2,
                shape: on_edge(self.degree, k, d) as u16,
                sign: if turned && d % 2 == 1 { -1.0 } else { 1.0 },
            }));
        }
        let inner = inside(self.degree, self.degrees[triangle]);
        out.extend(inner.zip(self.inner_first[triangle]..).map(|(shape, unknown)| Local {
            unknown,
            shape: shape as u16,
            sign: 1.0,
        }));
        out
    }

    /// The unknowns of an edge between two corners, with their signs as walked from the first one: start, end, degree 2, 3, ...
    pub fn on_edge(&self, [a, b]: [u32; 2]) -> Vec<(u32, f64)> {
        let mut out = vec![(a, 1.0), (b, 1.0)];
        if let Some(edge) = self.topology.edge(a, b) {
            let sign = |d: usize| if a > b && d % 2 == 1 { -1.0 } else { 1.0 };
            out.extend((2..=self.edge_degrees[edge]).map(|d| (self.edge_first[edge] + d as u32 - 2, sign(d))));
        }
        out
    }
}
