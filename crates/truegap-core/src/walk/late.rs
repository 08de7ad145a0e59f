//! The clock of the load against that of the response.
//!
//! Between two rows a column goes on as its own rows say: straight, or by a cubic ([`super::between`]).
//!
//! Limits: a shifted column keeps its first and last value beyond the ends of a run, where nothing was recorded; [`beyond_the_ends`] says which rows these are.

use super::known;
use crate::{chain::Stage, inputs::Inputs};
use std::{borrow::Cow, ops::Range};

/// The inputs on the response's clock.
pub(super) fn on_one_clock<'a>(inputs: &'a Inputs, stages: &[&dyn Stage]) -> Cow<'a, Inputs> {
    // most stages shift nothing, and are not asked row by row
    let stages: Vec<&&dyn Stage> = stages.iter().filter(|stage| stage.shifts()).collect();
    if stages.is_empty() {
        return Cow::Borrowed(inputs);
    }
    let clock = clock(inputs);
    let first = clock.first().copied().unwrap_or(0.0);
    let late = |of: &dyn Fn(&dyn Stage, f64) -> f64| {
        let late = |time: &f64| stages.iter().map(|stage| of(**stage, time - first)).sum();
        clock.iter().map(late).collect::<Vec<f64>>()
    };
    let load = late(&|stage, elapsed| stage.late_s(elapsed));
    if load.iter().all(|late| *late == 0.0) {
        return Cow::Borrowed(inputs);
    }
    let of_driver = |driver: usize| late(&|stage, elapsed| stage.driver_late_s(driver, elapsed));
    Cow::Owned(caught_up(inputs, &clock, &load, of_driver))
}

/// Rows that a shifted load is read for from beyond an end of their run, or from between the last two rows before it: nothing was recorded there, so that what a model makes of them is made up.
pub fn beyond_the_ends(inputs: &Inputs, stages: &[&dyn Stage]) -> Vec<usize> {
    let clock = clock(inputs);
    let Some(first) = clock.first() else { return Vec::new() };
    let late = |row: usize| stages.iter().map(|stage| stage.late_s(clock[row] - first)).sum::<f64>();
    let beyond = |run: &Range<usize>, row: usize| {
        let (late, last) = (late(row), run.end - 1);
        let (start, end) = (clock[(run.start + 1).min(last)], clock[last.saturating_sub(1).max(run.start)]);
        (late > 0.0 && clock[row] + late > end) || (late < 0.0 && clock[row] + late < start)
    };
    inputs.runs().iter().flat_map(|run| run.clone().filter(|row| beyond(run, *row)).collect::<Vec<_>>()).collect()
}

/// The inputs with the columns of the load (force, pressure, gap, simulation) read `late[row]` seconds further on, and each driver by what is `of_driver`: what stands there happened now.
fn caught_up(inputs: &Inputs, clock: &[f64], late: &[f64], of_driver: impl Fn(usize) -> Vec<f64>) -> Inputs {
    let mut shifted = inputs.clone();
    let columns = [&mut shifted.force_n, &mut shifted.pressure_pa, &mut shifted.gap_m, &mut shifted.simulated];
    let runs = inputs.runs();
    for column in columns.into_iter().flatten() {
        *column = known::shifted(clock, column, &runs, late);
    }
    for (number, driver) in shifted.drivers.iter_mut().enumerate() {
        driver.values = known::shifted(clock, &driver.values, &runs, &of_driver(number));
    }
    shifted
}

/// Seconds of each row; rows count as seconds where no clock was recorded.
fn clock(inputs: &Inputs) -> Cow<'_, [f64]> {
    match &inputs.time_s {
        Some(time) => Cow::Borrowed(time),
        None => Cow::Owned((0..inputs.len()).map(|row| row as f64).collect()),
    }
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)] // one run
mod tests {
    use super::*;

    /// Seconds late at the first row, and seconds more in each second.
    struct Late(f64, f64);
    impl Stage for Late {
        fn late_s(&self, elapsed_s: f64) -> f64 {
            self.0 + self.1 * elapsed_s
        }
    }

    fn ramp() -> Inputs {
        let time = vec![0.0, 1.0, 3.0, 4.0, 5.0, 7.0];
        let force = vec![0.0, 2.0, 6.0, 10.0, 12.0, 16.0];
        Inputs { time_s: Some(time), run: vec![1, 1, 1, 2, 2, 2], force_n: Some(force), ..Inputs::default() }
    }

    fn force(inputs: &Inputs) -> Vec<f64> {
        inputs.force_n.clone().unwrap()
    }

    fn shifted(late: f64) -> Vec<f64> {
        shifted_by(Late(late, 0.0))
    }

    fn shifted_by(stage: Late) -> Vec<f64> {
        let inputs = ramp();
        force(&on_one_clock(&inputs, &[&stage]))
    }

