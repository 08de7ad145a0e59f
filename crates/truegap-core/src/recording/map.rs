//! Columns named in one line in place of a TOML: `response=C_measured:pF`, `driver.position=position_mm:mm`.
//!
//! Limits: one column a line.

use super::{
    default_names::role_of_driver,
    error::RecordingError,
    heading::Heading,
    keys::ROLES_CALLED,
    manifest::{Manifest, Named, NamedDriver},
    roles::ROLES,
};
use crate::inputs::Role;
use crate::{given_again, nearest::instead};
use std::{path::Path, str::FromStr};

/// Line of what stands in no file.
pub(super) const NO_LINE: usize = 0;

/// What stands before the name of a driver.
const DRIVER: &str = "driver.";

/// A role or a driver, and the column that plays it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mapped {
    part: Part,
    /// the column's name, with a unit behind the last colon where there is one
    column: String,
}

/// What a column is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Role(Role),
    /// with its name
    Driver(String),
}

/// Why a text names no column.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum MapError {
    /// No sign between role and column, or nothing on a side of it.
    #[error(
        "`{text}` names no column; write ROLE=COLUMN or ROLE=COLUMN:UNIT, as in response=C_measured:pF or driver.position=position_mm:mm"
    )]
    NoColumn { text: String },
    /// Not a role.
    #[error(
        "`{role}` is no role of a column; {instead}; any other column is a driver: driver.{role}=COLUMN:UNIT (docs/recordings.md)"
    )]
    NoRole { role: String, instead: String },
}

impl FromStr for Mapped {
    type Err = MapError;

    fn from_str(text: &str) -> Result<Self, MapError> {
        let no_column = || MapError::NoColumn { text: text.to_owned() };
        let (role, column) = text.split_once('=').ok_or_else(no_column)?;
        let (word, column) = (role.trim(), column.trim());
        if column.is_empty() {
            return Err(no_column());
        }
        let part = match word.strip_prefix(DRIVER) {
            Some(name) if name.trim().is_empty() => return Err(no_column()),
            Some(name) => Part::Driver(name.trim().to_owned()),
            None => Part::Role(role_of(word)?),
        };
        Ok(Self { part, column: column.to_owned() })
    }
}

/// The role with that name.
fn role_of(word: &str) -> Result<Role, MapError> {
    ROLES
        .into_iter()
        .find(|role| role.key() == word)
        .ok_or_else(|| MapError::NoRole { role: word.to_owned(), instead: instead(word, &ROLES_CALLED, &ROLES.map(Role::key)) })
}

impl Part {
    /// The role, of a driver that is called after one as well.
    fn role(&self) -> Option<Role> {
        match self {
            Self::Role(role) => Some(*role),
            Self::Driver(name) => role_of_driver(name),
        }
    }
}

impl Mapped {
    /// The same, a driver that is called after a role as that role.
    pub(super) fn as_role(&self) -> Self {
        let part = self.part.role().map_or_else(|| self.part.clone(), Part::Role);
        Self { part, column: self.column.clone() }
    }

    /// What the column is.
    pub(super) fn part(&self) -> &Part {
        &self.part
    }

    /// The column, and the unit; a colon in the name of a column that is there is a part of it.
    pub(super) fn column_and_unit(&self, header: &[Heading]) -> (&str, Option<&str>) {
        let is_there = header.iter().any(|heading| heading.name == self.column);
        match self.column.rsplit_once(':').filter(|_| !is_there) {
            Some((column, unit)) => (column.trim_end(), Some(unit.trim()).filter(|unit| !unit.is_empty())),
            None => (&self.column, None),
        }
    }
}

/// Refuses a role or a driver that is told twice; `file` is for the message.
pub(super) fn each_once(map: &[Mapped], file: &Path) -> Result<(), RecordingError> {
    let Some((before, mapped)) = given_again(map, |one, other| one.as_role().part == other.as_role().part) else { return Ok(()) };
    let part = match &mapped.part {
        Part::Role(role) => role.key().to_owned(),
        Part::Driver(name) => format!("{DRIVER}{name}"),
    };
    let (first, second) = (before.column.clone(), mapped.column.clone());
    Err(RecordingError::MappedTwice { file: file.to_owned(), part, first, second })
}

impl Manifest {
    /// The same with the columns of `map` in place of those that the TOML names.
    pub fn mapped(mut self, map: &[Mapped], header: &[Heading]) -> Self {
        for mapped in map {
            let (column, unit) = mapped.column_and_unit(header);
            match &mapped.part {
                Part::Role(role) => self.map_role(*role, column, unit),
                Part::Driver(name) => {
                    self.forget(name, mapped.part.role());
                    let (name, column, unit) = (name.clone(), column.to_owned(), unit.map(str::to_owned));
                    self.drivers.push(NamedDriver { name, column, unit, line: NO_LINE });
                }
            }
        }
        // as those of a TOML, by their names
        self.drivers.sort_by(|one, other| one.name.cmp(&other.name));
        self
    }

    /// Leaves out what the TOML says of a driver, and of the role that it is called after: its unit there is that of another column.
    fn forget(&mut self, driver: &str, role: Option<Role>) {
        self.drivers.retain(|named| named.name != driver);
        self.columns.retain(|named, _| Some(*named) != role);
        self.units.retain(|named, _| Some(*named) != role);
    }

    fn map_role(&mut self, role: Role, column: &str, unit: Option<&str>) {
        let named = |text: &str| Named { text: text.to_owned(), line: NO_LINE };
        self.forget(role.key(), Some(role));
        self.columns.insert(role, named(column));
        self.units.extend(unit.map(|unit| (role, named(unit))));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_role_a_column_and_a_unit_are_told_apart() {
        let header: Vec<Heading> = ["C_measured", "cell: left", "a=b"].map(Heading::of).to_vec();
        let read = |text: &str| {
            let mapped: Mapped = text.parse().unwrap();
            let (column, unit) = mapped.column_and_unit(&header);
            (mapped.part.clone(), column.to_owned(), unit.map(str::to_owned))
        };
        assert_eq!(read("response=C_measured:pF"), (Part::Role(Role::Response), "C_measured".into(), Some("pF".into())));
        assert_eq!(read("force = cell: left"), (Part::Role(Role::Force), "cell: left".into(), None));
        assert_eq!(read("force=cell: left:mN"), (Part::Role(Role::Force), "cell: left".into(), Some("mN".into())));
        assert_eq!(
            read("driver.position = cell: left:mm"),
            (Part::Driver("position".into()), "cell: left".into(), Some("mm".into()))
        );
        assert_eq!(read("force=a=b"), (Part::Role(Role::Force), "a=b".into(), None));
    }

    #[test]
    fn what_names_no_column_is_told() {
        let told = |text: &str| text.parse::<Mapped>().unwrap_err().to_string();
        assert!(told("response").contains("ROLE=COLUMN:UNIT") && told("response=").contains("ROLE=COLUMN:UNIT"));
        assert!(told("forse=Load").contains("`forse` is no role") && told("forse=Load").contains("did you mean `force`"));
        assert!(told("load=Load").contains("did you mean `force`") && told("fan=U").contains("driver.fan=COLUMN:UNIT"));
        assert!(told("driver.=U").contains("driver.position=position_mm:mm"));
    }
}
