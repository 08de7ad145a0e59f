//! Sparse Cholesky (LLT) and LDLT with symbolic analysis done once, unit-diagonal scaling, one step of refinement
//! and a residual check.
//!
//! LDLT takes symmetric indefinite systems without pivoting: give every block a diagonal.

use super::error::SolveError;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::{ldlt::factor::LdltRegularization, llt::factor::LltRegularization};
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side, Spec};
use nalgebra_sparse::CscMatrix;

/// Largest normwise backward error that a solution may have after refinement.
pub(crate) const ALLOWED_RESIDUAL: f64 = 1e-11;
/// Backward error above which a step of refinement can still gain something.
const REFINE_ABOVE: f64 = 4.0 * f64::EPSILON;
/// Largest relative error of a known solution before the matrix counts as singular.
pub(crate) const ALLOWED_PROBE_ERROR: f64 = 0.05;

/// Which factorisation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Positive definite systems.
    Llt,
    /// Symmetric indefinite systems whose pivots exist in any order.
    Ldlt,
}

/// A solution and how well it satisfies its equations.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Values of the free unknowns.
    pub x: Vec<f64>,
    /// Normwise backward error of the scaled system: |b - A x| / (|A| |x| + |b|), maximum norms.
    pub residual: f64,
}

/// What a factorisation holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Memory {
    /// Entries of the factor.
    pub factor_entries: usize,
    /// Bytes of factor, scaled copy and workspace.
    pub bytes: usize,
}

/// A direct solver for matrices of one pattern.
pub struct Direct {
    kind: Kind,
    symbolic: SymbolicCholesky<usize>,
    scale: Vec<f64>,
    scaled: Vec<f64>,
    factor: Vec<f64>,
    workspace: MemBuffer,
    workspace_bytes: usize,
    norm: f64,
}

