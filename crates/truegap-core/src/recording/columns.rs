//! Which column of the header plays which role, and how its numbers become SI.
//!
//! Limits: a unit is the end of a column's name (`force_n`, `Force [N]`, `Time(s)`) or stands under `[units]`.

use super::{
    error::RecordingError,
    manifest::{Manifest, Named, NamedDriver},
    note::Note,
    roles::ROLES,
};
use crate::inputs::Role;
use crate::units::{Dimension, UnitError};
use std::path::Path;

/// A column that plays a role.
#[derive(Clone, Debug)]
pub(super) struct Column {
    pub role: Role,
    pub index: usize,
    pub name: String,
    /// unit after conversion
    pub unit: String,
    /// value = cell x factor + offset
    pub scale: (f64, f64),
}

/// A column that is none of the roles, and that physics may follow all the same.
#[derive(Clone, Debug)]
pub(super) struct DriverColumn {
    pub index: usize,
    /// name under `[drivers]`
    pub driver: String,
    /// name in the header
    pub name: String,
    /// as recorded; not converted
    pub unit: String,
}

/// What a role measures; `None` for names, and for readings in any unit.
pub(super) fn dimension(role: Role) -> Option<Dimension> {
    match role {
        Role::Time => Some(Dimension::Time),
        Role::Force => Some(Dimension::Force),
        Role::Pressure => Some(Dimension::Pressure),
        Role::Gap => Some(Dimension::Length),
        Role::Temperature => Some(Dimension::Temperature),
        Role::Humidity => Some(Dimension::Humidity),
        Role::Response | Role::Simulated | Role::Run | Role::Sensor => None,
    }
}

/// Name that the contract gives a role's column.
fn default_name(role: Role) -> &'static str {
    match role {
        Role::Time => "time_s",
        Role::Force => "force_n",
        Role::Pressure => "pressure_kpa",
        Role::Gap => "gap_mm",
        Role::Temperature => "temperature_c",
        Role::Humidity => "humidity_pct",
        Role::Response => "capacitance_pf",
        Role::Simulated | Role::Run | Role::Sensor => role.key(),
    }
}

/// The columns of a header, and what was assumed about them.
pub(super) fn bind(
    file: &Path,
    toml: Option<&Path>,
    header: &[String],
    manifest: &Manifest,
) -> Result<(Vec<Column>, Vec<Note>), RecordingError> {
    let binder = Binder { file, toml: toml.unwrap_or(file), header, manifest };
    let mut found = Vec::new();
    for role in ROLES {
        found.extend(binder.find(role)?.map(|(index, name)| (role, index, name)));
    }
    let mut notes = Vec::new();
    let columns = found.into_iter().map(|(role, index, name)| binder.column(role, index, name, &mut notes));
    let mut columns = columns.collect::<Result<Vec<_>, _>>()?;
    binder.match_simulated(&mut columns)?;
    Ok((columns, notes))
}

/// The columns that `[drivers]` names; `roles` are those that play a role already.
pub(super) fn bind_drivers(
    file: &Path,
    toml: Option<&Path>,
    header: &[String],
    manifest: &Manifest,
    roles: &[Column],
) -> Result<Vec<DriverColumn>, RecordingError> {
    let refused = |wanted: &NamedDriver, why: String| RecordingError::Driver {
        file: toml.unwrap_or(file).to_owned(),
        line: wanted.line,
        driver: wanted.name.clone(),
        why,
    };
    let bound = |wanted: &NamedDriver| {
        if let Some(role) = ROLES.into_iter().find(|role| role.key() == wanted.name) {
            return Err(refused(wanted, format!("`{0}` is a role; name its column under [columns]: {0} = \"...\"", role.key())));
        }
        if wanted.name.trim().is_empty() {
            return Err(refused(wanted, "it has no name; write position = { column = \"...\", unit = \"...\" }".into()));
        }
        let Some(index) = header.iter().position(|name| *name == wanted.column) else {
            let found = quoted(header.iter().map(String::as_str).filter(|name| !name.is_empty()));
            return Err(refused(wanted, format!("`{}` is not in the header; found: {found}", wanted.column)));
        };
        if let Some(column) = roles.iter().find(|c| c.index == index) {
            let role = column.role.key();
            return Err(refused(wanted, format!("column `{}` is the {role} already; leave it out of [drivers]", column.name)));
        }
        let unit = wanted.unit.clone().or_else(|| unit_end(&wanted.column).map(str::to_owned));
        let unit = unit.ok_or_else(|| {
            let example = format!("{} = {{ column = \"{}\", unit = \"mm\" }}", wanted.name, wanted.column);
            refused(wanted, format!("column `{}` has no unit in its name; write {example}, or unit = \"1\"", wanted.column))
        })?;
        Ok(DriverColumn { index, driver: wanted.name.clone(), name: wanted.column.clone(), unit })
    };
    manifest.drivers.iter().map(bound).collect()
}

struct Binder<'a> {
    file: &'a Path,
    toml: &'a Path,
    header: &'a [String],
    manifest: &'a Manifest,
}

