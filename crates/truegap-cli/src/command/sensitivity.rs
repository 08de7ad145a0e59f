//! `truegap sensitivity`: which quantity moves which number of the data sheet.
//!
//! Limits: reads, calls, prints.

use super::{Outcome, Run};
use crate::console::Console;
use crate::table::{digits, table};
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;
use truegap::design::sensitivity::{
    LocalSensitivity, OneAtATime, PAPER_QUANTITIES, QuantityIndices, SobolOptions, local, one_at_a_time, tolerance_indices,
};
use truegap::design::{METRICS, Metric, MetricOptions};
use truegap::output::OutputFolder;
use truegap::scene::figure::Bars;
use truegap::sensors::{DEFAULT_SENSOR, find_sensor};

/// Which quantity moves which number: one at a time, derivatives, Sobol indices over the tolerances
#[derive(Debug, clap::Args)]
pub struct Sensitivity {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// By how many per cent each quantity goes down and up
    #[arg(long, default_value_t = 10.0, value_name = "PERCENT")]
    change: f64,
    /// Rows of the Sobol study; each is evaluated once for every tolerance and twice more
    #[arg(long, default_value_t = 4096)]
    rows: usize,
    /// Seed of the Sobol study
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Folder for a CSV and one SVG a metric
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
}

#[derive(Serialize)]
struct Answer {
    sensor: String,
    change_pct: f64,
    seed: u64,
    metrics: [Metric; METRICS.len()],
    one_at_a_time: Vec<OneAtATime>,
    local: Vec<LocalSensitivity>,
    sobol: Vec<QuantityIndices>,
}

impl Run for Sensitivity {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        anyhow::ensure!(
            self.change > 0.0 && self.change < 100.0,
            "--change {}: give a number of per cent above 0 and below 100",
            self.change
        );
        let sensor = find_sensor(&self.sensor, None)?;
        let options = MetricOptions::default();
        let answer = Answer {
            sensor: sensor.name.clone(),
            change_pct: self.change,
            seed: self.seed,
            metrics: METRICS,
            one_at_a_time: one_at_a_time(&sensor, &PAPER_QUANTITIES, 0.01 * self.change, options)?,
            local: local(&sensor, &PAPER_QUANTITIES, options)?,
            sobol: tolerance_indices(&sensor, options, SobolOptions { rows: self.rows, seed: self.seed, ..Default::default() })?,
        };
        if let Some(folder) = &self.output {
            let folder = OutputFolder::begin(folder)?;
            folder.write("one_at_a_time.csv", csv(&answer.one_at_a_time))?;
            for metric in METRICS {
                folder.write(format!("{metric}.svg"), bars(&answer, metric)?)?;
            }
            folder.publish()?;
        }
        if console.json {
            console.print_json(&answer)?;
            return Ok(Outcome::Fine);
        }
        let header: Vec<String> =
            ["quantity".to_owned()].into_iter().chain(METRICS.iter().map(|m| format!("{m}\n{}", m.unit()))).collect();
        let change = self.change;
        console.print(format!("{}: change when a quantity goes up by {change} %, all others as they are", sensor.name))?;
        console.print(table(&header, answer.one_at_a_time.iter().map(|r| line(r.quantity.symbol(), &r.up))))?;
        console.print(format!("\nChange when it goes down by {change} %"))?;
        console.print(table(&header, answer.one_at_a_time.iter().map(|r| line(r.quantity.symbol(), &r.down))))?;
        console.print("\nDerivative, per 1 % of the quantity")?;
        console.print(table(&header, answer.local.iter().map(|r| line(r.quantity.symbol(), &r.per_percent))))?;
        console.print(format!(
            "\nTotal Sobol index over the tolerances, with 95 % interval (seed {}, {} rows)",
            self.seed, self.rows
        ))?;
        let indices = |r: &QuantityIndices| {
            let cells = r.total.iter().map(|i| format!("{:.3} ({:.3}-{:.3})", i.value, i.low, i.high));
            std::iter::once(r.quantity.symbol().to_owned()).chain(cells).collect()
        };
        console.print(table(&header, answer.sobol.iter().map(indices)))?;
        Ok(Outcome::Fine)
    }
}

fn line(name: &str, values: &[f64]) -> Vec<String> {
    std::iter::once(name.to_owned()).chain(values.iter().map(|&v| digits(v, 3))).collect()
}

fn csv(rows: &[OneAtATime]) -> String {
    let mut text = String::from("quantity,metric,unit,down,up\n");
    for row in rows {
        for (i, metric) in METRICS.into_iter().enumerate() {
            let _ = writeln!(text, "{},{metric},{},{},{}", row.quantity, metric.unit(), row.down[i], row.up[i]); // a String takes everything
        }
    }
    text
}

fn bars(answer: &Answer, metric: Metric) -> anyhow::Result<String> {
    let labels: Vec<&str> = answer.one_at_a_time.iter().map(|r| r.quantity.symbol()).collect();
    let column = |pick: fn(&OneAtATime) -> &[f64; METRICS.len()]| -> Vec<f64> {
        answer.one_at_a_time.iter().map(|r| pick(r)[metric as usize]).collect()
    };
    let change = answer.change_pct;
    let bars = Bars::new(&format!("{metric} of {}", answer.sensor), &labels)
        .x(&format!("change of {metric}"), metric.unit())
        .series(&format!("-{change} %"), &column(|r| &r.down))
        .series(&format!("+{change} %"), &column(|r| &r.up));
    Ok(bars.ranked().overlaid().to_svg()?)
}
