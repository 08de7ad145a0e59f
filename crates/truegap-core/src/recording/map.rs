//! Columns named in one line in place of a TOML: `response=C_measured:pF`.
//!
//! Limits: roles only; a column that is none goes under `[drivers]` of a TOML.

use super::{
    heading::Heading,
    keys::ROLES_CALLED,
    manifest::{Manifest, Named},
    roles::ROLES,
};
use crate::inputs::Role;
use crate::nearest::instead;
use std::str::FromStr;

/// Line of what stands in no file.
pub(super) const NO_LINE: usize = 0;

/// A role, and the column that plays it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mapped {
    role: Role,
    /// the column's name, with a unit behind the last colon where there is one
    column: String,
}

/// Why a text names no column.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum MapError {
    /// No sign between role and column, or nothing on a side of it.
    #[error("`{text}` names no column; write ROLE=COLUMN or ROLE=COLUMN:UNIT, as in response=C_measured:pF")]
    NoColumn { text: String },
    /// Not a role.
    #[error("`{role}` is no role of a column; {instead}; any other column goes under [drivers] of a TOML (docs/recordings.md)")]
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
        let role = ROLES.into_iter().find(|role| role.key() == word).ok_or_else(|| MapError::NoRole {
            role: word.to_owned(),
            instead: instead(word, &ROLES_CALLED, &ROLES.map(Role::key)),
        })?;
        Ok(Self { role, column: column.to_owned() })
    }
}

impl Mapped {
    /// The column, and the unit; a colon in the name of a column that is there is a part of it.
    fn column_and_unit(&self, header: &[Heading]) -> (&str, Option<&str>) {
        let is_there = header.iter().any(|heading| heading.name == self.column);
        match self.column.rsplit_once(':').filter(|_| !is_there) {
            Some((column, unit)) => (column.trim_end(), Some(unit.trim()).filter(|unit| !unit.is_empty())),
            None => (&self.column, None),
        }
    }
}

impl Manifest {
    /// The same with the columns of `map` in place of those that the TOML names.
    pub fn mapped(mut self, map: &[Mapped], header: &[Heading]) -> Self {
        for mapped in map {
            let (column, unit) = mapped.column_and_unit(header);
            let named = |text: &str| Named { text: text.to_owned(), line: NO_LINE };
            self.columns.insert(mapped.role, named(column));
            // the unit that the TOML gives is that of another column
            self.units.remove(&mapped.role);
            self.units.extend(unit.map(|unit| (mapped.role, named(unit))));
        }
        self
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
            (mapped.role, column.to_owned(), unit.map(str::to_owned))
        };
        assert_eq!(read("response=C_measured:pF"), (Role::Response, "C_measured".into(), Some("pF".into())));
        assert_eq!(read("force = cell: left"), (Role::Force, "cell: left".into(), None));
        assert_eq!(read("force=cell: left:mN"), (Role::Force, "cell: left".into(), Some("mN".into())));
        assert_eq!(read("force=a=b"), (Role::Force, "a=b".into(), None));
    }

    #[test]
    fn what_names_no_column_is_told() {
        let told = |text: &str| text.parse::<Mapped>().unwrap_err().to_string();
        assert!(told("response").contains("ROLE=COLUMN:UNIT") && told("response=").contains("ROLE=COLUMN:UNIT"));
        assert!(told("forse=Load").contains("`forse` is no role") && told("forse=Load").contains("did you mean `force`"));
        assert!(told("load=Load").contains("did you mean `force`") && told("fan=U").contains("[drivers]"));
    }
}
