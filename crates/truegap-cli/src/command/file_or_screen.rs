//! What is told of an answer whose text goes to a file, or to standard output where none is given.
//!
//! Limits: prints; the file is written already.

use crate::console::Console;
use serde::Serialize;
use std::path::Path;

/// Tells the `document`: as JSON, as its `table` where the text is in a file, or as the `text` with what it `says` beside it; then its notes.
pub(super) fn tell<D: Serialize>(
    console: &Console,
    (document, file): (&D, Option<&Path>),
    (says, notes): (&str, &[String]),
    table: impl FnOnce(&Console, &D) -> anyhow::Result<()>,
    text: impl FnOnce() -> String,
) -> anyhow::Result<()> {
    match (file, console.json) {
        (_, true) => console.print_json(document)?,
        (Some(_), false) => table(console, document)?,
        (None, false) => console.print(text().trim_end())?,
    }
    if file.is_none() {
        console.note(says);
    }
    notes.iter().for_each(|note| console.note(note));
    Ok(())
}
