//! The TOML of a CSV as far as it shows: which column is what, in which unit, and as comments what is left to somebody who knows.
//!
//! Limits: the header and the first rows; nothing is guessed from the size of numbers.

use super::{
    columnar,
    columns::{quoted, there},
    date_and_time::{date_and_time, joined},
    default_names::{dimension, shown_unit},
    driver_columns::bind_drivers,
    error::RecordingError,
    guess::{Guess, guess},
    heading::Heading,
    likely::Likely,
    manifest::{Manifest, SCHEMA},
    map::{Mapped, Part},
    packed::is_standard_input,
    roles::ROLES,
    seen::Seen,
    told::Told,
    toml_names::{free, plain, toml_key, toml_text},
    twins::Twins,
    words::{is_called_simulation, told},
};
use crate::inputs::Role;
use crate::units::Dimension;
use std::path::Path;

/// What may stand under `[base]`.
const BASES: &str = r#"# [base]
# model = "linear"                                   # a straight line in the load, or in driver = "NAME"
# model = "external"                                 # your own simulation, a column that stands as `simulated` under [columns]
# model = "stack"
# sensor = "singletact-s15-4.5n"                     # a capacitive sensor, built in or a TOML
# model = "command"
# run = ["python3", "sim.py"]                        # your own simulator (docs/command-base.md)"#;

/// A TOML, and what somebody has to add to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sketch {
    /// text of the TOML
    pub toml: String,
    /// which column is what, by the names of the roles
    pub found: Vec<(String, String)>,
    /// what the header does not tell, a sentence each
    pub open: Vec<String>,
}

/// What a header tells of a recording, and what is told beside it.
///
/// # Errors
/// [`RecordingError`] where the table cannot be read, has no header, or lacks a column that is told of.
pub fn sketch(csv: &Path, told: &Told) -> Result<Sketch, RecordingError> {
    let seen = match columnar::read(csv)? {
        Some(frame) => Seen::of_frame(csv, frame, told)?,
        None => Seen::of_csv(csv, told)?,
    };
    let manifest = Manifest::default().told(told, &seen.header).with_roles_of_drivers(csv, None, &seen.header)?;
    let told = &told.by_roles();
    manifest.columns.iter().try_for_each(|(role, named)| there(csv, &seen.header, *role, named))?;
    bind_drivers(csv, None, &seen.header, &manifest, &[])?;
    let nameless = is_standard_input(csv);
    let file = csv.file_name().filter(|_| !nameless).map_or_else(|| "-".into(), |name| name.to_string_lossy().into_owned());
    let Seen { header, numeric, days, notes } = seen;
    Ok(Writer { header: &header, numeric: &numeric, told, days, toml: String::new(), open: nameless_file(nameless) }
        .write(&file, notes))
}

/// What is open of the name of a table.
fn nameless_file(nameless: bool) -> Vec<String> {
    let says = "what the table is called: put its name in place of `-`, which is standard input, under `file`";
    nameless.then(|| says.to_owned()).into_iter().collect()
}

struct Writer<'a> {
    header: &'a [Heading],
    /// whether there are numbers under a heading
    numeric: &'a [bool],
    told: &'a Told,
    /// a date in no order that shows
    days: Option<String>,
    toml: String,
    open: Vec<String>,
}

