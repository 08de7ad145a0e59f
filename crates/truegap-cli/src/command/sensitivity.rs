//! `truegap sensitivity`: which quantity moves which number of the data sheet.
//!
//! Limits: reads, calls, prints.

use super::run::{Outcome, Run};
use super::stop::{is_stopped, stop_on_interrupt};
use super::study;
use crate::console::Console;
use crate::table::{digits, table};
use std::path::PathBuf;
use truegap::design::METRICS;
use truegap::design::sensitivity::QuantityIndices;
use truegap::predict::DEFAULT_SENSOR;
use truegap::study::answer::sensitivity::SensorSensitivity;
use truegap::study::sensitivity::SensitivityRequest;
use truegap::study::{SensorText, check_place};

/// Which quantity moves which number: one at a time, derivatives, Sobol indices over the tolerances
#[derive(Debug, clap::Args)]
pub struct Sensitivity {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// A second sensor to set beside it, such as an optimised one
    #[arg(long, value_name = "SENSOR")]
    compare: Option<String>,
    /// By how many per cent each quantity goes down and up
    #[arg(long, default_value_t = 10.0, value_name = "PERCENT")]
    change: f64,
    /// Rows of the Sobol study; each is evaluated once for every tolerance and twice more
    #[arg(long, default_value_t = 4096)]
    rows: usize,
    /// Seed of the Sobol study
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Folder for numbers, figures and report.html
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
}

impl Run for Sensitivity {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        anyhow::ensure!(
            self.change > 0.0 && self.change < 100.0,
            "--change {}: give a number of per cent above 0 and below 100",
            self.change
        );
        self.output.as_deref().map_or(Ok(()), check_place)?;
        let sensors = [Some(&self.sensor), self.compare.as_ref()].into_iter().flatten();
        let sensors = sensors.map(|name| SensorText::find(name)).collect::<Result<_, _>>()?;
        let request = SensitivityRequest { sensors, change_pct: self.change, rows: self.rows, seed: self.seed };
        stop_on_interrupt(console)?;
        let bar = study::bar(console);
        let answer = request.run(|done, of| {
            bar.set_length(of as u64);
            bar.set_position(done as u64);
            !is_stopped()
        });
        bar.finish_and_clear();
        let answer = answer?;
        if let Some(folder) = &self.output {
            answer.write(folder)?;
        }
        if console.json {
            console.print_json(&answer)?;
        } else {
            answer.sensors.iter().try_for_each(|of| self.print(console, of))?;
        }
        let stopped = is_stopped();
        if stopped {
            console.note("stopped; the Sobol indices rest on the rows that were done");
        }
        Ok(study::outcome(!stopped))
    }
}

impl Sensitivity {
    fn print(&self, console: &Console, of: &SensorSensitivity) -> anyhow::Result<()> {
        let header: Vec<String> =
            ["quantity".to_owned()].into_iter().chain(METRICS.iter().map(|m| format!("{m}\n{}", m.unit()))).collect();
        let change = self.change;
        console.print(format!("{}: change when a quantity goes up by {change} %, all others as they are", of.sensor))?;
        console.print(table(&header, of.one_at_a_time.iter().map(|r| line(r.quantity.symbol(), &r.up))))?;
        console.print(format!("\nChange when it goes down by {change} %"))?;
        console.print(table(&header, of.one_at_a_time.iter().map(|r| line(r.quantity.symbol(), &r.down))))?;
        console.print("\nDerivative, per 1 % of the quantity")?;
        console.print(table(&header, of.local.iter().map(|r| line(r.quantity.symbol(), &r.per_percent))))?;
        let Some(sobol) = &of.sobol else {
            return console.print("\nNo tolerance in the sensor's file, so no Sobol indices");
        };
        let told = format!("with 95 % interval (seed {}, {} rows)", sobol.seed, sobol.rows);
        console.print(format!("\nTotal Sobol index over the tolerances, {told}"))?;
        let indices = |r: &QuantityIndices| {
            let cells = r.total.iter().map(|i| format!("{:.3} ({:.3}-{:.3})", i.value, i.low, i.high));
            std::iter::once(r.quantity.symbol().to_owned()).chain(cells).collect()
        };
        console.print(table(&header, sobol.quantities.iter().map(indices)))?;
        console.print("")
    }
}

fn line(name: &str, values: &[f64]) -> Vec<String> {
    std::iter::once(name.to_owned()).chain(values.iter().map(|&v| digits(v, 3))).collect()
}
