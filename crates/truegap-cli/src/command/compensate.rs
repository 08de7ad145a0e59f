//! `truegap compensate`: readings without the physics that a diagnosis has added.
//!
//! Limits: reads, calls, prints.

use super::file_or_screen::tell;
use super::run::{Outcome, Run};
use super::told::TellArgs;
use crate::console::Console;
use crate::table::{digits, table};
use std::path::PathBuf;
use truegap::core::recording::Note;
use truegap::diagnosis::compensate::{Compensation, Wanted, check, compensate};
use truegap::diagnosis::recorded;

/// Correct the readings of a recording for the physics that a diagnosis has added
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Exit codes: 0 corrected as far as the noise allows, 1 the model leaves more of the readings than their noise, or the corrected readings are farther from the recorded truth, 2 it could not run, or more than half of the rows are far beyond what the model gives."
)]
pub struct Compensate {
    /// Model file: the augmented.toml of a diagnosis
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// TOML or CSV of the recording, or a folder with a recording.toml; the load, or whatever else the base model follows, need not be in it
    #[arg(value_name = "RECORDING")]
    recording: PathBuf,
    /// Correct for what follows the clock as well, as drift and settling do: the recording began as the one of the diagnosis did
    #[arg(long)]
    all: bool,
    /// Correct for what the model only carries as well, without a claim to its name
    #[arg(long)]
    carried: bool,
    /// Sensor column of a recording that holds several
    #[arg(long, value_name = "NAME")]
    channel: Option<String>,
    #[command(flatten)]
    tell: TellArgs,
    /// CSV for the rows; on standard output where none is given
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Run for Compensate {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        if let Some(file) = &self.output {
            check(file)?;
        }
        let recording = recorded(&self.recording, &self.tell.told())?;
        // the base model is that of the model file
        let notes = recording.notes.iter().filter(|note| !matches!(note, Note::BaseAssumed { .. }));
        notes.for_each(|note| console.note(note));
        let wanted = Wanted { of_the_clock: self.all, carried: self.carried };
        let compensated = compensate(&self.model, recording, self.channel.as_deref(), wanted)?;
        let document = &compensated.document;
        if let Some(file) = &self.output {
            compensated.write(file)?;
        }
        tell(console, (document, self.output.as_deref()), (&document.says, &document.notes), print, || compensated.csv())?;
        Ok(if document.explains() { Outcome::Fine } else { Outcome::LookAt })
    }
}

fn print(console: &Console, document: &Compensation) -> anyhow::Result<()> {
    let unit = &document.unit;
    console.print(&document.says)?;
    let error = document.error.as_ref();
    let errors = error.into_iter().flat_map(|error| [("reading", error.before), ("corrected reading", error.after)]);
    let rows = errors.chain([
        ("noise of a reading", document.noise),
        ("noise of a corrected reading", document.noise * document.noise_growth),
    ]);
    console.print(table(
        &["".to_owned(), format!("error (RMS)\n{unit}")],
        rows.map(|(name, value)| vec![name.to_owned(), digits(value, 4)]),
    ))
}
