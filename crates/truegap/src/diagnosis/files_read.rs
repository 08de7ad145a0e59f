//! The files that a recording is read from, so that none of them is written over.
//!
//! Limits: a TOML and its table; what a base model reads beside them stands under names of its own.

use std::path::{Path, PathBuf};

/// The file at `path`, and the table that a TOML there names.
pub fn files_read(path: &Path) -> Vec<PathBuf> {
    let file = if path.is_dir() { path.join("recording.toml") } else { path.to_owned() };
    let is_toml = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    let text = is_toml.then(|| truegap_limits::read_text(&file).ok()).flatten();
    let toml = text.and_then(|text| text.parse::<toml::Table>().ok());
    let table = toml.as_ref().and_then(|toml| toml.get("file")?.as_str());
    let table = table.map(|table| file.parent().unwrap_or(Path::new("")).join(table));
    [file].into_iter().chain(table).collect()
}