impl Direct {
    /// Orders and analyses the pattern of `matrix` (lower triangle); its values do not matter.
    pub fn analyse(matrix: &CscMatrix<f64>, kind: Kind) -> Result<Direct, SolveError> {
        let symbolic =
            factorize_symbolic_cholesky(pattern(matrix), Side::Lower, SymmetricOrdering::Amd, CholeskySymbolicParams::default())
                .map_err(|e| SolveError::Analysis { size: matrix.ncols(), reason: format!("{e:?}") })?;
        let factoring = match kind {
            Kind::Llt => symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default()),
            Kind::Ldlt => symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Spec::default()),
        };
        let request = factoring.or(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        Ok(Direct {
            kind,
            scale: vec![1.0; matrix.ncols()],
            scaled: vec![0.0; matrix.nnz()],
            factor: vec![0.0; symbolic.len_val()],
            workspace: MemBuffer::new(request),
            workspace_bytes: request.size_bytes(),
            symbolic,
            norm: f64::NAN,
        })
    }

    /// Analyses and factorises.
    pub fn new(matrix: &CscMatrix<f64>, kind: Kind) -> Result<Direct, SolveError> {
        let mut direct = Direct::analyse(matrix, kind)?;
        direct.factorise(matrix)?;
        Ok(direct)
    }

    /// Factorises a matrix of the analysed pattern, and checks with a known solution that it is not singular.
    pub fn factorise(&mut self, matrix: &CscMatrix<f64>) -> Result<(), SolveError> {
        self.factorise_unchecked(matrix)?;
        self.probe(matrix)
    }

    /// Factorises without the check for singularity (the sign of an indefinite tangent is asked for, not its solution).
    pub(crate) fn factorise_unchecked(&mut self, matrix: &CscMatrix<f64>) -> Result<(), SolveError> {
        if matrix.nnz() != self.scaled.len() || matrix.ncols() != self.scale.len() {
            return Err(SolveError::WrongPattern { got: matrix.nnz(), expected: self.scaled.len() });
        }
        self.rescale(matrix)?;
        let size = matrix.ncols();
        let a = SparseColMatRef::new(pattern(matrix), &self.scaled);
        let stack = MemStack::new(&mut self.workspace);
        match self.kind {
            Kind::Llt => {
                let rule = LltRegularization::default();
                let done =
                    self.symbolic.factorize_numeric_llt(&mut self.factor, a, Side::Lower, rule, Par::Seq, stack, Spec::default());
                let faer::linalg::cholesky::llt::factor::LltError::NonPositivePivot { index } = match done {
                    Ok(_) => return Ok(()),
                    Err(e) => e,
                };
                Err(SolveError::NotPositiveDefinite { pivot: index, size })
            }
            Kind::Ldlt => {
                let rule = LdltRegularization::default();
                let done = self.symbolic.factorize_numeric_ldlt(
                    &mut self.factor,
                    a,
                    Side::Lower,
                    rule,
                    Par::Seq,
                    stack,
                    Spec::default(),
                );
                done.map(|_| ()).map_err(|_| SolveError::Singular { error: f64::INFINITY, size })
            }
        }
    }

    fn rescale(&mut self, matrix: &CscMatrix<f64>) -> Result<(), SolveError> {
        let (offsets, rows, values) = matrix.csc_data();
        for j in 0..matrix.ncols() {
            // The diagonal comes first in a lower column.
            let d = values[offsets[j]].abs();
            self.scale[j] = if d > 0.0 { 1.0 / d.sqrt() } else { 1.0 };
        }
        for j in 0..matrix.ncols() {
            for k in offsets[j]..offsets[j + 1] {
                self.scaled[k] = values[k] * self.scale[j] * self.scale[rows[k]];
                if !self.scaled[k].is_finite() {
                    return Err(SolveError::NotFinite { column: j });
                }
            }
        }
        let sizes: Vec<f64> = self.scaled.iter().map(|v| v.abs()).collect();
        self.norm = largest(&symmetric_product(offsets, rows, &sizes, &vec![1.0; matrix.ncols()]));
        Ok(())
    }

    /// Solves a system whose solution is known; a singular matrix does not give it back.
    fn probe(&mut self, matrix: &CscMatrix<f64>) -> Result<(), SolveError> {
        let size = self.scale.len();
        // Uneven entries, so that no kernel is orthogonal to them by symmetry.
        let known: Vec<f64> = (0..size).map(|i| 1.0 + 0.5 * (i as f64 * 0.754_877_666).fract()).collect();
        let mut y = self.product(matrix, &known);
        self.back_substitute(&mut y);
        let error =
            known.iter().zip(&y).fold(0.0, |m: f64, (k, y)| if (k - y).is_nan() { f64::INFINITY } else { m.max((k - y).abs()) });
        if error > ALLOWED_PROBE_ERROR { Err(SolveError::Singular { error, size }) } else { Ok(()) }
    }

    /// Solves for one right-hand side, with one step of refinement where rounding leaves room for it, and a check of the
    /// residual.
    ///
    /// `matrix` is the one that was factorised.
    pub fn solve(&mut self, matrix: &CscMatrix<f64>, rhs: &[f64]) -> Result<Solution, SolveError> {
        let b: Vec<f64> = rhs.iter().zip(&self.scale).map(|(b, s)| b * s).collect();
        let mut y = b.clone();
        self.back_substitute(&mut y);
        let (mut r, mut residual) = self.residual(matrix, &b, &y);
        if !(residual <= REFINE_ABOVE) {
            self.back_substitute(&mut r);
            y.iter_mut().zip(&r).for_each(|(y, r)| *y += r);
            residual = self.residual(matrix, &b, &y).1;
        }
        if !(residual <= ALLOWED_RESIDUAL) {
            return Err(SolveError::Residual { residual, allowed: ALLOWED_RESIDUAL, size: b.len() });
        }
        Ok(Solution { x: y.iter().zip(&self.scale).map(|(y, s)| y * s).collect(), residual })
    }

    /// Applies the inverse of the factorised matrix to a vector, without refinement or check; for iterations.
    pub(crate) fn apply_inverse(&mut self, vector: &mut [f64]) {
        vector.iter_mut().zip(&self.scale).for_each(|(x, s)| *x *= s);
        self.back_substitute(vector);
        vector.iter_mut().zip(&self.scale).for_each(|(x, s)| *x *= s);
    }

    fn back_substitute(&mut self, x: &mut [f64]) {
        let n = x.len();
        let rhs = MatMut::from_column_major_slice_mut(x, n, 1);
        let stack = MemStack::new(&mut self.workspace);
        match self.kind {
            Kind::Llt => LltRef::new(&self.symbolic, &self.factor).solve_in_place_with_conj(Conj::No, rhs, Par::Seq, stack),
            Kind::Ldlt => LdltRef::new(&self.symbolic, &self.factor).solve_in_place_with_conj(Conj::No, rhs, Par::Seq, stack),
        }
    }

    fn product(&self, matrix: &CscMatrix<f64>, x: &[f64]) -> Vec<f64> {
        let (offsets, rows, _) = matrix.csc_data();
        symmetric_product(offsets, rows, &self.scaled, x)
    }

    /// What is left of the scaled equations, and the normwise backward error.
    fn residual(&self, matrix: &CscMatrix<f64>, b: &[f64], y: &[f64]) -> (Vec<f64>, f64) {
        let r: Vec<f64> = b.iter().zip(self.product(matrix, y)).map(|(b, a)| b - a).collect();
        let below = self.norm * largest(y) + largest(b);
        let error = if below == 0.0 { largest(&r) } else { largest(&r) / below };
        (r, error)
    }

    /// What the factorisation holds.
    pub fn memory(&self) -> Memory {
        let floats = self.factor.len() + self.scaled.len() + self.scale.len();
        Memory { factor_entries: self.factor.len(), bytes: 8 * floats + self.workspace_bytes }
    }
}

/// Largest magnitude; NaN if any entry is NaN.
pub(crate) fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m, v| if v.is_nan() || v.abs() > m { v.abs() } else { m })
}

fn pattern(matrix: &CscMatrix<f64>) -> SymbolicSparseColMatRef<'_, usize> {
    let (offsets, rows, _) = matrix.csc_data();
    SymbolicSparseColMatRef::new_checked(matrix.nrows(), matrix.ncols(), offsets, None, rows)
}

/// Product of a symmetric matrix, given by its lower triangle, with a vector.
fn symmetric_product(offsets: &[usize], rows: &[usize], values: &[f64], x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; x.len()];
    for j in 0..x.len() {
        let mut sum = 0.0;
        for k in offsets[j]..offsets[j + 1] {
            let i = rows[k];
            sum += values[k] * x[i];
            if i != j {
                y[i] += values[k] * x[j];
            }
        }
        y[j] += sum;
    }
    y
}
