//! Shape functions on the reference triangle (0,0), (1,0), (0,1).
//!
//! Quadratic nodes: corners 0, 1, 2, then the middles of the edges 0-1, 1-2, 2-0 (the order of gmsh and VTK).

use super::quadrature::QuadraturePoint;

/// Value and gradient of one shape function at a point, in physical coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shape {
    /// Value.
    pub value: f64,
    /// Derivatives along the first and second coordinate (1/m).
    pub gradient: [f64; 2],
}

/// Values and reference derivatives of `N` shape functions at one quadrature point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShapeTable<const N: usize> {
    /// Weight of the point on the reference triangle (all weights sum to 1/2).
    pub weight: f64,
    /// Values.
    pub value: [f64; N],
    /// Derivatives along the two reference coordinates.
    pub slope: [[f64; 2]; N],
}

/// Which shapes a solution is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Order {
    /// Three-node triangles; for comparison only: they converge slowly, and lock in bending and near incompressibility.
    Linear,
    /// Six-node triangles.
    #[default]
    Quadratic,
}

impl Order {
    /// Nodes of an element.
    pub fn nodes(self) -> usize {
        match self {
            Order::Linear => 3,
            Order::Quadratic => 6,
        }
    }
}

/// Linear shapes.
pub struct P1;
/// Quadratic shapes.
pub struct P2;

impl P1 {
    /// Values and slopes at a reference point.
    pub fn at([x, y]: [f64; 2]) -> ([f64; 3], [[f64; 2]; 3]) {
        ([1.0 - x - y, x, y], [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]])
    }

    /// Tabulates at the points of a rule.
    pub fn table(rule: &[QuadraturePoint]) -> Vec<ShapeTable<3>> {
        rule.iter().map(|q| tabulated(q, P1::at(q.at))).collect()
    }
}

impl P2 {
    /// Values and slopes at a reference point.
    pub fn at([x, y]: [f64; 2]) -> ([f64; 6], [[f64; 2]; 6]) {
        let l = 1.0 - x - y;
        let value = [l * (2.0 * l - 1.0), x * (2.0 * x - 1.0), y * (2.0 * y - 1.0), 4.0 * l * x, 4.0 * x * y, 4.0 * y * l];
        let slope = [
            [1.0 - 4.0 * l, 1.0 - 4.0 * l],
            [4.0 * x - 1.0, 0.0],
            [0.0, 4.0 * y - 1.0],
            [4.0 * (l - x), -4.0 * x],
            [4.0 * y, 4.0 * x],
            [-4.0 * y, 4.0 * (l - y)],
        ];
        (value, slope)
    }

    /// Tabulates at the points of a rule.
    pub fn table(rule: &[QuadraturePoint]) -> Vec<ShapeTable<6>> {
        rule.iter().map(|q| tabulated(q, P2::at(q.at))).collect()
    }
}

fn tabulated<const N: usize>(q: &QuadraturePoint, (value, slope): ([f64; N], [[f64; 2]; N])) -> ShapeTable<N> {
    ShapeTable { weight: q.weight, value, slope }
}

/// Quadratic shapes of an edge at `t` in [0, 1], for its nodes (start, end, middle), and their derivatives by `t`.
pub(crate) fn edge_shape(t: f64) -> ([f64; 3], [f64; 3]) {
    let s = 1.0 - t;
    ([s * (s - t), t * (t - s), 4.0 * s * t], [4.0 * t - 3.0, 4.0 * t - 1.0, 4.0 - 8.0 * t])
}