    #[test]
    fn a_late_load_is_read_further_on_and_held_at_the_ends_of_its_run() {
        // slope 2 N/s in both runs, so half a second is 1 N
        assert_eq!(shifted(0.5), [1.0, 3.0, 6.0, 11.0, 13.0, 16.0]);
        assert_eq!(shifted(-0.5), [0.0, 1.0, 5.0, 10.0, 11.0, 15.0]);
        assert_eq!(shifted(100.0), [6.0, 6.0, 6.0, 16.0, 16.0, 16.0]);
    }

    /// A cubic with the slopes of parabolas has no error on a parabola, however the rows are spaced, but beside the ends.
    #[test]
    fn a_parabola_is_read_between_rows_without_an_error() {
        let time = vec![0.0, 1.0, 3.0, 4.0, 4.5, 7.0, 8.0];
        let curve = |t: f64| 2.0 - 3.0 * t + 0.5 * t * t;
        let force = Some(time.iter().copied().map(curve).collect());
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 7], force_n: force, ..Inputs::default() };
        let shifted = self::force(&on_one_clock(&inputs, &[&Late(0.4, 0.0)]));
        for row in 1..5 {
            approx::assert_abs_diff_eq!(shifted[row], curve(time[row] + 0.4), epsilon = 1e-12);
        }
    }

    /// Steps from row to row are straight between rows: a cubic would run beyond them on both sides.
    #[test]
    fn steps_are_read_straight() {
        let time: Vec<f64> = (0..41).map(f64::from).collect();
        let force: Vec<f64> = time.iter().map(|t| (t / 10.0).floor()).collect();
        let inputs = Inputs { time_s: Some(time), run: vec![1; 41], force_n: Some(force.clone()), ..Inputs::default() };
        let shifted = self::force(&on_one_clock(&inputs, &[&Late(0.3, 0.0)]));
        for row in 0..40 {
            approx::assert_abs_diff_eq!(shifted[row], 0.7 * force[row] + 0.3 * force[row + 1], epsilon = 1e-12);
        }
    }

    /// Rows at one time, as loggers of whole seconds write them, have finite values between them.
    #[test]
    fn repeated_times_are_read_without_a_slope() {
        let inputs = Inputs {
            time_s: Some(vec![0.0, 1.0, 1.0, 1.0, 2.0]),
            run: vec![1; 5],
            force_n: Some(vec![0.0, 1.0, 5.0, 2.0, 3.0]),
            ..Inputs::default()
        };
        assert!(force(&on_one_clock(&inputs, &[&Late(0.5, 0.0)])).iter().all(|value| value.is_finite()));
    }

    #[test]
    fn a_slow_clock_is_later_and_later_through_all_runs() {
        // a quarter of a second a second from half a second early; slope 2 N/s
        assert_eq!(shifted_by(Late(-0.5, 0.25)), [0.0, 1.5, 6.0, 11.0, 13.5, 16.0]);
    }

    /// Three rows a run, at 0, 1 and 3 s and at 4, 5 and 7 s.
    #[test]
    fn rows_that_are_read_from_beyond_the_ends_are_known() {
        let rows = |late: f64, rate: f64| beyond_the_ends(&ramp(), &[&Late(late, rate)]);
        assert_eq!(rows(0.0, 0.0), [0_usize; 0]);
        assert_eq!(rows(0.5, 0.0), [1, 2, 4, 5]);
        assert_eq!(rows(-0.5, 0.0), [0, 1, 3, 4]);
        // early at first, late in the end
        assert_eq!(rows(-0.5, 0.25), [0, 1, 2, 4, 5]);
    }

    /// The first driver is as late as the load, the second was recorded beside the response.
    #[test]
    fn a_driver_beside_the_response_is_not_shifted_with_the_load() {
        struct OfTheFirst;
        impl Stage for OfTheFirst {
            fn late_s(&self, _: f64) -> f64 {
                0.5
            }
            fn driver_late_s(&self, driver: usize, elapsed_s: f64) -> f64 {
                if driver == 0 { self.late_s(elapsed_s) } else { 0.0 }
            }
        }
        let driver = |name: &str| crate::Driver { name: name.into(), unit: "1".into(), values: force(&ramp()) };
        let inputs = Inputs { drivers: vec![driver("a"), driver("b")], ..ramp() };
        let shifted = on_one_clock(&inputs, &[&OfTheFirst]);
        assert_eq!(force(&shifted), shifted.drivers[0].values);
        assert_ne!(force(&shifted), force(&inputs));
        assert_eq!(force(&inputs), shifted.drivers[1].values);
    }

    #[test]
    fn two_stages_shift_by_the_sum() {
        let inputs = ramp();
        let (a, b) = (Late(0.75, 0.0), Late(-0.25, 0.0));
        assert_eq!(force(&on_one_clock(&inputs, &[&a, &b])), shifted(0.5));
    }
}
