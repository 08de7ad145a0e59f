//! The rows of a table, checked and converted, as columns.
//!
//! Limits: a row without a value in a column that plays a role is left out, and rows of one instant become one; both are counted.

use super::{
    clock::{Clock, Tick},
    columns::Column,
    date_and_time::Midnights,
    driver_columns::DriverColumn,
    error::RecordingError,
    note::Note,
    number::{Fault, number},
    refuse::refuse,
    signs::{Signs, Thousands},
    singletact,
    stamp::{First, of_day, stamp},
    table::Table,
    text::text,
    whole::{Gone, Instant, is_angle},
    zones::Zones,
};
use crate::inputs::{Driver, Inputs, Role};
use crate::units::ABSOLUTE_ZERO_C;
use std::io::{Read, Seek};

/// Why a value cannot be, SI; `None` where it can. An instrument for humidity reads a little below nothing and a little above all.
pub(super) fn impossible(role: Role, value: f64) -> Option<Impossible> {
    let (possible, why) = match role {
        Role::Temperature => (value >= ABSOLUTE_ZERO_C, "it lies below absolute zero"),
        Role::Humidity => ((-5.0..=110.0).contains(&value), "relative humidity lies between 0 and 100 %"),
        _ => return None,
    };
    (!possible).then_some(Impossible { unit: role.unit(), why })
}

/// A value that cannot be.
pub(super) struct Impossible {
    pub unit: &'static str,
    pub why: &'static str,
}

/// Columns that grow with the rows read.
#[derive(Debug, Default)]
pub(super) struct Rows {
    pub clock: Clock,
    /// sensor of each row, as an index of `names`; empty where there is no such column
    pub sensors: Vec<u32>,
    pub names: Vec<String>,
    values: Vec<(Role, Vec<f64>)>,
    drivers: Vec<Driver>,
    runs: Vec<u32>,
    missing: Option<Note>,
    repeated: Option<Note>,
    below: Option<Note>,
    gone: Gone,
    instant: Instant,
    /// whether a comma was read as a decimal point
    pub commas: bool,
    /// signs between thousands, a column each
    pub thousands: Vec<Thousands>,
    /// what is told of a clock that is a date
    pub first_date: Option<Note>,
    /// which of day and month stands first in dates
    pub order: First,
    /// whether dates have a zone
    zones: Zones,
    /// whole seconds of the first date
    epoch: Option<i64>,
    /// midnights of a clock of times of day
    midnights: Midnights,
}

impl Rows {
    /// Reads a table to its end; `sensor` names all its rows where the table has no such column.
    pub fn take<R: Read + Seek>(
        &mut self,
        table: &mut Table<R>,
        columns: &[Column],
        drivers: &[DriverColumn],
        sensor: Option<&str>,
    ) -> Result<(), RecordingError> {
        if self.values.is_empty() {
            self.begin(columns, drivers);
        }
        let (first_note, mut row) = (self.clock.notes.len(), Vec::with_capacity(columns.len()));
        let (first_row, before) = (self.runs.len(), std::mem::take(&mut self.gone));
        while table.advance()? {
            if self.is_below(table)? {
                break;
            }
            if self.parse(table, columns, drivers, &mut row)? {
                self.push(table, columns, sensor, &row)?;
            }
        }
        self.gone.find_lines(|byte| table.line(byte as u64))?;
        self.gone.check(table.file(), self.runs.len() - first_row)?;
        self.gone = before.and(std::mem::take(&mut self.gone));
        self.name_lines(table, first_note)
    }

    /// Empty columns of numbers.
    fn begin(&mut self, columns: &[Column], drivers: &[DriverColumn]) {
        let numbers = columns.iter().filter(|c| !matches!(c.role, Role::Run | Role::Sensor));
        self.values = numbers.map(|c| (c.role, Vec::new())).collect();
        let driver = |d: &DriverColumn| Driver { name: d.driver.clone(), unit: d.unit.clone(), values: Vec::new() };
        self.drivers = drivers.iter().map(driver).collect();
    }

