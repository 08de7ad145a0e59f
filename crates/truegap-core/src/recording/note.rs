//! What a reader of a recording should be told although it could be read.
//!
//! Limits: only what reading itself did or assumed; judgement of the data belongs to the diagnosis.

use super::date_and_time::joined;
use crate::inputs::Role;
use crate::units::readable;
use serde::Serialize;
use std::fmt;

/// Something that reading changed, left out or assumed.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "note", rename_all = "snake_case")]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the sentences
pub enum Note {
    /// Rows were left out because a value is marked as missing.
    RowsWithoutValue { column: String, rows: usize, first_line: usize },
    /// Rows were left out because they repeat the time of the row before.
    RepeatedStamps { rows: usize, first_line: usize },
    /// Rows of one instant became one row, the mean of theirs.
    RowsOfOneInstant { rows: usize, first_line: usize },
    /// The clock fell back, so a new run began.
    TareReset { line: usize, run: u32 },
    /// The clock of a run began below the end of the run before, and was carried on.
    ClockCarriedOn { line: usize, run: u32, shift_s: f64 },
    /// Lines above the header were left out.
    AboveHeader { lines: usize, header_line: usize },
    /// Lines of text below the rows were left out.
    BelowTable { lines: usize, first_line: usize },
    /// Lines that begin as remarks do and look like rows.
    MarkedRows { lines: usize, first_line: usize, taken: bool },
    /// Rows that sum up others were left out.
    Summaries { rows: usize, words: String, lines: Vec<usize> },
    /// The header is no UTF-8.
    Windows1252 { text: String },
    /// The clock is a date, with its time of day in a column of its own where there is one.
    Dates {
        column: String,
        #[serde(skip_serializing_if = "Option::is_none")]
        of_day: Option<String>,
        first: String,
    },
    /// The clock is the time of day, without dates.
    TimesOfDay { column: String, first: String },
    /// The order of day and month is told of a clock that shows it, or has no dates.
    OrderNotAsked,
    /// Columns that nothing asked for, in a table without a TOML.
    NotRead { columns: String },
    /// Columns of numbers that nothing asked for, where nothing was read that the reading could follow.
    NoInput { columns: String },
    /// Columns of a table without a TOML that were read because of a word of their names.
    ReadByName { columns: String },
    /// A temperature that looks like one in another unit.
    OtherDegrees { column: String, unit: String, low: f64, high: f64, other: String },
    /// Commas were read as decimal points.
    DecimalCommas,
    /// Signs between thousands were left out.
    Thousands { columns: String },
    /// Runs were numbered afresh, because there are several sensors.
    RunsRenumbered { runs: u32 },
    /// The unit that is told is not the one in the column's name; `by` says where it is told.
    UnitOverridesName { column: String, unit: String, named: String, by: String },
    /// Units of roles that have no column.
    UnitsOfNothing { roles: String },
    /// A column that one of several recordings lacks and another has.
    ColumnOfSome { role: Role, without: String, with: String },
    /// No base model was named.
    BaseAssumed { model: String, because: String },
    /// A TOML of the same name stands beside the CSV and was not read.
    ManifestNotRead { file: String },
    /// The simulation has a unit of its own.
    SimulatedUnit { unit: String, response: String },
    /// A column never changes.
    Constant { role: Role, value: f64 },
}

