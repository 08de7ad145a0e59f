//! Symmetric systems whose entries lie near the diagonal, solved by factors L D Lᵀ.
//!
//! Limits: four entries a row, no pivots: positive definite matrices.

/// Half the width of the band: two values a node, two nodes an element.
const BAND: usize = 4;

/// A symmetric system whose entries lie near the diagonal; `rows[i][j]` is the entry in column `i - j`.
#[derive(Clone)]
pub(super) struct Banded {
    rows: Vec<[f64; BAND]>,
    pub right: Vec<f64>,
}

impl Banded {
    pub(super) fn new(count: usize) -> Self {
        Self { rows: vec![[0.0; BAND]; count], right: vec![0.0; count] }
    }

    /// Adds to an entry of the lower half.
    pub(super) fn add(&mut self, row: usize, column: usize, value: f64) {
        self.rows[row][row - column] += value;
    }

    /// Gives an unknown a value.
    pub(super) fn fix(&mut self, unknown: usize, value: f64) {
        for near in unknown.saturating_sub(BAND - 1)..self.rows.len().min(unknown + BAND) {
            self.right[near] -= value * self.entry(near, unknown);
            self.rows[near.max(unknown)][near.abs_diff(unknown)] = 0.0;
        }
        self.rows[unknown][0] = 1.0;
        self.right[unknown] = value;
    }

    fn entry(&self, row: usize, column: usize) -> f64 {
        self.rows[row.max(column)][row.abs_diff(column)]
    }

    /// What is left over in an equation where the unknowns have these values: the force that holds it.
    pub(super) fn residual(&self, row: usize, values: &[f64]) -> f64 {
        let near = row.saturating_sub(BAND - 1)..self.rows.len().min(row + BAND);
        near.map(|column| self.entry(row, column) * values[column]).sum::<f64>() - self.right[row]
    }

    /// Factors L D Lᵀ of the matrix, in its place.
    pub(super) fn factored(mut self) -> Factored {
        for i in 0..self.rows.len() {
            // rows above the first are those of the identity
            let [first, second, third] = [1, 2, 3].map(|k| if i >= k { self.rows[i - k] } else { [1.0, 0.0, 0.0, 0.0] });
            let [own, a, b, c] = self.rows[i];
            let c = c / third[0];
            let b = (b - c * third[0] * second[1]) / second[0];
            let a = (a - c * third[0] * first[2] - b * second[0] * first[1]) / first[0];
            self.rows[i] = [own - a * a * first[0] - b * b * second[0] - c * c * third[0], a, b, c];
        }
        Factored { rows: self.rows }
    }

    /// The solution.
    pub(super) fn solved(mut self) -> Vec<f64> {
        let right = std::mem::take(&mut self.right);
        self.factored().solve(right)
    }
}

/// A factored matrix.
pub(super) struct Factored {
    rows: Vec<[f64; BAND]>,
}

impl Factored {
    /// The solution for a right side.
    pub(super) fn solve(&self, mut right: Vec<f64>) -> Vec<f64> {
        let count = right.len();
        for i in 0..count {
            let above: f64 = (1..BAND.min(i + 1)).map(|k| self.rows[i][k] * right[i - k]).sum();
            right[i] -= above;
        }
        for i in (0..count).rev() {
            let below: f64 = (1..BAND.min(count - i)).map(|k| self.rows[i + k][k] * right[i + k]).sum();
            right[i] = right[i] / self.rows[i][0] - below;
        }
        right
    }
}