    /// Finds the signs between thousands of the columns that are used; reads the table to its end.
    pub fn find_thousands<R: Read + Seek>(
        &mut self,
        table: &mut Table<R>,
        columns: &[Column],
        drivers: &[DriverColumn],
    ) -> Result<Option<Note>, RecordingError> {
        let numbers = columns.iter().filter(|c| !c.dated && !matches!(c.role, Role::Run | Role::Sensor));
        let used: Vec<usize> = numbers.map(|c| c.index).chain(drivers.iter().map(|d| d.index)).collect();
        self.thousands = Signs::of(table)?.thousands(table, used.iter().copied())?;
        let grouped: Vec<String> = used
            .into_iter()
            .filter(|index| self.thousands[*index] != Thousands::None)
            .map(|index| format!("`{}`", table.header[index].name))
            .collect();
        Ok((!grouped.is_empty()).then(|| Note::Thousands { columns: grouped.join(", ") }))
    }

    /// Number of a cell, as it stands; `None` where it is empty, NaN or infinite.
    fn number<R: Read + Seek>(
        &mut self,
        table: &mut Table<R>,
        index: usize,
        column: &str,
        role: &str,
    ) -> Result<Option<f64>, RecordingError> {
        let cell = table.row().get(index).unwrap_or_default();
        let thousands = self.thousands.get(index).copied().unwrap_or_default();
        let without = thousands.taken_out(cell);
        let cell = without.as_deref().unwrap_or(cell);
        match number(cell, table.decimal_comma) {
            Ok(value) => {
                self.commas |= table.decimal_comma && cell.contains(&b',');
                Ok(Some(value))
            }
            Err(Fault::NoValue) => Ok(None),
            Err(Fault::Text) => Err(refuse(table, index, column, role, self.runs.is_empty())),
        }
    }

    /// Seconds of a cell that is a date, since the first.
    fn seconds<R: Read + Seek>(&mut self, table: &mut Table<R>, column: &Column) -> Result<f64, RecordingError> {
        let cell = &date(table.row(), column);
        let read = if column.times { of_day(cell) } else { stamp(cell, self.order) };
        let Some(mut stamp) = read else {
            let (text, file, name, byte) = (text(cell).0.into_owned(), table.file(), column.name.clone(), table.byte());
            return Err(RecordingError::NotADate { file, line: table.line(byte)?, column: name, text });
        };
        if let Some(first) = self.zones.see(stamp, cell) {
            let says = if stamp.zoned { "has a zone" } else { "has no zone" };
            let (text, file, name, byte) = (text(cell).0.into_owned(), table.file(), column.name.clone(), table.byte());
            return Err(RecordingError::MixedZones { file, line: table.line(byte)?, column: name, text, says, first });
        }
        if column.times {
            stamp.seconds += self.midnights.passed(stamp.seconds);
        }
        if self.runs.is_empty() {
            self.epoch = Some(stamp.seconds);
            let of_day = column.of_day.map(|time| table.header[time].name.clone());
            let (name, first) = (column.name.clone(), text(cell).0.into_owned());
            self.first_date = Some(if column.times {
                Note::TimesOfDay { column: name, first }
            } else {
                Note::Dates { column: name, of_day, first }
            });
        }
        let epoch = self.epoch.unwrap_or(stamp.seconds);
        Ok((stamp.seconds - epoch) as f64 + stamp.fraction)
    }

    /// Whether the row and all that follow are no rows but what somebody wrote below the table: fewer cells than the header has, and no number. Reads them.
    ///
    /// # Errors
    /// [`RecordingError::Ragged`] where the row has another number of cells than the header and is none of these.
    fn is_below<R: Read + Seek>(&mut self, table: &mut Table<R>) -> Result<bool, RecordingError> {
        let (expected, found) = (table.header.len(), table.row().len());
        let spare = table.row().iter().skip(expected).any(|cell| !cell.is_empty());
        let short = found < expected && !table.singletact;
        if !(spare || short) {
            return Ok(false);
        }
        let (byte, mut lines) = (table.byte(), 0);
        let mut more = short && !self.runs.is_empty();
        while more && table.row().len() < expected && !table.row().iter().any(|cell| number(cell, true).is_ok()) {
            lines += 1;
            more = table.advance()?;
        }
        let first_line = table.line(byte)?;
        if lines == 0 || more {
            return Err(RecordingError::Ragged { file: table.file(), line: first_line, found, expected });
        }
        self.below = Some(Note::BelowTable { lines, first_line });
        Ok(true)
    }

