//! The column of a mechanism: driver, form and kinetics, in the driver's own unit.
//!
//! Limits: memory goes on from run to run where there is a clock, and starts afresh with each run where there is none.

use crate::{
    data::context::{Context, load_column},
    effects::composed::{
        mechanism::{Numbers, Sentence, Sum},
        words::{Driver, Form, Kinetics},
    },
    effects::memory::{Play, elapsed_s, first_order_lag, lag_through_runs, rates, walk},
    stats::spread,
};
use truegap_core::Inputs;

/// What can be followed at a place of the chain.
#[derive(Clone, Copy)]
pub struct Courses<'a> {
    /// what was recorded
    pub inputs: &'a Inputs,
    /// load, full loads
    pub load: Option<&'a [f64]>,
    /// temperature above the reference, K
    pub temperature: Option<&'a [f64]>,
    /// reading above its zero
    pub reading: Option<&'a [f64]>,
}

/// Names of the recorded columns that are neither load nor temperature.
pub fn recorded(inputs: &Inputs) -> Vec<(String, &[f64], String)> {
    let mut all: Vec<(String, &[f64], String)> =
        inputs.drivers.iter().map(|d| (d.name.clone(), d.values.as_slice(), d.unit.clone())).collect();
    let others = [("gap", &inputs.gap_m, "m"), ("humidity", &inputs.humidity_pct, "%")];
    all.extend(others.into_iter().filter_map(|(name, c, unit)| Some((name.to_owned(), c.as_deref()?, unit.to_owned()))));
    all
}

/// The driver's course; `None` where it was not recorded or is not known at this place.
pub fn course(driver: &Driver, at: &Courses<'_>) -> Option<Vec<f64>> {
    let clock = at.inputs.time_s.as_deref();
    let rate = |x: &[f64]| clock.map(|clock| rates(Some(clock), x, &at.inputs.runs()));
    let named = |name: &str| recorded(at.inputs).into_iter().find(|(n, _, _)| n == name).map(|(_, values, _)| values.to_vec());
    match driver {
        Driver::Load | Driver::LoadHistory => at.load.map(<[f64]>::to_vec),
        Driver::LoadRate => rate(at.load?),
        Driver::Temperature => at.temperature.map(<[f64]>::to_vec),
        Driver::TemperatureRate => rate(at.temperature?),
        Driver::Time => clock.map(|time| time.iter().map(|t| t - time[0]).collect()),
        Driver::Reading => at.reading.map(<[f64]>::to_vec),
        Driver::Recorded(name) => named(name),
        Driver::RateOf(name) => rate(&named(name)?),
    }
}

/// Whether a driver was recorded, as far as inputs tell, and moves.
pub fn available(driver: &Driver, context: &Context<'_>) -> bool {
    let load = load_column(context.inputs, context.simulator);
    let temperature = context.inputs.temperature_c.as_deref();
    let reading = if context.simulator.moves() { context.inputs.simulated.as_deref().or(load.as_deref()) } else { None };
    let at = Courses { inputs: context.inputs, load: load.as_deref(), temperature, reading };
    course(driver, &at).is_some_and(|x| spread(&x) > 0.0)
}

/// The whole column u.
pub fn column(sentence: &Sentence, numbers: &Numbers, at: &Courses<'_>) -> Option<Vec<f64>> {
    let mut x = course(&sentence.driver, at)?;
    if sentence.even {
        x.iter_mut().for_each(|x| *x = x.abs());
    }
    Some(of_course(sentence, numbers, at.inputs, x))
}

/// The column of a course that is known already; even parts are taken.
pub fn of_course(sentence: &Sentence, numbers: &Numbers, inputs: &Inputs, mut x: Vec<f64>) -> Vec<f64> {
    let law = |x: &mut [f64]| x.iter_mut().for_each(|x| *x = form(sentence, numbers, *x));
    match sentence.kinetics {
        Kinetics::Static => law(&mut x),
        Kinetics::FirstOrder if sentence.driver == Driver::Time => {
            // a start at the first row, which time itself has no memory of
            x.iter_mut().for_each(|t| *t = -(-*t / numbers.tau_s.max(f64::MIN_POSITIVE)).exp_m1());
        }
        Kinetics::FirstOrder => {
            law(&mut x);
            let now = if sentence.passing { x.clone() } else { vec![0.0; x.len()] };
            late(inputs, numbers.tau_s, &mut x);
            x.iter_mut().zip(now).for_each(|(late, now)| *late -= now);
        }
        Kinetics::RateIndependent => {
            x = way(inputs, &x, numbers.width);
        }
        Kinetics::Accumulating => {
            x = added_up(sentence.sum.unwrap_or(Sum::Dose), inputs, &x);
            law(&mut x);
        }
        Kinetics::Event if sentence.driver == Driver::Time => {
            x.iter_mut().for_each(|t| *t = if *t >= numbers.threshold { 1.0 } else { 0.0 });
        }
        Kinetics::Event => x = crossings(&x, numbers.threshold),
        Kinetics::Periodic => {
            let turn = std::f64::consts::TAU / numbers.period;
            x.iter_mut().for_each(|x| *x = (turn * *x + numbers.phase).sin());
        }
    }
    x
}

