//! The map from the reference triangle to a six-node element, and from the unit interval to a three-node edge.

use super::shape::{P2, Shape, ShapeTable, edge_shape};
use crate::mesh::{Mesh, Point, Topology};

/// Positions of all quadratic nodes of a mesh: corners, then the middle of every edge (m).
#[derive(Debug, Clone, PartialEq)]
pub struct Nodes {
    /// Corners first, then one node an edge.
    pub points: Vec<Point>,
    /// The six nodes of every triangle.
    pub triangles: Vec<[u32; 6]>,
    /// Number of corners.
    pub corners: usize,
}

impl Nodes {
    /// Numbers the quadratic nodes of a mesh.
    pub fn new(mesh: &Mesh, topology: &Topology) -> Nodes {
        let corners = mesh.points.len();
        let mut points = mesh.points.clone();
        points.extend(topology.middles(mesh));
        let middle = |edge: u32| corners as u32 + edge;
        let triangles = mesh
            .triangles
            .iter()
            .zip(&topology.triangle_edges)
            .map(|(c, e)| [c[0], c[1], c[2], middle(e[0]), middle(e[1]), middle(e[2])])
            .collect();
        Nodes { points, triangles, corners }
    }

    /// The element of a triangle.
    #[inline]
    pub fn element(&self, triangle: usize) -> Element {
        Element { nodes: self.triangles[triangle].map(|i| self.points[i as usize]) }
    }

    /// The three nodes (start, end, middle) of the edge between two corners.
    pub fn edge(&self, topology: &Topology, [a, b]: [u32; 2]) -> Option<[u32; 3]> {
        topology.edge(a, b).map(|edge| [a, b, (self.corners + edge) as u32])
    }
}

/// A six-node triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Element {
    /// Corners, then middles of the edges 0-1, 1-2, 2-0 (m).
    pub nodes: [Point; 6],
}

/// Where a quadrature point lies and how lengths change there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointMap {
    /// Position (m).
    pub at: Point,
    /// Jacobian determinant: twice the area of the triangle if it is straight (m^2).
    pub jacobian: f64,
    /// Inverse of the derivative of position by reference coordinates, `[reference][physical]` (1/m).
    pub inverse: [[f64; 2]; 2],
}

impl PointMap {
    /// Physical gradient of a function with the given reference slopes (1/m).
    #[inline]
    pub fn gradient(&self, slope: [f64; 2]) -> [f64; 2] {
        let g = &self.inverse;
        [slope[0] * g[0][0] + slope[1] * g[1][0], slope[0] * g[0][1] + slope[1] * g[1][1]]
    }

    /// Values and physical gradients of tabulated shapes.
    #[inline]
    pub fn shapes<const N: usize>(&self, table: &ShapeTable<N>) -> [Shape; N] {
        std::array::from_fn(|i| Shape { value: table.value[i], gradient: self.gradient(table.slope[i]) })
    }
}

/// A point of an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EdgePoint {
    /// Position (m).
    pub at: Point,
    /// Unit normal to the right of the direction of travel: outward if the domain lies to the left.
    pub normal: [f64; 2],
    /// Length per unit of the parameter (m).
    pub speed: f64,
    /// Values of the quadratic shapes (start, end, middle).
    pub value: [f64; 3],
}

impl Element {
    /// The map at a tabulated point of the quadratic shapes.
    #[inline]
    pub fn map(&self, table: &ShapeTable<6>) -> PointMap {
        self.map_with(&table.value, &table.slope)
    }

    /// The map at any reference point.
    pub fn map_at(&self, reference: [f64; 2]) -> PointMap {
        let (value, slope) = P2::at(reference);
        self.map_with(&value, &slope)
    }

    #[inline]
    fn map_with(&self, value: &[f64; 6], slope: &[[f64; 2]; 6]) -> PointMap {
        let (mut at, mut d) = ([0.0; 2], [[0.0; 2]; 2]);
        for (i, p) in self.nodes.iter().enumerate() {
            for k in 0..2 {
                at[k] += value[i] * p[k];
                d[0][k] += slope[i][0] * p[k];
                d[1][k] += slope[i][1] * p[k];
            }
        }
        let jacobian = d[0][0] * d[1][1] - d[0][1] * d[1][0];
        let s = 1.0 / jacobian;
        // d is [reference][physical]; its inverse is transposed here, so that rows belong to reference slopes.
        PointMap { at, jacobian, inverse: [[d[1][1] * s, -d[1][0] * s], [-d[0][1] * s, d[0][0] * s]] }
    }

    /// The point at `t` of the local edge `k` (from corner k to corner k + 1), domain to the left.
    pub(crate) fn edge_point(&self, k: usize, t: f64) -> EdgePoint {
        edge_point([self.nodes[k], self.nodes[(k + 1) % 3], self.nodes[k + 3]], t)
    }

    /// Reference coordinates of the point at `t` of the local edge `k`.
    pub(crate) fn edge_reference(k: usize, t: f64) -> [f64; 2] {
        match k {
            0 => [t, 0.0],
            1 => [1.0 - t, t],
            _ => [0.0, 1.0 - t],
        }
    }

    /// Reference coordinates of a physical point by Newton's method, or `None` where it lies outside by more than
    /// `slack` (in reference units).
    pub(crate) fn locate(&self, p: Point, slack: f64) -> Option<[f64; 2]> {
        let mut at = [1.0 / 3.0; 2];
        for _ in 0..20 {
            let map = self.map_at(at);
            let d = [p[0] - map.at[0], p[1] - map.at[1]];
            let step = [d[0] * map.inverse[0][0] + d[1] * map.inverse[0][1], d[0] * map.inverse[1][0] + d[1] * map.inverse[1][1]];
            at = [at[0] + step[0], at[1] + step[1]];
            if step[0].abs() + step[1].abs() < 1e-14 {
                break;
            }
        }
        let inside = at[0] >= -slack && at[1] >= -slack && at[0] + at[1] <= 1.0 + slack;
        inside.then_some(at)
    }
}

/// The point at `t` of an edge with the nodes (start, end, middle).
fn edge_point(nodes: [Point; 3], t: f64) -> EdgePoint {
    let (value, slope) = edge_shape(t);
    let sum = |w: [f64; 3], k: usize| (0..3).map(|i| w[i] * nodes[i][k]).sum::<f64>();
    let tangent = [sum(slope, 0), sum(slope, 1)];
    let speed = tangent[0].hypot(tangent[1]);
    EdgePoint { at: [sum(value, 0), sum(value, 1)], normal: [tangent[1] / speed, -tangent[0] / speed], speed, value }
}

/// Smallest Jacobian of a six-node triangle over its six nodes (m^2).
pub(crate) fn least_jacobian(nodes: &[Point; 6]) -> f64 {
    let element = Element { nodes: *nodes };
    [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]]
        .into_iter()
        .map(|p| element.map_at(p).jacobian)
        .fold(f64::INFINITY, f64::min)
}
