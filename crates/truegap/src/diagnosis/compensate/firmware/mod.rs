//! The correction of a model file as one C99 file for the firmware of a sensor: one reading after the other, in `float`.
//!
//! Limits: what depends on the row alone is tabulated over the reading and at most two columns; of memories, first-order lags of inputs and one of the reading are stepped. Everything else
//! is left out, with its reason.

mod asked;
mod document;
mod error;
mod grid;
mod lags;
mod points;
mod sorting;
mod source;

pub use asked::Asked;
pub use document::{Argument, Firmware, FirmwareFacts, SCHEMA, Undone, check};
pub use error::FirmwareError;

use super::input::{Column, Way};
use super::{CompensateError, nothing};
use crate::diagnosis::beside_model::{model_facts, word};
use crate::models::{ModelFile, Programs, RunningModel, Wanted, corrected_for};
use grid::{FLOAT, Grid};
use lags::Lags;
use points::{Axis, Points, followed, follows_the_clock};
use sorting::{LagOfReading, Sorted, sorted, trial};
use source::{Source, state_bytes};
use std::path::Path;
use truegap_core::{Inputs, Role};
use truegap_diagnose::Library;
use truegap_diagnose::text::{listed, significant, spoken, spoken_list};
use truegap_model::BaseModel;

/// Error of a table that is wanted, over the noise of a reading.
const OF_THE_NOISE: f64 = 0.1;
/// The same over the range of the readings, where their noise is not known.
const OF_THE_RANGE: f64 = 1e-4;
/// Columns besides the reading for which a table has room.
const COLUMNS: usize = 2;
/// Part of a range by which a table may go beyond it without a word, and of the range of a temperature that is added: a thermometer has noise.
const NEAR: f64 = 0.1;
/// Rounding of a `float` in a few operations, over its size.
const ROUNDS: f64 = 2.4e-7;
/// Words of C that no argument may have, and names that the file has itself.
const TAKEN: &str = " auto break case char const continue default do double else enum extern float for goto if inline int long register restrict return short signed sizeof static struct \
    switch typedef union unsigned void volatile while class new this private public template state dt_s reading at rate over nothing ";

/// The firmware of the model file `file`.
///
/// # Errors
/// [`FirmwareError`] where nothing of the model can be corrected in a microcontroller, or no table holds it.
pub fn firmware(file: &Path, asked: &Asked) -> Result<Firmware, FirmwareError> {
    let written = ModelFile::open(file).map_err(CompensateError::from)?;
    firmware_of(&written, file, asked)
}

/// As [`firmware`], of a model that was read already; `file` is its name.
///
/// # Errors
/// As [`firmware`].
pub fn firmware_of(written: &ModelFile, file: &Path, asked: &Asked) -> Result<Firmware, FirmwareError> {
    asked.check()?;
    let model_name = file.display().to_string();
    let library = Library::default();
    // a program is not started for a refusal
    if matches!(written.base, BaseModel::Command { .. } | BaseModel::Function { .. }) {
        return Err(FirmwareError::Recorded { model: model_name, base: word(&written.base).to_owned() });
    }
    let model = written.build_of(file, &Programs::default()).map_err(CompensateError::from)?;
    let wanted = Wanted { carried: asked.carried, ..Wanted::default() };
    let parted = model.parted(&library, &Inputs::default(), false, wanted);
    if corrected_for(&parted.kept).next().is_none() {
        return Err(nothing(model_name, &parted).into());
    }
    let way = Way::of(&written.base, model.simulator());
    let history = trial(&model, &way);
    if follows_the_clock(&model, &history) {
        return Err(FirmwareError::OfTheClock { model: model_name, base: model.simulator().name().to_owned() });
    }
    let sorted = sorted(&model, &parted, &way, &library);
    Task { written, model: &model, way: &way, asked, file: &model_name, history: &history }.made(sorted)
}

/// A model of which a firmware is made.
struct Task<'a> {
    written: &'a ModelFile,
    model: &'a RunningModel,
    way: &'a Way,
    asked: &'a Asked,
    file: &'a str,
    history: &'a Inputs,
}

