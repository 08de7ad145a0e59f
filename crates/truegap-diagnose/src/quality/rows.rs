//! What is wrong with a recording, before any physics is named: one kind of trouble a file.
//!
//! Limits: looks at one recording at a time; what is told here is certain or nearly so, doubts are told by [`crate::quality::preconditions`].

use crate::{
    data::{context::load_column, problem::Problem},
    noise::switching::{followed, looks_like_noise},
    quality::tuning::DRIVES,
    stats::spread,
    text::Scale,
};
use std::ops::Range;
use truegap_core::Inputs;

/// Where a row is, for a reader.
#[derive(Clone, Copy)]
pub struct Rows<'a> {
    /// what was done
    pub inputs: &'a Inputs,
    /// number in the recording as it was given, from 0; absent where no row was left out
    pub given: Option<&'a [usize]>,
    /// unit of the response
    pub unit: &'a str,
}

impl Rows<'_> {
    /// Number as the user counts, from 1.
    pub fn number(&self, row: usize) -> usize {
        self.given.map_or(row, |given| given[row]) + 1
    }

    /// `row 132 (t = 66.0 s)`.
    pub(crate) fn place(&self, row: usize) -> String {
        match &self.inputs.time_s {
            Some(time) => format!("row {} (t = {})", self.number(row), Scale::of("s", time[row].abs()).text(time[row])),
            None => format!("row {}", self.number(row)),
        }
    }

    /// `rows 40 to 95 (t = 20.0 s)`.
    pub(crate) fn places(&self, rows: &Range<usize>) -> String {
        let (first, last) = (self.number(rows.start), self.number(rows.end - 1));
        match &self.inputs.time_s {
            Some(time) => {
                format!("rows {first} to {last} (from t = {})", Scale::of("s", time[rows.start].abs()).text(time[rows.start]))
            }
            None => format!("rows {first} to {last}"),
        }
    }

    /// A reading with its unit.
    pub(crate) fn reading(&self, value: f64) -> String {
        let number = format!("{value:.6}");
        let number = number.trim_end_matches('0').trim_end_matches('.');
        if self.unit.is_empty() || self.unit == "1" { number.to_owned() } else { format!("{number} {}", self.unit) }
    }

    /// First and last number of each stretch.
    pub(crate) fn numbers<'r>(&self, ranges: impl Iterator<Item = &'r Range<usize>>) -> Vec<[usize; 2]> {
        ranges.map(|rows| [self.number(rows.start), self.number(rows.end - 1)]).collect()
    }

    /// The same for single rows in order, neighbours put together.
    pub(crate) fn numbers_of(&self, rows: &[usize]) -> Vec<[usize; 2]> {
        let mut found: Vec<[usize; 2]> = Vec::new();
        for number in rows.iter().map(|row| self.number(*row)) {
            match found.last_mut() {
                Some([_, last]) if *last + 1 == number => *last = number,
                _ => found.push([number, number]),
            }
        }
        found
    }
}

/// Stretches of equal values inside runs.
pub(crate) fn equal_stretches(column: &[f64], runs: &[Range<usize>]) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    for run in runs {
        let mut first = run.start;
        for row in run.start + 1..=run.end {
            if row == run.end || column[row] != column[first] {
                found.push(first..row);
                first = row;
            }
        }
    }
    found
}

/// Share of neighbouring rows with equal values, those inside stretches longer than `longest` aside.
pub(crate) fn standing_still(stretches: &[Range<usize>], longest: usize) -> f64 {
    let others = stretches.iter().filter(|s| s.len() < longest);
    let (pairs, rows) = others.fold((0, 0), |(pairs, rows), s| (pairs + s.len() - 1, rows + s.len()));
    if rows == 0 { 1.0 } else { pairs as f64 / rows as f64 }
}

/// Least and greatest value over some rows.
pub(crate) fn ends(column: &[f64], rows: impl Iterator<Item = usize>) -> (f64, f64) {
    truegap_core::ends(rows.map(|row| column[row]))
}

/// Whether a column moves by no more than `least`, or shows nothing but its own noise, which the reading does not follow.
pub(crate) fn stands(column: &[f64], least: f64, problem: &Problem<'_>) -> bool {
    let runs = problem.inputs.runs();
    spread(column) <= least || looks_like_noise(column, problem.inputs, &runs) && !followed(column, problem.response, &runs)
}

/// Inputs that drive a reading: load or gap, temperature where it moves by more than a kelvin, simulation; none of them where it shows only its own noise.
pub(crate) fn drivers(problem: &Problem<'_>) -> Vec<Vec<f64>> {
    let inputs = problem.inputs;
    let load = load_column(inputs, problem.simulator).filter(|load| !stands(load, 0.0, problem));
    let warm = inputs.temperature_c.clone().filter(|warm| !stands(warm, DRIVES, problem));
    let columns = [load, warm, inputs.simulated.clone().filter(|s| !stands(s, 0.0, problem))];
    let recorded = inputs.drivers.iter().map(|driver| driver.values.clone()).filter(|d| !stands(d, 0.0, problem));
    columns.into_iter().flatten().chain(recorded).collect()
}

/// Greatest change of any driver over some rows, as a share of its range over the recording.
pub(crate) fn moved(drivers: &[Vec<f64>], rows: &Range<usize>) -> f64 {
    let share = |column: &Vec<f64>| {
        let (low, high) = ends(column, rows.clone());
        (high - low) / spread(column)
    };
    drivers.iter().map(share).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{common::Plate, quality::dead::dead_channel};
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    /// A reading of noise that hangs for 60 of 400 rows, under a load that stands still and this temperature.
    fn hangs(temperature_c: impl Fn(usize, f64) -> f64) -> bool {
        let random = &mut ChaCha8Rng::seed_from_u64(4);
        let mut noise = || -> f64 { StandardNormal.sample(random) };
        let response: Vec<f64> =
            (0..400).map(|row| if (200..260).contains(&row) { 210.0 } else { 210.0 + 0.004 * noise() }).collect();
        let inputs = Inputs {
            time_s: Some((0..400).map(f64::from).collect()),
            run: vec![1; 400],
            force_n: Some(vec![0.0; 400]),
            temperature_c: Some((0..400).map(|row| temperature_c(row, noise())).collect()),
            ..Inputs::default()
        };
        let problem = Problem { inputs: &inputs, response: &response, simulator: &Plate::new(Some(true)) };
        dead_channel(&problem, &Rows { inputs: &inputs, given: None, unit: "pF" }).is_some()
    }

    /// "while the inputs move by 80 % of their range" was said of a thermometer that showed 0.1 K of noise, and no physics was named.
    #[test]
    fn a_thermometer_that_shows_only_noise_does_not_move() {
        assert!(!hangs(|_, noise| 22.0 + 0.1 * noise));
        assert!(!hangs(|_, noise| 22.0 + 0.5 * noise), "noise that spans 3 K is noise");
        assert!(!hangs(|row, noise| 22.0 + 0.6 * (row as f64 / 60.0).sin().max(0.0) + 0.01 * noise), "less than a kelvin");
        assert!(hangs(|row, noise| 22.0 + 8.0 * (row as f64 / 60.0).sin() + 0.1 * noise));
    }
}
