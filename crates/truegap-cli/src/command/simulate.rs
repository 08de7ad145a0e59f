//! `truegap simulate`: the analytic model at points, or along a recorded history.

use super::{Outcome, Run};
use crate::console::Console;
use crate::table::{digits, table};
use anyhow::bail;
use std::path::PathBuf;
use truegap::axis;
use truegap::core::{Dimension, Recording};
use truegap::model::{SeriesOrder, StackOptions, State};
use truegap::predict::{Driven, drive, grid};
use truegap::sensors::{DEFAULT_SENSOR, find_sensor};

/// Capacitance at given loads and temperatures, or along the history of a recording
#[derive(Debug, clap::Args)]
pub struct Simulate {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// Loads: a value ("4.5 N"), a list ("0, 1, 4.5 N") or a range ("0:4.5 N:10", both ends included)
    #[arg(long, allow_hyphen_values = true, required_unless_present = "drive", conflicts_with = "drive")]
    load: Option<String>,
    /// Temperatures, written like loads; the sensor's reference temperature where none is given
    #[arg(long, allow_hyphen_values = true, conflicts_with = "drive")]
    temperature: Option<String>,
    /// Leave out the warp of the electrode
    #[arg(long)]
    no_warp: bool,
    /// Order of (19) and (21): as printed, or exact for a bent gap
    #[arg(long, value_enum, default_value = "printed")]
    series: Series,
    /// Follow the loads and temperatures of a recording
    #[arg(long, value_name = "RECORDING")]
    drive: Option<PathBuf>,
}

/// Order in which the layers of the main gap are added up.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum Series {
    /// each layer over the plate, then in series: (21) as printed
    Printed,
    /// in series at each point, then over the plate
    Exact,
}

impl From<Series> for SeriesOrder {
    fn from(series: Series) -> Self {
        match series {
            Series::Printed => Self::IntegrateThenSeries,
            Series::Exact => Self::SeriesThenIntegrate,
        }
    }
}

impl Run for Simulate {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let sensor = find_sensor(&self.sensor, None)?;
        let options = StackOptions { warp: !self.no_warp, series: self.series.into() };
        if let Some(path) = &self.drive {
            let recording = Recording::open(path)?;
            let rows = drive(&sensor, options, &recording)?;
            recording.notes.iter().for_each(|note| console.note(note));
            return if console.json { console.print_json_lines(&rows) } else { print_history(console, &rows) }
                .map(|()| Outcome::Fine);
        }
        let Some(load) = &self.load else { bail!("give --load, as in --load \"4.5 N\", or --drive RECORDING") };
        let forces = axis::values(load, Dimension::Force)?;
        let temperatures = match &self.temperature {
            Some(text) => axis::values(text, Dimension::Temperature)?,
            None => vec![sensor.reference_c],
        };
        let states = truegap::simulate(&sensor, options, &grid(&forces, &temperatures))?;
        if console.json { console.print_json_lines(&states) } else { print_states(console, &states) }.map(|()| Outcome::Fine)
    }
}

/// Names and units of a state's columns.
const STATE: [&str; 10] = [
    "force\nN",
    "temperature\ndegC",
    "strain\n%",
    "curvature\n1/m",
    "C beads\npF",
    "C polyimide\npF",
    "C main\npF",
    "C backing\npF",
    "C tail\npF",
    "C total\npF",
];

fn cells(s: &State) -> Vec<String> {
    let mut cells =
        vec![digits(s.force_n, 4), digits(s.temperature_c, 4), digits(100.0 * s.strain, 4), digits(s.curvature_per_m, 4)];
    let capacitances = [s.c_rtv_pf, s.c_polyimide_pf, s.c_main_pf, s.c_backing_pf, s.c_tail_pf, s.c_total_pf];
    cells.extend(capacitances.map(|c| format!("{c:.4}")));
    cells
}

fn print_states(console: &Console, states: &[State]) -> anyhow::Result<()> {
    console.print(table(&STATE, states.iter().map(cells)))
}

fn print_history(console: &Console, rows: &[Driven]) -> anyhow::Result<()> {
    let header: Vec<&str> = ["run", "time\ns"].into_iter().chain(STATE).collect();
    let lines = rows.iter().map(|row| {
        let time = row.time_s.map_or_else(|| "-".to_owned(), |t| t.to_string());
        [row.run.to_string(), time].into_iter().chain(cells(&row.state)).collect()
    });
    console.print(table(&header, lines))
}
