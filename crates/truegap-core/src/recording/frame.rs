//! A recording from columns that are in memory already, named and converted as those of a CSV are.
//!
//! Limits: numbers only, no column that names sensors; a row with a value that is not finite is left out, and that is noted. Lines in messages are rows,
//! counted from 1.

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
        let (kept, missing) = frame.whole_rows();
        notes.extend(missing);
        let (inputs, response, found) = frame.columns(&kept)?;
        notes.extend(found);
        if response.is_empty() {
            return Err(RecordingError::NoRows { file: path });
        }
        let unit = bound.iter().find(|c| c.role == Role::Response).map(|c| c.unit.clone()).unwrap_or_default();
        let base = manifest.base.unwrap_or_else(|| open::assumed_base(&bound, &mut notes));
        let mut recording = Self::new(inputs, response, &unit, base)?;
        recording.columns = bound.iter().map(|c| (c.role, c.name.clone())).collect::<BTreeMap<_, _>>();
        recording.notes = notes;
        recording.notes.extend(recording.constants());
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

struct Frame<'a> {
    path: &'a Path,
    table: &'a [(String, &'a [f64])],
    bound: &'a [Column],
    drivers: &'a [DriverColumn],
}

impl Frame<'_> {
    /// Rows in which every column that is used has a value.
    fn whole_rows(&self) -> (Vec<usize>, Option<Note>) {
        let rows = self.table.first().map_or(0, |(_, column)| column.len());
        let used: Vec<usize> = self.bound.iter().map(|c| c.index).chain(self.drivers.iter().map(|d| d.index)).collect();
        let hole = |row: usize| used.iter().copied().find(|&index| !self.table[index].1[row].is_finite());
        let kept: Vec<usize> = (0..rows).filter(|&row| hole(row).is_none()).collect();
        let first = (0..rows).find_map(|row| hole(row).map(|index| (row, index)));
        let note = first.map(|(row, index)| Note::RowsWithoutValue {
            column: self.table[index].0.clone(),
            rows: rows - kept.len(),
            first_line: row + 1,
        });
        (kept, note)
    }

    fn column(&self, role: Role, kept: &[usize]) -> Option<Vec<f64>> {
        let column = self.bound.iter().find(|c| c.role == role)?;
        let (factor, offset) = column.scale;
        Some(kept.iter().map(|&row| self.table[column.index].1[row] * factor + offset).collect())
    }

    /// The columns in SI, runs and clock in order.
    fn columns(&self, kept: &[usize]) -> Result<(Inputs, Vec<f64>, Vec<Note>), RecordingError> {
        let (time, run) = (self.column(Role::Time, kept), self.column(Role::Run, kept));
        let mut clock = Clock::default();
        let (mut runs, mut times) = (Vec::with_capacity(kept.len()), Vec::with_capacity(kept.len()));
        for (index, &row) in kept.iter().enumerate() {
            let run = run.as_ref().map(|run| self.run(run[index], row)).transpose()?;
            match clock.tick(0, run, time.as_ref().map(|t| t[index]), row + 1) {
                Ok(Tick::Row { run, time_s }) => {
                    runs.push(run);
                    times.push(time_s);
                }
                // only the vendor's tool repeats rows
                Ok(Tick::Repeat) => {}
                Err(disorder) => return Err(disorder.at(self.path.to_owned(), row + 1)),
            }
        }
        let temperature_c = self.column(Role::Temperature, kept);
        let humidity_pct = self.column(Role::Humidity, kept);
        self.possible(Role::Temperature, temperature_c.as_deref(), kept)?;
        self.possible(Role::Humidity, humidity_pct.as_deref(), kept)?;
        let driver = |d: &DriverColumn| Driver {
            name: d.driver.clone(),
            unit: d.unit.clone(),
            values: kept.iter().map(|&row| self.table[d.index].1[row]).collect(),
        };
        let inputs = Inputs {
            time_s: time.map(|_| times),
            run: runs,
            force_n: self.column(Role::Force, kept),
            pressure_pa: self.column(Role::Pressure, kept),
            gap_m: self.column(Role::Gap, kept),
            temperature_c,
            humidity_pct,
            simulated: self.column(Role::Simulated, kept),
            drivers: self.drivers.iter().map(driver).collect(),
        };
        Ok((inputs, self.column(Role::Response, kept).unwrap_or_default(), clock.notes))
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