impl Writer<'_> {
    fn line(&mut self, text: &str) {
        self.toml.push_str(text);
        self.toml.push('\n');
    }

    fn name(&self, index: usize) -> &str {
        &self.header[index].name
    }

    /// Whether no other column has this one's name: a TOML names columns by it.
    fn is_alone(&self, index: usize) -> bool {
        !self.name(index).is_empty() && self.header.iter().filter(|other| other.name == self.name(index)).count() == 1
    }

    fn write(mut self, file: &str, notes: Vec<String>) -> Sketch {
        let columns = 0..self.header.len();
        let usable: Vec<usize> = columns
            .clone()
            .filter(|index| (self.numeric[*index] || self.header[*index].dated) && self.is_alone(*index))
            .collect();
        let told = self.told_of().into_iter().map(|(part, index, _)| (part.clone(), index)).collect();
        let (guess, twins) = Likely { header: self.header, usable: &usable, told }.roles();
        self.line(&format!("schema = \"{SCHEMA}\"\nfile = {}", toml_text(file)));
        self.dates();
        notes.iter().for_each(|note| self.line(&format!("# {note}")));
        self.columns(&guess, &usable);
        self.units(&guess);
        self.drivers();
        self.spare(&guess, &usable);
        let unusable: Vec<usize> = columns.filter(|index| !usable.contains(index)).collect();
        self.without_numbers(&guess, &unusable);
        self.unusable(unusable);
        self.base(&guess, twins);
        let found = guess.found.iter().map(|(role, index)| (role.key().to_owned(), self.called(*role, *index))).collect();
        Sketch { toml: self.toml, found, open: self.open }
    }

    /// The name of a role's column, and of the one that it is joined with.
    fn called(&self, role: Role, index: usize) -> String {
        let other = date_and_time(self.header, index).filter(|_| role == Role::Time).map(|(_, time)| self.name(time));
        other.map_or_else(|| self.name(index).to_owned(), |time| joined(self.name(index), time))
    }

    /// Columns that are told of, with what they are and their units.
    fn told_of(&self) -> Vec<(&Part, usize, Option<&str>)> {
        self.told.map.iter().filter_map(|mapped| placed(mapped, self.header)).collect()
    }

    fn is_told_of(&self, index: usize) -> bool {
        self.told_of().iter().any(|(_, told, _)| *told == index)
    }

    /// Columns that are called after a simulation and play no part yet.
    fn computed(&self, guess: &Guess, usable: &[usize]) -> Vec<usize> {
        let is_free = |index: &&usize| !self.is_told_of(**index) && guess.found.values().all(|taken| taken != *index);
        usable.iter().filter(is_free).filter(|index| is_called_simulation(self.name(**index))).copied().collect()
    }

    fn dates(&mut self) {
        match (self.told.dayfirst, self.days.take()) {
            (Some(told), _) => self.line(&format!("dayfirst = {told}")),
            (None, Some(date)) => {
                self.line(&format!("# dayfirst = true   # whether `{date}` begins with the day"));
                self.open.push(format!("whether `{date}` begins with the day or the month: complete `dayfirst`"));
            }
            (None, None) => {}
        }
    }

    fn drivers(&mut self) {
        let drivers = self.told_of().into_iter().filter_map(|(part, index, unit)| match part {
            Part::Driver(name) => Some((name.clone(), index, unit.map(str::to_owned))),
            Part::Role(_) => None,
        });
        let drivers: Vec<_> = drivers.collect();
        if !drivers.is_empty() {
            self.line("\n[drivers]");
        }
        for (name, index, unit) in drivers {
            let heading = &self.header[index];
            let unit = unit.or_else(|| heading.proper_unit().map(str::to_owned)).unwrap_or_else(|| "1".to_owned());
            let line = format!("{} = {{ column = {}, unit = {} }}", toml_key(&name), toml_text(&heading.name), toml_text(&unit));
            self.line(&line);
        }
    }

    fn columns(&mut self, guess: &Guess, usable: &[usize]) {
        self.line("\n[columns]");
        for role in ROLES {
            let key = role.key();
            let missing = role == Role::Response && !guess.found.contains_key(&role);
            match (guess.found.get(&role), guess.several.get(&role)) {
                (Some(index), _) => {
                    let by_name = role == Role::Simulated && !self.is_told_of(*index);
                    let why = if by_name {
                        "   # by its name; where it is no simulation, take it out and name another base"
                    } else {
                        ""
                    };
                    self.line(&format!("{key} = {}{why}", toml_text(self.name(*index))));
                }
                (None, Some(several)) => {
                    let names = quoted(several.iter().map(|index| self.name(*index)));
                    self.line(&format!("# {key} = \"...\"   # several could be it: {names}"));
                    self.open.push(format!("which of {names} is the {key}: complete `{key}` under [columns]"));
                }
                (None, None) if missing => {
                    let free = usable.iter().filter(|index| guess.found.values().all(|taken| taken != *index));
                    let (computed, read): (Vec<usize>, Vec<usize>) =
                        free.copied().partition(|index| is_called_simulation(self.name(*index)));
                    let may_be = if read.is_empty() { computed } else { read };
                    let names = quoted(may_be.iter().map(|index| self.name(*index)));
                    self.line(&format!("# response = \"...\"   # the reading; one of: {names}"));
                    self.open.push("which column is the reading: complete `response` under [columns]".to_owned());
                }
                (None, None) if role == Role::Simulated => self.proposed(&self.computed(guess, usable)),
                (None, None) => {}
            }
        }
    }

    /// Columns that may be a simulation, proposed as one.
    fn proposed(&mut self, computed: &[usize]) {
        let Some(first) = computed.first() else { return };
        let (first, names) = (toml_text(self.name(*first)), quoted(computed.iter().map(|index| self.name(*index))));
        self.line(&format!("# simulated = {first}   # if it is your own simulation; then model = \"external\" under [base]"));
        self.open.push(format!(
            "whether {names} is your own simulation: then `simulated` under [columns], and model = \"external\" under [base]"
        ));
    }

    fn units(&mut self, guess: &Guess) {
        self.line("\n[units]");
        for (role, index) in guess.found.iter().filter(|(role, _)| !matches!(role, Role::Run | Role::Sensor)) {
            let (key, heading) = (role.key(), &self.header[*index]);
            let told = self.told_of().into_iter().find_map(|(part, _, unit)| unit.filter(|_| *part == Part::Role(*role)));
            if let Some(unit) = told {
                let line = format!("{key} = {}", toml_text(unit));
                self.line(&line);
                continue;
            }
            if *role == Role::Time && heading.dated {
                let with = date_and_time(self.header, *index)
                    .map(|(_, time)| format!(" with the times of day in `{}`", self.name(time)));
                let with = with.unwrap_or_default();
                self.line(&format!("# time: the column holds dates{with}, and is read in seconds from the first"));
                continue;
            }
            match shown_unit(*role, heading) {
                Some(unit) => self.line(&format!("{key} = {}", toml_text(&unit))),
                None => {
                    let says = match heading.unit() {
                        Some(unit) if dimension(*role).is_some() => format!("`{unit}` is no unit of it"),
                        _ => "the header does not say".to_owned(),
                    };
                    let known = dimension(*role).map_or_else(|| "pF, mV, counts, ...".to_owned(), |d| d.unit_names().join(", "));
                    let example = dimension(*role).map_or("pF", Dimension::si_unit);
                    self.open.push(format!("the unit of `{}`: complete `{key}` under [units]", heading.name));
                    self.line(&format!("# {key} = \"{example}\"   # {says}; one of: {known}"));
                }
            }
        }
    }

    /// Columns of numbers that play no role.
    fn spare(&mut self, guess: &Guess, usable: &[usize]) {
        let of_role = |index: usize| guess.found.values().any(|taken| *taken == index);
        let taken = |index: &&usize| of_role(**index) || self.is_told_of(**index) || self.header[**index].dated;
        let spare: Vec<usize> = usable.iter().filter(|index| !taken(index)).copied().collect();
        if spare.is_empty() {
            return;
        }
        let computed = self.computed(guess, usable);
        let unasked: Vec<_> = spare.iter().filter(|index| !computed.contains(index)).map(|index| self.name(*index)).collect();
        if guess.found.contains_key(&Role::Response) && !unasked.is_empty() {
            let names = quoted(unasked.into_iter());
            self.open.push(format!(
                "what {names} may be: what the reading follows (under [drivers]), your own simulation (`simulated` under [columns]), or nothing that matters"
            ));
        }
        let names: Vec<&str> = spare.iter().map(|index| self.name(*index)).collect();
        self.line(&format!("\n# Not used: {}. Physics may follow a column that stands under [drivers]:", names.join(", ")));
        if self.told_of().iter().all(|(part, ..)| matches!(part, Part::Role(_))) {
            self.line("# [drivers]");
        }
        let mut keys: Vec<String> = Vec::new();
        for index in spare {
            let heading = &self.header[index];
            let unit = heading.proper_unit().unwrap_or("1");
            let what = heading.unit_in_name().map_or(heading.name.as_str(), |(measured, _)| measured);
            let key = free(&plain(what, index), &keys);
            let line = format!("# {key} = {{ column = {}, unit = {} }}", toml_text(&heading.name), toml_text(unit));
            self.line(&line);
            keys.push(key);
        }
    }

    /// Columns that are called after a role and hold no number, as `5 N` is none: to leave one out without a word would be to diagnose another recording.
    fn without_numbers(&mut self, found: &Guess, unusable: &[usize]) {
        use Role::{Force, Gap, Humidity, Pressure, Response, Temperature, Time};
        if !self.numeric.contains(&true) {
            return; // there are no rows to look at
        }
        let named: Vec<usize> = unusable.iter().copied().filter(|index| self.is_alone(*index)).collect();
        let called = guess(self.header, &named).found;
        let is_open = |role: &Role| !found.found.contains_key(role) && !found.several.contains_key(role);
        for role in [Time, Force, Pressure, Gap, Temperature, Humidity, Response].into_iter().filter(is_open) {
            // what is left over of the columns is no reading because of that
            let by_name = |index: &&usize| role != Response || told(role, self.name(**index));
            if let Some(index) = called.get(&role).filter(by_name) {
                let (name, key) = (self.name(*index), role.key());
                let says = format!(
                    "`{name}` is called after the {key}, and its first rows hold no number: correct them, or the recording has no {key}"
                );
                self.open.push(says);
            }
        }
    }

    /// Columns that cannot be named: no numbers, no name, or one that another has too.
    fn unusable(&mut self, columns: Vec<usize>) {
        let (text, named): (Vec<usize>, Vec<usize>) =
            columns.into_iter().filter(|index| !self.name(*index).is_empty()).partition(|index| self.is_alone(*index));
        if !text.is_empty() {
            let names = quoted(text.iter().map(|index| self.name(*index)));
            self.line(&format!("\n# No numbers in the first rows: {names}."));
        }
        let mut twice: Vec<String> = named.iter().map(|index| self.name(*index).to_owned()).collect();
        twice.dedup();
        if !twice.is_empty() {
            let names = quoted(twice.iter().map(String::as_str));
            self.line(&format!(
                "\n# Several columns have the same name: {names}. They cannot be told apart here: rename them in the CSV."
            ));
            self.open.push(format!("several columns are called {names}: rename them in the CSV"));
        }
    }

    fn base(&mut self, guess: &Guess, twins: Option<Twins>) {
        self.line("\n# What the recording is compared with (docs/recordings.md):");
        if guess.found.contains_key(&Role::Simulated) {
            self.line(
                "[base]\nmodel = \"external\"                                  # your own simulation, the column `simulated`",
            );
            return;
        }
        self.line(BASES);
        self.open.push("what the recording is compared with: complete [base]".to_owned());
        if let Some(Twins { reading, beside, is_simulated: false }) = twins {
            let [reading, beside] = [reading, beside].map(|index| self.name(index));
            self.open.push(format!(
                "whether `{reading}` is the reading, as its name says; `{beside}` may be its simulation, what it would read if nothing were missing: then `simulated` under [columns], and model = \"external\" under [base]"
            ));
        }
    }
}

/// What a column that is told of is, its place in the header, and its unit where that is told.
fn placed<'a>(mapped: &'a Mapped, header: &[Heading]) -> Option<(&'a Part, usize, Option<&'a str>)> {
    let (column, unit) = mapped.column_and_unit(header);
    Some((mapped.part(), header.iter().position(|heading| heading.name == column)?, unit))
}
