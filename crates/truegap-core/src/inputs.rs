//! What was done to a sensor, a column a quantity, in SI (temperature in degrees Celsius, humidity in per cent).
//!
//! Limits: rows are in time order inside a run; runs follow one another.

use serde::{Deserialize, Serialize};
use std::ops::Range;

/// What a column of a recording is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, PartialOrd, Ord)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// clock, s
    Time,
    /// applied force, N
    Force,
    /// applied pressure, Pa
    Pressure,
    /// plate separation, m
    Gap,
    /// thermometer, degrees Celsius
    Temperature,
    /// relative humidity, per cent
    Humidity,
    /// recorded value
    Response,
    /// somebody else's simulation
    Simulated,
    /// run number
    Run,
    /// sensor name
    Sensor,
}

impl Role {
    /// Name in a recording's TOML.
    pub fn key(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::Force => "force",
            Self::Pressure => "pressure",
            Self::Gap => "gap",
            Self::Temperature => "temperature",
            Self::Humidity => "humidity",
            Self::Response => "response",
            Self::Simulated => "simulated",
            Self::Run => "run",
            Self::Sensor => "sensor",
        }
    }

    /// Name of its column where quantities are written in SI: its key, with its unit behind it where it has one.
    pub fn column_name(self) -> &'static str {
        match self {
            Self::Time => "time_s",
            Self::Force => "force_n",
            Self::Pressure => "pressure_pa",
            Self::Gap => "gap_m",
            Self::Temperature => "temperature_c",
            Self::Humidity => "humidity_pct",
            Self::Response | Self::Simulated | Self::Run | Self::Sensor => self.key(),
        }
    }

    /// Unit of its column in [`Inputs`]; empty where readings may be in any unit, and where it is no quantity.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Time => "s",
            Self::Force => "N",
            Self::Pressure => "Pa",
            Self::Gap => "m",
            Self::Temperature => "degC",
            Self::Humidity => "%",
            Self::Response | Self::Simulated | Self::Run | Self::Sensor => "",
        }
    }
}

/// Roles of what loads a sensor.
pub const LOADS: [Role; 2] = [Role::Force, Role::Pressure];

/// The roles that have a column in [`Inputs`], in the order in which columns are written.
pub const INPUT_ROLES: [Role; 7] =
    [Role::Time, Role::Force, Role::Pressure, Role::Gap, Role::Temperature, Role::Humidity, Role::Simulated];

/// A recorded column that physics may follow although no base model asks for it: the position of a piston, the voltage of a pump.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Driver {
    /// name under `[drivers]`
    pub name: String,
    /// unit as recorded; drivers are not converted
    pub unit: String,
    /// one value a row, in `unit`
    pub values: Vec<f64>,
}

/// Columns of equal length; a column that was not recorded is absent.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inputs {
    /// second 0 of `time_s`, in seconds since the begin of 1970 (UTC where its dates have a zone); absent where the clock is no date
    pub began_s: Option<f64>,
    /// seconds on one clock through all runs; absent where only the order of rows is known
    pub time_s: Option<Vec<f64>>,
    /// run of each row; memory starts afresh where it changes
    pub run: Vec<u32>,
    /// applied force, N
    pub force_n: Option<Vec<f64>>,
    /// applied pressure, Pa
    pub pressure_pa: Option<Vec<f64>>,
    /// plate separation, m
    pub gap_m: Option<Vec<f64>>,
    /// thermometer, degrees Celsius
    pub temperature_c: Option<Vec<f64>>,
    /// relative humidity, per cent
    pub humidity_pct: Option<Vec<f64>>,
    /// somebody else's simulation of the response, in the response's unit
    pub simulated: Option<Vec<f64>>,
    /// what else was recorded, in the order of names
    pub drivers: Vec<Driver>,
}

