//! Where a calibration of the base model begins: at its optimum on few rows.
//!
//! A calibration that is driven far takes thousands of evaluations from each of its starts. On means of rows it takes as many, each of which is ten times cheaper; from there
//! few steps lead to the optimum of all rows.
//!
//! Limits: a base model whose rows do not depend on one another, with a clock.

use crate::{
    data::problem::Problem,
    fit::{
        levenberg_marquardt::FitOptions, maximum_a_posteriori::fit, model::Model, optimum::Fit, several_starts::lowest,
        tuning::LOOSE,
    },
    noise::block_average::{BlockAverages, block_averages},
    whitening::{noise_model::NoiseModel, whitener::Whitener},
};
use truegap_core::SimulationError;

/// Means that a start is looked for on, about.
const SCOUTED_ROWS: usize = 600;

/// Rows from which that is worth it.
const WORTH_IT: usize = 3 * SCOUTED_ROWS;

/// A recording on few rows.
pub struct Scout {
    averages: BlockAverages,
    noise: NoiseModel,
}

impl Scout {
    /// The recording on few rows; `None` where it has not many, or where the rows of the base model depend on one another.
    ///
    /// # Errors
    /// Those of the simulator at the centre of its prior.
    pub fn of(problem: &Problem<'_>, noise: &NoiseModel) -> Result<Option<Self>, SimulationError> {
        if !problem.simulator.row_by_row() || problem.response.len() < WORTH_IT {
            return Ok(None);
        }
        let averages =
            block_averages(problem, noise, SCOUTED_ROWS)?.filter(|found| 2 * found.response.len() < problem.response.len());
        Ok(averages.map(|averages| Self { noise: averages.noise(noise), averages }))
    }

    /// The optimum on few rows, from several starts; `changed` makes their noise what it is to be.
    ///
    /// # Errors
    /// Those of the simulator at the centre of its prior.
    fn start(&self, model: &Model<'_>, changed: impl Fn(&NoiseModel) -> NoiseModel) -> Result<Vec<f64>, SimulationError> {
        let simulator = model.problem.simulator;
        let few = Problem { inputs: &self.averages.inputs, response: &self.averages.response, simulator };
        let model = Model::new(&few, model.context, Vec::new());
        let (runs, noise) = (few.runs(), changed(&self.noise));
        Ok(lowest(&model, &noise.whitener(&runs, None), &noise.scaled(LOOSE).whitener(&runs, None))?.z)
    }
}

/// The base model calibrated under `noise`, from several starts; `model` holds no effects.
///
/// # Errors
/// Those of the simulator at the centre of its prior.
pub(crate) fn calibrated(model: &Model<'_>, noise: &NoiseModel) -> Result<Fit, SimulationError> {
    let runs = model.problem.runs();
    let (whitener, loose) = (noise.whitener(&runs, None), noise.scaled(LOOSE).whitener(&runs, None));
    scouted(model, &whitener, &loose, Scout::of(model.problem, noise)?.as_ref(), NoiseModel::clone)
}

/// The base model calibrated from where few rows have it, under noise `changed` as there; from several starts where there are no few rows.
///
/// # Errors
/// Those of the simulator at the centre of its prior.
pub(crate) fn scouted(
    model: &Model<'_>,
    whitener: &Whitener,
    loose: &Whitener,
    scout: Option<&Scout>,
    changed: impl Fn(&NoiseModel) -> NoiseModel,
) -> Result<Fit, SimulationError> {
    match scout {
        Some(scout) => from_start(model, whitener, &scout.start(model, changed)?),
        None => lowest(model, whitener, loose),
    }
}

/// The base model calibrated from one start.
///
/// # Errors
/// Those of the simulator at the start.
pub(crate) fn from_start(model: &Model<'_>, whitener: &Whitener, start: &[f64]) -> Result<Fit, SimulationError> {
    fit(model, whitener, start, &FitOptions::default())
}
