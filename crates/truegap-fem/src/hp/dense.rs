//! The first columns of a dense Cholesky factor, and what they leave of the rest.

use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::{Accum, MatMut, MatRef, Par};
use pulp::Arch;

/// Columns that are factorised before the others see them.
const BLOCK: usize = 32;
/// Rows from which a whole block of columns is subtracted by the library, whose kernels use wide registers.
const MANY: usize = 48;

/// A pivot that is not positive, counted from the first column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BadPivot {
    pub column: usize,
    pub value: f64,
}

/// Factorises the columns of `panel` in place, and subtracts from `rest` what their rows below contribute.
///
/// Both are lower triangles, column by column: `panel` has `n` rows, `rest` is square and has the last rows of it.
pub(super) fn eliminate(panel: &mut [f64], n: usize, rest: &mut [f64]) -> Result<(), BadPivot> {
    Arch::new().dispatch(|| eliminate_by_blocks(panel, n, rest))
}

#[inline(always)]
fn eliminate_by_blocks(panel: &mut [f64], n: usize, rest: &mut [f64]) -> Result<(), BadPivot> {
    let columns = panel.len().checked_div(n).unwrap_or(0);
    for first in (0..columns).step_by(BLOCK) {
        let last = columns.min(first + BLOCK);
        let (done, later) = panel.split_at_mut(last * n);
        let block = &mut done[first * n..];
        factorise(block, n, first)?;
        subtract(block, n, last, later, n);
        subtract(block, n, columns, rest, n - columns);
    }
    Ok(())
}

/// Cholesky of a block of columns, the first of which has its diagonal in the row `first`.
#[inline(always)]
fn factorise(block: &mut [f64], n: usize, first: usize) -> Result<(), BadPivot> {
    for j in 0..block.len() / n {
        let (before, own) = block.split_at_mut(j * n);
        let row = first + j;
        let column = &mut own[row..n];
        subtract_from_column(before, n, row, column);
        let value = column[0];
        if !(value > 0.0 && value.is_finite()) {
            return Err(BadPivot { column: row, value });
        }
        let scale = 1.0 / value.sqrt();
        for x in column {
            *x *= scale;
        }
    }
    Ok(())
}

/// Subtracts `B B^T` for the rows of `block` from `first` on from the lower triangle of `of`, columns of `stride` values whose diagonal begins
/// in the row `first` of the block where `stride` is the block's own, and in the row 0 else.
#[inline(always)]
fn subtract(block: &[f64], n: usize, first: usize, of: &mut [f64], stride: usize) {
    if of.is_empty() {
        return;
    }
    let (width, count, top) = (block.len() / n, of.len() / stride, stride - (n - first));
    if n - first < MANY || width < BLOCK / 2 {
        for (c, column) in of.chunks_exact_mut(stride).enumerate() {
            subtract_from_column(block, n, first + c, &mut column[top + c..]);
        }
        return;
    }
    let rows = MatRef::from_column_major_slice(block, n, width);
    let upper = rows.submatrix(first, 0, count, width);
    let lower = rows.submatrix(first + count, 0, n - first - count, width);
    let whole = MatMut::from_column_major_slice_mut(of, stride, count);
    let (square, below) = whole.subrows_mut(top, n - first).split_at_row_mut(count);
    let full = BlockStructure::Rectangular;
    matmul(square, BlockStructure::TriangularLower, Accum::Add, upper, full, upper.transpose(), full, -1.0, Par::Seq);
    if lower.nrows() > 0 {
        matmul(below, full, Accum::Add, lower, full, upper.transpose(), full, -1.0, Par::Seq);
    }
}

/// Subtracts from a column, which begins at its diagonal in the row `row`, the columns before it times their values in that row.
#[inline(always)]
fn subtract_from_column(before: &[f64], n: usize, row: usize, column: &mut [f64]) {
    // four at a time: a value is read and written once for all of them
    let mut fours = before.chunks_exact(4 * n);
    for four in &mut fours {
        let [a, b, c, d] = [0, 1, 2, 3].map(|q| &four[q * n + row..(q + 1) * n]);
        let [fa, fb, fc, fd] = [a[0], b[0], c[0], d[0]];
        for ((((x, a), b), c), d) in column.iter_mut().zip(a).zip(b).zip(c).zip(d) {
            *x -= fa * a + fb * b + fc * c + fd * d;
        }
    }
    for one in fours.remainder().chunks_exact(n) {
        let a = &one[row..];
        let factor = a[0];
        for (x, a) in column.iter_mut().zip(a) {
            *x -= factor * a;
        }
    }
}

