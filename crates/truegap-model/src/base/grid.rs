//! A curve or a field of values that somebody gives as numbers: over one column, or over two at every combination of their values.
//!
//! Limits: straight between the values; beyond its ends it goes on straight for [`MARGIN`] of the axis, so that noise and added physics have an answer there.

use super::driver::DRIVERS;
use serde::{Deserialize, Serialize};
use truegap_core::{Inputs, Role, SimulationError};

/// Share of an axis by which a recorded value may lie beyond its end.
const MARGIN: f64 = 0.05;

/// One axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// which column
    pub role: Role,
    /// its values, rising, in the units of [`Inputs`]
    pub at: Vec<f64>,
}

/// Values over one or two axes, the last axis running fastest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// one or two
    pub axes: Vec<Axis>,
    /// one a combination
    pub values: Vec<f64>,
    /// unit of the values
    pub unit: String,
}

/// Why numbers are no table.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum GridError {
    /// Not one or two columns.
    #[error(
        "a table has one or two columns that the reading depends on and that change, this one has {found}; leave the others out (force, pressure, gap, temperature, humidity)"
    )]
    Axes { found: usize },
    /// A combination is missing or given twice.
    #[error(
        "a table over two columns has every combination of their values once: {rows} rows do not fill {first} values of {first_role} times {second} of {second_role}"
    )]
    NotFilled { rows: usize, first: usize, first_role: &'static str, second: usize, second_role: &'static str },
}

impl Grid {
    /// The table that rows hold, in any order.
    ///
    /// # Errors
    /// [`GridError`] where they are no table.
    pub fn of(inputs: &Inputs, response: &[f64], unit: &str) -> Result<Self, GridError> {
        let axis = |role: &Role| {
            let mut at = inputs.column(*role)?.to_vec();
            at.sort_by(f64::total_cmp);
            at.dedup();
            (at.len() > 1).then_some(Axis { role: *role, at })
        };
        let axes: Vec<Axis> = DRIVERS.iter().filter(|role| **role != Role::Time).filter_map(axis).collect();
        let size: usize = axes.iter().map(|axis| axis.at.len()).product();
        let mut values = vec![f64::NAN; size];
        for (row, response) in response.iter().enumerate() {
            let place = |axis: &Axis| {
                let value = inputs.column(axis.role).map_or(f64::NAN, |column| column[row]);
                axis.at.partition_point(|at| *at < value)
            };
            let index = axes.iter().fold(0, |index, axis| index * axis.at.len() + place(axis));
            if let Some(cell) = values.get_mut(index) {
                *cell = *response;
            }
        }
        let filled = size == response.len() && values.iter().all(|value| value.is_finite());
        match axes.as_slice() {
            [_] | [_, _] if filled => Ok(Self { axes, values, unit: unit.to_owned() }),
            [first] => Err(GridError::NotFilled {
                rows: response.len(),
                first: first.at.len(),
                first_role: first.role.key(),
                second: 1,
                second_role: "nothing else",
            }),
            [first, second] => Err(GridError::NotFilled {
                rows: response.len(),
                first: first.at.len(),
                first_role: first.role.key(),
                second: second.at.len(),
                second_role: second.role.key(),
            }),
            _ => Err(GridError::Axes { found: axes.len() }),
        }
    }

    /// Whether the table holds what was recorded.
    ///
    /// # Errors
    /// [`SimulationError::OutsideTable`] names the first row that lies outside, [`SimulationError::MissingColumn`] a column that was not recorded.
    pub fn holds(&self, inputs: &Inputs) -> Result<(), SimulationError> {
        for axis in &self.axes {
            let missing = || SimulationError::MissingColumn { model: "table".to_owned(), role: axis.role };
            let column = inputs.column(axis.role).ok_or_else(missing)?;
            let (low, high) = axis.ends();
            let margin = MARGIN * (high - low);
            let outside = column.iter().position(|value| !(low - margin..=high + margin).contains(value));
            if let Some(row) = outside {
                return Err(SimulationError::OutsideTable { row, role: axis.role, value: column[row], low, high });
            }
        }
        Ok(())
    }

    /// Value at a place, one number an axis.
    pub fn at(&self, place: &[f64]) -> f64 {
        let cells: Vec<(usize, f64)> = self.axes.iter().zip(place).map(|(axis, value)| axis.cell(*value)).collect();
        match cells.as_slice() {
            [(i, share)] => between(self.values[*i], self.values[i + 1], *share),
            [(i, first), (j, second)] => {
                let width = self.axes[1].at.len();
                let line = |i: usize| between(self.values[i * width + j], self.values[i * width + j + 1], *second);
                between(line(*i), line(i + 1), *first)
            }
            _ => f64::NAN,
        }
    }

    /// The axis of a load.
    pub fn axis(&self, wanted: impl Fn(Role) -> bool) -> Option<&Axis> {
        self.axes.iter().find(|axis| wanted(axis.role))
    }
}

impl Axis {
    /// Least and greatest value.
    pub fn ends(&self) -> (f64, f64) {
        (self.at.first().copied().unwrap_or(f64::NAN), self.at.last().copied().unwrap_or(f64::NAN))
    }

    /// The cell of a value, the outermost beyond the ends, and the share of it that lies before the value.
    fn cell(&self, value: f64) -> (usize, f64) {
        let after = self.at.partition_point(|at| *at <= value).clamp(1, self.at.len() - 1);
        (after - 1, (value - self.at[after - 1]) / (self.at[after] - self.at[after - 1]))
    }
}

fn between(before: f64, after: f64, share: f64) -> f64 {
    before + share * (after - before)
}