impl Task<'_> {
    fn made(&self, mut sorted: Sorted) -> Result<Firmware, FirmwareError> {
        let mut axes = self.axes(&sorted)?;
        if !sorted.late.is_empty()
            && !self.points(&sorted, &axes).goes_along(self.history, |column, now| self.late(&sorted, column, now))
        {
            sorted.leave_out_late();
            axes = self.axes(&sorted)?;
        }
        if sorted.corrected_for().is_empty() {
            let reasons: Vec<String> =
                sorted.left_out.iter().map(|left| format!("{} ({})", spoken(&left.effect), left.why)).collect();
            return Err(CompensateError::NothingLeft { model: self.file.to_owned(), reasons: listed(&reasons, "and") }.into());
        }
        self.has_ranges(&axes)?;
        let points = self.points(&sorted, &axes);
        let range = self.readings(&points, &axes)?;
        let noise = self.model.scales().noise_sd;
        let wanted = if noise > 0.0 { OF_THE_NOISE * noise } else { OF_THE_RANGE * (range[1] - range[0]) };
        let ends: Vec<[f64; 2]> = std::iter::once(range).chain(axes.iter().map(|axis| [axis.low, axis.high])).collect();
        let grid = Grid::coarsest(&points, ends, wanted)?;
        self.columns_fit(&axes, &grid)?;
        let grid = grid.refined(&points, wanted, self.asked.bytes / FLOAT)?;
        self.is_as_good(&grid, noise, wanted)?;
        if sorted.lag.is_none() && grid.values.iter().all(|value| value.abs() <= wanted) {
            let (model, unit) = (self.file.to_owned(), self.written.unit.clone());
            let effects = spoken_list(sorted.corrected_for(), "and");
            return Err(FirmwareError::NothingMoves { model, effects, moved: significant(wanted, 2), unit });
        }
        self.written(&sorted, &axes, &grid, wanted)
    }

    fn points<'b>(&'b self, sorted: &'b Sorted, axes: &'b [Axis]) -> Points<'b> {
        let least = sorted.late.iter().map(|late| late.lags.least_s()).fold(f64::INFINITY, f64::min);
        let least_s = (!sorted.late.is_empty()).then_some(least);
        let (model, way, file) = (self.model, self.way, self.file);
        Points { model, way, effects: &sorted.tabulated, axes, least_s, file }
    }

    fn late(&self, sorted: &Sorted, column: &Column, now: &[f64]) -> Vec<f64> {
        let late = sorted.late.iter().find(|late| late.column == *column);
        late.map_or_else(|| now.to_vec(), |late| late.lags.late(self.history, now))
    }

    /// What the correction may follow besides the reading: columns, and what comes late of them.
    fn axes(&self, sorted: &Sorted) -> Result<Vec<Axis>, FirmwareError> {
        let mut axes = Vec::new();
        for column in followed(self.model, &sorted.tabulated, self.way, self.history) {
            let [low, high] = self.range(&column)?;
            let is_late = sorted.late.iter().any(|late| late.column == column);
            axes.push(Axis { column: column.clone(), late: false, low, high });
            axes.extend(is_late.then_some(Axis { column, late: true, low, high }));
        }
        Ok(axes)
    }

    /// The range of a column: as asked, else as the model file knows it, of a temperature with a tenth more to either side. A file of an earlier version knows of a temperature how far it moved alone, which is taken
    /// to either side of the reference.
    fn range(&self, column: &Column) -> Result<[f64; 2], FirmwareError> {
        let asked = self.asked.ranges.get(&column.name()).copied();
        let range = asked.or_else(|| self.known_range(column));
        range.ok_or_else(|| FirmwareError::RangeIsNotKnown { model: self.file.to_owned(), column: column.name() })
    }

    fn known_range(&self, column: &Column) -> Option<[f64; 2]> {
        match (column, &self.model.scales().moved) {
            (Column::Of(Role::Temperature), Some(moved)) => {
                let reference = self.model.simulator().reference_c();
                let moved_c = moved.temperature_c.unwrap_or([reference - moved.temperature_k, reference + moved.temperature_k]);
                let far = NEAR * moved.temperature_k;
                Some([moved_c[0] - far, moved_c[1] + far])
            }
            (column, Some(moved)) => moved.ranges.get(&column.name()).copied(),
            (_, None) => None,
        }
    }

    fn has_ranges(&self, axes: &[Axis]) -> Result<(), FirmwareError> {
        let known: Vec<String> =
            std::iter::once("reading".to_owned()).chain(axes.iter().filter(|a| !a.late).map(|a| a.column.name())).collect();
        match self.asked.ranges.keys().find(|name| !known.contains(name)) {
            Some(name) => Err(FirmwareError::UnknownRange { name: name.clone(), known: listed(&known, "and") }),
            None => Ok(()),
        }
    }

    /// The range of the readings: as asked, else what the model gives at the ends and in the middle of all that it follows.
    fn readings(&self, points: &Points<'_>, axes: &[Axis]) -> Result<[f64; 2], FirmwareError> {
        if let Some(range) = self.asked.ranges.get("reading") {
            return Ok(*range);
        }
        let mut corners = vec![Vec::new()];
        for axis in axes {
            let along = [axis.low, 0.5 * (axis.low + axis.high), axis.high];
            corners = corners.iter().flat_map(|corner| along.map(|at| [&corner[..], &[at]].concat())).collect();
        }
        points.range(&corners)
    }

    fn is_as_good(&self, grid: &Grid, noise: f64, wanted: f64) -> Result<(), FirmwareError> {
        let worst = if noise > 0.0 { noise } else { wanted / OF_THE_NOISE };
        let told = |value: f64| significant(value, 2);
        let (model, unit) = (self.file.to_owned(), self.written.unit.clone());
        let left = grid.left;
        if left.is_nan() || left > worst {
            return Err(FirmwareError::NotInverted { model, left: told(left), noise: told(noise), unit });
        }
        if grid.error.is_nan() || grid.error > worst {
            let (error, noise) = (told(grid.error), told(noise));
            return Err(FirmwareError::TooCoarse { model, bytes: self.asked.bytes, error, noise, unit });
        }
        Ok(())
    }

    fn columns_fit(&self, axes: &[Axis], grid: &Grid) -> Result<(), FirmwareError> {
        let columns: Vec<String> = axes
            .iter()
            .zip(&grid.nodes[1..])
            .filter(|(_, nodes)| **nodes > 1)
            .map(|(axis, _)| if axis.late { format!("{} as it comes late", axis.column.name()) } else { axis.column.name() })
            .collect();
        match columns.len() > COLUMNS {
            true => {
                let (model, count) = (self.file.to_owned(), columns.len());
                Err(FirmwareError::TooManyColumns { model, count, columns: listed(&columns, "and") })
            }
            false => Ok(()),
        }
    }

    fn written(&self, sorted: &Sorted, axes: &[Axis], grid: &Grid, wanted: f64) -> Result<Firmware, FirmwareError> {
        let arguments = self.arguments(axes, grid);
        let name =
            |axis: &Axis| arguments.iter().find(|a| a.column == axis.column.name()).map_or_else(String::new, |a| a.name.clone());
        let lags = |axis: &Axis, nodes: usize| -> Option<Lags> {
            let late = sorted.late.iter().find(|late| axis.late && nodes > 1 && late.column == axis.column)?;
            Some(late.lags.clone())
        };
        let of_axes = axes.iter().zip(&grid.nodes[1..]).map(|(axis, nodes)| (name(axis), lags(axis, *nodes)));
        let in_c: Vec<(String, Option<Lags>)> = std::iter::once(("reading".to_owned(), None)).chain(of_axes).collect();
        let undone = sorted.lag.as_ref().map(|lag| self.undone(lag));
        let states = in_c.iter().filter_map(|(_, lags)| lags.as_ref()).map(Lags::states).sum();
        let noise = self.model.scales().noise_sd;
        let largest = grid.ends[0][0].abs().max(grid.ends[0][1].abs());
        let mut facts = FirmwareFacts {
            schema: SCHEMA,
            made_by: format!("truegap {}", env!("CARGO_PKG_VERSION")),
            model: model_facts(self.model, self.written, self.file),
            unit: self.written.unit.clone(),
            corrected_for: sorted.corrected_for(),
            left_out: sorted.left_out.clone(),
            readings: (grid.nodes[0] > 1).then_some(grid.ends[0]),
            reading_nodes: grid.nodes[0],
            arguments,
            table_bytes: grid.bytes(),
            state_bytes: state_bytes(states, undone.is_some()),
            error: grid.error,
            rounding: ROUNDS * largest,
            wanted,
            noise,
            table_growth: grid.steepest(),
            undone,
            says: String::new(),
            notes: Vec::new(),
        };
        facts.says = facts.sentence();
        facts.notes =
            facts.left_out.iter().map(|left| format!("not corrected for {}: {}", spoken(&left.effect), left.why)).collect();
        facts.notes.extend(facts.doubts());
        facts.notes.extend(self.beyond_the_bench(axes));
        let undone_s = facts.undone.as_ref().map(|undone| [undone.tau_s, undone.left_s]);
        let recording = [self.written.recording.as_str(), self.written.sha256.as_str()];
        let source = Source { facts: &facts, grid, axes: &in_c, undone_s, recording }.text()?;
        Ok(Firmware { document: facts, source })
    }

    /// Columns of which the table is asked to go beyond what the model was fitted over, each told.
    fn beyond_the_bench(&self, axes: &[Axis]) -> Vec<String> {
        let asked = axes.iter().filter(|axis| !axis.late && self.asked.ranges.contains_key(&axis.column.name()));
        let told = |axis: &Axis| {
            let [low, high] = self.known_range(&axis.column)?;
            let near = NEAR * (high - low);
            (axis.low < low - near || axis.high > high + near).then(|| {
                format!(
                    "the table goes from {} to {} of {}, beyond the {} to {} that the model file knows: there the law is taken further",
                    significant(axis.low, 3),
                    significant(axis.high, 3),
                    axis.column.name(),
                    significant(low, 3),
                    significant(high, 3)
                )
            })
        };
        asked.filter_map(told).collect()
    }

    /// The columns that the function in C is given, each once.
    fn arguments(&self, axes: &[Axis], grid: &Grid) -> Vec<Argument> {
        let mut arguments: Vec<Argument> = Vec::new();
        for (k, axis) in axes.iter().enumerate().filter(|(_, axis)| !axis.late) {
            let late = axes.iter().position(|other| other.late && other.column == axis.column);
            let (nodes, late_nodes) = (grid.nodes[1 + k], late.map(|late| grid.nodes[1 + late]));
            if nodes == 1 && late_nodes.is_none_or(|nodes| nodes == 1) {
                continue;
            }
            let column = axis.column.name();
            let unit = match &axis.column {
                Column::Driver(name) => self.written.drivers.get(name).cloned().unwrap_or_default(),
                column => column.unit(self.model.simulator()),
            };
            let mut name = name_in_c(if let Column::Of(role) = &axis.column { role.column_name() } else { &column });
            while TAKEN.contains(&format!(" {name} ")) || arguments.iter().any(|other| other.name == name) {
                name.push('_');
            }
            arguments.push(Argument { name, column, unit, low: axis.low, high: axis.high, nodes, late_nodes });
        }
        arguments
    }

    /// How a lag of the reading is undone: by `y + tau dy/dt`, the derivative over a time by which white noise grows no more than is asked.
    ///
    /// With the derivative over a step and u the time constant over it, the noise grows by the root of (1 + u)^2 + u^2. Over longer times it grows less than by the same formula.
    fn undone(&self, lag: &LagOfReading) -> Undone {
        let most = self.asked.noise_growth;
        let u = 0.5 * ((2.0 * most * most - 1.0).sqrt() - 1.0);
        let left_s = lag.tau_s / u;
        let step = self.model.scales().shortest_step_s;
        let growth = (step > 0.0).then(|| growth(lag.tau_s, left_s, step));
        Undone { effect: lag.id.clone(), tau_s: lag.tau_s, left_s, most_growth: most, growth }
    }
}

/// Growth of white noise by `y + tau dy/dt` at even steps, the derivative over a step or over `shortest_s`: the root of the sum of squares of what one reading does.
fn growth(tau_s: f64, shortest_s: f64, step_s: f64) -> f64 {
    let (b, u) = (step_s / step_s.max(shortest_s), tau_s / step_s.max(shortest_s));
    ((u + b).powi(2) + b * (1.0 - b - u).powi(2) / (2.0 - b)).sqrt()
}

/// A name of C that is like a column's.
fn name_in_c(column: &str) -> String {
    let name: String = column.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if name.starts_with(|c: char| c.is_ascii_alphabetic()) { name } else { format!("x{name}") }
}
