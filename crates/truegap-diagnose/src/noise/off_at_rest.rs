//! Rest in which an instrument is off: what it reads there says nothing of its noise at work.
//!
//! A power meter at night is still to a watt; by day clouds, wind and the meter itself move it by kilowatts. Measured in its noise at night everything of the day is misfit.
//!
//! Limits: one recording with a clock, whose rest has one reading.

use crate::{
    data::{context::load_column, problem::Problem},
    noise::{
        rescale::not_above,
        response::{blocks, follows_nothing, from_misfit},
        tuning::{LOUDER_AT_WORK, ONE_READING},
    },
    stats::spread,
    whitening::noise_model::NoiseModel,
};

/// The noise beside a model that leaves `misfit`, where `noise` was measured while the reading was off and is far too small for what goes on in a few rows at work; `None` where it is not so.
pub(crate) fn at_work(problem: &Problem<'_>, misfit: &[f64], noise: &NoiseModel) -> Option<NoiseModel> {
    if !noise.measured || noise.lasts() || !problem.is_one_with_a_clock() || !is_off_at_rest(problem, noise) {
        return None;
    }
    let clean = follows_nothing(problem.inputs, misfit.to_vec());
    let found = from_misfit(problem, &clean, &NoiseModel { measured: false, ..noise.clone() });
    let says = format!("at rest the reading is off, which says nothing of its noise at work; {}", found.says);
    let of_reading = |noise: &NoiseModel| noise.response.white_sd.hypot(noise.response.ar_sd);
    (of_reading(&found) > LOUDER_AT_WORK * of_reading(noise)).then(|| not_above(problem, misfit, NoiseModel { says, ..found }))
}

/// Whether all rest has one reading.
fn is_off_at_rest(problem: &Problem<'_>, noise: &NoiseModel) -> bool {
    let load = load_column(problem.inputs, problem.simulator);
    let (rest, ..) = blocks(problem, load.as_deref(), &noise.inputs, noise.load_wanders());
    let read: Vec<f64> = rest.iter().flat_map(|block| &block.rows).map(|row| problem.response[*row]).collect();
    spread(&read) <= ONE_READING * spread(problem.response)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::whitening::{
        noise_model::InputNoise,
        whitener::{InputError, Noise},
    };
    use truegap_core::{
        Driver, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, simulator::StageName, walk_without_plates,
    };

    struct Sun;
    impl Simulator for Sun {
        fn name(&self) -> &str {
            "sun"
        }
        fn unit(&self) -> &str {
            "kW"
        }
        fn parameters(&self) -> &[Parameter] {
            &[]
        }
        fn needs(&self) -> &[Role] {
            &[]
        }
        fn lacks(&self, _: StageName) -> Option<&'static str> {
            None
        }
        fn full_load(&self) -> Option<f64> {
            None
        }
        fn load(&self, _: &Inputs) -> Option<Vec<f64>> {
            None
        }
        fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
            walk_without_plates(self, values, inputs, stages, |drive| {
                Ok((drive.inputs.drivers[0].values.clone(), Readout { zero: 0.0, span: 1.0 }))
            })
        }
    }

    /// Three days of sun and nights, and a noise of `of` each row; each night reads `more` than the one before.
    fn days(more: f64, of: impl Fn(usize) -> f64) -> (Inputs, Vec<f64>, Vec<f64>) {
        let sun: Vec<f64> = (0..900).map(|row| (3.0 * (f64::from(row) / 300.0 * std::f64::consts::TAU).sin()).max(0.0)).collect();
        let misfit: Vec<f64> = (0..900).map(|row| of(row) * ((row * 7919 % 101) as f64 / 50.0 - 1.0)).collect();
        let night = |row: usize| if sun[row] == 0.0 { more * (row / 300) as f64 } else { 0.0 };
        let reading = sun.iter().zip(&misfit).enumerate().map(|(row, (sun, off))| night(row) + sun + off).collect();
        let driver = Driver { name: "sun".into(), unit: "W".into(), values: sun };
        let time = (0..900).map(|row| 300.0 * f64::from(row)).collect();
        (Inputs { time_s: Some(time), run: vec![1; 900], drivers: vec![driver], ..Inputs::default() }, reading, misfit)
    }

    fn measured(white_sd: f64) -> NoiseModel {
        NoiseModel {
            response: Noise { white_sd, ar_sd: 0.0, ar_correlation: 0.0 },
            inputs: InputNoise::default(),
            recordings: Vec::new(),
            input_error: InputError { variance: vec![0.0; 900], level: vec![0.0; 900], ..InputError::default() },
            step: 0.0,
            uncertainty: 0.1,
            weights: None,
            untold: Vec::new(),
            measured: true,
            rows: 400,
            says: "at night".into(),
        }
    }

    #[test]
    fn noise_at_work_is_not_that_of_a_night() {
        let by_day = |row: usize| if row % 300 < 150 { 0.2 } else { 0.0002 };
        let asked = |more: f64, of: &dyn Fn(usize) -> f64| {
            let (inputs, response, misfit) = days(more, of);
            at_work(&Problem { inputs: &inputs, response: &response, simulator: &Sun }, &misfit, &measured(0.0001))
        };
        let found = asked(0.0, &by_day).unwrap();
        // by day uniform within 0.2, half of the time: sd 0.115, 0.082 over all rows
        assert!(!found.measured && (0.04..0.2).contains(&found.floor()), "{}", found.floor());
        // as quiet by day as at night; or at night another reading each time, so that it is not off
        assert!(asked(0.0, &|_| 0.0002).is_none());
        assert!(asked(1.5, &by_day).is_none());
    }
}
