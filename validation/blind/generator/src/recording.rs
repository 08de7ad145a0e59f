//! The recording as the tool gets it: noisy columns at finite resolution, and the TOML beside them.
//!
//! Limits: the `stack` base model of the built-in 15 mm sensor only. Format: `design.md`, "Files and commands".

use crate::draws::Draws;
use crate::history::History;
use crate::noise::Noise;
use std::fmt::Write;

/// Recorded columns; units in the names as in the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    /// Run number.
    pub run: Vec<u32>,
    /// Clock, s.
    pub time_s: Vec<f64>,
    /// Load as recorded, N.
    pub force_n: Vec<f64>,
    /// Temperature as recorded, degC.
    pub temperature_c: Vec<f64>,
    /// Relative humidity, %, where it was recorded.
    pub humidity_pct: Option<Vec<f64>>,
    /// A further column, where a cause brings one.
    pub driver: Option<Column>,
    /// Capacitance as recorded, pF.
    pub capacitance_pf: Vec<f64>,
    /// Whether the declared base model has the warp.
    pub warp: bool,
}

/// A recorded column of any quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name under `[drivers]`.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// One entry a row.
    pub values: Vec<f64>,
}

impl Recording {
    /// `truth_pf` (noise-free) as recorded with `noise`.
    pub fn noisy(history: &History, truth_pf: &[f64], noise: &Noise, declared: Declared, draws: &mut Draws) -> Self {
        let capacitance = noise.capacitance(truth_pf.len(), draws);
        let force = history.force.iter().map(|f| rounded(f + noise.force_n * draws.normal(), 1e4)).collect();
        let temperature = history.temperature.iter().map(|t| rounded(t + noise.temperature_k * draws.normal(), 1e3)).collect();
        Self {
            run: history.run.clone(),
            time_s: history.time.clone(),
            force_n: force,
            temperature_c: temperature,
            humidity_pct: declared.humidity.then(|| history.humidity.iter().map(|h| rounded(*h, 1e2)).collect()),
            driver: None,
            capacitance_pf: truth_pf.iter().zip(capacitance).map(|(c, n)| rounded(c + n, 1e3)).collect(),
            warp: declared.warp,
        }
    }

    /// The CSV with its header.
    pub fn csv(&self) -> String {
        let humidity = if self.humidity_pct.is_some() { "humidity_pct," } else { "" };
        let driver = self.driver.as_ref().map(|d| format!("{},", d.name)).unwrap_or_default();
        let mut text = format!("run,time_s,force_n,temperature_c,{humidity}{driver}capacitance_pf\n");
        for row in 0..self.run.len() {
            let humidity = self.humidity_pct.as_ref().map(|h| format!("{:.2},", h[row])).unwrap_or_default();
            let driver = self.driver.as_ref().map(|d| format!("{:.4},", d.values[row])).unwrap_or_default();
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "{},{:.3},{:.4},{:.3},{humidity}{driver}{:.4}",
                self.run[row], self.time_s[row], self.force_n[row], self.temperature_c[row], self.capacitance_pf[row]
            );
        }
        text
    }

    /// The TOML beside it; the columns have the default names of the contract, `humidity_pct` included.
    pub fn toml(&self) -> String {
        let base = format!("model = \"stack\"\nsensor = \"singletact-s15-4.5n\"\nwarp = {}\n", self.warp);
        let column = |d: &Column| format!("[drivers]\n{0} = {{ column = \"{0}\", unit = \"{1}\" }}\n\n", d.name, d.unit);
        let drivers = self.driver.as_ref().map(column).unwrap_or_default();
        format!("schema = \"truegap.recording/1\"\nfile = \"recording.csv\"\n\n{drivers}[base]\n{base}")
    }
}

/// What the recording says of itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Declared {
    /// The base model has the warp.
    pub warp: bool,
    /// A humidity column is written.
    pub humidity: bool,
}

fn rounded(value: f64, per_unit: f64) -> f64 {
    (value * per_unit).round() / per_unit
}
