//! A world that is linear in its numbers, with Gaussian noise: every stage of a diagnosis has a known answer there.
//!
//! The answers are computed from the covariance of all rows, `C = K + B B^T` for noise K and columns B of unit Gaussian weights: by Cholesky's factor of an n x n
//! matrix, without a fit, a Hessian or a whitening filter. Where a tolerance has no reason of its own it is `FITTED`.

mod effects;
mod exact;
mod fits;
mod foreseen;
mod held_out;
mod kept_bank;
mod lack_of_fit;
mod probabilities;
mod tempered;
mod under_noise;
mod unmodelled;
mod weak;
mod whole;
mod words;

use crate::{
    Context, Problem,
    adequacy::lack_of_fit::LackOfFitTests,
    calibration::{InputError, Noise, Whitener},
    noise::several::measured,
    selection::candidates::Search,
    whitening::noise_model::NoiseModel,
};
use effects::{Line, Term};
use exact::Exact;
use nalgebra::{DMatrix, DVector};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::sync::atomic::AtomicBool;
use truegap_core::{Inputs, Simulator};

/// A fit is exact but for a damping of 1e-6 and difference quotients with 13 digits in steps of 1e-3.
const FITTED: f64 = 1e-5;

/// What was done, what acts, and the noise.
struct World {
    inputs: Inputs,
    line: Line,
    terms: Vec<Term>,
    noise: Noise,
}

impl World {
    /// `runs` runs of `rows` rows, a second apart, with terms of these sizes (prior standard deviations) under white noise of unit variance.
    fn new(runs: usize, rows: usize, sizes: &[f64]) -> Self {
        let n = runs * rows;
        let inputs = Inputs {
            time_s: Some((0..n).map(|row| row as f64).collect()),
            run: (0..n).map(|row| 1 + (row / rows) as u32).collect(),
            ..Inputs::default()
        };
        let terms = sizes.iter().enumerate().map(|(k, sd)| Term::new(k, n, *sd)).collect();
        Self { inputs, line: Line::empty(), terms, noise: Noise { white_sd: 1.0, ar_sd: 0.0, ar_correlation: 0.0 } }
    }

    fn rows(&self) -> usize {
        self.inputs.len()
    }

    /// Covariance of the noise: autoregressive inside of each run, and white.
    fn noise_covariance(&self) -> DMatrix<f64> {
        let Noise { white_sd, ar_sd, ar_correlation } = self.noise;
        DMatrix::from_fn(self.rows(), self.rows(), |i, j| {
            let white = if i == j { white_sd * white_sd } else { 0.0 };
            let alike = self.inputs.run[i] == self.inputs.run[j];
            white + if alike { ar_sd * ar_sd * ar_correlation.powi(i.abs_diff(j) as i32) } else { 0.0 }
        })
    }

    /// Columns of the base model and of some terms, each for one prior standard deviation of its number.
    fn columns(&self, terms: &[usize]) -> DMatrix<f64> {
        let base = self.line.columns.iter().map(|(sd, column)| column.iter().map(|c| sd * c).collect());
        let own = terms.iter().map(|k| self.terms[*k].of_one_deviation());
        let all: Vec<Vec<f64>> = base.chain(own).collect();
        DMatrix::from_fn(self.rows(), all.len(), |row, k| all[k][row])
    }

    /// What is known exactly of a response under the base model with these terms.
    fn exact(&self, terms: &[usize], response: &[f64]) -> Exact {
        Exact::new(self.noise_covariance(), self.columns(terms), DVector::from_column_slice(response))
    }

    /// A response with these coordinates of the base model's numbers and of some terms, and noise.
    fn drawn(&self, terms: &[usize], z: &[f64], random: &mut ChaCha8Rng) -> Vec<f64> {
        let white = DVector::from_fn(self.rows(), |_, _| StandardNormal.sample(random));
        let noise = self.noise_covariance().cholesky().unwrap().l() * white;
        (noise + self.columns(terms) * DVector::from_column_slice(z)).as_slice().to_vec()
    }

    /// The filter of the noise, `louder` times as large.
    fn whitener(&self, louder: f64) -> Whitener {
        let Noise { white_sd, ar_sd, ar_correlation } = self.noise;
        let noise = Noise { white_sd: louder * white_sd, ar_sd: louder * ar_sd, ar_correlation };
        Whitener::new(&noise, &InputError::white(vec![0.0; self.rows()]), None, &self.inputs.runs(), None)
    }

    /// Searches a response.
    fn search<T>(&self, response: &[f64], then: impl FnOnce(&Search<'_>, &LackOfFitTests) -> T) -> T {
        let problem = Problem { inputs: &self.inputs, response, simulator: &self.line };
        let context = Context::new(&self.inputs, &self.line, problem.span(), 1.0);
        let (whitener, loose) = (self.whitener(1.0), self.whitener(30.0));
        let search = Search {
            problem: &problem,
            context: &context,
            library: self.terms.iter().map(|t| t as _).collect(),
            whitener: &whitener,
            loose: &loose,
            scout: None,
            progress: &|_| (),
            stop: &AtomicBool::new(false),
        };
        then(&search, &LackOfFitTests::new(&[], &whitener, self.inputs.runs(), 0.0))
    }
}

/// White noise of unit variance, as the world has it.
fn noise(world: &World, y: &[f64]) -> NoiseModel {
    let problem = crate::Problem { inputs: &world.inputs, response: y, simulator: &world.line };
    let (_, noise) = measured(&problem).unwrap();
    NoiseModel { response: world.noise, ..noise }
}

/// Unit normal numbers.
fn normals<const N: usize>(random: &mut ChaCha8Rng) -> [f64; N] {
    std::array::from_fn(|_| StandardNormal.sample(random))
}

/// The base model has nothing to do in most of these tests.
#[test]
fn the_world_is_linear() {
    let world = World::new(1, 8, &[2.0]);
    let stage = world.terms[0].stage_of(3.0);
    let response = world.line.respond(&[], &world.inputs, &[stage.as_ref()]).unwrap();
    let column = world.columns(&[0]).column(0) * 1.5;
    approx::assert_relative_eq!(response.as_slice(), column.as_slice(), max_relative = 1e-15);
}
