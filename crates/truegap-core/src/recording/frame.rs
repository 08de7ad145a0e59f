//! A recording from columns that are in memory already, named and converted as those of a CSV are.
//!
//! Limits: numbers only, no column that names sensors; a row with a value that is not finite is left out and rows of one instant become one, as those of a CSV are, and that is noted. Lines in
//! messages are rows, counted from 1.

use super::{
    clock::{Clock, Tick},
    columns::{self, Column, DriverColumn},
    data::Recording,
    degrees,
    error::RecordingError,
    heading::Heading,
    manifest::Manifest,
    note::Note,
    open,
    rows::{Impossible, impossible},
    whole::{Gone, Instant, is_angle},
};
use crate::inputs::{Driver, Inputs, Role};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

impl Recording {
    /// Reads a recording from columns; `toml` is the text of a recording's TOML, whose `file` is not looked for, and `name` stands for the frame in messages.
    ///
    /// # Errors
    /// As [`Recording::open`]; [`RecordingError::Lengths`] where the columns are not of one length.
    pub fn from_columns(name: &str, toml: &str, table: &[(String, &[f64])]) -> Result<Self, RecordingError> {
        let path = PathBuf::from(name);
        let manifest = Manifest::parse(&path, toml)?;
        let header: Vec<Heading> = table.iter().map(|(column, _)| Heading::of(column)).collect();
        same_length(table)?;
        let (bound, mut notes) = columns::bind(&path, None, &header, &manifest)?;
        let drivers = columns::bind_drivers(&path, None, &header, &manifest, &bound)?;
        let frame = Frame { path: &path, table, bound: &bound, drivers: &drivers };
        let mut gone = Gone::default();
        let kept = frame.whole_rows(&mut gone);
        let (inputs, response, found) = frame.columns(&kept, &mut gone)?;
        gone.check(path.clone(), response.len())?;
        notes.extend(gone.notes());
        notes.extend(found);
        if response.is_empty() {
            return Err(RecordingError::NoRows { file: path });
        }
        let unit = bound.iter().find(|c| c.role == Role::Response).map(|c| c.unit.clone()).unwrap_or_default();
        let base = manifest.base.unwrap_or_else(|| open::assumed_base(&bound, &mut notes));
        let mut recording = Self::new(inputs, response, &unit, base)?;
        recording.columns = bound.iter().map(|c| (c.role, c.name.clone())).collect::<BTreeMap<_, _>>();
        recording.notes = notes.into_iter().chain(recording.constants()).collect();
        recording.notes.extend(degrees::doubt(&recording, &bound));
        Ok(recording)
    }
}

fn same_length(table: &[(String, &[f64])]) -> Result<(), RecordingError> {
    let expected = table.first().map_or(0, |(_, column)| column.len());
    match table.iter().find(|(_, column)| column.len() != expected) {
        Some((column, values)) => Err(RecordingError::Lengths { column: column.clone(), found: values.len(), expected }),
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
    table: &'a [(String, &'a [f64])],
    bound: &'a [Column],
    drivers: &'a [DriverColumn],
}

impl Frame<'_> {
    /// Rows in which every column that is used has a value; the others are counted.
    fn whole_rows(&self, gone: &mut Gone) -> Vec<usize> {
        let rows = self.table.first().map_or(0, |(_, column)| column.len());
        let used: Vec<usize> = self.bound.iter().map(|c| c.index).chain(self.drivers.iter().map(|d| d.index)).collect();
        let hole = |row: usize| used.iter().copied().find(|&index| !self.table[index].1[row].is_finite());
        let mut kept = Vec::with_capacity(rows);
        for row in 0..rows {
            match hole(row) {
                Some(index) => gone.empty(&self.table[index].0, row + 1),
                None => kept.push(row),
            }
        }
        kept
    }

    fn column(&self, role: Role, kept: &[usize]) -> Option<Vec<f64>> {
        let column = self.bound.iter().find(|c| c.role == role)?;
        let (factor, offset) = column.scale;
        Some(kept.iter().map(|&row| self.table[column.index].1[row] * factor + offset).collect())
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
        for role in [Role::Temperature, Role::Humidity] {
            self.possible(role, self.column(role, kept).as_deref(), kept)?;
        }
        let column = |role| self.column(role, kept).map(|values| means(values, &again));
        let driver = |d: &DriverColumn| {
            let values: Vec<f64> = kept.iter().map(|&row| self.table[d.index].1[row]).collect();
            let values = if is_angle(&d.unit) { firsts(values, &again) } else { means(values, &again) };
            Driver { name: d.driver.clone(), unit: d.unit.clone(), values }
        };
        let inputs = Inputs {
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
    fn possible(&self, role: Role, column: Option<&[f64]>, kept: &[usize]) -> Result<(), RecordingError> {
        let mut values = column.unwrap_or(&[]).iter().enumerate();
        let found = values.find_map(|(index, &value)| Some((index, value, impossible(role, value)?)));
        let Some((index, value, Impossible { unit, why })) = found else { return Ok(()) };
        Err(RecordingError::Impossible {
            file: self.path.to_owned(),
            line: kept[index] + 1,
            column: self.bound.iter().find(|c| c.role == role).map(|c| c.name.clone()).unwrap_or_default(),
            value,
            unit: unit.into(),
            why: why.into(),
        })
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