fn form(sentence: &Sentence, numbers: &Numbers, x: f64) -> f64 {
    match sentence.form {
        Form::Linear => x,
        Form::Power => x.signum() * x.abs().powf(numbers.exponent),
        Form::Threshold if sentence.below => (numbers.threshold - x).max(0.0),
        Form::Threshold => (x - numbers.threshold).max(0.0),
        Form::Saturating => x / (1.0 + x.abs() / numbers.scale),
        Form::Peak => {
            let mut from = x - numbers.threshold;
            if numbers.turn > 0.0 {
                from -= numbers.turn * (from / numbers.turn).round();
            }
            (-0.5 * (from / numbers.scale).powi(2)).exp()
        }
    }
}

fn late(inputs: &Inputs, tau_s: f64, x: &mut [f64]) {
    match inputs.time_s {
        Some(_) => lag_through_runs(inputs, tau_s, x),
        None => first_order_lag(inputs, tau_s, x, |first| first),
    }
}

/// From -1 on a long fall to 1 on a long rise: a play of half width `width`, at rest at the first row of a run.
fn way(inputs: &Inputs, x: &[f64], width: f64) -> Vec<f64> {
    let (mut play, mut out) = (Play::new(width, 0.0), vec![0.0; x.len()]);
    walk(inputs, |row, step| {
        match step {
            None => play.state = x[row],
            Some(_) => _ = play.slip(x[row]),
        }
        out[row] = (x[row] - play.state) / width;
    });
    out
}

/// What adds up to each row, over all runs.
fn added_up(sum: Sum, inputs: &Inputs, x: &[f64]) -> Vec<f64> {
    let mut total = if sum == Sum::Greatest { f64::NEG_INFINITY } else { 0.0 };
    let mut out = Vec::with_capacity(x.len());
    for (row, &now) in x.iter().enumerate() {
        match sum {
            Sum::Greatest => total = f64::max(total, now),
            Sum::Path if row > 0 && inputs.run[row] == inputs.run[row - 1] => total += (now - x[row - 1]).abs(),
            Sum::Dose if row > 0 => total += 0.5 * (now + x[row - 1]) * (elapsed_s(inputs, row) - elapsed_s(inputs, row - 1)),
            Sum::Path | Sum::Dose => {}
        }
        out.push(total);
    }
    out
}

/// How many times the level has been passed upwards.
fn crossings(x: &[f64], level: f64) -> Vec<f64> {
    let mut count = 0.0;
    let step = |row: usize| {
        if row > 0 && x[row - 1] < level && x[row] >= level {
            count += 1.0;
        }
        count
    };
    (0..x.len()).map(step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::composed::words::{Action, Quantity};

    fn inputs(rows: usize) -> Inputs {
        Inputs { time_s: Some((0..rows).map(|i| i as f64).collect()), run: vec![1; rows], ..Inputs::default() }
    }

    fn sentence(driver: Driver, kinetics: Kinetics, form: Form) -> Sentence {
        Sentence {
            quantity: Quantity::Reading,
            action: Action::Adds,
            driver,
            kinetics,
            form,
            even: false,
            below: false,
            passing: false,
            sum: None,
        }
    }

    #[test]
    fn a_ramp_adds_up_to_half_the_square_of_its_time() {
        let inputs = inputs(5);
        let load: Vec<f64> = (0..5).map(f64::from).collect();
        let at = Courses { inputs: &inputs, load: Some(&load), temperature: None, reading: None };
        let words = sentence(Driver::LoadHistory, Kinetics::Accumulating, Form::Linear);
        let dose = column(&words, &Numbers::default(), &at).unwrap();
        assert_eq!(dose, [0.0, 0.5, 2.0, 4.5, 8.0]);
        let path = column(&Sentence { sum: Some(Sum::Path), ..words }, &Numbers::default(), &at).unwrap();
        assert_eq!(path, load);
    }

    #[test]
    fn a_play_is_plus_one_on_a_long_rise_and_minus_one_on_a_long_fall() {
        let inputs = inputs(21);
        let load: Vec<f64> = (0..21).map(|i: i32| f64::from(10 - (i - 10).abs())).collect();
        let at = Courses { inputs: &inputs, load: Some(&load), temperature: None, reading: None };
        let words = sentence(Driver::Load, Kinetics::RateIndependent, Form::Linear);
        let way = column(&words, &Numbers { width: 2.0, ..Numbers::default() }, &at).unwrap();
        assert_eq!((way[10], way[20]), (1.0, -1.0));
        assert_eq!(way[12], 0.0);
    }

    /// A fit that ran away asks for it; its answer is refused elsewhere, as no finite one.
    #[test]
    fn a_play_of_numbers_that_are_none_is_no_panic() {
        for (width, second) in [(f64::NAN, 1.0), (0.5, f64::NAN), (f64::INFINITY, 1.0)] {
            assert_eq!(way(&inputs(3), &[0.0, second, 0.0], width).len(), 3);
        }
    }

    #[test]
    fn a_peak_of_an_angle_reaches_over_the_end_of_the_turn() {
        let words = sentence(Driver::Recorded("direction".into()), Kinetics::Static, Form::Peak);
        let numbers = Numbers { threshold: 350.0, scale: 20.0, turn: 360.0, ..Numbers::default() };
        let at = |x: f64| of_course(&words, &numbers, &inputs(1), vec![x])[0];
        approx::assert_relative_eq!(at(10.0), (-0.5f64).exp(), max_relative = 1e-12);
        approx::assert_relative_eq!(at(330.0), at(10.0), max_relative = 1e-12);
        assert!(at(170.0) < 1e-15);
    }

    #[test]
    fn levels_are_counted_upwards_only() {
        assert_eq!(crossings(&[0.0, 2.0, 0.0, 3.0, 4.0], 1.0), [0.0, 1.0, 1.0, 2.0, 2.0]);
    }
}
