//! Which columns moved in a recording: what an effect follows is decided by these facts, so that it follows the same column on other inputs.
//!
//! Limits: whether and how far a column moves, not when.

use crate::{
    data::{angle::begins_anew, load::load_column},
    stats::spread,
};
use serde::{Deserialize, Serialize};
use std::{collections::BTreeMap, ops::Range};
use truegap_core::{Driver, Inputs, Simulator, StageName, ends};

/// Name of the recorded humidity among the drivers that move.
pub const HUMIDITY: &str = "humidity";

/// Columns that moved.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Moved {
    /// range of the temperature, K; 0 without a thermometer
    pub temperature_k: f64,
    /// its least and greatest value, degrees Celsius; absent without a thermometer, and in a file of an earlier version
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub temperature_c: Option<[f64; 2]>,
    /// range of the load, full loads; 0 where load plays no part
    pub load: f64,
    /// whether a gap was given that moves
    pub gap: bool,
    /// whether somebody's simulation was given that moves
    pub simulated: bool,
    /// whether the clock is a date
    #[serde(default)]
    pub dated: bool,
    /// whether the load, the gap, a simulation or a driver stands nearly still for long and moves by jumps
    #[serde(default)]
    pub jumps: bool,
    /// names of the recorded drivers that move up and down, in the order of the recording, and [`HUMIDITY`] where that moves beside a base model without plates; of three and more the second is one that the base model does
    /// not follow by itself, where there is one
    pub drivers: Vec<String>,
    /// names of those that the base model follows by itself; absent before it was asked, and in a file of an earlier version. A model file is asked for the numbers of its effects on a row that has its drivers alone, which a
    /// simulator of the user's own need not know how to answer
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub followed: Option<Vec<String>>,
    /// names of those that are angles and begin anew after each turn: to rise and to fall means nothing there
    #[serde(default)]
    pub round: Vec<String>,
    /// least and greatest value of each driver that moves up and down: a law over a range keeps the range of the recording that it was found in
    #[serde(default)]
    pub ranges: BTreeMap<String, [f64; 2]>,
}

/// Most that the steps before and behind a jump may be, over its size.
const ALONE: f64 = 0.2;
/// Least size of a jump, over the range of its column: less is a digit of a recorder.
const SIZE_OF_A_JUMP: f64 = 0.05;
/// Share that jumps hold of the squares of all steps from row to row.
const IN_JUMPS: f64 = 0.9;

/// Whether nearly all of the motion of a column is in single rows before and behind which it hardly moves.
fn jumps(column: &[f64], runs: &[Range<usize>]) -> bool {
    let least = SIZE_OF_A_JUMP * spread(column);
    let (mut in_jumps, mut all) = (0.0, 0.0);
    for run in runs {
        let steps = || column[run.clone()].windows(2).map(|pair| (pair[1] - pair[0]).abs());
        // each step with those before and behind it, where there are any
        let before = std::iter::once(0.0).chain(steps());
        let behind = steps().skip(1).chain([0.0]);
        for ((before, size), behind) in before.zip(steps()).zip(behind) {
            all += size * size;
            if size > least && before.max(behind) <= ALONE * size {
                in_jumps += size * size;
            }
        }
    }
    in_jumps > 0.0 && in_jumps >= IN_JUMPS * all
}

/// Puts a driver that the base model does not follow by itself in the second place, where the one there is followed: effects ask for two drivers, and what the base model follows has its own laws.
fn put_second_beside_the_base(drivers: &mut [String], follows: impl Fn(&str) -> bool) {
    if drivers.len() > 2
        && follows(&drivers[1])
        && let Some(other) = (2..drivers.len()).find(|number| !follows(&drivers[*number]))
    {
        drivers.swap(1, other);
    }
}

/// Share of the span of a column by which it is moved to see whether the base model follows it.
const MOVED_BY: f64 = 0.1;

/// Whether the response of the base model changes where the driver of this name, or recorded humidity, is moved: two simulations.
pub(crate) fn follows(simulator: &dyn Simulator, inputs: &Inputs, name: &str, span: f64) -> bool {
    let mut moved = inputs.clone();
    let recorded = moved.drivers.iter_mut().find(|driver| driver.name == name).map(|driver| &mut driver.values);
    let column = recorded.or_else(|| moved.humidity_pct.as_mut().filter(|_| name == HUMIDITY));
    column.into_iter().flatten().for_each(|value| *value += MOVED_BY * span);
    // off the centre of the priors, where a slope may be 0
    let values: Vec<f64> = simulator.parameters().iter().map(|p| p.prior.at(1.0)).collect();
    let respond = |inputs| simulator.respond(&values, inputs, &[]);
    matches!((respond(inputs), respond(&moved)), (Ok(here), Ok(there)) if here != there)
}

