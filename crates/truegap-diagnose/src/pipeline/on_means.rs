//! Means of rows that are what the fitted model makes of them.
//!
//! Where inputs move within a mean, the mean of what is read is not the response to the mean inputs, and an effect with a memory sees a smoother course of its input. The base model at the centre of its
//! prior knows only the first of these differences. In a long recording, where a mean of many rows has little noise, the second is many squares of it: laws then bend after that, and what is left
//! is told as further physics. So the difference is taken from the model that leaves least, and the search is done once more where that changes anything.
//!
//! **Source:** Böhmer, Hemker & Stetter, The defect correction approach, Computing Supplementum 5 (1984) 1: the rows are the fine problem and the means the coarse one.
//!
//! Limits: means within which inputs move, that is recordings of some ten thousand rows; one model for all that is tried, which a rival far from it would have otherwise.

use crate::{
    data::error::DiagnoseError,
    pipeline::{
        judged::{Told, examined_on_means},
        prepare::Prepared,
    },
    selection::{candidates::Tried, examine::Examined},
    validation::tuning::MOST_ASKED,
};
use std::sync::atomic::Ordering;

/// Times that means are made anew with one model, which is fitted again in between; each time leaves about a hundredth of the squares before.
const MOST_ROUNDS: usize = 4;

/// Fits, weighs and decides; on means of rows that are what the model that leaves least makes of them.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn examined(prepared: &mut Prepared<'_>, told: &Told<'_>) -> Result<Examined, DiagnoseError> {
    if let Some(first) = first_effect(prepared, told)? {
        converged(prepared, first, told);
    }
    let examined = examined_on_means(prepared, told)?;
    // what leaves least may be another model than that by which the means were made
    let least = examined.selection.least().filter(|_| prepared.inputs_move_within_means()).cloned();
    let changed = least.is_some_and(|least| converged(prepared, least, told));
    if changed { examined_on_means(prepared, told) } else { Ok(examined) }
}

/// The base model with the effect that explains most of what it leaves; `None` where means need no model.
fn first_effect(prepared: &Prepared<'_>, told: &Told<'_>) -> Result<Option<Tried>, DiagnoseError> {
    if !prepared.inputs_move_within_means() || told.stop.load(Ordering::Relaxed) {
        return Ok(None);
    }
    let searched = prepared.searched();
    let search = prepared.search(&searched, told.progress, told.stop);
    let base = search.base()?;
    let all: Vec<usize> = (0..search.library.len()).collect();
    let singles = search.add_each(&base, &all, MOST_ASKED, "means of rows");
    let evidence = |tried: &Tried| tried.fit.log_evidence;
    Ok(singles.into_iter().chain([base]).max_by(|a, b| evidence(a).total_cmp(&evidence(b))))
}

/// Makes the means by a model, which is fitted to them again, until they are what it makes of them; whether they changed.
fn converged(prepared: &mut Prepared<'_>, mut model: Tried, told: &Told<'_>) -> bool {
    let mut changed = false;
    for _ in 0..MOST_ROUNDS {
        if told.stop.load(Ordering::Relaxed) || !prepared.averaged_by(&model) {
            break;
        }
        changed = true;
        let searched = prepared.searched();
        match prepared.search(&searched, told.progress, told.stop).polished(&model) {
            Some(fitted) => model = fitted,
            None => break,
        }
    }
    changed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Options, Problem,
        common::Plate,
        fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit},
        noise::several::measured,
        whitening::whitener::{InputError, Noise},
    };
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};
    use std::{f64::consts::TAU, sync::atomic::AtomicBool};
    use truegap_core::{Inputs, Simulator};

    const ROWS: usize = 40_000;
    const LAG_S: f64 = 40.0;
    const NOISE: f64 = 1e-4;

    /// Temperature `lag` seconds behind two waves, in closed form: each weaker and later, and what is left of its beginning.
    fn waves(t: f64, lag: f64) -> f64 {
        let wave = |(period, kelvin): (f64, f64)| {
            let turn = TAU / period;
            let late = (turn * lag).atan();
            let beginning = if lag > 0.0 { late.sin() * (-t / lag).exp() } else { 0.0 };
            kelvin * late.cos() * ((turn * t - late).sin() + beginning)
        };
        25.0 + wave((611.0, 4.0)) + wave((7200.0, 6.0))
    }

    /// Load and temperature never rest, so that a mean holds rows within which they move; the temperature is late. On means a lag sees a smoother course of it than on rows, which the base model does not
    /// know: the right law left a third more than the noise.
    #[test]
    fn means_are_what_the_right_model_makes_of_them() {
        let time_s: Vec<f64> = (0..ROWS).map(|row| row as f64).collect();
        let inputs = |lag: f64| Inputs {
            run: vec![1; ROWS],
            force_n: Some(time_s.iter().map(|t| 2.0 + 1.5 * (TAU * t / 3000.0).sin()).collect()),
            temperature_c: Some(time_s.iter().map(|t| waves(*t, lag)).collect()),
            time_s: Some(time_s.clone()),
            ..Inputs::default()
        };
        let plate = Plate::new(Some(false));
        let mut response = plate.respond(&plate.centre(), &inputs(LAG_S), &[]).unwrap();
        let random = &mut ChaCha8Rng::seed_from_u64(21);
        let white = |random: &mut ChaCha8Rng| -> f64 { StandardNormal.sample(random) };
        response.iter_mut().for_each(|value| *value += NOISE * white(random));
        let inputs = inputs(0.0);
        let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
        let (denoised, mut noise) = measured(&problem).unwrap();
        // nothing rests, so that the noise is taken for what is left of the waves
        noise.response = Noise { white_sd: NOISE, ar_sd: 0.0, ar_correlation: 0.0 };
        noise.input_error = InputError::white(vec![0.0; ROWS]);
        let problem = Problem { inputs: &denoised, ..problem };
        let options = Options { effects: vec!["thermal_lag".into()], ..Options::default() };
        let mut prepared = Prepared::new(&problem, noise, &options).unwrap();
        let stop = AtomicBool::new(false);
        let told = Told { options: &options, progress: &|_| (), asked: &stop, stop: &stop };
        // squares of the noise for each mean, less one, in their standard deviations by chance
        let left = |prepared: &Prepared<'_>| {
            let searched = prepared.searched();
            let search = prepared.search(&searched, told.progress, told.stop);
            let model = search.model(&[0]);
            let fit = fit(&model, search.whitener, &vec![0.0; model.parameters.len()], &FitOptions::default()).unwrap();
            let rows = search.whitener.rows as f64;
            ((fit.chi2 / rows - 1.0) / (2.0 / rows).sqrt(), Tried { effects: vec![0], fit })
        };
        let (before, model) = left(&prepared);
        assert!(before > 10.0, "{before}");
        assert!(converged(&mut prepared, model, &told));
        let (after, model) = left(&prepared);
        assert!(after.abs() < 3.0, "{after}");
        // nothing is left to change
        assert!(!converged(&mut prepared, model, &told));
    }
}
