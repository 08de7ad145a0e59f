//! The numbers of the review of the workspace: an earlier version, kept as a file, beside the sources as they are.
//!
//! Limits: what is counted, and how, is said by `truegap-house`.

use crate::{csv, error::TablesError, markdown::Markdown};
use std::path::Path;
use truegap_house::House;

/// The numbers of the version before the regrouping, as `truegap-house --review` wrote them.
const BEFORE: &str = "validation/house/before.csv";

/// One row a number: before, and now.
///
/// # Errors
/// [`TablesError::NoRow`] where the file lacks a number that is counted now; [`TablesError::House`] where the sources cannot be read.
pub(crate) fn table(root: &Path) -> Result<Markdown, TablesError> {
    let path = root.join(BEFORE);
    let before = csv::read(&path)?;
    let mut table = Markdown::new(&["what", "before", "now"]);
    for row in House::open(root)?.review() {
        let earlier = before.rows.iter().find(|cells| cells[0] == row.what);
        let earlier = earlier.ok_or_else(|| TablesError::NoRow { path: path.clone(), row: row.what.clone() })?;
        table.rows.push(vec![row.what, earlier[1].clone(), row.value]);
    }
    Ok(table)
}