impl Binder<'_> {
    /// Index and name of a role's column.
    fn find(&self, role: Role) -> Result<Option<(usize, String)>, RecordingError> {
        let named = self.manifest.columns.get(&role);
        let found: Vec<(usize, &String)> = match named {
            Some(named) => self.header.iter().enumerate().filter(|(_, name)| **name == named.text).collect(),
            None => self.header.iter().enumerate().filter(|(_, name)| is_default(role, name)).collect(),
        };
        match (found.as_slice(), named) {
            ([(index, name)], _) => Ok(Some((*index, (*name).clone()))),
            ([], None) if role != Role::Response => match self.almost(role) {
                Some(refused) => Err(refused),
                None => Ok(None),
            },
            ([], _) => Err(self.missing(role, named)),
            ([(_, first), ..], _) => Err(RecordingError::AmbiguousColumn {
                file: self.file.to_owned(),
                role: role.key().to_owned(),
                found: quoted(found.iter().map(|(_, name)| name.as_str())),
                first: (*first).clone(),
            }),
        }
    }

    /// Why a role has no column although the header holds one that is called after it: what stands behind the word is no unit of it. To leave the column out
    /// without a word would be to diagnose another recording.
    fn almost(&self, role: Role) -> Option<RecordingError> {
        let dimension = dimension(role)?;
        let elsewhere = |name: &String| self.manifest.columns.values().any(|named| named.text == **name);
        let name = self.header.iter().find(|name| called_after(role, name) && !elsewhere(name))?;
        let unit = unit_end(name).unwrap_or_default();
        Some(RecordingError::NotItsUnit {
            file: self.file.to_owned(),
            column: name.clone(),
            role: role.key().to_owned(),
            unit: unit.to_owned(),
            known: dimension.unit_names().join(", "),
        })
    }

    fn missing(&self, role: Role, named: Option<&Named>) -> RecordingError {
        RecordingError::MissingColumn {
            file: self.file.to_owned(),
            role: role.key().to_owned(),
            wanted: named.map_or_else(|| format!("`{}`", default_name(role)), |n| format!("`{}`", n.text)),
            found: quoted(self.header.iter().map(String::as_str).filter(|name| !name.is_empty())),
        }
    }

    fn column(&self, role: Role, index: usize, name: String, notes: &mut Vec<Note>) -> Result<Column, RecordingError> {
        let given = self.manifest.units.get(&role);
        let (unit, scale) = match (role, dimension(role)) {
            (Role::Run | Role::Sensor, _) => (String::new(), (1.0, 0.0)),
            (_, None) => self.reading(role, &name, given, notes)?,
            (_, Some(dimension)) => self.quantity(role, dimension, &name, given, notes)?,
        };
        Ok(Column { role, index, name, unit, scale })
    }

    /// SI unit and scale of a quantity.
    fn quantity(
        &self,
        role: Role,
        dimension: Dimension,
        name: &str,
        given: Option<&Named>,
        notes: &mut Vec<Note>,
    ) -> Result<(String, (f64, f64)), RecordingError> {
        let in_name = unit_end(name).and_then(|end| dimension.unit_like(end));
        let scale = match (given, in_name) {
            (Some(given), _) => {
                let scale = dimension.scale(&given.text).map_err(|source| self.wrong_unit(role, given.line, source))?;
                if let Some(named) = in_name.filter(|named| dimension.scale(named) != Ok(scale)) {
                    notes.push(Note::UnitOverridesName { column: name.into(), unit: given.text.clone(), named: named.into() });
                }
                scale
            }
            (None, Some(unit)) => dimension.scale(unit).map_err(|source| self.wrong_unit(role, 1, source))?,
            (None, None) => return Err(self.missing_unit(role, dimension, name)),
        };
        Ok((dimension.si_unit().to_owned(), scale))
    }

    /// Unit and scale of a reading: picofarads for capacitances, anything else as it stands.
    fn reading(
        &self,
        role: Role,
        name: &str,
        given: Option<&Named>,
        notes: &mut Vec<Note>,
    ) -> Result<(String, (f64, f64)), RecordingError> {
        let farads = Dimension::Capacitance;
        let in_name = unit_end(name).and_then(|end| farads.unit_like(end));
        let unit = match (given, in_name) {
            (Some(given), named) => {
                if let Some(named) = named.filter(|named| *named != given.text) {
                    notes.push(Note::UnitOverridesName { column: name.into(), unit: given.text.clone(), named: named.into() });
                }
                given.text.clone()
            }
            (None, Some(named)) => named.to_owned(),
            (None, None) if role == Role::Simulated => String::new(),
            (None, None) => unit_end(name).unwrap_or(name).to_owned(),
        };
        if let Some(given) = given {
            self.not_another_case(role, given)?;
        }
        Ok(match farads.scale(&unit) {
            Ok((factor, _)) => ("pF".to_owned(), (factor / 1e-12, 0.0)),
            Err(_) => (unit, (1.0, 0.0)),
        })
    }

    /// A reading may be in any unit, but `PF` is a slip of the pen.
    fn not_another_case(&self, role: Role, given: &Named) -> Result<(), RecordingError> {
        match Dimension::Capacitance.scale(&given.text) {
            Err(source) if Dimension::Capacitance.unit_like(&given.text).is_some() => {
                Err(self.wrong_unit(role, given.line, source))
            }
            _ => Ok(()),
        }
    }

    /// Gives a simulated column without a unit the response's; refuses two different ones.
    fn match_simulated(&self, columns: &mut [Column]) -> Result<(), RecordingError> {
        let Some(response) = columns.iter().find(|c| c.role == Role::Response).cloned() else { return Ok(()) };
        let Some(simulated) = columns.iter_mut().find(|c| c.role == Role::Simulated) else { return Ok(()) };
        if simulated.unit.is_empty() {
            simulated.unit = response.unit;
            simulated.scale = response.scale;
        } else if simulated.unit != response.unit {
            return Err(RecordingError::UnitsDiffer {
                file: self.file.to_owned(),
                column: simulated.name.clone(),
                unit: simulated.unit.clone(),
                response: response.unit,
            });
        }
        Ok(())
    }

    fn wrong_unit(&self, role: Role, line: usize, source: UnitError) -> RecordingError {
        RecordingError::WrongUnit { file: self.toml.to_owned(), line, role: role.key().to_owned(), source }
    }

    fn missing_unit(&self, role: Role, dimension: Dimension, name: &str) -> RecordingError {
        RecordingError::MissingUnit {
            file: self.file.to_owned(),
            column: name.to_owned(),
            role: role.key().to_owned(),
            example: dimension.si_unit().to_owned(),
            known: dimension.unit_names().join(", "),
        }
    }
}

