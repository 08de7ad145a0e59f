//! `truegap confirm`: whether a recording that took no part bears out what a diagnosis has added.
//!
//! Limits: reads, calls, prints.

use super::run::{Outcome, Run};
use super::told::TellArgs;
use crate::console::Console;
use crate::table::{digits, table};
use std::path::PathBuf;
use truegap::OutputFolder;
use truegap::diagnose::confirmation::Judgement;
use truegap::diagnosis::confirm::{Confirmation, FILES, Free, confirm, words};
use truegap::diagnosis::{files_read, recorded};

/// Judge the augmented model of a diagnosis on a recording that took no part in it
#[derive(Debug, clap::Args)]
#[command(after_help = "Exit codes: 0 confirmed, 1 refuted or cannot tell, 2 it could not run.")]
pub struct Confirm {
    /// Model file: the augmented.toml of a diagnosis
    #[arg(value_name = "AUGMENTED")]
    model: PathBuf,
    /// TOML or CSV of the other recording, or a folder with a recording.toml
    #[arg(value_name = "OTHER")]
    recording: PathBuf,
    /// What may be fitted to the other recording: gain and offset of its reading, clock of its load against that of its reading (gain,offset,clock); nothing else is
    #[arg(long, value_delimiter = ',', value_name = "WHAT")]
    free: Vec<String>,
    /// Sensor column of a recording that holds several
    #[arg(long, value_name = "NAME")]
    channel: Option<String>,
    #[command(flatten)]
    tell: TellArgs,
    /// Folder for confirmation.json and confirmation.csv
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
}

impl Run for Confirm {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let free = Free::of(&self.free)?;
        if let Some(folder) = &self.output {
            let read = files_read(&self.recording);
            OutputFolder::check_spares(folder, &FILES, &read)?;
            OutputFolder::check(folder, &FILES)?;
        }
        let recording = recorded(&self.recording, &self.tell.told())?;
        recording.notes.iter().for_each(|note| console.note(note));
        let confirmed = confirm(&self.model, recording, self.channel.as_deref(), free)?;
        let document = &confirmed.document;
        if let Some(folder) = &self.output {
            confirmed.write(folder)?;
        }
        if console.json {
            console.print_json(document)?
        } else {
            print(console, document)?
        }
        Ok(if document.verdict == Judgement::Confirmed { Outcome::Fine } else { Outcome::LookAt })
    }
}

fn print(console: &Console, document: &Confirmation) -> anyhow::Result<()> {
    let unit = &document.unit;
    let is_free = |word: &str| document.free.contains(&word);
    let clock = is_free("clock");
    let columns = ["".to_owned(), format!("error (RMS)\n{unit}"), "gain".to_owned(), format!("offset\n{unit}")];
    let clocks = ["load late at first row\ns".to_owned(), "falls behind\nms/s".to_owned()];
    let header: Vec<String> = columns.into_iter().chain(clocks.into_iter().filter(|_| clock)).collect();
    let cell = |word: &str, value: f64| if is_free(word) { digits(value, 4) } else { "-".to_owned() };
    let models = [("base model alone".to_owned(), &document.base), ("augmented model".to_owned(), &document.augmented)];
    let rivals = document.rivals.iter().flat_map(|rivals| &rivals.judged);
    let rivals = rivals.map(|rival| (rival.row(), &rival.errors));
    let rows = models.into_iter().chain(rivals).map(|(name, model)| {
        let (gain, offset) = (cell("gain", model.reading.gain), cell("offset", model.reading.offset));
        let clock = model.clock.map(|clock| [digits(clock.late_s, 3), digits(1e3 * clock.rate, 3)]);
        [name, digits(model.rmse, 4), gain, offset].into_iter().chain(clock.into_iter().flatten()).collect()
    });
    let nothing = std::iter::repeat_n("-".to_owned(), header.len() - 2);
    let noise: Vec<String> = ["noise".to_owned(), digits(document.noise.rmse, 4)].into_iter().chain(nothing).collect();
    console.print(format!("Verdict: {}. {}\n", words(document.verdict), document.says))?;
    console.print(table(&header, rows.chain([noise])))?;
    if let Some(rivals) = &document.rivals {
        console.print(&rivals.says)?;
        rivals.refused.iter().for_each(|refused| console.note(format!("not judged here: {refused}")));
    }
    console.print(format!("Noise: {}.", document.noise.says))?;
    document.notes.iter().for_each(|note| console.note(note));
    Ok(())
}
