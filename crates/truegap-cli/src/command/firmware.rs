//! `truegap firmware`: the correction of a diagnosis as a file in C, for the firmware of the sensor.
//!
//! Limits: reads, calls, prints.

use super::file_or_screen::tell;
use super::run::{Outcome, Run};
use crate::console::Console;
use crate::table::{digits, table};
use std::path::PathBuf;
use truegap::diagnosis::compensate::firmware::{Asked, FirmwareFacts, check, firmware};

/// Write the correction of a diagnosis in C, for the firmware of the sensor
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Exit codes: 0 written, 1 written, and less exact than a tenth of the noise, 2 it could not run, or nothing of the model can be corrected in a microcontroller."
)]
pub struct Firmware {
    /// Model file: the augmented.toml of a diagnosis
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// Correct for what the model only carries as well, without a claim to its name
    #[arg(long)]
    carried: bool,
    /// Range of a column of the table, or of the reading; degC for a temperature, % for a humidity, as recorded for others (temperature=-10:60)
    #[arg(long = "range", value_name = "NAME=LOW:HIGH", allow_hyphen_values = true)]
    ranges: Vec<String>,
    /// Most bytes of the table
    #[arg(long, value_name = "N", default_value_t = Asked::default().bytes)]
    bytes: usize,
    /// Most that undoing a lag of the reading may make its noise grow
    #[arg(long, value_name = "FACTOR", default_value_t = Asked::default().noise_growth)]
    noise_growth: f64,
    /// File in C; on standard output where none is given
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Run for Firmware {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        if let Some(file) = &self.output {
            check(file)?;
        }
        let (carried, bytes, noise_growth) = (self.carried, self.bytes, self.noise_growth);
        let mut asked = Asked { carried, bytes, noise_growth, ..Asked::default() };
        self.ranges.iter().try_for_each(|range| asked.add_range(range))?;
        let made = firmware(&self.model, &asked)?;
        let facts = &made.document;
        if let Some(file) = &self.output {
            made.write(file)?;
        }
        tell(console, (facts, self.output.as_deref()), (&facts.says, &facts.notes), print, || made.source.clone())?;
        Ok(if facts.is_exact() { Outcome::Fine } else { Outcome::LookAt })
    }
}

fn print(console: &Console, facts: &FirmwareFacts) -> anyhow::Result<()> {
    console.print(&facts.says)?;
    let reading = facts.readings.map(|[low, high]| ("reading", &facts.unit, [low, high], facts.reading_nodes));
    let arguments =
        facts.arguments.iter().map(|a| (a.name.as_str(), &a.unit, [a.low, a.high], a.nodes.max(a.late_nodes.unwrap_or(1))));
    let rows = reading.into_iter().chain(arguments);
    console.print(table(
        &["argument", "unit", "from", "to", "nodes"],
        rows.map(|(name, unit, [low, high], nodes)| {
            vec![name.to_owned(), unit.clone(), digits(low, 4), digits(high, 4), nodes.to_string()]
        }),
    ))
}
