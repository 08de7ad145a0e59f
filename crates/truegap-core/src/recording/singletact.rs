//! The CSV of the SingleTact demonstration tool: a start time, a blank line, then time and one column a sensor.
//!
//! Rows end in a separator, `null` stands for a missing value, a cell of the header may hold the selected range, and the clock falls back to 0
//! where the user tares. Separator and decimal sign follow the computer's locale. Seen in public logs of the tool.
//!
//! Limits: the tool records what the sensor says and no reference; the base model is `constant` unless a TOML says otherwise.

/// Words of the headings of its sensors and of the cell with the selected range, in small letters.
const OF_SENSORS: [&str; 3] = ["pps sensor", "singletact", "(selected full scale"];

/// Whether these are the cells of the first line of such a file and of the next that is not blank. A column that is called `Start Time` alone may be anybody's.
pub(super) fn wrote(first: &[&[u8]], header: &[&[u8]]) -> bool {
    let lower = |cell: &[u8]| String::from_utf8_lossy(cell).to_lowercase();
    let (begins, clock) = (first.first().map(|cell| lower(cell)), header.first().map(|cell| lower(cell)));
    begins.is_some_and(|cell| cell == "start time")
        && clock.is_some_and(|cell| cell.starts_with("time"))
        && header.iter().skip(1).any(|cell| of_sensor(&lower(cell)))
}

/// Whether a heading is one of a sensor: it has one of the words, or begins with a port, as `COM5` is.
fn of_sensor(heading: &str) -> bool {
    let port = heading.strip_prefix("com").is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
    port || OF_SENSORS.iter().any(|word| heading.contains(word))
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