    /// Numbers of the row into `row`; false where it lacks one, and is left out.
    fn parse<R: Read + Seek>(
        &mut self,
        table: &mut Table<R>,
        columns: &[Column],
        drivers: &[DriverColumn],
        row: &mut Vec<f64>,
    ) -> Result<bool, RecordingError> {
        row.clear();
        for column in columns {
            let Some(value) = self.value(table, column)? else { return self.leave_out(table, column.index, &column.name) };
            row.extend((!matches!(column.role, Role::Run | Role::Sensor)).then_some(value));
        }
        for driver in drivers {
            let cell = table.row().get(driver.index).unwrap_or_default();
            let is_null = table.singletact && singletact::is_null(cell);
            let value = if is_null { None } else { self.number(table, driver.index, &driver.name, &driver.driver)? };
            let Some(value) = value else { return self.leave_out(table, driver.index, &driver.name) };
            row.push(value);
        }
        Ok(true)
    }

    /// Value of a column in SI, whatever a run's or a sensor's is; `None` where the cell has none.
    fn value<R: Read + Seek>(&mut self, table: &mut Table<R>, column: &Column) -> Result<Option<f64>, RecordingError> {
        let cell = table.row().get(column.index).unwrap_or_default();
        let is_null = table.singletact && singletact::is_null(cell);
        let empty = |cell: &[u8]| number(cell, false) == Err(Fault::NoValue);
        let no_time = column.of_day.is_some_and(|index| empty(table.row().get(index).unwrap_or_default()));
        let is_empty = no_time || ((column.dated || column.role == Role::Run) && empty(cell));
        if is_null || is_empty {
            return Ok(None);
        }
        let number = match column.role {
            Role::Run | Role::Sensor => return Ok(Some(0.0)),
            _ if column.dated => Some(self.seconds(table, column)?),
            role => self.number(table, column.index, &column.name, role.key())?,
        };
        let Some(value) = number.map(|number| number * column.scale.0 + column.scale.1) else { return Ok(None) };
        if !value.is_finite() {
            let text = String::from_utf8_lossy(table.row().get(column.index).unwrap_or_default()).trim().to_owned();
            let (file, byte) = (table.file(), table.byte());
            return Err(RecordingError::BeyondNumbers { file, line: table.line(byte)?, column: column.name.clone(), text });
        }
        match impossible(column.role, value) {
            None => Ok(Some(value)),
            Some(Impossible { unit, why }) => {
                let (file, name, byte) = (table.file(), column.name.clone(), table.byte());
                let (line, unit, why) = (table.line(byte)?, unit.to_owned(), why.to_owned());
                Err(RecordingError::Impossible { file, line, column: name, value, unit, why })
            }
        }
    }

    /// Counts a row that lacks a value, with those that the vendor's tool marks by themselves; false, as it is not taken.
    fn leave_out<R: Read + Seek>(&mut self, table: &mut Table<R>, index: usize, column: &str) -> Result<bool, RecordingError> {
        let byte = table.byte();
        let marked = table.singletact && singletact::is_null(table.row().get(index).unwrap_or_default());
        match &mut self.missing {
            _ if !marked => self.gone.empty(column, byte as usize),
            Some(Note::RowsWithoutValue { rows, .. }) => *rows += 1,
            _ => {
                let first_line = table.line(byte)?;
                self.missing = Some(Note::RowsWithoutValue { column: column.to_owned(), rows: 1, first_line });
            }
        }
        Ok(false)
    }

    fn push<R: Read + Seek>(
        &mut self,
        table: &mut Table<R>,
        columns: &[Column],
        sensor: Option<&str>,
        row: &[f64],
    ) -> Result<(), RecordingError> {
        let sensor = self.sensor(table, columns, sensor);
        let run = columns.iter().find(|c| c.role == Role::Run).map(|c| run(table, c)).transpose()?;
        let clock = self.values.iter().position(|(role, _)| *role == Role::Time);
        let byte = table.byte();
        let tick = self.clock.tick(sensor.unwrap_or(0), run, clock.map(|at| row[at]), byte as usize);
        match tick {
            Err(disorder) => return Err(disorder.at(table.file(), table.line(byte)?)),
            Ok(Tick::Repeat) if table.singletact => return self.repeat(table),
            Ok(Tick::Repeat) => self.same_instant(row, byte as usize),
            Ok(Tick::Row { run, time_s }) => {
                self.instant.next();
                self.columns().zip(row).for_each(|((column, _), value)| column.push(*value));
                if let Some(time) = clock.and_then(|at| self.values[at].1.last_mut()) {
                    *time = time_s;
                }
                self.runs.push(run);
                self.sensors.extend(sensor);
            }
        }
        Ok(())
    }