/// Adds the product of the first rows and columns of a symmetric matrix, its lower triangle in columns of `n`, with a vector.
pub(super) fn multiply(matrix: &[f64], n: usize, x: &[f64], out: &mut [f64]) {
    Arch::new().dispatch(|| {
        for (c, column) in matrix.chunks_exact(n).enumerate().take(x.len()) {
            let below = &column[c + 1..x.len()];
            out[c] += column[c] * x[c] + dot(below, &x[c + 1..]);
            let factor = x[c];
            for (o, k) in out[c + 1..].iter_mut().zip(below) {
                *o += k * factor;
            }
        }
    });
}

/// Sum of products, as far as the shorter one goes; eight sums at a time, so that none waits for another.
#[inline(always)]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len().min(b.len());
    let (a, b) = (a[..n].chunks_exact(8), b[..n].chunks_exact(8));
    let mut tail = 0.0;
    for (a, b) in a.remainder().iter().zip(b.remainder()) {
        tail += a * b;
    }
    let mut sums = [0.0; 8];
    for (a, b) in a.zip(b) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a * b;
        }
    }
    let [a, b, c, d, e, f, g, h] = sums;
    ((a + b) + (c + d)) + ((e + f) + (g + h)) + tail
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;

    /// Uneven numbers, and a diagonal that outweighs them.
    fn matrix(n: usize) -> DMatrix<f64> {
        let at = |i: usize, j: usize| ((i * j + i + j) as f64 * 0.618).sin();
        DMatrix::from_fn(n, n, |i, j| if i == j { 2.0 * n as f64 } else { at(i, j) })
    }

    #[test]
    fn columns_and_rest_are_those_of_another_library() {
        for (n, k) in [(1, 1), (9, 3), (30, 30), (70, 10), (150, 80), (200, 33)] {
            let a = matrix(n);
            let mut panel: Vec<f64> = a.columns(0, k).iter().copied().collect();
            let mut rest: Vec<f64> = a.view((k, k), (n - k, n - k)).iter().copied().collect();
            assert_eq!(eliminate(&mut panel, n, &mut rest), Ok(()));
            let l = a.clone().cholesky().expect("positive definite").l();
            for j in 0..k {
                (j..n).for_each(|i| assert!((panel[j * n + i] - l[(i, j)]).abs() < 1e-12, "{n} {k}: {i} {j}"));
            }
            let below = l.view((k, k), (n - k, n - k));
            let expected = below * below.transpose();
            for j in 0..n - k {
                (j..n - k).for_each(|i| assert!((rest[j * (n - k) + i] - expected[(i, j)]).abs() < 1e-10, "{n} {k}: {i} {j}"));
            }
        }
    }

    #[test]
    fn products_are_those_of_another_library() {
        for n in [1, 7, 16, 29] {
            let a = matrix(n + 2);
            let x: Vec<f64> = (0..n).map(|i| 1.0 + i as f64).collect();
            let mut found = vec![1.0; n];
            multiply(a.lower_triangle().as_slice(), n + 2, &x, &mut found);
            let expected = a.lower_triangle().map_with_location(|i, j, _| a[(i.max(j), i.min(j))]);
            let expected = expected.view((0, 0), (n, n)) * nalgebra::DVector::from_column_slice(&x);
            (0..n).for_each(|i| assert!((found[i] - 1.0 - expected[i]).abs() < 1e-10, "{n}, {i}"));
        }
    }

    #[test]
    fn a_pivot_that_is_not_positive_is_told() {
        let mut panel = [1.0, 2.0, 2.0, 4.0];
        assert_eq!(eliminate(&mut panel, 2, &mut []), Err(BadPivot { column: 1, value: 0.0 }));
        let mut panel = [f64::NAN];
        assert!(eliminate(&mut panel, 1, &mut []).is_err());
    }
}