/// Whether a column's name is one that a role has by default: the role's word, alone or with a unit behind it.
pub(super) fn is_default(role: Role, name: &str) -> bool {
    let words: &[&str] = if role == Role::Response { &["capacitance", "response"] } else { &[role.key()] };
    let lower = name.to_ascii_lowercase();
    let rest = words.iter().find_map(|word| lower.strip_prefix(word));
    match (rest, role) {
        (None, _) => false,
        (Some(""), _) => true,
        (Some(_), Role::Run | Role::Sensor) => false,
        (Some(rest), Role::Response) if lower.starts_with("response") => rest.starts_with('_'),
        (Some(rest), Role::Simulated) => rest.starts_with('_'),
        (Some(rest), _) => {
            let dimension = dimension(role).unwrap_or(Dimension::Capacitance);
            unit_end(rest).is_some_and(|end| whole(rest, end) && dimension.unit_like(end).is_some())
        }
    }
}

/// Whether a column's name is a role's word with one more behind it, in brackets or after an underscore, where a unit stands: `force_xyz`, `Force [pF]`.
fn called_after(role: Role, name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    let rest = lower.strip_prefix(role.key()).map(str::trim);
    rest.is_some_and(|rest| {
        rest.starts_with(['_', '(', '[']) && unit_end(rest).is_some_and(|end| whole(rest, end) && !end.is_empty())
    })
}

/// Whether `rest` is the unit and nothing but punctuation.
fn whole(rest: &str, end: &str) -> bool {
    rest.chars().filter(|c| !matches!(c, '_' | ' ' | '(' | ')' | '[' | ']')).eq(end.chars())
}

/// What stands last in a column's name: in brackets, or behind the last underscore.
pub(super) fn unit_end(name: &str) -> Option<&str> {
    let name = name.trim();
    for (open, close) in [('(', ')'), ('[', ']')] {
        if let Some((_, unit)) = name.strip_suffix(close).and_then(|inner| inner.rsplit_once(open)) {
            return Some(unit.trim());
        }
    }
    name.rsplit_once('_').map(|(_, unit)| unit).filter(|unit| !unit.is_empty())
}

/// Names for a message.
fn quoted<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    names.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_is_what_stands_last_in_the_name() {
        assert_eq!(unit_end("force_n"), Some("n"));
        assert_eq!(unit_end("Force [N]"), Some("N"));
        assert_eq!(unit_end("Time(s)"), Some("s"));
        assert_eq!(unit_end("counts"), None);
    }

    #[test]
    fn a_column_called_after_a_role_has_one_word_behind_it() {
        assert!(called_after(Role::Force, "force_pa") && called_after(Role::Force, "Force [xyz]"));
        assert!(
            !called_after(Role::Force, "force_setpoint_n")
                && !called_after(Role::Force, "force")
                && !called_after(Role::Time, "timer_s")
        );
    }

    #[test]
    fn a_default_name_is_the_word_and_a_unit() {
        assert!(
            is_default(Role::Force, "force_n")
                && is_default(Role::Force, "Force [mN]")
                && is_default(Role::Pressure, "pressure_bar")
        );
        assert!(!is_default(Role::Force, "force_setpoint_n") && !is_default(Role::Force, "force_pf"));
        assert!(is_default(Role::Response, "capacitance_ff") && is_default(Role::Response, "response_counts"));
        assert!(!is_default(Role::Response, "capacitance_spare_pf"));
        assert!(is_default(Role::Run, "run") && !is_default(Role::Run, "running_hours"));
    }
}
