//! From element matrices and prescribed values to the energy products of the solutions.
//!
//! Unknowns that one element has for itself are eliminated from its matrix before anything is assembled: at the degree 6 three in five.
//! Nothing loads them, so that the reduced matrices hold the whole energy and the eliminated values are never needed.

use crate::algebra::{Direct, Kind, Pattern, SolveError, for_each_element};
use crate::space::{ElementDofs, Numbering};
use nalgebra::DMatrix;
use std::time::Instant;

/// Energy products `a(u_i, u_j)` of solutions, and what they cost.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Gram {
    pub products: DMatrix<f64>,
    /// Free unknowns, the eliminated ones included.
    pub unknowns: usize,
    /// Largest normwise backward error of the solves.
    pub residual: f64,
    /// Wall-clock seconds of factorising and solving.
    pub seconds: f64,
}

/// Solves without loads for every vector of `prescribed` (values of the unknowns that are `fixed`, zero elsewhere).
///
/// `element` gives the matrix of an element, full, column by column.
///
/// # Errors
/// Those of the solver: `NotPositiveDefinite` or `Singular` where a part of the body is not held.
pub(crate) fn gram(
    dofs: &ElementDofs,
    fixed: &[bool],
    prescribed: &[Vec<f64>],
    element: impl Fn(usize) -> Vec<f64> + Sync,
) -> Result<Gram, SolveError> {
    let own = own(dofs, fixed);
    let mut matrices = Vec::with_capacity(dofs.elements());
    let mut shared = ElementDofs::empty(dofs.count);
    let mut failed = None;
    let reduced = |e: usize| reduced(dofs.of(e), &own, &element(e));
    for_each_element(dofs.elements(), reduced, |e, m: Option<DMatrix<f64>>| {
        shared.push(&dofs.of(e).iter().copied().filter(|&d| !own[d as usize]).collect::<Vec<_>>());
        failed = failed.or(m.is_none().then_some(e));
        matrices.extend(m);
    });
    let unknowns = fixed.iter().filter(|f| !**f).count();
    if let Some(pivot) = failed {
        return Err(SolveError::NotPositiveDefinite { pivot, size: unknowns });
    }
    let numbering = Numbering::new(&fixed.iter().zip(&own).map(|(f, o)| *f || *o).collect::<Vec<_>>());
    let (mut matrix, scatter) = Pattern::new(&shared, &numbering)?.into_matrix();
    scatter.assemble(&mut matrix, |e, out| out.copy_from_slice(matrices[e].as_slice()));
    let begin = Instant::now();
    let mut direct = Direct::new(&matrix, Kind::Llt)?;
    let mut residual = 0.0f64;
    let mut solutions = Vec::new();
    for values in prescribed {
        let mut load = vec![0.0; dofs.count];
        for (e, k) in matrices.iter().enumerate() {
            let of = shared.of(e);
            for (j, v) in of.iter().map(|&d| values[d as usize]).enumerate().filter(|(_, v)| *v != 0.0) {
                of.iter().zip(&k.column(j)).for_each(|(&d, k)| load[d as usize] -= k * v);
            }
        }
        let solution = direct.solve(&matrix, &numbering.restrict(&load))?;
        residual = residual.max(solution.residual);
        let mut u = values.clone();
        numbering.scatter(&solution.x, &mut u);
        solutions.push(u);
    }
    let seconds = begin.elapsed().as_secs_f64();
    Ok(Gram { products: products(&shared, &matrices, &solutions), unknowns, residual, seconds })
}

/// Free unknowns that one element alone has.
fn own(dofs: &ElementDofs, fixed: &[bool]) -> Vec<bool> {
    let mut elements = vec![0u8; dofs.count];
    (0..dofs.elements()).flat_map(|e| dofs.of(e)).for_each(|&d| elements[d as usize] = elements[d as usize].saturating_add(1));
    elements.iter().zip(fixed).map(|(n, fixed)| *n == 1 && !fixed).collect()
}

/// The matrix of an element without its own unknowns; `None` where it is not positive definite in them.
fn reduced(of: &[u32], own: &[bool], matrix: &[f64]) -> Option<DMatrix<f64>> {
    let m = of.len();
    let (inner, outer): (Vec<usize>, Vec<usize>) = (0..m).partition(|&i| own[of[i] as usize]);
    let part =
        |rows: &[usize], columns: &[usize]| DMatrix::from_fn(rows.len(), columns.len(), |i, j| matrix[columns[j] * m + rows[i]]);
    let kept = part(&outer, &outer);
    if inner.is_empty() {
        return Some(kept);
    }
    let factor = part(&inner, &inner).cholesky()?;
    // with K_ii = L L^T: K_oo - (L^-1 K_io)^T (L^-1 K_io)
    let half = factor.l_dirty().solve_lower_triangular(&part(&inner, &outer))?;
    Some(kept - half.tr_mul(&half))
}

/// `u_i K u_j`, summed element by element.
fn products(dofs: &ElementDofs, matrices: &[DMatrix<f64>], solutions: &[Vec<f64>]) -> DMatrix<f64> {
    let mut out = DMatrix::zeros(solutions.len(), solutions.len());
    for (e, k) in matrices.iter().enumerate() {
        let of = dofs.of(e);
        let local = DMatrix::from_fn(of.len(), solutions.len(), |i, s| solutions[s][of[i] as usize]);
        out += local.tr_mul(&(k * &local));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of springs between 0 and 1, one of them with a free unknown of its own in the middle.
    #[test]
    fn eliminated_unknowns_leave_the_energy_as_it_is() {
        let mut dofs = ElementDofs::empty(4);
        dofs.push(&[0, 1]);
        dofs.push(&[1, 3, 2]);
        let springs = |e: usize| match e {
            0 => vec![2.0, -2.0, -2.0, 2.0],
            // 1 - 3 and 3 - 2, of 4 and 6
            _ => vec![4.0, -4.0, 0.0, -4.0, 10.0, -6.0, 0.0, -6.0, 6.0],
        };
        let found = gram(&dofs, &[true, false, true, false], &[vec![0.0, 0.0, 1.0, 0.0]], springs).expect("held at both ends");
        assert_eq!(found.unknowns, 2);
        let stiffness = 1.0 / (1.0 / 2.0 + 1.0 / 4.0 + 1.0 / 6.0);
        assert!((found.products[(0, 0)] - stiffness).abs() < 1e-14);
    }
}
