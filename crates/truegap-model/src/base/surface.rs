//! How a simulated column follows load and temperature: a smooth surface by least squares, along which it is moved where physics moves what drives it.
//!
//! Limits: cubic in the load, square in the temperature; a simulation with a memory of its own is followed in its static part only.

use super::driver::Driver;
use serde::{Deserialize, Serialize};
use truegap_core::{Inputs, Role};

/// Share of the simulation's variance that a surface must explain to be followed.
const EXPLAINS: f64 = 0.9;
/// Ridge, as a share of the mean square of a column: columns that cannot be told apart share their weight.
const RIDGE: f64 = 1e-9;

/// The surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// the load, where one was recorded and moves
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load: Option<Driver>,
    /// the temperature, where it was recorded and moves
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Driver>,
    /// weights of the terms, a constant first
    pub weights: Vec<f64>,
}

impl Surface {
    /// The surface of `inputs.simulated`; `None` where neither load nor temperature explains it.
    pub fn of(inputs: &Inputs) -> Option<Self> {
        let simulated = inputs.simulated.as_ref()?;
        let load = [Role::Force, Role::Pressure].into_iter().find_map(|role| Driver::of(inputs, role));
        let temperature = Driver::of(inputs, Role::Temperature);
        let column = |driver: Option<Driver>| driver.and_then(|d| d.recorded(inputs, "external").ok());
        let (loads, warmths) = (column(load), column(temperature));
        if loads.is_none() && warmths.is_none() {
            return None;
        }
        let at = |column: &Option<Vec<f64>>, row: usize| column.as_ref().map(|c| c[row]);
        let rows: Vec<Vec<f64>> = (0..simulated.len()).map(|row| terms(at(&loads, row), at(&warmths, row))).collect();
        let weights = least_squares(&rows, simulated)?;
        let surface = Self { load, temperature, weights };
        surface.explains(&rows, simulated).then_some(surface)
    }

    /// Its value at a load and a temperature in units of their drivers.
    pub fn at(&self, load: f64, warmth: f64) -> f64 {
        let terms = terms(self.load.map(|_| load), self.temperature.map(|_| warmth));
        terms.iter().zip(&self.weights).map(|(term, weight)| term * weight).sum()
    }

    fn explains(&self, rows: &[Vec<f64>], simulated: &[f64]) -> bool {
        let mean = simulated.iter().sum::<f64>() / simulated.len() as f64;
        let all: f64 = simulated.iter().map(|s| (s - mean).powi(2)).sum();
        let fitted = |terms: &[f64]| terms.iter().zip(&self.weights).map(|(t, w)| t * w).sum::<f64>();
        let left: f64 = rows.iter().zip(simulated).map(|(terms, s)| (s - fitted(terms)).powi(2)).sum();
        all > 0.0 && left <= (1.0 - EXPLAINS) * all
    }
}

fn terms(load: Option<f64>, warmth: Option<f64>) -> Vec<f64> {
    let mut terms = vec![1.0];
    terms.extend(load.into_iter().flat_map(|l| [l, l * l, l * l * l]));
    terms.extend(warmth.into_iter().flat_map(|t| [t, t * t]));
    terms.extend(load.zip(warmth).map(|(l, t)| l * t));
    terms
}

/// Weights of a linear least-squares fit by the normal equations; `None` where they cannot be solved.
fn least_squares(rows: &[Vec<f64>], target: &[f64]) -> Option<Vec<f64>> {
    let n = rows.first()?.len();
    let mut gram = vec![vec![0.0; n + 1]; n];
    for (terms, value) in rows.iter().zip(target) {
        for i in 0..n {
            (0..n).for_each(|j| gram[i][j] += terms[i] * terms[j]);
            gram[i][n] += terms[i] * value;
        }
    }
    (0..n).for_each(|i| gram[i][i] *= 1.0 + RIDGE);
    for pivot in 0..n {
        let best = (pivot..n).max_by(|a, b| gram[*a][pivot].abs().total_cmp(&gram[*b][pivot].abs()))?;
        gram.swap(pivot, best);
        let line = gram[pivot].clone();
        if line[pivot] == 0.0 {
            return None;
        }
        for row in (0..n).filter(|row| *row != pivot) {
            let factor = gram[row][pivot] / line[pivot];
            gram[row].iter_mut().zip(&line).for_each(|(value, pivoted)| *value -= factor * pivoted);
        }
    }
    let weights: Vec<f64> = (0..n).map(|i| gram[i][n] / gram[i][i]).collect();
    weights.iter().all(|w| w.is_finite()).then_some(weights)
}
