//! Which columns moved in a recording: what an effect follows is decided by these facts, so that it follows the same column on other inputs.
//!
//! Limits: whether and how far a column moves, not when.

use crate::{
    data::{angle::begins_anew, load::load_column},
    stats::spread,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use truegap_core::{Driver, Inputs, Simulator, StageName, ends};

/// Name of the recorded humidity among the drivers that move.
pub const HUMIDITY: &str = "humidity";

/// Columns that moved.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Moved {
    /// range of the temperature, K; 0 without a thermometer
    pub temperature_k: f64,
    /// range of the load, full loads; 0 where load plays no part
    pub load: f64,
    /// whether a gap was given that moves
    pub gap: bool,
    /// whether somebody's simulation was given that moves
    pub simulated: bool,
    /// whether the clock is a date
    #[serde(default)]
    pub dated: bool,
    /// names of the recorded drivers that move up and down, in the order of the recording, and [`HUMIDITY`] where that moves beside a base model without plates
    pub drivers: Vec<String>,
    /// names of those that are angles and begin anew after each turn: to rise and to fall means nothing there
    #[serde(default)]
    pub round: Vec<String>,
    /// least and greatest value of each driver that moves up and down: a law over a range keeps the range of the recording that it was found in
    #[serde(default)]
    pub ranges: BTreeMap<String, [f64; 2]>,
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
        Self {
            temperature_k: inputs.temperature_c.as_deref().map_or(0.0, range),
            load: load_column(inputs, simulator).as_deref().map_or(0.0, range),
            gap: moves(&inputs.gap_m),
            simulated: moves(&inputs.simulated),
            dated: inputs.began_s.is_some(),
            drivers,
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
