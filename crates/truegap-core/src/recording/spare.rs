//! Columns of a table that nothing asked for: who wrote them may think that they are read.
//!
//! Limits: names alone; whether a column holds numbers is for the reader of the table to say.

use super::{
    columns::{Column, quoted},
    driver_columns::DriverColumn,
    heading::Heading,
    note::Note,
};
use crate::inputs::Role;

/// A table and what was read of it, whatever kind of table it is.
pub(super) struct Spare<'a> {
    pub header: &'a [Heading],
    pub columns: &'a [Column],
    pub drivers: &'a [DriverColumn],
    /// whether numbers stand under each heading
    pub numeric: &'a [bool],
    /// names of further columns, which hold neither numbers nor times
    pub left_out: &'a [String],
    /// whether no TOML says which column is what
    pub bare: bool,
}

impl Spare<'_> {
    /// Columns of numbers, where nothing was read that the reading could follow; else every column that a table without a TOML holds beside those that were read.
    pub fn note(&self) -> Option<Note> {
        let numbers = self.names(|index| self.numeric[index]);
        if self.has_no_input() && !numbers.is_empty() {
            return Some(Note::NoInput { columns: quoted(numbers.into_iter()) });
        }
        let mut names = self.names(|_| true);
        names.extend(self.left_out.iter().map(String::as_str).filter(|name| !name.is_empty()));
        (self.bare && !names.is_empty()).then(|| Note::NotRead { columns: quoted(names.into_iter()) })
    }

    fn has_no_input(&self) -> bool {
        let is_input = |c: &Column| !matches!(c.role, Role::Response | Role::Time | Role::Run | Role::Sensor);
        self.drivers.is_empty() && !self.columns.iter().any(is_input)
    }

    /// Names of the columns that were not read and for which `which` holds.
    fn names(&self, which: impl Fn(usize) -> bool) -> Vec<&str> {
        let of_day = self.columns.iter().filter_map(|c| c.of_day);
        let used: Vec<usize> =
            self.columns.iter().map(|c| c.index).chain(of_day).chain(self.drivers.iter().map(|d| d.index)).collect();
        let spare = self.header.iter().enumerate().filter(|(index, _)| !used.contains(index) && which(*index));
        spare.map(|(_, heading)| heading.name.as_str()).filter(|name| !name.is_empty()).collect()
    }
}