impl Inputs {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.run.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.run.is_empty()
    }

    /// The column of a role, SI; `None` where it was not recorded, or is no column of numbers that is done to a sensor (response, run, sensor).
    pub fn column(&self, role: Role) -> Option<&[f64]> {
        let column = match role {
            Role::Time => &self.time_s,
            Role::Force => &self.force_n,
            Role::Pressure => &self.pressure_pa,
            Role::Gap => &self.gap_m,
            Role::Temperature => &self.temperature_c,
            Role::Humidity => &self.humidity_pct,
            Role::Simulated => &self.simulated,
            Role::Response | Role::Run | Role::Sensor => &None,
        };
        column.as_deref()
    }

    /// The place of a role's column, to be filled, changed or emptied; `None` of a role that has none ([`INPUT_ROLES`] have one).
    pub fn column_mut(&mut self, role: Role) -> Option<&mut Option<Vec<f64>>> {
        Some(match role {
            Role::Time => &mut self.time_s,
            Role::Force => &mut self.force_n,
            Role::Pressure => &mut self.pressure_pa,
            Role::Gap => &mut self.gap_m,
            Role::Temperature => &mut self.temperature_c,
            Role::Humidity => &mut self.humidity_pct,
            Role::Simulated => &mut self.simulated,
            Role::Response | Role::Run | Role::Sensor => return None,
        })
    }

    /// Makes a driver of a load (force or pressure), which has the role's name and its SI unit then; nothing changes where it was not recorded, or a driver has that name.
    pub fn load_as_driver(&mut self, role: Role) {
        if !LOADS.contains(&role) || self.drivers.iter().any(|driver| driver.name == role.key()) {
            return;
        }
        let Some(values) = self.column_mut(role).and_then(Option::take) else { return };
        self.drivers.push(Driver { name: role.key().into(), unit: role.unit().into(), values });
        self.drivers.sort_by(|a, b| a.name.cmp(&b.name));
    }

    /// Row ranges of the runs, in order.
    pub fn runs(&self) -> Vec<Range<usize>> {
        let mut runs = Vec::new();
        let mut start = 0;
        for row in 1..=self.run.len() {
            if row == self.run.len() || self.run[row] != self.run[start] {
                runs.push(start..row);
                start = row;
            }
        }
        runs
    }

    /// Seconds from the row before, 0 at the first row of a run; rows count as seconds where no clock was recorded.
    pub fn steps_s(&self) -> Vec<f64> {
        let mut steps = vec![1.0; self.len()];
        for run in self.runs() {
            steps[run.start] = 0.0;
            if let Some(time) = &self.time_s {
                (run.start + 1..run.end).for_each(|row| steps[row] = time[row] - time[row - 1]);
            }
        }
        steps
    }

    /// The drivers with each column replaced by what `change` makes of it.
    pub fn drivers_as(&self, change: impl Fn(&[f64]) -> Vec<f64>) -> Vec<Driver> {
        let changed = |d: &Driver| Driver { values: change(&d.values), ..d.clone() };
        self.drivers.iter().map(changed).collect()
    }

    /// Other rows: of the runs `run`, and every column replaced by what `change` makes of it.
    #[must_use]
    pub fn columns_as(&self, run: Vec<u32>, change: impl Fn(&[f64]) -> Vec<f64>) -> Self {
        let changed = |column: &Option<Vec<f64>>| column.as_deref().map(&change);
        Self {
            began_s: self.began_s,
            time_s: changed(&self.time_s),
            run,
            force_n: changed(&self.force_n),
            pressure_pa: changed(&self.pressure_pa),
            gap_m: changed(&self.gap_m),
            temperature_c: changed(&self.temperature_c),
            humidity_pct: changed(&self.humidity_pct),
            simulated: changed(&self.simulated),
            drivers: self.drivers_as(&change),
        }
    }

    /// The rows that `keep` names, in that order.
    #[must_use]
    pub fn select(&self, keep: &[usize]) -> Self {
        let run = keep.iter().map(|&row| self.run[row]).collect();
        self.columns_as(run, |column| keep.iter().map(|&row| column[row]).collect())
    }
}
