//! A smooth function of several numbers as a tensor product of Chebyshev polynomials, with its range and its measured accuracy.
//!
//! Limits: a box; asked outside of it, a table refuses.

use crate::{error::AuditError, fit::polynomials};
use serde::{Deserialize, Serialize};

/// One argument of a table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// quantity, dimensionless
    pub name: String,
    /// lower end
    pub low: f64,
    /// upper end
    pub high: f64,
    /// whether polynomials are in the logarithm
    pub logarithmic: bool,
    /// number of polynomials
    pub count: usize,
}

impl Axis {
    /// An axis that is even in the quantity itself.
    pub(crate) fn linear(name: &str, low: f64, high: f64, count: usize) -> Self {
        Self { name: name.into(), low, high, logarithmic: false, count }
    }

    /// An axis that is even in the logarithm.
    pub(crate) fn logarithmic(name: &str, low: f64, high: f64, count: usize) -> Self {
        Self { name: name.into(), low, high, logarithmic: true, count }
    }

    /// Values at which the table is computed: zeros of the next Chebyshev polynomial.
    pub(crate) fn nodes(&self) -> Vec<f64> {
        let reduced = |k: usize| (std::f64::consts::PI * (k as f64 + 0.5) / self.count as f64).cos();
        (0..self.count).map(|k| self.expanded(reduced(k))).collect()
    }

    /// The value at a position from -1 to 1.
    pub(crate) fn expanded(&self, t: f64) -> f64 {
        let share = 0.5 * (1.0 + t);
        if self.logarithmic { self.low * (self.high / self.low).powf(share) } else { self.low + share * (self.high - self.low) }
    }

    fn reduced(&self, x: f64) -> Result<f64, AuditError> {
        let slack = 1e-9 * (self.high - self.low);
        if !(x >= self.low - slack && x <= self.high + slack) {
            let remedy =
                "corrections cover the paper's design space; run `truegap audit`, which computes, for a sensor beyond it";
            return Err(AuditError::Uncovered { what: self.name.clone(), value: x, low: self.low, high: self.high, remedy });
        }
        let share = if self.logarithmic {
            (x / self.low).ln() / (self.high / self.low).ln()
        } else {
            (x - self.low) / (self.high - self.low)
        };
        Ok(2.0 * share - 1.0)
    }

    /// Polynomials at a value.
    fn polynomials(&self, x: f64) -> Result<Vec<f64>, AuditError> {
        Ok(polynomials(self.reduced(x)?, self.count))
    }
}

/// A table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// name
    pub id: String,
    /// what it gives, a sentence with the formula it enters
    pub says: String,
    /// the command that made it
    pub command: String,
    /// largest relative error at points between the nodes, measured against finite elements there
    pub accuracy: f64,
    /// number of points at which the accuracy was measured
    pub checked_at: usize,
    /// arguments
    pub axes: Vec<Axis>,
    /// coefficients, the last axis fastest
    pub coefficients: Vec<f64>,
}

impl Table {
    /// Interpolates values given at all nodes, the last axis fastest.
    pub(crate) fn interpolating(id: &str, says: &str, axes: Vec<Axis>, values: Vec<f64>) -> Self {
        let mut coefficients = values;
        for axis in 0..axes.len() {
            let inner: usize = axes[axis + 1..].iter().map(|a| a.count).product();
            coefficients = transformed(&coefficients, axes[axis].count, inner);
        }
        Self { id: id.into(), says: says.into(), command: String::new(), accuracy: f64::NAN, checked_at: 0, axes, coefficients }
    }

    /// All nodes, the last axis fastest.
    pub(crate) fn nodes(axes: &[Axis]) -> Vec<Vec<f64>> {
        let extend = |points: Vec<Vec<f64>>, axis: &Axis| {
            let longer = |p: &Vec<f64>| axis.nodes().into_iter().map(|x| [p.as_slice(), &[x]].concat()).collect::<Vec<_>>();
            points.iter().flat_map(longer).collect()
        };
        axes.iter().fold(vec![Vec::new()], extend)
    }

    /// The value at a point, in the order of the axes.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] outside of the box.
    pub fn at(&self, point: &[f64]) -> Result<f64, AuditError> {
        let mut rest = self.coefficients.clone();
        for (axis, &x) in self.axes.iter().zip(point) {
            rest = contracted(&rest, &axis.polynomials(x)?);
        }
        Ok(rest.first().copied().unwrap_or(f64::NAN))
    }

    /// The table with its first arguments given: what is left depends on the others.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] outside of the box.
    pub(crate) fn given(&self, first: &[f64]) -> Result<Self, AuditError> {
        let mut table = self.clone();
        for &x in first {
            let polynomials = table.axes[0].polynomials(x)?;
            table.coefficients = contracted(&table.coefficients, &polynomials);
            table.axes.remove(0);
        }
        Ok(table)
    }
}

/// Discrete cosine transform along one axis.
fn transformed(values: &[f64], count: usize, inner: usize) -> Vec<f64> {
    let mut out = vec![0.0; values.len()];
    for (block, chunk) in values.chunks(count * inner).enumerate() {
        for degree in 0..count {
            let scale = if degree == 0 { 1.0 } else { 2.0 } / count as f64;
            for k in 0..count {
                let t = (std::f64::consts::PI * degree as f64 * (k as f64 + 0.5) / count as f64).cos() * scale;
                for i in 0..inner {
                    out[block * count * inner + degree * inner + i] += t * chunk[k * inner + i];
                }
            }
        }
    }
    out
}

/// Sum over the first axis with weights.
fn contracted(coefficients: &[f64], weights: &[f64]) -> Vec<f64> {
    let inner = coefficients.len() / weights.len();
    (0..inner).map(|i| weights.iter().enumerate().map(|(k, w)| w * coefficients[k * inner + i]).sum()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_finds_a_smooth_function_between_its_nodes_and_refuses_beyond_them() {
        let axes = vec![Axis::linear("x", 0.0, 1.0, 9), Axis::logarithmic("y", 0.1, 10.0, 9), Axis::linear("z", -1.0, 2.0, 4)];
        let f = |p: &[f64]| (0.5 * p[0]).exp() * (1.0 + p[1].ln() * 0.2).sin() + p[2] * p[2] * p[0];
        let values = Table::nodes(&axes).iter().map(|p| f(p)).collect();
        let table = Table::interpolating("t", "", axes, values);
        for point in [[0.3, 0.7, 1.1], [0.0, 0.1, -1.0], [1.0, 10.0, 2.0], [0.91, 4.4, 0.0]] {
            let value = table.at(&point).unwrap();
            assert!((value - f(&point)).abs() < 1e-8, "{value} {}", f(&point));
            let part = table.given(&point[..2]).unwrap();
            assert!((part.at(&point[2..]).unwrap() - value).abs() < 1e-14);
        }
        assert!(matches!(table.at(&[0.3, 0.05, 0.0]), Err(AuditError::Uncovered { .. })));
    }
}
