//! The part of the load stiffness that is not symmetric: two entries at each node where a following pressure ends.
//!
//! The factorised matrix is symmetric. With `A = U C U'` for these nodes, `(S + A)^-1` follows from a few more solutions
//! with `S` (Woodbury's formula), so that Newton's method keeps its order and dual problems their transpose. At a
//! support, on the axis, and on a closed surface there is nothing to add.

use super::body::Body;
use nalgebra::{DMatrix, DVector};

/// Skew entries at one node: `K[first][second] += size`, `K[second][first] -= size`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct End {
    /// The node.
    pub node: usize,
    /// Their size (N/m, or N/m^2 in planar bodies).
    pub size: f64,
}

/// The ends at a state and load factor.
pub(crate) fn ends(body: &Body, state: &[f64], load: f64) -> Vec<End> {
    let at = |j: &super::pressure::Jump| {
        let r = body.nodes.points[j.node][0] + state[2 * j.node];
        End { node: j.node, size: 0.5 * load * j.pressure * body.problem.symmetry.weight(r) }
    };
    body.jumps.iter().map(at).collect()
}

/// Adds the product of the skew entries (`way` 1) or of their transpose (`way` -1) with `x`.
pub(crate) fn add_product(ends: &[End], x: &[f64], way: f64, out: &mut [f64]) {
    for end in ends {
        let [a, b] = [2 * end.node, 2 * end.node + 1];
        out[a] += way * end.size * x[b];
        out[b] -= way * end.size * x[a];
    }
}

/// What turns a solution with the symmetric part into one with the whole matrix.
#[derive(Debug, Default)]
pub(crate) struct EndCorrection {
    rows: Vec<[usize; 2]>,
    sizes: Vec<f64>,
    /// Solutions for a unit force at each row, two a node.
    unit: Vec<Vec<f64>>,
}

impl EndCorrection {
    /// Prepares the nodes that are free in both directions; `solve` applies the inverse of the symmetric part.
    pub fn new(body: &Body, ends: &[End], mut solve: impl FnMut(&mut [f64])) -> EndCorrection {
        let mut out = EndCorrection::default();
        for end in ends {
            let dofs = [2 * end.node, 2 * end.node + 1];
            if dofs.iter().any(|&d| body.fixed[d]) || end.size == 0.0 {
                continue;
            }
            let rows = dofs.map(|d| body.numbering.rows[d] as usize);
            for row in rows {
                let mut x = vec![0.0; body.numbering.free.len()];
                x[row] = 1.0;
                solve(&mut x);
                out.unit.push(x);
            }
            out.rows.push(rows);
            out.sizes.push(end.size);
        }
        out
    }

    /// Corrects `x`, a solution with the symmetric part, for the skew entries (`way` 1) or their transpose (`way` -1):
    /// `x - Z (I + C U'Z)^-1 C U'x`.
    pub fn apply(&self, x: &mut [f64], way: f64) {
        let n = self.unit.len();
        if n == 0 {
            return;
        }
        // The rows of C U', applied to a vector.
        let skew = |v: &[f64]| {
            let pair = |(rows, size): (&[usize; 2], &f64)| [way * size * v[rows[1]], -way * size * v[rows[0]]];
            self.rows.iter().zip(&self.sizes).flat_map(pair).collect::<Vec<f64>>()
        };
        let columns: Vec<Vec<f64>> = self.unit.iter().map(|z| skew(z)).collect();
        let matrix = DMatrix::from_fn(n, n, |i, j| columns[j][i] + f64::from(u8::from(i == j)));
        let Some(part) = matrix.lu().solve(&DVector::from_vec(skew(x))) else {
            // A singular tangent: the load step is cut.
            x.fill(f64::NAN);
            return;
        };
        for (z, part) in self.unit.iter().zip(part.iter()) {
            x.iter_mut().zip(z).for_each(|(x, z)| *x -= part * z);
        }
    }
}
