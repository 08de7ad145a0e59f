//! Which column is which driver.
//!
//! Limits: numbers of a driver are not converted; its unit is the one that is given, or the end of the column's name.

use super::{
    columns::{Column, almost_called, names, twice},
    default_names::role_of_driver,
    error::RecordingError,
    heading::Heading,
    manifest::{Manifest, NamedDriver},
    map::NO_LINE,
    roles::ROLES,
};
use crate::given_again;
use crate::inputs::Role;
use std::path::Path;

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

/// Refuses a driver, by its line or as what was told beside the files.
pub(super) fn refused(file: &Path, toml: Option<&Path>, wanted: &NamedDriver, why: String) -> RecordingError {
    let driver = wanted.name.clone();
    match wanted.line {
        NO_LINE => RecordingError::MappedDriver { file: file.to_owned(), driver, why },
        line => RecordingError::Driver { file: toml.unwrap_or(file).to_owned(), line, driver, why },
    }
}

/// Says that a column of a driver is not in the header, what is, and which of it is called almost so.
pub(super) fn not_in(header: &[Heading], column: &str) -> String {
    let (found, near) = (names(header), almost_called(column, header));
    format!("`{column}` is not in the header; {near}found: {found}")
}

/// The columns that `[drivers]` names; `roles` are those that play a role already.
pub(super) fn bind_drivers(
    file: &Path,
    toml: Option<&Path>,
    header: &[Heading],
    manifest: &Manifest,
    roles: &[Column],
) -> Result<Vec<DriverColumn>, RecordingError> {
    let refused = |wanted: &NamedDriver, why: String| refused(file, toml, wanted, why);
    let bound = |wanted: &NamedDriver| {
        let is_role = |role: &Role| role.key() == wanted.name && role_of_driver(&wanted.name).is_none();
        if let Some(role) = ROLES.into_iter().find(is_role) {
            return Err(refused(
                wanted,
                format!("`{0}` is a role; name its column under [columns], {0} = \"...\", or by --map {0}=COLUMN", role.key()),
            ));
        }
        if wanted.name.trim().is_empty() {
            return Err(refused(wanted, "it has no name; write position = { column = \"...\", unit = \"...\" }".into()));
        }
        let called: Vec<usize> = (0..header.len()).filter(|index| header[*index].name == wanted.column).collect();
        let Some(&index) = called.first() else {
            return Err(refused(wanted, not_in(header, &wanted.column)));
        };
        if called.len() > 1 {
            return Err(twice(file, &wanted.column, &called));
        }
        if let Some(column) = roles.iter().find(|c| c.index == index) {
            let role = column.role.key();
            return Err(refused(wanted, format!("column `{}` is the {role} already; leave it out of [drivers]", column.name)));
        }
        let unit = wanted.unit.clone().or_else(|| header[index].proper_unit().map(str::to_owned));
        let unit = unit.ok_or_else(|| {
            let example = match wanted.line {
                NO_LINE => format!("driver.{}=\"{}:mm\", or :1 where it has none", wanted.name, wanted.column),
                _ => format!("{} = {{ column = \"{}\", unit = \"mm\" }}, or unit = \"1\"", wanted.name, wanted.column),
            };
            refused(wanted, format!("column `{}` has no unit in its name; write {example}", wanted.column))
        })?;
        Ok(DriverColumn { index, driver: wanted.name.clone(), name: wanted.column.clone(), unit })
    };
    let bound: Vec<DriverColumn> = manifest.drivers.iter().map(bound).collect::<Result<_, _>>()?;
    let each: Vec<_> = manifest.drivers.iter().zip(&bound).collect();
    if let Some(((_, before), (wanted, _))) = given_again(&each, |(_, one), (_, other)| one.index == other.index) {
        let why = format!("column `{}` is the driver `{}` already; leave one of the two out", before.name, before.driver);
        return Err(refused(wanted, why));
    }
    Ok(bound)
}
