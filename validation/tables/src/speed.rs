//! Times that were measured by hand, with the command of each.
//!
//! Limits: shown as they stand in `validation/speed.csv`.

use crate::{csv, error::TablesError, markdown::Markdown};
use std::path::Path;

/// The file, from the root of the repository; columns key, what, time, command.
const SPEED: &str = "validation/speed.csv";

/// All of them.
pub(crate) fn table(root: &Path) -> Result<Markdown, TablesError> {
    let mut all = csv::read(&root.join(SPEED))?;
    // the key is for programs
    all.header.remove(0);
    all.rows.iter_mut().for_each(|row| drop(row.remove(0)));
    Ok(all)
}

/// What was measured, and the time, of the row with this key.
pub(crate) fn of(root: &Path, key: &str) -> Result<(String, String), TablesError> {
    let path = root.join(SPEED);
    let row = csv::read(&path)?.rows.into_iter().find(|row| row[0] == key);
    match row.as_deref() {
        Some([_, what, time, ..]) => Ok((what.clone(), time.clone())),
        _ => Err(TablesError::NoRow { path, row: key.to_owned() }),
    }
}
