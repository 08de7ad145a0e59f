//! Whitened maximum a posteriori fits in units of the prior's standard deviations, with Laplace evidence.
//!
//! Limits: one mode; the caller gives the starting point.

use crate::{
    fit::tuning::REACHED,
    fit::{few_jumps::few_jumps, laplace, model::Kinds, prior::Prior},
};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use std::{ops::Range, sync::Arc};

/// A fit at the optimum of its linearised objective.
pub struct Linearised {
    /// whitened residual there; that of the fit itself where it has converged
    pub residual: DVector<f64>,
    /// what calibration can take up of a whitened column b: the squared length of `taken^T b`; n x (free parameters)
    pub taken: DMatrix<f64>,
    /// by how much the objective is lower there
    pub promise: f64,
}

impl Linearised {
    /// Whether the straight step there promises next to nothing: where it promises more, the search has stopped short, and what is linear in the fit says little.
    pub fn is_reached(&self) -> bool {
        self.promise < REACHED
    }
}

/// A fit at its optimum; what has a number for each row is shared by its copies.
#[derive(Clone)]
pub struct Fit {
    /// most probable point, prior-whitened
    pub z: Vec<f64>,
    /// standard deviations, prior-whitened
    pub sd: Vec<f64>,
    /// sum of squares of the whitened residual
    pub chi2: f64,
    /// whitened residual
    pub residual: Arc<Vec<f64>>,
    /// whitened Jacobian at the optimum
    pub jacobian: Arc<DMatrix<f64>>,
    /// what is known of the parameters, there
    pub(crate) prior: Prior,
    /// J^T J and the curvature of the prior
    pub hessian: DMatrix<f64>,
    /// which parameters lie on a bound
    pub at_limit: Vec<bool>,
    /// parameters of each effect without an equation: a size, and jumps in sizes
    pub free_form: Vec<Range<usize>>,
    /// log evidence, up to a constant common to all models of one noise model
    pub log_evidence: f64,
    /// the part of it that comes from sizes whose order of magnitude is not known, and from jumps of which a few may be all
    pub scale_gain: f64,
    /// steps taken
    pub iterations: usize,
    /// whether the last step was small
    pub converged: bool,
}

impl Fit {
    /// Objective: half of chi2 and of the prior's penalty.
    pub fn objective(&self) -> f64 {
        0.5 * (self.chi2 + self.prior.penalty())
    }

    /// What it explains beyond another fit of the same rows, in units of the noise variance: twice the fall of the objective.
    pub fn explains_beyond(&self, other: &Self) -> f64 {
        2.0 * (other.objective() - self.objective())
    }

    /// How little its numbers are to be believed after what is known beforehand: the prior's penalty, in squares of its standard deviations.
    pub fn disbelief(&self) -> f64 {
        self.prior.penalty()
    }

    /// Log evidence where differences count for `temper` times less, because equations may be off.
    ///
    /// What has no equation has nothing that could be off, but freedom enough to follow what others leave: its freedom is paid for in full, at noise of
    /// `temper` times the variance.
    pub fn tempered(&self, temper: f64) -> f64 {
        let freedom = |temper: f64| {
            let known = DMatrix::from_diagonal(&DVector::from_iterator(self.z.len(), self.prior.curvature()));
            let hessian = (&self.hessian - &known) / temper + known;
            let fixed: Vec<usize> = (0..self.z.len()).filter(|i| !self.free_form.iter().any(|own| own.contains(i))).collect();
            let others = hessian.select_rows(&fixed).select_columns(&fixed);
            [hessian, others].map(|h| Cholesky::new(h).map_or(0.0, |f| laplace::log_determinant(&f)))
        };
        if self.free_form.is_empty() {
            return self.log_evidence / temper;
        }
        let few = |louder| -> f64 {
            self.free_form.iter().map(|steps| few_jumps(&self.hessian, &self.z, steps, &self.at_limit, louder)).sum()
        };
        // freedom that is paid for, less what is not where a few jumps are all
        let [paid, due] =
            [1.0, temper].map(|temper| (freedom(temper), few(temper))).map(|([all, others], few)| 0.5 * (all - others) - few);
        (self.log_evidence + paid) / temper - due
    }

    /// Standard deviations by which the objective falls beyond where parameter `index` is, the others free: 0 inside its bounds, where a fit has converged.
    pub fn pull(&self, index: usize) -> f64 {
        let known = self.prior.gradient().nth(index).unwrap_or(0.0);
        let gradient = known - self.jacobian.column(index).dot(&DVector::from_column_slice(&self.residual));
        gradient.abs() * self.sd[index]
    }

    /// Cholesky factor of the Hessian.
    pub fn factor(&self) -> Option<Cholesky<f64, Dyn>> {
        Cholesky::new(self.hessian.clone())
    }

