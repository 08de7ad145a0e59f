//! The noise without the rows that a model reads from beyond the ends of a run ([`crate::noise::beyond_the_ends`]).
//!
//! With such rows in it a fit of two clocks is pulled away from them: it finds too short a shift, so that some of them are overlooked, and what it leaves elsewhere is no noise. So the model is fitted once more
//! without them, until no further one is found, before the noise is taken from what it leaves.
//!
//! Limits: one recording; the clocks are those of the model stood behind, or else of the likeliest.

use crate::{
    data::error::DiagnoseError,
    fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit},
    noise::beyond_the_ends::{rows_felt, weightless, with_noise_of_others},
    pipeline::prepare::Prepared,
    selection::{candidates::Tried, examine::Examined},
    stats::rms,
    whitening::{
        noise_model::{NoiseModel, tells},
        whitener::Whitener,
    },
};
use truegap_core::{Stage, beyond_the_ends};

/// Most fits of the model; each finds the shift anew, and the second seldom finds another row.
const MOST_FITS: usize = 5;

impl Prepared<'_> {
    /// The noise without these rows; `None` where there are none, or nothing of them is felt.
    ///
    /// # Errors
    /// Those of the simulator.
    pub(crate) fn within_the_ends(&self, examined: &Examined) -> Result<Option<NoiseModel>, DiagnoseError> {
        let selection = &examined.selection;
        let Some(model) = selection.named_or_likeliest(examined.decision.model) else { return Ok(None) };
        let tried = &selection.models[model];
        let mut rows = self.read_beyond(tried, &tried.fit.z);
        if self.problem.simulator.joined().is_some() || !rows_felt(&rows, &self.model(tried).misfit(&tried.fit.z)?, &self.noise) {
            return Ok(None);
        }
        let searched = self.searched();
        let (mut noise, mut z) = (weightless(self.problem, &rows, &self.noise), tried.fit.z.clone());
        for _ in 0..MOST_FITS {
            z = fit(&self.model_of(&searched, tried), &self.filter_of(&noise), &z, &FitOptions::default())?.z;
            let more: Vec<usize> = self.read_beyond(tried, &z).into_iter().filter(|row| !rows.contains(row)).collect();
            if more.is_empty() {
                break;
            }
            rows.extend(more);
            rows.sort_unstable();
            noise = weightless(self.problem, &rows, &self.noise);
        }
        let misfit = self.model(tried).misfit(&z)?;
        // a memory of the noise that was taken without most of these rows hangs on a few others: of further rows it is kept
        let is_further = !self.noise.untold.is_empty();
        Ok(Some(if is_further { self.no_louder(misfit, noise) } else { with_noise_of_others(self.problem, &misfit, &noise) }))
    }

    /// The noise as loud as what a model leaves of rows that tell something, where that is less.
    fn no_louder(&self, mut misfit: Vec<f64>, noise: NoiseModel) -> NoiseModel {
        noise.whitener(&self.problem.runs(), None).apply(&mut misfit);
        let told = (0..misfit.len()).filter(|row| tells(&noise.untold, *row)).map(|row| misfit[row]);
        noise.with_parts_scaled(rms(told).min(1.0), 1.0)
    }

    /// Rows that a model of the library reads from beyond the ends.
    fn read_beyond(&self, tried: &Tried, z: &[f64]) -> Vec<usize> {
        let stages = self.model(tried).stages(z);
        beyond_the_ends(self.problem.inputs, &stages.iter().map(AsRef::as_ref).collect::<Vec<&dyn Stage>>())
    }

    /// The filter of the rows that are searched, under this noise of every row.
    pub(crate) fn filter_of(&self, noise: &NoiseModel) -> Whitener {
        let of_means = self.averages.as_ref().map(|averages| averages.noise(noise));
        of_means.as_ref().unwrap_or(noise).whitener(&self.searched().runs(), None)
    }
}