    /// The columns of numbers in the order of a row's, and whether a mean of them says anything: half-way from 359 degrees to 1 is no place between them.
    fn columns(&mut self) -> impl Iterator<Item = (&mut Vec<f64>, bool)> {
        let drivers = self.drivers.iter_mut().map(|driver| {
            let mean = !is_angle(&driver.unit);
            (&mut driver.values, mean)
        });
        self.values.iter_mut().map(|(role, column)| (column, *role != Role::Time)).chain(drivers)
    }

    /// Takes a row into the one before it, which has the same time.
    fn same_instant(&mut self, row: &[f64], byte: usize) {
        self.instant.again();
        self.gone.again(byte);
        let instant = self.instant.clone();
        let averaged = self.columns().zip(row).filter(|((_, mean), _)| *mean);
        averaged.for_each(|((column, _), value)| {
            column.iter_mut().last().into_iter().for_each(|last| *last = instant.mean(*last, *value))
        });
    }

    fn repeat<R: Read + Seek>(&mut self, table: &mut Table<R>) -> Result<(), RecordingError> {
        match &mut self.repeated {
            Some(Note::RepeatedStamps { rows, .. }) => *rows += 1,
            _ => {
                let byte = table.byte();
                self.repeated = Some(Note::RepeatedStamps { rows: 1, first_line: table.line(byte)? });
            }
        }
        Ok(())
    }

    /// Index of the row's sensor.
    fn sensor<R: Read + Seek>(&mut self, table: &Table<R>, columns: &[Column], sensor: Option<&str>) -> Option<u32> {
        let column = columns.iter().find(|c| c.role == Role::Sensor);
        let cell = column.and_then(|c| table.row().get(c.index)).map(|cell| text(cell).0);
        let name = cell.as_deref().or(sensor)?;
        let known = self.names.iter().rposition(|known| known == name);
        let index = known.unwrap_or_else(|| {
            self.names.push(name.to_owned());
            self.names.len() - 1
        });
        u32::try_from(index).ok()
    }

    /// Turns the byte offsets that stand in the clock's notes into lines.
    fn name_lines<R: Read + Seek>(&mut self, table: &mut Table<R>, first: usize) -> Result<(), RecordingError> {
        for note in &mut self.clock.notes[first..] {
            if let Note::TareReset { line, .. } | Note::ClockCarriedOn { line, .. } = note {
                *line = table.line(*line as u64)?;
            }
        }
        Ok(())
    }

    /// The columns read, the response, and what was noted.
    pub fn finish(self) -> (Inputs, Vec<f64>, Vec<Note>) {
        let is_day = !self.midnights.are_counted() && !Note::carries_clock_on(&self.clock.notes);
        let began_s = self.epoch.map(|seconds| seconds as f64).filter(|_| is_day);
        let mut inputs = Inputs { began_s, run: self.runs, drivers: self.drivers, ..Inputs::default() };
        let mut response = Vec::new();
        for (role, column) in self.values {
            match role {
                Role::Response => response = column,
                role => {
                    if let Some(place) = inputs.column_mut(role) {
                        *place = Some(column);
                    }
                }
            }
        }
        let notes = self
            .missing
            .into_iter()
            .chain(self.repeated)
            .chain(self.below)
            .chain(self.gone.notes())
            .chain(self.clock.notes)
            .collect();
        (inputs, response, notes)
    }
}

/// The date of a row, with its time of day where that stands in a column of its own.
fn date(row: &csv::ByteRecord, column: &Column) -> Vec<u8> {
    let cell = |index: usize| row.get(index).unwrap_or_default();
    let of_day = column.of_day.map(cell).into_iter().flat_map(|cell| [b" ".as_slice(), cell]);
    std::iter::once(cell(column.index)).chain(of_day).collect::<Vec<_>>().concat()
}

fn run<R: Read + Seek>(table: &mut Table<R>, column: &Column) -> Result<u32, RecordingError> {
    let cell = table.row().get(column.index).unwrap_or_default().to_vec();
    let whole = number(&cell, table.decimal_comma).ok().filter(|v| v.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(v));
    if let Some(run) = whole {
        return Ok(run as u32);
    }
    let (byte, text) = (table.byte(), text(&cell).0.into_owned());
    Err(RecordingError::NotARun { file: table.file(), line: table.line(byte)?, column: column.name.clone(), text })
}
