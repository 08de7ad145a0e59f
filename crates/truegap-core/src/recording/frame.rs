//! A recording from columns that are in memory already, named and converted as those of a CSV are.
//!
//! Limits: numbers only, no column that names sensors; a row with a value that is not finite is left out and rows of one instant become one, as those of a CSV are, and that is noted. Lines in
//! messages are rows, counted from 1.

use super::{
    assumed_base::assumed_base,
    clock::{Clock, Tick},
    columns::{self, Column},
    data::Recording,
    degrees,
    driver_columns::{DriverColumn, bind_drivers},
    error::RecordingError,
    heading::Heading,
    manifest::Manifest,
    note::Note,
    rows::{Impossible, impossible},
    spans,
    spare::Spare,
    stamp::{First, stamp},
    whole::{Gone, Instant, is_angle},
};
use crate::inputs::{Driver, Inputs, Role};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A column of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameColumn<'a> {
    /// its name, with the unit where that shows it
    pub name: String,
    /// one number a row; NaN where there is none
    pub values: Cow<'a, [f64]>,
    /// what stood in its cells
    pub cells: Cells,
}

/// What the cells of a frame's column are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Cells {
    /// numbers in whatever unit the name or a TOML says
    Numbers,
    /// lengths of time; the values are seconds
    Durations,
    /// dates; the values are seconds since the whole second of the first
    Dates {
        /// the first of them, as text
        first: String,
    },
}

impl<'a> FrameColumn<'a> {
    /// A column of numbers.
    pub fn numbers(name: &str, values: &'a [f64]) -> Self {
        Self { name: name.to_owned(), values: Cow::Borrowed(values), cells: Cells::Numbers }
    }

    fn holds_numbers(&self) -> bool {
        self.cells == Cells::Numbers && self.values.iter().any(|value| value.is_finite())
    }

    pub(super) fn heading(&self) -> Heading {
        Heading { dated: self.cells != Cells::Numbers, ..Heading::of(&self.name) }
    }
}

