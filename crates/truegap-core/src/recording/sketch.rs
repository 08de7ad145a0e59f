//! The TOML of a CSV as far as its header tells: which column is what, in which unit.
//!
//! Limits: names and the first row only; what cannot be seen there is left open, as a comment that says what to write.

use super::{
    columns::{dimension, is_default, unit_end},
    error::RecordingError,
    manifest::SCHEMA,
    number::number,
    open::open_file,
    roles::ROLES,
    table::Table,
};
use crate::inputs::Role;
use crate::units::Dimension;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// Words of a column's name that tell its role, where they begin a word of it.
const WORDS: [(Role, &[&str]); 7] = [
    (Role::Time, &["time", "elapsed", "t"]),
    (Role::Force, &["force", "load", "weight", "fz"]),
    (Role::Pressure, &["pressure", "press"]),
    (Role::Gap, &["gap", "separation"]),
    (Role::Temperature, &["temperature", "temp", "thermometer"]),
    (Role::Humidity, &["humidity", "rh"]),
    (Role::Response, &["response", "capacitance", "cap", "reading", "signal", "output", "counts"]),
];

/// A TOML, and what somebody has to add to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sketch {
    /// text of the TOML
    pub toml: String,
    /// what the header does not tell, a sentence each
    pub open: Vec<String>,
}

/// What a header tells of a recording.
///
/// # Errors
/// [`RecordingError`] where the CSV cannot be read or has no header.
pub fn sketch(csv: &Path) -> Result<Sketch, RecordingError> {
    let mut table = Table::open(csv, open_file(csv)?)?;
    let header = table.header.clone();
    let is_there = table.advance()?;
    let decimal_comma = table.decimal_comma;
    let numeric = |index: usize| is_there && table.row().get(index).is_some_and(|cell| number(cell, decimal_comma).is_ok());
    let columns: Vec<&str> = header.iter().enumerate().filter(|(i, _)| numeric(*i)).map(|(_, name)| name.as_str()).collect();
    let found = roles(&columns);
    let file = csv.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    Ok(written(&file, &columns, &found))
}

/// The column of each role: by its default name, then by a word of its name, then by its unit, then as the only one that is left.
fn roles<'a>(columns: &[&'a str]) -> BTreeMap<Role, &'a str> {
    let mut found: BTreeMap<Role, &str> = BTreeMap::new();
    let mut take = |fits: &dyn Fn(Role, &str) -> bool| {
        for role in ROLES {
            let free: Vec<&str> =
                columns.iter().copied().filter(|c| found.values().all(|taken| taken != c) && fits(role, c)).collect();
            if let ([only], false) = (free.as_slice(), found.contains_key(&role)) {
                found.insert(role, only);
            }
        }
    };
    take(&|role, name| is_default(role, name));
    take(&|role, name| called(role, name));
    take(&|role, name| measured(role, name));
    take(&|role, _| role == Role::Response);
    found
}

/// Whether a word of the name tells the role, and its unit does not tell another.
fn called(role: Role, name: &str) -> bool {
    let lower = name.to_lowercase();
    let words: Vec<&str> = lower.split(|c: char| !c.is_alphanumeric()).collect();
    let told = WORDS.iter().any(|(of, told)| *of == role && words.iter().any(|word| told.contains(word)));
    let unit = unit_end(name).unwrap_or("");
    let other = |of: Role| dimension(of).is_some_and(|d| d.unit_like(unit).is_some());
    told && (dimension(role).is_none() || other(role) || !ROLES.into_iter().any(other))
}

/// Whether the unit behind the name is one of the role.
fn measured(role: Role, name: &str) -> bool {
    let dimension = if role == Role::Response { Some(Dimension::Capacitance) } else { dimension(role) };
    dimension.is_some_and(|d| unit_end(name).is_some_and(|unit| d.unit_like(unit).is_some()))
}

fn written(file: &str, columns: &[&str], found: &BTreeMap<Role, &str>) -> Sketch {
    let (mut toml, mut open) = (format!("schema = \"{SCHEMA}\"\nfile = {}\n\n[columns]\n", quoted(file)), Vec::new());
    let mut line = |text: String| toml.push_str(&(text + "\n"));
    for role in ROLES.into_iter().filter(|role| found.contains_key(role)) {
        line(format!("{} = {}", role.key(), quoted(found[&role])));
    }
    if !found.contains_key(&Role::Response) {
        line(format!("# response = \"...\"   # the reading; one of: {}", columns.join(", ")));
        open.push("which column is the reading: complete `response` under [columns]".to_owned());
    }
    line("\n[units]".to_owned());
    for (role, column) in found.iter().filter(|(role, _)| !matches!(role, Role::Run | Role::Sensor)) {
        let text = unit(*role, column);
        if text.starts_with('#') {
            open.push(format!("the unit of `{column}`: complete `{}` under [units]", role.key()));
        }
        line(text);
    }
    let spare: Vec<&str> = columns.iter().copied().filter(|c| found.values().all(|taken| taken != c)).collect();
    if !spare.is_empty() {
        line(format!("\n# Not used: {}. Physics may follow a column that stands under [drivers]:", spare.join(", ")));
        line(format!("# [drivers]\n# {} = {{ column = {}, unit = \"1\" }}", plain(spare[0]), quoted(spare[0])));
    }
    line("\n# What the recording is compared with (docs/recordings.md):".to_owned());
    line("# [base]\n# model = \"linear\"                                    # a straight line in the load".to_owned());
    line(
        "# model = \"stack\"\n# sensor = \"singletact-s15-4.5n\"                     # a capacitive sensor, built in or a TOML"
            .to_owned(),
    );
    line("# model = \"command\"\n# run = [\"python3\", \"sim.py\"]                      # your own simulator (docs/command-base.md)".to_owned());
    if found.keys().any(|role| matches!(role, Role::Force | Role::Pressure)) && !found.contains_key(&Role::Simulated) {
        open.push("what the recording is compared with: complete [base]".to_owned());
    }
    Sketch { toml, open }
}

/// The line of a role's unit: as the header says it, else a comment.
fn unit(role: Role, column: &str) -> String {
    let told = unit_end(column);
    let known = |d: Dimension| told.and_then(|unit| d.unit_like(unit));
    let key = role.key();
    match dimension(role) {
        Some(d) => match known(d) {
            Some(unit) => format!("{key} = \"{unit}\""),
            None => format!("# {key} = \"{}\"   # the header does not say", d.si_unit()),
        },
        // behind an underscore anything may stand, in brackets a unit
        None => {
            match known(Dimension::Capacitance).or(known(Dimension::Voltage)).or(told.filter(|_| column.contains(['[', '(']))) {
                Some(unit) => format!("{key} = {}", quoted(unit)),
                None => format!("# {key} = \"pF\"   # the header does not say"),
            }
        }
    }
}

fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}

/// A name that TOML takes without quotes.
fn plain(name: &str) -> String {
    let mut plain = String::new();
    for c in name.to_lowercase().chars() {
        let _ = plain.write_char(if c.is_ascii_alphanumeric() { c } else { '_' }); // writing to a String cannot fail
    }
    plain.trim_matches('_').to_owned()
}
