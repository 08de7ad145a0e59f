//! `truegap simulate`: the analytic model, or an augmented one, at points or along a recorded history.

use super::run::{Outcome, Run};
use super::told::TellArgs;
use crate::console::Console;
use crate::table::{digits, table};
use anyhow::bail;
use std::path::{Path, PathBuf};
use truegap::core::recording::Told;
use truegap::core::units::twelve_digits;
use truegap::core::{Dimension, Recording, RecordingError};
use truegap::diagnosis::recorded;
use truegap::model::{SeriesOrder, StackOptions, State};
use truegap::models::{self, Answer, ModelFile, Programs};
use truegap::predict::{DEFAULT_SENSOR, Driven, axis, check_points, drive, find_sensor, grid};

/// Capacitance at given loads and temperatures, or along the history of a recording
#[derive(Debug, clap::Args)]
pub struct Simulate {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// Loads: a value ("4.5 N"), a list ("0, 1, 4.5 N") or a range ("0:4.5 N:10", both ends included)
    #[arg(long, allow_hyphen_values = true, required_unless_present_any = ["drive", "profile", "model"], conflicts_with = "drive")]
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
    /// Model file, as the augmented.toml of a diagnosis: its calibration and added physics in place of --sensor
    #[arg(long, value_name = "FILE", conflicts_with_all = ["sensor", "no_warp", "series"])]
    model: Option<PathBuf>,
    /// Follow the loads and temperatures of a recording, whether it has a response or not
    #[arg(long, value_name = "RECORDING")]
    drive: Option<PathBuf>,
    #[command(flatten)]
    tell: TellArgs,
    /// Follow a built-in profile, as a diagnosis proposes one for the next recording: long-hold, rates, staircase, thermal-sweep-unloaded, thermal-sweep-loaded, overnight
    #[arg(long, value_name = "NAME", requires = "model", conflicts_with_all = ["load", "temperature", "drive"])]
    profile: Option<String>,
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
        if self.drive.is_none() && !self.tell.is_empty() {
            bail!("--map and --dayfirst say how a recording is read, and none is; give --drive RECORDING, or leave them out");
        }
        if let Some(file) = &self.model {
            return self.augmented(file, console);
        }
        let sensor = find_sensor(&self.sensor, None)?;
        let options = StackOptions { warp: !self.no_warp, series: self.series.into() };
        if let Some(path) = &self.drive {
            let recording = self.driving(path)?;
            let rows = drive(&sensor, options, &recording)?;
            recording.notes.iter().for_each(|note| console.note(note));
            return if console.json { console.print_json_lines(&rows) } else { print_history(console, &rows) }
                .map(|()| Outcome::Fine);
        }
        let forces = self.loads(Dimension::Force)?;
        let temperatures = self.temperatures(sensor.reference_c)?;
        check_points(forces.len(), temperatures.len())?;
        let states = truegap::predict::simulate(&sensor, options, &grid(&forces, &temperatures))?;
        if console.json { console.print_json_lines(&states) } else { print_states(console, &states) }.map(|()| Outcome::Fine)
    }
}

impl Simulate {
    /// The recording to follow, of which nobody asks what was read.
    fn driving(&self, path: &Path) -> Result<Recording, RecordingError> {
        recorded(path, &Told { inputs_alone: true, ..self.tell.told() })
    }

    fn loads(&self, dimension: Dimension) -> anyhow::Result<Vec<f64>> {
        let Some(load) = &self.load else {
            bail!("give --load, as in --load \"4.5 N\", --drive RECORDING, or with --model a --profile")
        };
        Ok(axis::values(load, dimension)?)
    }

    fn temperatures(&self, reference_c: f64) -> anyhow::Result<Vec<f64>> {
        match &self.temperature {
            Some(text) => Ok(axis::values(text, Dimension::Temperature)?),
            None => Ok(vec![reference_c]),
        }
    }

    /// The same questions put to a model file.
    fn augmented(&self, file: &Path, console: &Console) -> anyhow::Result<Outcome> {
        let model = ModelFile::open(file)?.build_of(file, &Programs::default())?;
        let answers = if let Some(name) = &self.profile {
            models::on_profile(&model, name)?
        } else if let Some(path) = &self.drive {
            let recording = self.driving(path)?;
            recording.notes.iter().for_each(|note| console.note(note));
            models::along(&model, &recording)?
        } else {
            let loads = self.loads(models::load_dimension(&model)?)?;
            let temperatures = self.temperatures(model.simulator().reference_c())?;
            check_points(loads.len(), temperatures.len())?;
            models::at_points(&model, &loads, &temperatures)?
        };
        if console.json { console.print_json_lines(&answers) } else { print_answers(console, &answers) }.map(|()| Outcome::Fine)
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

fn print_answers(console: &Console, answers: &[Answer]) -> anyhow::Result<()> {
    let unit = answers.first().map_or("", |a| a.unit.as_str());
    let response = format!("response\n{unit}");
    type Column = fn(&Answer) -> Option<f64>;
    let inputs: [(&str, Column); 6] = [
        ("run", |a| a.run.map(f64::from)),
        ("time\ns", |a| a.time_s),
        ("force\nN", |a| a.force_n),
        ("pressure\nPa", |a| a.pressure_pa),
        ("gap\nm", |a| a.gap_m),
        ("temperature\ndegC", |a| a.temperature_c),
    ];
    let there: Vec<_> = inputs.into_iter().filter(|(_, get)| answers.iter().any(|a| get(a).is_some())).collect();
    let header: Vec<&str> = there.iter().map(|(name, _)| *name).chain([response.as_str()]).collect();
    let cell = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |v| twelve_digits(v).to_string());
    let row = |a: &Answer| there.iter().map(|(_, get)| cell(get(a))).chain([digits(a.response, 7)]).collect();
    console.print(table(&header, answers.iter().map(row)))
}
