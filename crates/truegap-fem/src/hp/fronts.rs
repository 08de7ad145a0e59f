//! Cholesky by fronts: each step adds up dense matrices of what it joins, eliminates its unknowns there and hands the rest on.
//!
//! Right-hand sides are further rows of every matrix that never leave. They meet all eliminations on the way, so that only the way back is
//! left for a solution; and no sparse pattern is ever made.
//!
//! **Source:** Duff & Reid, ACM Transactions on Mathematical Software 9 (1983) 302.

use super::dense::{BadPivot, dot, eliminate};
use super::order::{Order, Step};
use pulp::Arch;

/// A matrix over some unknowns and all right-hand sides, lower triangle, column by column.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Part {
    /// Numbers of the unknowns, ascending.
    pub rows: Vec<u32>,
    /// Square, of as many columns as unknowns and right-hand sides.
    pub matrix: Vec<f64>,
    /// Magnitudes of what prescribed values load the unknowns with, summed before anything cancels, side by side; empty where nothing is prescribed.
    pub loads: Vec<f64>,
}

/// The factor of a sum of parts, and the right-hand sides as far as they are forward substituted.
pub(super) struct Factor<'a> {
    order: &'a Order,
    sides: usize,
    columns: Vec<f64>,
    /// Where the columns of every step begin.
    starts: Vec<usize>,
}

impl<'a> Factor<'a> {
    /// Factorises the sum of the elements' parts, which have `sides` right-hand sides; `BadPivot` counts in the numbers of the order.
    pub fn new(order: &'a Order, elements: &[Part], sides: usize) -> Result<Factor<'a>, BadPivot> {
        let of_step = |s: &Step| s.pivots.len() * (s.pivots.len() + s.boundary.len() + sides);
        let entries = order.steps.iter().map(of_step).sum();
        let mut out =
            Factor { order, sides, columns: Vec::with_capacity(entries), starts: Vec::with_capacity(order.steps.len()) };
        let mut left: Vec<Vec<f64>> = Vec::with_capacity(order.steps.len());
        let mut place = vec![0; order.count];
        let mut to = Vec::new();
        for step in &order.steps {
            step.pivots.clone().chain(step.boundary.iter().copied()).enumerate().for_each(|(i, u)| place[u as usize] = i);
            let below = step.boundary.len() + sides;
            let n = step.pivots.len() + below;
            let start = out.columns.len();
            out.starts.push(start);
            out.columns.resize(start + n * step.pivots.len(), 0.0);
            let panel = &mut out.columns[start..];
            let mut rest = vec![0.0; below * below];
            for j in step.joined.iter().map(|j| *j as usize) {
                let earlier = j.checked_sub(elements.len());
                let rows = earlier.map_or_else(|| &elements[j].rows, |s| &order.steps[s].boundary);
                to.clear();
                to.extend(rows.iter().map(|&u| place[u as usize]).chain(n - sides..n));
                match earlier {
                    None => add(&elements[j].matrix, &to, panel, n, &mut rest),
                    Some(s) => add(&std::mem::take(&mut left[s]), &to, panel, n, &mut rest),
                }
            }
            let first = step.pivots.start as usize;
            eliminate(panel, n, &mut rest).map_err(|b| BadPivot { column: first + b.column, ..b })?;
            left.push(rest);
        }
        Ok(out)
    }

    /// The solution for one right-hand side, which stands on the left: the whole of each equation is zero.
    pub fn solution(&self, side: usize) -> Vec<f64> {
        Arch::new().dispatch(|| self.back_substituted(side))
    }

    #[inline(always)]
    fn back_substituted(&self, side: usize) -> Vec<f64> {
        let mut x = vec![0.0; self.order.count];
        let mut boundary = Vec::new();
        for (step, &start) in self.order.steps.iter().zip(&self.starts).rev() {
            let (first, k) = (step.pivots.start as usize, step.pivots.len());
            boundary.clear();
            boundary.extend(step.boundary.iter().map(|&u| x[u as usize]));
            let n = k + boundary.len() + self.sides;
            for q in (0..k).rev() {
                let column = &self.columns[start + q * n..start + (q + 1) * n];
                let (own, below) = column.split_at(k);
                let sum = dot(&own[q + 1..], &x[first + q + 1..first + k]) + dot(below, &boundary) + below[boundary.len() + side];
                x[first + q] = -sum / own[q];
            }
        }
        x
    }
}

/// Adds a matrix to a front, its rows and columns to the ascending places `to`.
fn add(matrix: &[f64], to: &[usize], panel: &mut [f64], n: usize, rest: &mut [f64]) {
    let (size, pivots) = (to.len(), panel.len() / n);
    for (c, &column) in to.iter().enumerate() {
        let (into, above) = match column.checked_sub(pivots) {
            None => (&mut panel[column * n..(column + 1) * n], 0),
            Some(column) => (&mut rest[column * (n - pivots)..(column + 1) * (n - pivots)], pivots),
        };
        for (row, value) in to[c..].iter().zip(&matrix[c * size + c..(c + 1) * size]) {
            into[row - above] += value;
        }
    }
}
