//! How likely a fitted model is under another noise than that of its fit.
//!
//! A model follows part of any noise: a slow one of a few memories it takes up nearly whole. So a likelihood of what it leaves falls for a quieter noise, and more so the more numbers it has. What its numbers
//! are free to take up is therefore paid for, as the evidence of a fit pays for it.
//!
//! **Source:** Patterson & Thompson, Biometrika 58 (1971) 545, with what is known of the numbers beforehand.
//!
//! Limits: linear about the fit; a number on a bound stays there.

use crate::{
    fit::{
        laplace::log_determinant,
        model::{Around, Model},
        optimum::Fit,
        prior::Prior,
    },
    whitening::whitener::Whitener,
};
use nalgebra::{Cholesky, DMatrix, DVector};
use truegap_core::SimulationError;

/// A fitted model, to be weighed under any noise.
pub(crate) struct UnderNoise {
    around: Around,
    prior: Prior,
    /// numbers that may move
    free: Vec<usize>,
}

impl UnderNoise {
    /// About the optimum of a fit of this model.
    ///
    /// # Errors
    /// Those of the simulator.
    pub(crate) fn of(model: &Model<'_>, fit: &Fit) -> Result<Self, SimulationError> {
        let free = (0..fit.z.len()).filter(|i| !fit.at_limit[*i]).collect();
        Ok(Self { around: model.around(&fit.z)?, prior: fit.prior.clone(), free })
    }

    /// Log density of what was recorded, all free numbers integrated over what is known of them, up to a constant that no noise changes; and the mean square of what the model leaves of a whitened row, the numbers
    /// where they are best.
    pub(crate) fn log_density(&self, whitener: &Whitener) -> (f64, f64) {
        let (residual, jacobian) = self.around.whitened(whitener);
        let residual = DVector::from_vec(residual);
        let columns = jacobian.select_columns(&self.free);
        let of_free = |all: &[f64]| DVector::from_iterator(self.free.len(), self.free.iter().map(|i| all[*i]));
        let (known, slope) = (of_free(&self.prior.residual), of_free(&self.prior.slope));
        let hessian = columns.tr_mul(&columns) + DMatrix::from_diagonal(&slope.component_mul(&slope));
        let Some(factor) = Cholesky::new(hessian) else { return (f64::NEG_INFINITY, f64::INFINITY) };
        let moved = factor.solve(&(columns.tr_mul(&residual) - slope.component_mul(&known)));
        let left = (residual - columns * &moved).norm_squared();
        let penalty = (known + slope.component_mul(&moved)).norm_squared();
        let density = -0.5 * (whitener.log_determinant + left + penalty + log_determinant(&factor));
        (density, left / whitener.rows.max(1) as f64)
    }

    /// Log density under a noise whose white part is as loud as the model leaves it beside the rest of its kind, from one of this `size`; that white part, and its filter.
    pub(crate) fn as_loud(&self, size: f64, filter: impl Fn(f64) -> Whitener) -> (f64, f64, Whitener) {
        let (_, square) = self.log_density(&filter(size));
        let size = size * square.sqrt();
        let filter = filter(size);
        (self.log_density(&filter).0, size, filter)
    }
}
