//! Tables that come with the program, a row an effect: its name, and a number of it.
//!
//! Limits: the second column alone; a name that stands twice has its first number.

/// The number of an `effect` in a table; `None` where the table has no row of it.
pub(crate) fn number_of(effect: &str, table: &str) -> Option<f64> {
    let rows = table.lines().skip(1).map(|row| row.split(','));
    let own = |mut row: std::str::Split<'_, char>| (row.next() == Some(effect)).then(|| row.next()?.parse().ok()).flatten();
    rows.filter_map(own).next()
}
