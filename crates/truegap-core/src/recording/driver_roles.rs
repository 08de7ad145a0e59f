//! Drivers that are called after a role: columns of that role, where their unit is one of it.
//!
//! Limits: roles that measure something; a reading, a simulation, a run and a sensor are no drivers.

use super::{
    default_names::{dimension, role_of_driver},
    driver_columns::{not_in, refused},
    error::RecordingError,
    heading::Heading,
    manifest::{Manifest, Named, NamedDriver},
    map::NO_LINE,
};
use crate::inputs::Role;
use crate::units::Dimension;
use std::path::Path;

impl Manifest {
    /// The same with each driver that is called after a role as the column of that role.
    ///
    /// # Errors
    /// [`RecordingError`] where its column is not in the header, its unit is none of the role, or the role has a column already.
    pub(super) fn with_roles_of_drivers(
        mut self,
        file: &Path,
        toml: Option<&Path>,
        header: &[Heading],
    ) -> Result<Self, RecordingError> {
        for wanted in std::mem::take(&mut self.drivers) {
            let heading = header.iter().find(|heading| heading.name == wanted.column);
            let role = role_of_driver(&wanted.name).and_then(|role| Some((role, dimension(role)?)));
            let Some((role, dimension)) = role else {
                self.drivers.push(wanted);
                continue;
            };
            let heading = heading.ok_or_else(|| not_in(header, &wanted.column));
            heading
                .and_then(|heading| self.place(&wanted, role, dimension, heading))
                .map_err(|why| refused(file, toml, &wanted, why))?;
        }
        Ok(self)
    }

    /// Makes a driver the column of its role, or says why it cannot be.
    fn place(&mut self, wanted: &NamedDriver, role: Role, dimension: Dimension, heading: &Heading) -> Result<(), String> {
        let key = role.key();
        if let Some(column) = self.columns.get(&role) {
            return Err(format!(
                "`{key}` is a role, and {} names a column for it as well, `{}`; leave one of the two out",
                place("[columns]", column.line),
                column.text
            ));
        }
        if let (Some(unit), Some(_)) = (self.units.get(&role), &wanted.unit) {
            let under = place("[units]", unit.line);
            return Err(format!("{under} gives a unit of {key} as well, `{}`; leave one of the two out", unit.text));
        }
        let named = |text: &str| Named { text: text.to_owned(), line: wanted.line };
        let given = wanted.unit.as_deref().or(self.units.get(&role).map(|unit| unit.text.as_str()));
        let fits = given.map_or_else(
            || heading.unit_of(dimension).is_some() || (role == Role::Time && heading.dated),
            |unit| dimension.scale(unit).is_ok(),
        );
        if !fits {
            return Err(unfit(wanted, key, dimension, given.or(heading.proper_unit())));
        }
        self.units.extend(wanted.unit.as_deref().map(|unit| (role, named(unit))));
        self.columns.insert(role, named(&wanted.column));
        Ok(())
    }
}

/// Where a role is named: in which table, on which line of the TOML.
fn place(table: &str, line: usize) -> String {
    if line == NO_LINE { "--map".to_owned() } else { format!("{table} (line {line})") }
}

/// Why a driver is no column of the role that it is called after, and what to do.
fn unfit(wanted: &NamedDriver, key: &str, dimension: Dimension, unit: Option<&str>) -> String {
    let (NamedDriver { column, line, .. }, known) = (wanted, dimension.unit_names().join(", "));
    let si = dimension.si_unit();
    let as_driver = |name: &str, unit: &str| match *line {
        NO_LINE => format!("driver.{name}=\"{column}:{unit}\""),
        _ => format!("{name} = {{ column = \"{column}\", unit = \"{unit}\" }}"),
    };
    match unit {
        None => format!("column `{column}` has no unit in its name; write {}, or one of {known}", as_driver(key, si)),
        Some(unit) => format!(
            "`{key}` is a role, and `{unit}`, the unit of column `{column}`, is no unit of {key} ({known}); correct the unit, or give the driver another name: {}, and \
             driver = \"{key}_signal\" under [base] where it is followed",
            as_driver(&format!("{key}_signal"), unit)
        ),
    }
}