impl Moved {
    /// What moves in `inputs`.
    pub fn of(inputs: &Inputs, simulator: &dyn Simulator) -> Self {
        let range = |column: &[f64]| if column.is_empty() { 0.0 } else { spread(column) };
        let moves = |column: &Option<Vec<f64>>| column.as_deref().is_some_and(|column| range(column) > 0.0);
        let moving = inputs.drivers.iter().filter(|driver| range(&driver.values) > 0.0);
        let (round, straight): (Vec<&Driver>, Vec<&Driver>) = moving.partition(|driver| begins_anew(driver));
        let range_of = |values: &[f64]| ends(values.iter().copied()).into();
        let mut ranges: BTreeMap<String, [f64; 2]> =
            straight.iter().map(|driver| (driver.name.clone(), range_of(&driver.values))).collect();
        let names = |drivers: Vec<&Driver>| drivers.into_iter().map(|driver| driver.name.clone()).collect::<Vec<String>>();
        let mut drivers = names(straight);
        let taken = inputs.drivers.iter().any(|driver| driver.name == HUMIDITY);
        let of_plates = simulator.lacks(StageName::Geometry).is_none();
        if let Some(humidity) = inputs.humidity_pct.as_deref().filter(|column| range(column) > 0.0 && !taken && !of_plates) {
            drivers.push(HUMIDITY.into());
            ranges.insert(HUMIDITY.into(), range_of(humidity));
        }
        put_second_beside_the_base(&mut drivers, |name| {
            let span = ranges.get(name).map_or(0.0, |[least, most]| most - least);
            follows(simulator, inputs, name, span)
        });
        let load = load_column(inputs, simulator);
        let followed = [load.as_deref(), inputs.gap_m.as_deref(), inputs.simulated.as_deref()].into_iter().flatten();
        let runs = inputs.runs();
        Self {
            jumps: followed.chain(inputs.drivers.iter().map(|driver| &*driver.values)).any(|column| jumps(column, &runs)),
            temperature_k: inputs.temperature_c.as_deref().map_or(0.0, range),
            temperature_c: inputs.temperature_c.as_deref().map(range_of),
            load: load.as_deref().map_or(0.0, range),
            gap: moves(&inputs.gap_m),
            simulated: moves(&inputs.simulated),
            dated: inputs.began_s.is_some(),
            drivers,
            followed: None,
            round: names(round),
            ranges,
        }
    }

    /// Whether anything but time moved.
    pub fn anything(&self) -> bool {
        self.temperature_k > 0.0
            || self.load > 0.0
            || self.gap
            || self.simulated
            || !self.drivers.is_empty()
            || !self.round.is_empty()
    }

    /// One row of inputs that has these drivers, to ask an effect for its numbers where no recording is at hand.
    pub fn one_row(&self) -> Inputs {
        let driver = |name: &String| Driver { name: name.clone(), unit: "1".into(), values: vec![0.0] };
        Inputs { run: vec![1], drivers: self.drivers.iter().map(driver).collect(), ..Inputs::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plant whose model follows the warmth, beside a vacuum and a humidity: both are asked. What is followed keeps its place where nothing else could stand there.
    #[test]
    fn the_second_driver_is_one_that_the_base_model_does_not_follow() {
        let ordered = |names: &[&str], followed: &str| {
            let mut drivers: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
            put_second_beside_the_base(&mut drivers, |name| name == followed);
            drivers.join(" ")
        };
        assert_eq!(ordered(&["vacuum", "warmth", "humidity"], "warmth"), "vacuum humidity warmth");
        assert_eq!(ordered(&["vacuum", "warmth"], "warmth"), "vacuum warmth");
        assert_eq!(ordered(&["warmth", "vacuum", "humidity"], "warmth"), "warmth vacuum humidity");
    }

    /// A valve that is set every minute, with what it leaves trembling. A sine, a ramp, noise, the digits of a recorder, what decays from the first row on and what stands still do not jump.
    #[test]
    fn a_column_that_is_set_every_minute_jumps() {
        let column = |of: &dyn Fn(f64) -> f64| (0..900).map(|row| of(f64::from(row))).collect::<Vec<_>>();
        let set = |row: f64| ((row / 60.0).floor() * 7.0) % 5.0;
        let runs = [0..400, 400..900];
        assert!(jumps(&column(&|row| set(row) + 0.05 * (row / 11.0).sin()), &runs));
        let digits = |row: f64| (40.0 * (row / 200.0).sin()).floor();
        let smooth: [&dyn Fn(f64) -> f64; 6] =
            [&|row| (row / 30.0).sin(), &|row| row, &|row| (row * row).sin(), &digits, &|row| (-row / 5.0).exp(), &|_| 3.0];
        for of in smooth {
            assert!(!jumps(&column(of), &runs));
        }
        assert!(!jumps(&[0.0, 1.0, 0.0], std::slice::from_ref(&(0..3))));
    }
}