impl Recording {
    /// Reads a recording from columns; `toml` is the text of a recording's TOML, whose `file` is not looked for, and `name` stands for the frame in messages.
    ///
    /// # Errors
    /// As [`Recording::open`]; [`RecordingError::Lengths`] where the columns are not of one length.
    pub fn from_columns(name: &str, toml: &str, table: &[FrameColumn<'_>]) -> Result<Self, RecordingError> {
        Self::from_frame(name, toml, table, &[])
    }

    /// As [`Recording::from_columns`], of a frame that has further columns; `left_out` are the names of those, which hold neither numbers nor times.
    ///
    /// # Errors
    /// As [`Recording::from_columns`].
    pub fn from_frame(name: &str, toml: &str, table: &[FrameColumn<'_>], left_out: &[String]) -> Result<Self, RecordingError> {
        let path = PathBuf::from(name);
        let manifest = Manifest::parse(&path, toml)?;
        Self::of_frame(&path, None, manifest, table, left_out)
    }

    /// Reads a recording from columns, as `manifest` says; `toml` is where that stands, `left_out` are the names of columns without numbers.
    pub(super) fn of_frame(
        path: &Path,
        toml: Option<&Path>,
        manifest: Manifest,
        table: &[FrameColumn<'_>],
        left_out: &[String],
    ) -> Result<Self, RecordingError> {
        let header: Vec<Heading> = table.iter().map(FrameColumn::heading).collect();
        same_length(table)?;
        let manifest = manifest.with_roles_of_drivers(path, toml, &header)?;
        let (bound, mut notes) = columns::bind(path, toml, &header, &manifest)?;
        let drivers = bind_drivers(path, toml, &header, &manifest, &bound)?;
        let frame = Frame { path, table, bound: &bound, drivers: &drivers };
        let mut gone = Gone::default();
        let kept = frame.whole_rows(&mut gone);
        let (inputs, response, found) = frame.columns(&kept, &mut gone)?;
        gone.check(path.to_owned(), inputs.len())?;
        notes.extend(frame.dates());
        notes.extend(frame.spare(&header, left_out, toml.is_none()));
        notes.extend(gone.notes());
        notes.extend(found);
        if inputs.is_empty() {
            return Err(RecordingError::NoRows { file: path.to_owned() });
        }
        let unit = bound.iter().find(|c| c.role == Role::Response).map(|c| c.unit.clone()).unwrap_or_default();
        let base = manifest.base.unwrap_or_else(|| assumed_base(&bound, &mut notes));
        let mut recording = Self::made(inputs, response, &unit, base)?;
        spans::check(path, &recording, &bound)?;
        recording.columns = bound.iter().map(|c| (c.role, c.name.clone())).collect::<BTreeMap<_, _>>();
        recording.notes = notes.into_iter().chain(recording.constants()).collect();
        recording.notes.extend(degrees::doubt(&recording, &bound));
        Ok(recording)
    }
}

fn same_length(table: &[FrameColumn<'_>]) -> Result<(), RecordingError> {
    let expected = table.first().map_or(0, |column| column.values.len());
    match table.iter().find(|column| column.values.len() != expected) {
        Some(FrameColumn { name, values, .. }) => {
            Err(RecordingError::Lengths { column: name.clone(), found: values.len(), expected })
        }
        None => Ok(()),
    }
}

/// What the clock says of the rows of a frame.
#[derive(Default)]
struct Clocked {
    runs: Vec<u32>,
    times: Vec<f64>,
    again: Vec<bool>,
    notes: Vec<Note>,
}

struct Frame<'a> {
    path: &'a Path,
    table: &'a [FrameColumn<'a>],
    bound: &'a [Column],
    drivers: &'a [DriverColumn],
}

impl Frame<'_> {
    /// Rows in which every column that is used has a value; the others are counted.
    fn whole_rows(&self, gone: &mut Gone) -> Vec<usize> {
        let rows = self.table.first().map_or(0, |column| column.values.len());
        let used: Vec<usize> = self.bound.iter().map(|c| c.index).chain(self.drivers.iter().map(|d| d.index)).collect();
        let hole = |row: usize| used.iter().copied().find(|&index| !self.table[index].values[row].is_finite());
        let mut kept = Vec::with_capacity(rows);
        for row in 0..rows {
            match hole(row) {
                Some(index) => gone.empty(&self.table[index].name, row + 1),
                None => kept.push(row),
            }
        }
        kept
    }

    /// What is told of columns that were not read.
    fn spare(&self, header: &[Heading], left_out: &[String], bare: bool) -> Option<Note> {
        let numeric: Vec<bool> = self.table.iter().map(FrameColumn::holds_numbers).collect();
        Spare { header, columns: self.bound, drivers: self.drivers, numeric: &numeric, left_out, bare }.note()
    }

    /// What is told of a clock that is a date.
    fn dates(&self) -> Option<Note> {
        let column = &self.table[self.bound.iter().find(|c| c.dated)?.index];
        match &column.cells {
            Cells::Dates { first } => Some(Note::Dates { column: column.name.clone(), of_day: None, first: first.clone() }),
            _ => None,
        }
    }

    /// When a clock of dates began, where their year stands first: the whole second of its first date.
    fn began_s(&self) -> Option<f64> {
        match self.dates()? {
            // elsewhere day and month may stand in either order
            Note::Dates { first, .. } if first.get(..4)?.bytes().all(|b| b.is_ascii_digit()) => {
                Some(stamp(first.as_bytes(), First::Year)?.seconds as f64)
            }
            _ => None,
        }
    }

    fn column(&self, role: Role, kept: &[usize]) -> Option<Vec<f64>> {
        let column = self.bound.iter().find(|c| c.role == role)?;
        let (factor, offset) = column.scale;
        Some(kept.iter().map(|&row| self.table[column.index].values[row] * factor + offset).collect())
    }

    /// Runs and times in order, whether a row has the time of the row before, and what was noted.
    fn clocked(&self, kept: &[usize], gone: &mut Gone) -> Result<Clocked, RecordingError> {
        let (time, run) = (self.column(Role::Time, kept), self.column(Role::Run, kept));
        let (mut clock, mut clocked) = (Clock::default(), Clocked::default());
        for (index, &row) in kept.iter().enumerate() {
            let run = run.as_ref().map(|run| self.run(run[index], row)).transpose()?;
            let tick = clock.tick(0, run, time.as_ref().map(|t| t[index]), row + 1);
            clocked.again.push(matches!(tick, Ok(Tick::Repeat)));
            match tick {
                Ok(Tick::Row { run, time_s }) => {
                    clocked.runs.push(run);
                    clocked.times.push(time_s);
                }
                Ok(Tick::Repeat) => gone.again(row + 1),
                Err(disorder) => return Err(disorder.at(self.path.to_owned(), row + 1)),
            }
        }
        Ok(Clocked { notes: clock.notes, ..clocked })
    }

    /// The columns in SI, runs and clock in order, rows of one instant as one.
    fn columns(&self, kept: &[usize], gone: &mut Gone) -> Result<(Inputs, Vec<f64>, Vec<Note>), RecordingError> {
        let Clocked { runs, times, again, notes } = self.clocked(kept, gone)?;
        for column in self.bound {
            self.possible(column, kept)?;
        }
        let column = |role| self.column(role, kept).map(|values| means(values, &again));
        let driver = |d: &DriverColumn| {
            let values: Vec<f64> = kept.iter().map(|&row| self.table[d.index].values[row]).collect();
            let values = if is_angle(&d.unit) { firsts(values, &again) } else { means(values, &again) };
            Driver { name: d.driver.clone(), unit: d.unit.clone(), values }
        };
        let inputs = Inputs {
            began_s: self.began_s().filter(|_| !Note::carries_clock_on(&notes)),
            time_s: self.column(Role::Time, &[]).map(|_| times),
            run: runs,
            force_n: column(Role::Force),
            pressure_pa: column(Role::Pressure),
            gap_m: column(Role::Gap),
            temperature_c: column(Role::Temperature),
            humidity_pct: column(Role::Humidity),
            simulated: column(Role::Simulated),
            drivers: self.drivers.iter().map(driver).collect(),
        };
        Ok((inputs, column(Role::Response).unwrap_or_default(), notes))
    }

    /// Refuses the first value of a column that cannot be.
    fn possible(&self, column: &Column, kept: &[usize]) -> Result<(), RecordingError> {
        let ((factor, offset), given) = (column.scale, &self.table[column.index].values);
        let at = |row: usize| (self.path.to_owned(), row + 1, column.name.clone());
        for &row in kept {
            let value = given[row] * factor + offset;
            if !value.is_finite() {
                let (file, line, column) = at(row);
                return Err(RecordingError::BeyondNumbers { file, line, column, text: format!("{:e}", given[row]) });
            }
            if let Some(Impossible { unit, why }) = impossible(column.role, value) {
                let (file, line, column) = at(row);
                return Err(RecordingError::Impossible { file, line, column, value, unit: unit.into(), why: why.into() });
            }
        }
        Ok(())
    }

    fn run(&self, value: f64, row: usize) -> Result<u32, RecordingError> {
        let whole = value.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&value);
        whole.then_some(value as u32).ok_or_else(|| RecordingError::NotARun {
            file: self.path.to_owned(),
            line: row + 1,
            column: "run".into(),
            text: value.to_string(),
        })
    }
}

/// One value an instant, the mean of its rows; `again` says of each row whether it has the time of the row before.
fn means(values: Vec<f64>, again: &[bool]) -> Vec<f64> {
    let (mut instant, mut means) = (Instant::default(), Vec::with_capacity(values.len()));
    for (value, again) in values.into_iter().zip(again) {
        match means.last_mut().filter(|_| *again) {
            Some(mean) => {
                instant.again();
                *mean = instant.mean(*mean, value);
            }
            None => {
                instant.next();
                means.push(value);
            }
        }
    }
    means
}

/// One value an instant, that of its first row.
fn firsts(values: Vec<f64>, again: &[bool]) -> Vec<f64> {
    values.into_iter().zip(again).filter(|(_, again)| !**again).map(|(value, _)| value).collect()
}
