//! Detectability: what calibration within tolerance leaves of an effect, in units of the noise.
//!
//! $$ d^2 = \min_p \sum_i ((e_i - J_i p) / \sigma)^2 + |p|^2 $$
//!
//! with e the effect, J the Jacobian per standard deviation of each tolerance, sigma the noise: what stays in the residual and what
//! the parameters had to be pushed for, in one number. That this is the number in the shared open recordings is tested on them.
//! Limits: linear (finite differences at the true sensor); autocorrelation is ignored, and noise on the inputs unless it is asked for ([`input_error`]).

use crate::chain::simulate;
use crate::noise::Noise;
use crate::sensor::{Sensor, Toleranced};
use crate::state::{PlatesTouch, Scene};

const PARAMETERS: usize = Toleranced::ALL.len();
/// Half-step of the central differences, in standard deviations.
const STEP: f64 = 0.1;

/// Linear calibration of a sensor on a history.
#[derive(Debug, Clone)]
pub struct Calibration {
    columns: Vec<Vec<f64>>,
    factor: [[f64; PARAMETERS]; PARAMETERS],
    /// Noise of each row, pF.
    noise_pf: Vec<f64>,
}

/// What calibration leaves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leftover {
    /// Spread of the effect about its mean, before calibration, over the noise.
    pub before: f64,
    /// Detectability over the root of the rows: the same after calibration.
    pub after: f64,
    /// Detectability.
    pub detectability: f64,
    /// The part of it that is seen in the residual; the rest is conflict with the tolerances.
    pub residual: f64,
}

impl Calibration {
    /// Calibration of `scene.sensor` about its true values, tolerances those of `nominal`; `noise_pf` is the noise of each row.
    pub fn new(scene: Scene, nominal: &Sensor, warp: bool, noise_pf: Vec<f64>) -> Result<Self, PlatesTouch> {
        let mut columns = Vec::with_capacity(PARAMETERS);
        for what in Toleranced::ALL {
            let by = STEP * nominal.tolerance(what);
            let [up, down] = [by, -by].map(|by| {
                let sensor = scene.sensor.moved(what, by);
                simulate(Scene { sensor: &sensor, ..scene }, warp, &[])
            });
            let slope = |((up, down), noise): ((&f64, &f64), &f64)| (up - down) / (2.0 * STEP * noise);
            columns.push(up?.iter().zip(&down?).zip(&noise_pf).map(slope).collect::<Vec<f64>>());
        }
        let factor = cholesky(&columns);
        Ok(Self { columns, factor, noise_pf })
    }

    /// What is left of `effect` (pF, one entry a row) after calibration.
    pub fn leftover(&self, effect: &[f64]) -> Leftover {
        let scaled = self.scaled(effect);
        let mut moved = [0.0; PARAMETERS];
        for (b, column) in moved.iter_mut().zip(&self.columns) {
            *b = dot(column, &scaled);
        }
        solve(&self.factor, &mut moved);
        let left = |row: usize| scaled[row] - (0..PARAMETERS).map(|k| moved[k] * self.columns[k][row]).sum::<f64>();
        let square: f64 = (0..scaled.len()).map(|row| left(row).powi(2)).sum();
        let rows = scaled.len() as f64;
        let conflict: f64 = moved.iter().map(|m| m * m).sum();
        let detectability = (square + conflict).sqrt();
        let mean = scaled.iter().sum::<f64>() / rows;
        let spread = scaled.iter().map(|e| (e - mean).powi(2)).sum::<f64>() / rows;
        Leftover { before: spread.sqrt(), after: detectability / rows.sqrt(), detectability, residual: square.sqrt() }
    }
}

impl Calibration {
    fn scaled(&self, effect: &[f64]) -> Vec<f64> {
        effect.iter().zip(&self.noise_pf).map(|(e, noise)| e / noise).collect()
    }

    /// What calibration leaves of two effects (pF) in common: a'b less what the parameters take up, in units of the noise squared.
    ///
    /// For one effect it is the square of its detectability.
    pub fn in_common(&self, a: &[f64], b: &[f64]) -> f64 {
        let (a, b) = (self.scaled(a), self.scaled(b));
        let project = |effect: &[f64]| {
            let mut onto = [0.0; PARAMETERS];
            for (entry, column) in onto.iter_mut().zip(&self.columns) {
                *entry = dot(column, effect);
            }
            onto
        };
        let (onto_a, mut onto_b) = (project(&a), project(&b));
        solve(&self.factor, &mut onto_b);
        dot(&a, &b) - dot(&onto_a, &onto_b)
    }
}

/// Noise of each row (pF) where that of the recorded load and temperature is carried through the base model and added to `noise.sd_pf`.
pub fn input_error(scene: Scene, warp: bool, noise: &Noise) -> Result<Vec<f64>, PlatesTouch> {
    let base = simulate(scene, warp, &[])?;
    let moved = |force: f64, kelvin: f64| {
        let mut history = scene.history.clone();
        history.force.iter_mut().for_each(|f| *f += force);
        history.temperature.iter_mut().for_each(|t| *t += kelvin);
        simulate(Scene { history: &history, ..scene }, warp, &[])
    };
    let (by_force, by_kelvin) = (moved(noise.force_n, 0.0)?, moved(0.0, noise.temperature_k)?);
    let row = |(here, (force, kelvin)): (&f64, (&f64, &f64))| noise.sd_pf.hypot(force - here).hypot(kelvin - here);
    Ok(base.iter().zip(by_force.iter().zip(&by_kelvin)).map(row).collect())
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Lower Cholesky factor of J'J + 1; positive definite by the 1.
fn cholesky(columns: &[Vec<f64>]) -> [[f64; PARAMETERS]; PARAMETERS] {
    let mut factor = [[0.0; PARAMETERS]; PARAMETERS];
    for i in 0..PARAMETERS {
        for j in 0..=i {
            let ridge = if i == j { 1.0 } else { 0.0 };
            let known: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
            let value = dot(&columns[i], &columns[j]) + ridge - known;
            factor[i][j] = if i == j { value.sqrt() } else { value / factor[j][j] };
        }
    }
    factor
}

fn solve(factor: &[[f64; PARAMETERS]; PARAMETERS], b: &mut [f64; PARAMETERS]) {
    for i in 0..PARAMETERS {
        let known: f64 = (0..i).map(|k| factor[i][k] * b[k]).sum();
        b[i] = (b[i] - known) / factor[i][i];
    }
    for i in (0..PARAMETERS).rev() {
        let known: f64 = (i + 1..PARAMETERS).map(|k| factor[k][i] * b[k]).sum();
        b[i] = (b[i] - known) / factor[i][i];
    }
}
