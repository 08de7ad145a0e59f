//! The CSV of the SingleTact demonstration tool: a start time, a blank line, then time and one column a sensor.
//!
//! Rows end in a separator, `null` stands for a missing value, a cell of the header may hold the selected range, and the clock falls back to 0
//! where the user tares. Separator and decimal sign follow the computer's locale. Seen in public logs of the tool.
//!
//! Limits: the tool records what the sensor says and no reference; the base model is `constant` unless a TOML says otherwise.

/// Whether this is the first line of such a file.
pub(super) fn wrote(first_line: &str) -> bool {
    first_line.get(..10).is_some_and(|start| start.eq_ignore_ascii_case("Start Time"))
}

/// Name of the clock's column.
pub(super) fn time(header: &[String]) -> Option<&String> {
    header.iter().find(|name| name.to_ascii_lowercase().starts_with("time"))
}

/// Names of the sensors' columns: neither the clock nor a remark in parentheses nor the empty cell behind the last separator.
pub(super) fn sensors(header: &[String]) -> Vec<String> {
    let clock = time(header);
    header.iter().filter(|name| Some(*name) != clock && !name.is_empty() && !name.starts_with('(')).cloned().collect()
}

/// Whether a cell stands for a missing value.
pub(super) fn is_null(cell: &[u8]) -> bool {
    cell.is_empty() || cell.eq_ignore_ascii_case(b"null")
}
