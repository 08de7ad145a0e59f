//! Why a recording cannot be read: file, line, value and what to do about it.
//!
//! Limits: every error is fatal; what can be read in spite of an oddity is a [`crate::Note`].

use super::note::Note;
use crate::units::UnitError;
use std::path::PathBuf;

/// Why a recording cannot be read or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum RecordingError {
    /// The file is not there.
    #[error("{file}: there is no such file; give the path of a recording's TOML or CSV")]
    NotFound { file: PathBuf },
    /// A table that cannot be read, beside a TOML of its name that may say what is missing.
    #[error("{note} (of the CSV alone: {source})")]
    BesideManifest { source: Box<RecordingError>, note: Note },
    /// The file is there and cannot be read.
    #[error("{file}: cannot be read: {source}")]
    Read { file: PathBuf, source: std::io::Error },
    /// More than can be held.
    #[error(transparent)]
    TooLarge(#[from] truegap_limits::TooLarge),
    /// A table of columns, which this build does not read.
    #[error(
        "{file}: it is {kind} file, which this build does not read; install with `cargo install --path crates/truegap-cli --features columnar`, or save the \
         table as CSV"
    )]
    NoColumnar { file: PathBuf, kind: &'static str },
    /// A table of columns that is damaged, or more than is understood.
    #[error("{file}: cannot be read as {kind} file: {says}; write it again, or save the table as CSV")]
    Columnar { file: PathBuf, kind: &'static str, says: String },
    /// A table of columns through a pipe.
    #[error("{file}: it is {kind} file on standard input, where a CSV is read; write it to a file and give its path")]
    ColumnarStream { file: PathBuf, kind: &'static str },
    /// A column that is named and holds something else than numbers.
    #[error("{file}: column `{column}` holds neither numbers nor dates but {holds}; write numbers, or name another column")]
    NoNumbersInColumn { file: PathBuf, column: String, holds: String },
    /// The recording cannot be written.
    #[error("{file}: cannot be written: {source}")]
    Write { file: PathBuf, source: std::io::Error },
    /// Nothing in the file.
    #[error("{file}: the file is empty; a recording is a CSV with a header line and at least one row")]
    Empty { file: PathBuf },
    /// A header and nothing below it.
    #[error("{file}: there is no row below the header; record something, or name another file")]
    NoRows { file: PathBuf },
    /// The header holds what no text has.
    #[error(
        "{file}: the header holds `{text}`, which is no text; save the table as CSV in UTF-8 (a spreadsheet's own format cannot be read)"
    )]
    NotText { file: PathBuf, text: String },
    /// The first line holds numbers.
    #[error(
        "{file}, line {line}: `{first}` is a number, not a column's name; write a header such as time_s,force_n,capacitance_pf"
    )]
    NoHeader { file: PathBuf, line: usize, first: String },
    /// The TOML is not TOML, or holds a key that means nothing.
    #[error("{file}, line {line}: {message}")]
    Manifest { file: PathBuf, line: usize, message: String },
    /// A key that means nothing.
    #[error("{file}, line {line}: {table} has no key `{key}`; {instead}")]
    UnknownKey { file: PathBuf, line: usize, table: String, key: String, instead: String },
    /// The TOML is of another kind.
    #[error("{file}, line {line}: schema is `{found}`; a recording's is `truegap.recording/1`")]
    Schema { file: PathBuf, line: usize, found: String },
    /// A column that is needed or named is not there.
    #[error(
        "{file}: no column for {role}: {wanted} is not in the header; {near}found: {found}; name yours under [columns] of the TOML beside it: {role} = \"...\" (docs/recordings.md; \
         `truegap init` writes that TOML), or give --map {role}=COLUMN"
    )]
    MissingColumn { file: PathBuf, role: String, wanted: String, near: String, found: String },
    /// A name that stands over two columns.
    #[error("{file}: columns {columns} are both called `{name}`; give each a name of its own in the header, or delete one")]
    Twice { file: PathBuf, name: String, columns: String },
    /// Two columns would do.
    #[error("{file}: columns {found} could all be {role}; say which under [columns], e.g. {role} = \"{first}\"")]
    AmbiguousColumn { file: PathBuf, role: String, found: String, first: String },
    /// A column that is named for two roles.
    #[error(
        "{file}{place}: column `{column}` is both {first} and {second}; name another column for one of them, or leave it out"
    )]
    TwoRoles { file: PathBuf, place: String, column: String, first: String, second: String },
    /// What is told of one role or driver twice beside the files.
    #[error("{file}: --map names two columns for {part}, `{first}` and `{second}`; leave one of them out")]
    MappedTwice { file: PathBuf, part: String, first: String, second: String },
    /// A column that is named as a driver beside the files and cannot be taken.
    #[error("{file}: --map driver.{driver}: {why}")]
    MappedDriver { file: PathBuf, driver: String, why: String },
    /// A column under `[drivers]` that cannot be taken.
    #[error("{file}, line {line}: driver `{driver}`: {why}")]
    Driver { file: PathBuf, line: usize, driver: String, why: String },
    /// A number without a unit.
    #[error(
        "{file}: column `{column}` ({role}) has no unit in its name; write {role} = \"{example}\" under [units] of the TOML beside it, or one of {known}; or give --map \
         {role}=\"{column}:{example}\""
    )]
    MissingUnit { file: PathBuf, column: String, role: String, example: String, known: String },
    /// A column called after a role, with what is no unit of it.
    #[error(
        "{file}: column `{column}` is called after {role}, and `{unit}` is no unit of {role} ({known}); rename the column, or name the one that is meant under \
         [columns] of the TOML beside it: {role} = \"...\""
    )]
    NotItsUnit { file: PathBuf, column: String, role: String, unit: String, known: String },
    /// A unit in the name of a column and another in the line below it.
    #[error(
        "{file}: column `{column}` has the unit {named} in its name and {below} in the line of units below it; correct one of them, or say which it is: {role} = \
         \"{below}\" under [units], or --map {role}=\"{column}:{below}\""
    )]
    TwoUnits { file: PathBuf, column: String, role: String, named: String, below: String },
    /// A unit of something else.
    #[error("{file}, line {line}: unit of {role}: {source}")]
    WrongUnit { file: PathBuf, line: usize, role: String, source: UnitError },
    /// A unit of something else, given beside the column's name.
    #[error("{file}: --map {role}: {source}")]
    MappedUnit { file: PathBuf, role: String, source: UnitError },
    /// A sensor of the same table that reads in another unit.
    #[error(
        "{file}: column `{column}` is in {unit}, the first sensor in {response}; convert one, or give each a table of its own"
    )]
    SensorsDiffer { file: PathBuf, column: String, unit: String, response: String },
    /// A simulated column in another unit than the response, with a gain that is held.
    #[error(
        "{file}: the simulated column `{column}` is in {unit}, the response in {response}; convert one, or let the gain hold the ratio of the two: \
         free = [\"gain\", \"offset\"] under [base]"
    )]
    UnitsDiffer { file: PathBuf, column: String, unit: String, response: String },
    /// A quote that opens and holds the rows behind it.
    #[error(
        "{file}, line {line}: a quote opens in column {column} and does not close there: the rows behind it would be text in one cell; close it, or take it away \
         (an inch is written as in)"
    )]
    OpenQuote { file: PathBuf, line: usize, column: String },
    /// A row with more or fewer cells than the header.
    #[error(
        "{file}, line {line}: {found} cells where the header has {expected}; close the row, or write decimal points instead of commas"
    )]
    Ragged { file: PathBuf, line: usize, found: usize, expected: usize },
    /// Text where a number belongs.
    #[error("{file}, line {line}: `{text}` in column `{column}` is not a number; {hint}")]
    NotANumber { file: PathBuf, line: usize, column: String, text: String, hint: &'static str },
    /// A clock of dates with a cell that is none.
    #[error(
        "{file}, line {line}: `{text}` in column `{column}` is no date, as the first row of it is; write 2026-03-01T12:00:00"
    )]
    NotADate { file: PathBuf, line: usize, column: String, text: String },
    /// Dates that may begin with the day or with the month.
    #[error(
        "{file}, line {line}: `{text}` in column `{column}` may begin with the day or with the month, and no date of the column has a number above 12 there; \
         say which: dayfirst = true or false in the TOML, or --dayfirst or --dayfirst=false"
    )]
    DayOrMonth { file: PathBuf, line: usize, column: String, text: String },
    /// Dates that may begin with the day or with the year.
    #[error(
        "{file}, line {line}: `{text}` in column `{column}` may begin with the day or with the year, and time runs on in the column either way; say which: \
         dayfirst = true (day.month.year) or false (year.month.day) in the TOML, or --dayfirst or --dayfirst=false; or write years with four digits"
    )]
    DayOrYear { file: PathBuf, line: usize, column: String, text: String },
    /// Dates with a zone and dates without.
    #[error(
        "{file}, line {line}: `{text}` in column `{column}` {says}, other than the first date, `{first}`; write the zone in all rows, or in none"
    )]
    MixedZones { file: PathBuf, line: usize, column: String, text: String, says: &'static str, first: String },
    /// Dates in two orders.
    #[error(
        "{file}, line {line}: `{text}` in column `{column}` has another order of day and month than {other}; write all dates as 2026-03-01"
    )]
    BothOrders { file: PathBuf, line: usize, column: String, text: String, other: String },
    /// No number in any row.
    #[error(
        "{file}: column `{column}` ({role}) has no number in any of its {rows} rows (the first is `{text}`); delete it from the table, or rename it so that it \
         is not read as {role}"
    )]
    NoNumbers { file: PathBuf, column: String, role: String, rows: usize, text: String },
    /// A comma or a point that may stand between thousands or before decimals.
    #[error(
        "{file}, line {line}: `{text}` in column `{column}` may be a number with three decimals or one in thousands, and the table does not say which; write all \
         numbers with the same decimal sign, as in 1234.5, and none between thousands"
    )]
    PointOrThousands { file: PathBuf, line: usize, column: String, text: String },
    /// So many rows without a value that what is left is another recording.
    #[error(
        "{file}: {gone} of {rows} rows would be left out, more than half: they have no value in {columns} (the first is line {line}); fill the column, or \
         rename it in the header so that it is not read"
    )]
    FewWhole { file: PathBuf, gone: usize, rows: usize, columns: String, line: usize },
    /// A clock that begins anew every day.
    #[error(
        "{file}: column `{column}` (time) holds times of day without their dates; write both into it, as in 2026-03-01 12:00:00 (where the date has a column \
         of its own, join the two), or count seconds in a column `time_s`"
    )]
    TimeOfDay { file: PathBuf, column: String },
    /// A clock that stands more often than it goes.
    #[error(
        "{file}: {gone} of {rows} rows have the time of the row before, more than half (the first is line {line}); record the time with its fractions, or \
         average the rows of one instant; where date and time of day have a column each, join them into one"
    )]
    FewInstants { file: PathBuf, gone: usize, rows: usize, line: usize },
    /// A number that cannot be, in SI.
    #[error("{file}, line {line}: {value} {unit} in column `{column}` cannot be: {why}; check the unit of the column")]
    Impossible { file: PathBuf, line: usize, column: String, value: f64, unit: String, why: String },
    /// A number that is none once its unit is converted.
    #[error(
        "{file}, line {line}: `{text}` in column `{column}` is more than a number holds once its unit is converted; check the value, and the unit of the column"
    )]
    BeyondNumbers { file: PathBuf, line: usize, column: String, text: String },
    /// A run number that is not a whole number.
    #[error(
        "{file}, line {line}: run `{text}` in column `{column}` is not a whole number from 0 to 4294967295; number the runs 1, 2, 3"
    )]
    NotARun { file: PathBuf, line: usize, column: String, text: String },
    /// A run that was left and comes back.
    #[error(
        "{file}, line {line}: run {run} comes back after another run; give it a new number, or sort the rows by sensor and run"
    )]
    RunReturns { file: PathBuf, line: usize, run: u32 },
    /// Time running backwards.
    #[error("{file}, line {line}: time goes back from {before} s to {after} s inside run {run}; start a new run there")]
    TimeRunsBack { file: PathBuf, line: usize, run: u32, before: f64, after: f64 },
    /// A number that no clock shows.
    #[error("{file}, line {line}: {time:e} s is no time of a clock; look at the column and its unit, or leave the row out")]
    NoClock { file: PathBuf, line: usize, time: f64 },
    /// A clock from 1970 in another unit than it is read in.
    #[error("{file}: the times of column `{column}` would begin in the year {year:.0}: they count from 1970 in {unit}; {remedy}")]
    SinceWhen { file: PathBuf, column: String, year: f64, unit: &'static str, remedy: String },
    /// Numbers that cannot be reckoned with.
    #[error(
        "{file}: the numbers of column `{column}` go from {low:e} to {high:e} {unit}: {says}; check the column and its unit, and write numbers of usual size"
    )]
    Span { file: PathBuf, column: String, low: f64, high: f64, unit: String, says: &'static str },
    /// A recording made in the program has columns of different length.
    #[error("column {column} has {found} rows, the runs have {expected}; give every column one value a row")]
    Lengths { column: String, found: usize, expected: usize },
    /// A table that TOML cannot hold.
    #[error("{file}: the base model cannot be written as TOML: {message}; use plain keys and finite numbers")]
    NotToml { file: PathBuf, message: String },
}