impl Note {
    /// Whether one of these tells of a clock that was carried on, so that its dates are those of the first rows alone.
    pub(super) fn carries_clock_on(notes: &[Self]) -> bool {
        notes.iter().any(|note| matches!(note, Self::TareReset { .. } | Self::ClockCarriedOn { .. }))
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::RowsWithoutValue { column, rows, first_line } => {
                let were = if *rows == 1 { "1 row without a value in" } else { &format!("{rows} rows without a value in") };
                let left = if *rows == 1 { "was left out, on" } else { "were left out, the first on" };
                write!(f, "{were} `{column}` {left} line {first_line}")
            }
            Self::RepeatedStamps { rows, first_line } => {
                write!(f, "{rows} rows that repeat the time before them were left out, the first on line {first_line}")
            }
            Self::RowsOfOneInstant { rows, first_line } => {
                let have = if *rows == 1 { "1 row has" } else { &format!("{rows} rows have") };
                let first = if *rows == 1 { "on" } else { "the first on" };
                write!(
                    f,
                    "{have} the time of the row before, {first} line {first_line}; the rows of an instant were taken as one, with their means"
                )
            }
            Self::TareReset { line, run } => write!(f, "the clock falls back on line {line} (a tare): run {run} begins there"),
            Self::ClockCarriedOn { line, run, shift_s } => {
                write!(
                    f,
                    "the clock of run {run} (line {line}) was carried on by {shift_s} s; the true pause before it is not known"
                )
            }
            Self::AboveHeader { lines, header_line } => {
                let lines = if *lines == 1 { "1 line was".to_owned() } else { format!("{lines} lines were") };
                write!(f, "{lines} left out above the header, which is line {header_line}")
            }
            Self::BelowTable { lines, first_line } => {
                let lines = if *lines == 1 { "1 line of text was".to_owned() } else { format!("{lines} lines of text were") };
                write!(f, "{lines} left out below the rows, from line {first_line} on")
            }
            Self::MarkedRows { lines, first_line, taken } => {
                let one = *lines == 1;
                let (begin, first) = if one { ("line begins", "on") } else { ("lines begin", "the first on") };
                let (look, were) = if one { ("looks", "was") } else { ("look", "were") };
                let what = match (taken, one) {
                    (true, false) => "read as such, since the first column holds words; delete them if they are remarks",
                    (true, true) => "read as such, since the first column holds words; delete it if it is a remark",
                    (false, false) => "left out; take the sign away if they are rows",
                    (false, true) => "left out; take the sign away if it is one",
                };
                write!(f, "{lines} {begin} as a remark does and {look} like a row ({first} line {first_line}), and {were} {what}")
            }
            Self::Summaries { rows, words, lines } => {
                let were =
                    if *rows == 1 { "1 row that sums up others was" } else { &format!("{rows} rows that sum up others were") };
                let lines: Vec<String> = lines.iter().map(ToString::to_string).collect();
                let more = if *rows > lines.len() { " and further on" } else { "" };
                let line = if *rows == 1 { "line" } else { "lines" };
                write!(f, "{were} left out ({words}), on {line} {}{more}", lines.join(", "))
            }
            Self::Windows1252 { text } => {
                write!(
                    f,
                    "the header is no UTF-8 and was read as Windows-1252 (`{text}`); where that is not what it says, save the table in UTF-8"
                )
            }
            Self::Dates { column, of_day, first } => {
                match of_day {
                    Some(time) => write!(f, "columns `{}` hold", joined(column, time))?,
                    None => write!(f, "column `{column}` holds")?,
                }
                write!(f, " dates; time is counted in seconds from `{first}`")
            }
            Self::TimesOfDay { column, first } => write!(
                f,
                "column `{column}` holds times of day without dates; time is counted in seconds from `{first}`, and goes on past midnight"
            ),
            Self::OrderNotAsked => f.write_str(
                "dayfirst was told and not used: the clock holds no dates in which day and month could be taken for one another",
            ),
            Self::NotRead { columns } => write!(
                f,
                "not read: {columns}; name what they are in a TOML beside the CSV (`truegap init` writes one) or by --map, or leave them as they are"
            ),
            Self::NoInput { columns } => write!(
                f,
                "nothing was read that the reading could follow, and these columns of numbers were not read: {columns}; if one is what was done, name it by --map \
                 driver.NAME=COLUMN:UNIT or under [drivers], if one is your own simulation, by --map simulated=COLUMN or under [columns]"
            ),
            Self::ReadByName { columns } => write!(
                f,
                "read because of their names: {columns}; if that is not what they are, say so by --map or in a TOML beside the CSV (`truegap init` writes one)"
            ),
            Self::OtherDegrees { column, unit, low, high, other } => write!(
                f,
                "column `{column}` was read in {unit} and lies between {low} and {high} in all rows: is it in {other}? If so, write temperature = \"{other}\" \
                 under [units]"
            ),
            Self::DecimalCommas => f.write_str("commas were read as decimal points"),
            Self::Thousands { columns } => write!(f, "signs between thousands were left out in {columns}, as in 1,234.5"),
            Self::RunsRenumbered { runs } => write!(f, "runs were numbered afresh, 1 to {runs}, one for each sensor and run"),
            Self::UnitOverridesName { column, unit, named, by } => {
                write!(f, "column `{column}` was read in {unit}, as {by} says, although its name says {named}")
            }
            Self::UnitsOfNothing { roles } => write!(
                f,
                "[units] gives a unit of {roles}, and no column was read as that; name it under [columns], or take the unit out"
            ),
            Self::ColumnOfSome { role, without, with } => write!(
                f,
                "{without} has no column for {0}, which {with} has: what follows the {0} cannot be followed in it; name that column there, or diagnose it by itself",
                role.key()
            ),
            Self::BaseAssumed { model, because } => write!(f, "no [base] model is named; `{model}` was taken because {because}"),
            Self::ManifestNotRead { file } => {
                write!(f, "{file} stands beside this CSV and was not read; give its name to use it")
            }
            Self::SimulatedUnit { unit, response } => {
                write!(f, "the simulation is in {unit} and the response in {response}: the gain holds the ratio of the two")
            }
            Self::Constant { role, value } => {
                let unit = role.unit();
                let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
                write!(f, "the column for {} never changes from {}{unit}", role.key(), readable(*value))
            }
        }
    }
}
