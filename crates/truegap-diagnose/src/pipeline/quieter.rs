//! A noise that is louder than what a model leaves, learned from that.
//!
//! A model that explains leaves noise and nothing else, so no noise is louder than that. What a model's numbers are free to take up is no proof: it is paid for ([`crate::fit::under_noise`]).
//!
//! Limits: one recording; lowers, never raises; a noise measured at rest by its mean square, and to another memory that rest allows.

use crate::{
    data::error::DiagnoseError,
    discovery::{compose::Composition, discover::with_mechanisms},
    fit::{model::Model, under_noise::UnderNoise},
    noise::{
        learned_again::{learned_again, less_slow, of_rows_alike},
        rescale::{quieter_than, too_loud},
        response::no_finer_than_read,
        slow_rivals::memory_rivals,
        tuning::{CLEARLY_QUIETER, STILL_AS_LOUD},
    },
    pipeline::{prepare::Prepared, wanders::memories},
    selection::{candidates::Tried, examine::Examined, tuning::WALKS},
    stats::rms,
    whitening::{noise_model::NoiseModel, whitener::Noise},
};
use std::sync::atomic::AtomicBool;

impl Prepared<'_> {
    /// The noise as the model that leaves least has it, where that leaves less than noise.
    ///
    /// # Errors
    /// Those of the simulator.
    pub(crate) fn quieter(&self, examined: &Examined) -> Result<Option<NoiseModel>, DiagnoseError> {
        let Some(best) = examined.selection.least() else { return Ok(None) };
        if self.problem.simulator.joined().is_some() {
            return Ok(None);
        }
        let rows = self.whitener.rows.max(1) as f64;
        let misfit = self.misfit(best)?;
        let too_loud = best.fit.chi2 / rows <= too_loud(&self.noise);
        let lowered = if too_loud { quieter_than(self.problem, &misfit, &self.noise) } else { None };
        let searched = self.searched();
        let model = &self.model_of(&searched, best);
        if self.noise.measured {
            return if lowered.is_some() { Ok(lowered) } else { self.likelier(model, best, self.less_steep(&misfit)) };
        }
        let learned = learned_again(self.problem, &misfit, &self.noise);
        match lowered {
            // what was louder beside a worse misfit stays so where it is lowered only
            Some(lowered) => Ok(self.likeliest(model, best, [vec![lowered], learned].concat())?.map(|(noise, _)| noise)),
            None => self.likelier(model, best, learned),
        }
    }

    /// The noise as the model that leaves least in the end has it, be it a mechanism composed of words: of a noise that nobody measured, and of slow noise that the whole recording was given (`slowed`), where that leaves
    /// less.
    ///
    /// # Errors
    /// Those of the simulator.
    pub(crate) fn quieter_in_the_end(
        &self,
        examined: &Examined,
        composition: Option<&Composition>,
        slowed: bool,
    ) -> Result<Option<NoiseModel>, DiagnoseError> {
        let (searched, stop) = (self.searched(), AtomicBool::new(false));
        let mechanisms = composition.map_or(&[][..], |c| c.mechanisms.as_slice());
        let search = with_mechanisms(&self.search(&searched, &|_| (), &stop), mechanisms);
        let both = examined.selection.least().into_iter().chain(composition.map(|c| &c.tried));
        let least = both.min_by(|a, b| a.fit.objective().total_cmp(&b.fit.objective()));
        let Some(least) = least.filter(|_| self.problem.simulator.joined().is_none()) else { return Ok(None) };
        let misfit = search.model_over(self.problem, &least.effects).misfit(&least.fit.z)?;
        let model = &search.model(&least.effects);
        let mut noises = learned_again(self.problem, &misfit, &self.noise);
        noises.extend(self.of_one_memory(model, least)?);
        if slowed {
            noises.extend(less_slow(&self.noise));
        }
        self.likelier(model, least, noises)
    }

    /// The clearly quieter noises of other memories that rest allows as well: stretches of some dozen rows, of which the slow course is taken out, do not tell a memory of as many rows from a short one, and a steep noise is as loud as
    /// a whole recording is not.
    fn less_steep(&self, misfit: &[f64]) -> Vec<NoiseModel> {
        if self.noise.response.ar_sd <= 0.0 {
            return Vec::new();
        }
        let quieter = |noise: &NoiseModel| noise.floor() < STILL_AS_LOUD * self.noise.floor();
        memory_rivals(self.problem, misfit, &self.noise).into_iter().filter(quieter).collect()
    }

    /// White noise beside noise of the memory under which all that a fitted model leaves is likeliest: short stretches, from which a noise is read elsewhere, tell a steep noise by its changes from row to row alone. `None`
    /// where that is no quieter, or the noise was measured.
    fn of_one_memory(&self, model: &Model<'_>, tried: &Tried) -> Result<Option<NoiseModel>, DiagnoseError> {
        let noise = &self.noise;
        if noise.measured || noise.step > 0.0 || self.problem.inputs.time_s.is_none() {
            return Ok(None);
        }
        let weighed = UnderNoise::of(model, &tried.fit)?;
        let size = rms(model.misfit(&tried.fit.z)?.into_iter());
        let alike = of_rows_alike(noise);
        let longest = self.problem.runs().iter().map(|run| run.len()).max().unwrap_or(0) as f64;
        let of = |(memory, ratio): (f64, f64)| {
            let of_size = |size: f64| {
                let response = Noise { white_sd: size, ar_sd: ratio * size, ar_correlation: (-1.0 / memory).exp() };
                NoiseModel { response: no_finer_than_read(response, self.problem), ..alike.clone() }
            };
            let (density, size, _) = weighed.as_loud(size, |size| self.filter_of(&of_size(size)));
            (density, of_size(size))
        };
        let all = memories(1.0, longest).flat_map(|memory| WALKS.map(|ratio| (memory, ratio)));
        let likeliest = all.map(of).max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, noise)| noise);
        let says = |found: NoiseModel| NoiseModel {
            says: format!("{}, of the memory that all rows have beside what a model explains", noise.says),
            ..found
        };
        Ok(likeliest.filter(|found| found.floor() < STILL_AS_LOUD * noise.floor()).map(says))
    }

    /// The likeliest of these noises, where a fitted model is clearly likelier under it than under the noise that was taken.
    fn likelier(&self, model: &Model<'_>, tried: &Tried, noises: Vec<NoiseModel>) -> Result<Option<NoiseModel>, DiagnoseError> {
        Ok(self.likeliest(model, tried, noises)?.filter(|(_, gain)| *gain > CLEARLY_QUIETER).map(|(noise, _)| noise))
    }

    /// Of these noises the one under which a fitted model is likeliest, and by how much likelier in its log than under the noise that was taken: what its numbers are free to take up is counted. `None` of none.
    fn likeliest(
        &self,
        model: &Model<'_>,
        tried: &Tried,
        noises: Vec<NoiseModel>,
    ) -> Result<Option<(NoiseModel, f64)>, DiagnoseError> {
        if noises.is_empty() {
            return Ok(None);
        }
        let weighed = UnderNoise::of(model, &tried.fit)?;
        let (taken, _) = weighed.log_density(&self.whitener);
        let gain = |noise: NoiseModel| {
            let (log, _) = weighed.log_density(&self.filter_of(&noise));
            (noise, log - taken)
        };
        Ok(noises.into_iter().map(gain).max_by(|a, b| a.1.total_cmp(&b.1)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Options, Problem,
        common::{Plate, recording, without_rest},
        noise::slow_parts::slow_parts,
        whitening::whitener::InputError,
    };
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};
    use truegap_core::{Inputs, Simulator};

    const ROWS: usize = 1200;
    const NOISE: f64 = 0.004;
    const WHITE: Noise = Noise { white_sd: NOISE, ar_sd: 0.0, ar_correlation: 0.0 };

    /// What a plate at the centre of its priors reads beside white noise.
    fn read(plate: &Plate, inputs: &Inputs, seed: u64) -> Vec<f64> {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        let mut response = plate.respond(&plate.centre(), inputs, &[]).unwrap();
        response.iter_mut().for_each(|value| {
            let unit: f64 = StandardNormal.sample(random);
            *value += NOISE * unit;
        });
        response
    }

    /// The noise that the right model has white noise for, taken for `noise`: learned again, and with less that is slow; and the mean square of a whitened row under it.
    fn lowered(noise: &NoiseModel) -> ([Option<NoiseModel>; 2], f64) {
        let (plate, inputs) = (Plate::new(Some(false)), without_rest(ROWS));
        let response = read(&plate, &inputs, 5);
        let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
        let options = Options { effects: vec!["offset_drift".into()], ..Options::default() };
        let prepared = Prepared::new(&problem, noise.clone(), &options).unwrap();
        let searched = prepared.searched();
        let base = prepared.search(&searched, &|_| (), &AtomicBool::new(false)).base().unwrap();
        let again = learned_again(&problem, &prepared.misfit(&base).unwrap(), noise);
        let square = base.fit.chi2 / ROWS as f64;
        let model = prepared.model_of(&searched, &base);
        let likelier = |noises: Vec<NoiseModel>| prepared.likelier(&model, &base, noises).unwrap();
        ([likelier(again), likelier(less_slow(noise))], square)
    }

    /// The filter of a steep noise takes differences from row to row, of which white noise has as much as the steep one would: the mean square tells nothing.
    #[test]
    fn a_steep_noise_gives_way_to_the_white_one_that_a_model_leaves() {
        let none = || InputError::white(vec![0.0; ROWS]);
        let steep = Noise { white_sd: 0.1 * NOISE, ar_sd: 7.0 * NOISE, ar_correlation: 0.97 };
        let ([again, _], square) = lowered(&NoiseModel::unmeasured(steep, none()));
        assert!(square > 0.5, "{square}");
        let again = again.expect("it is learned again");
        // of 1200 rows: 2 %, and what a cubic in 24 rows takes
        approx::assert_relative_eq!(again.floor(), NOISE, max_relative = 0.1);
        // rows that were louder beside a misfit are no louder now
        let mut error = none();
        error.louder = (0..ROWS).map(|row| (8.0 * NOISE * (row as f64 / 37.0).cos()).powi(2)).collect();
        let ([again, _], _) = lowered(&NoiseModel::unmeasured(WHITE, error));
        approx::assert_relative_eq!(again.expect("it is learned again").floor(), NOISE, max_relative = 0.1);
        let ([again, _], _) = lowered(&NoiseModel::unmeasured(WHITE, none()));
        assert!(again.is_none(), "the right noise stays");
        let measured = NoiseModel { measured: true, ..NoiseModel::unmeasured(steep, none()) };
        assert!(lowered(&measured).0[0].is_none(), "what was measured stays");
    }

    /// Noise of a memory of four rows, taken for a steep one of three times its size: its changes from row to row are alike.
    #[test]
    fn a_noise_has_the_memory_that_all_rows_have() {
        let (plate, inputs) = (Plate::new(Some(false)), without_rest(ROWS));
        let random = &mut ChaCha8Rng::seed_from_u64(6);
        let mut response = plate.respond(&plate.centre(), &inputs, &[]).unwrap();
        let memory = (-0.25f64).exp();
        let mut at = 0.0;
        response.iter_mut().for_each(|value| {
            let unit: f64 = StandardNormal.sample(random);
            at = memory * at + NOISE * (1.0 - memory * memory).sqrt() * unit;
            *value += at;
        });
        let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
        let steep = Noise { white_sd: 0.01 * NOISE, ar_sd: 3.0 * NOISE, ar_correlation: 0.97 };
        let taken = NoiseModel::unmeasured(steep, InputError::white(vec![0.0; ROWS]));
        let of = |noise: NoiseModel| {
            let options = Options { effects: vec!["offset_drift".into()], ..Options::default() };
            let prepared = Prepared::new(&problem, noise, &options).unwrap();
            let searched = prepared.searched();
            let base = prepared.search(&searched, &|_| (), &AtomicBool::new(false)).base().unwrap();
            prepared.of_one_memory(&prepared.model_of(&searched, &base), &base).unwrap()
        };
        let found = of(taken.clone()).unwrap();
        // of 1200 rows some 170 are independent: 6 %, and what the model takes up
        approx::assert_relative_eq!(found.floor(), NOISE, max_relative = 0.15);
        assert!((0.6..0.9).contains(&found.response.ar_correlation), "{:?}", found.response);
        assert!(of(NoiseModel { measured: true, ..taken }).is_none(), "what was measured stays");
    }

    #[test]
    fn slow_noise_of_which_a_model_leaves_nothing_goes() {
        let slow = |sd: f64| InputError { lasting: slow_parts(ROWS, sd * sd), ..InputError::white(vec![0.0; ROWS]) };
        let ([_, less], _) = lowered(&NoiseModel::unmeasured(WHITE, slow(5.0 * NOISE)));
        assert!(less.expect("it is lowered").floor() < 1.2 * NOISE);
        // as little as this is neither told nor missed
        assert!(lowered(&NoiseModel::unmeasured(WHITE, slow(0.02 * NOISE))).0[1].is_none());
    }

    /// A noise at rest that was taken for one of a memory of thirty rows is louder than what the whole recording leaves; rest allows shorter memories.
    #[test]
    fn a_measured_noise_is_no_steeper_than_the_whole_recording_has_it() {
        let (plate, inputs) = (Plate::new(Some(false)), recording());
        let response = read(&plate, &inputs, 9);
        let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
        let options = Options { effects: vec!["offset_drift".into()], ..Options::default() };
        let taken = |response: Noise| {
            let noise =
                NoiseModel { measured: true, ..NoiseModel::unmeasured(response, InputError::white(vec![0.0; inputs.len()])) };
            let prepared = Prepared::new(&problem, noise, &options).unwrap();
            let searched = prepared.searched();
            let base = prepared.search(&searched, &|_| (), &AtomicBool::new(false)).base().unwrap();
            let proposed = prepared.less_steep(&prepared.misfit(&base).unwrap());
            prepared.likelier(&prepared.model_of(&searched, &base), &base, proposed).unwrap()
        };
        let found =
            taken(Noise { white_sd: 0.9 * NOISE, ar_sd: 1.2 * NOISE, ar_correlation: 0.97 }).expect("another memory is likelier");
        // of some 1800 rows
        approx::assert_relative_eq!(found.response.white_sd.hypot(found.response.ar_sd), NOISE, max_relative = 0.1);
        assert!(taken(WHITE).is_none(), "what has no memory keeps none");
    }
}
