//! `truegap init`: the TOML of a CSV, as far as its header tells.
//!
//! Limits: never writes over a file.

use super::told::TellArgs;
use super::{Outcome, Run};
use crate::console::Console;
use anyhow::anyhow;
use std::io::ErrorKind;
use std::path::PathBuf;
use truegap::core::recording::{is_standard_input, sketch};
use truegap::sweep::{SweepError, write_once};

/// Write the TOML beside a table: which column is what, in which unit, as far as the header and --map tell
#[derive(Debug, clap::Args)]
pub struct Init {
    /// CSV, Parquet or Arrow file of a recording; of a CSV on standard input (`-`) the TOML is printed
    #[arg(value_name = "CSV")]
    csv: PathBuf,
    #[command(flatten)]
    tell: TellArgs,
}

/// What was written, and what is left to the user: with `--json`.
#[derive(serde::Serialize)]
struct Written<'a> {
    written: &'a std::path::Path,
    /// the column of each role
    found: std::collections::BTreeMap<&'a str, &'a str>,
    left_to_you: &'a [String],
}

impl Run for Init {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let sketch = sketch(&self.csv, &self.tell.told())?;
        if is_standard_input(&self.csv) {
            console.print(sketch.toml.trim_end())?;
            sketch.open.iter().for_each(|open| console.note(format!("left to you: {open}")));
            return Ok(Outcome::Fine);
        }
        let file = self.csv.with_extension("toml");
        let name = file.display();
        // half a file, of a run that was killed or of a full disk, would have the next one refused
        write_once(&file, sketch.toml.as_bytes()).map_err(|error| match error {
            SweepError::Disk { source, .. } if source.kind() == ErrorKind::AlreadyExists => {
                anyhow!("{name}: is there already, and was left as it is; move it, or the CSV into another folder")
            }
            error => error.into(),
        })?;
        if console.json {
            let found = sketch.found.iter().map(|(role, column)| (role.as_str(), column.as_str())).collect();
            console.print_json(&Written { written: &file, found, left_to_you: &sketch.open })?;
            return Ok(Outcome::Fine);
        }
        console.print(format!("Written: {name}"))?;
        let found: Vec<String> = sketch.found.iter().map(|(role, column)| format!("{role} = `{column}`")).collect();
        console
            .print(format!("Found: {}", if found.is_empty() { "no column of a role".to_owned() } else { found.join(", ") }))?;
        sketch.open.iter().try_for_each(|open| console.print(format!("Left to you: {open}")))?;
        Ok(Outcome::Fine)
    }
}