    /// The linearised objective at its optimum; parameters on a bound stay there.
    ///
    /// By an orthogonal factorisation of the Jacobian above what is known beforehand: products of the Jacobian with itself lose, along a sloppy direction, what the
    /// scores of a direction consist of.
    pub fn linearised(&self) -> Linearised {
        let free: Vec<usize> = (0..self.z.len()).filter(|i| !self.at_limit[*i]).collect();
        let (rows, count) = (self.residual.len(), free.len());
        let stacked = DMatrix::from_fn(rows + count, count, |row, k| match row.checked_sub(rows) {
            None => self.jacobian[(row, free[k])],
            Some(own) if own == k => self.prior.slope[free[k]],
            Some(_) => 0.0,
        });
        let known = free.iter().map(|i| -self.prior.residual[*i]);
        let here = DVector::from_iterator(rows + count, self.residual.iter().copied().chain(known));
        let basis = stacked.qr().q();
        let along = basis.tr_mul(&here);
        let residual = (&here - &basis * &along).rows(0, rows).into_owned();
        Linearised { residual, taken: basis.rows(0, rows).into_owned(), promise: 0.5 * along.norm_squared() }
    }
}

/// `J^T J`, each pair of columns once.
pub(crate) fn gram(jacobian: &DMatrix<f64>) -> DMatrix<f64> {
    let n = jacobian.ncols();
    let mut gram = DMatrix::zeros(n, n);
    for i in 0..n {
        for j in 0..=i {
            gram[(i, j)] = jacobian.column(i).dot(&jacobian.column(j));
            gram[(j, i)] = gram[(i, j)];
        }
    }
    gram
}

/// A fit from where a search has ended.
pub(crate) fn finish(
    z: Vec<f64>,
    residual: Vec<f64>,
    jacobian: DMatrix<f64>,
    bounds: &[(f64, f64)],
    Kinds { open_sizes, free_form, known }: Kinds,
    (iterations, converged): (usize, bool),
) -> Fit {
    let prior = Prior::at(&z, known);
    let mut hessian = gram(&jacobian);
    prior.curvature().enumerate().for_each(|(i, curvature)| hessian[(i, i)] += curvature);
    let chi2 = residual.iter().map(|r| r * r).sum();
    let gradient = DVector::from_iterator(z.len(), prior.gradient()) - jacobian.tr_mul(&DVector::from_column_slice(&residual));
    let at_limit: Vec<bool> =
        z.iter().zip(bounds).map(|(z, b)| laplace::on_bound(*z, b.0) || laplace::on_bound(*z, b.1)).collect();
    // a curvature that has no inverse gives no errors: NaN, which texts write as a dash and JSON as null, so that a fit without errors is still a fit
    let sd: Vec<f64> = Cholesky::new(hessian.clone())
        .map(|f| f.inverse().diagonal().iter().map(|v| v.sqrt()).collect())
        .unwrap_or_else(|| vec![f64::NAN; z.len()]);
    let gain = |i: &usize| laplace::any_scale(z[*i], sd[*i] * sd[*i], gradient[*i], bounds[*i]);
    let scales: f64 = open_sizes.iter().map(gain).filter(|gain| gain.is_finite()).sum();
    let scale_gain = scales + free_form.iter().map(|steps| few_jumps(&hessian, &z, steps, &at_limit, 1.0)).sum::<f64>();
    let log_evidence = laplace::laplace(chi2, &z, prior.penalty(), &hessian, gradient.as_slice(), bounds) + scale_gain;
    let (residual, jacobian) = (Arc::new(residual), Arc::new(jacobian));
    Fit { z, sd, chi2, residual, jacobian, prior, hessian, at_limit, free_form, log_evidence, scale_gain, iterations, converged }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One number held at 2 that the recording wants at 5, known to 0.1: thirty deviations, less what the prior holds back.
    #[test]
    fn a_number_on_its_limit_is_pulled_by_as_many_deviations_as_it_is_off() {
        let (slope, wanted, limit): (f64, f64, f64) = (10.0, 5.0, 2.0);
        let bounds = [(f64::NEG_INFINITY, limit)];
        let residual = vec![slope * (wanted - limit)];
        let fit = finish(vec![limit], residual, DMatrix::from_element(1, 1, slope), &bounds, Kinds::default(), (1, true));
        // the other route: the optimum without the limit is slope^2 wanted / (slope^2 + 1), its deviation 1 / sqrt(slope^2 + 1)
        let precision = slope * slope + 1.0;
        approx::assert_relative_eq!(
            fit.pull(0),
            (slope * slope * wanted / precision - limit) * precision.sqrt(),
            max_relative = 1e-12
        );
    }

    /// Two columns that have nothing in common, one of them without an equation: at noise of `t` times the variance it costs `ln(1 + a^2 / t) / 2`, and all
    /// else is divided by `t`.
    #[test]
    fn what_has_no_equation_pays_for_its_freedom_in_full() {
        let (law, free, temper) = (30.0, 200.0, 7.0);
        let jacobian = DMatrix::from_row_slice(2, 2, &[law, 0.0, 0.0, free]);
        let bounds = [(f64::NEG_INFINITY, f64::INFINITY); 2];
        let second = 1..2;
        let kinds = Kinds { free_form: vec![second], ..Kinds::default() };
        let fit = finish(vec![0.5, 0.5], vec![3.0, 4.0], jacobian, &bounds, kinds, (1, true));
        let (chi2, size) = (25.0, 0.5);
        let paid = |entry: f64| 0.5 * f64::ln(1.0 + entry * entry);
        let exact = -(0.5 * (chi2 + size) + paid(law)) / temper - paid(free / temper.sqrt());
        approx::assert_relative_eq!(fit.tempered(temper), exact, max_relative = 1e-12);
        approx::assert_relative_eq!(fit.tempered(1.0), fit.log_evidence, max_relative = 1e-12);
    }
}
