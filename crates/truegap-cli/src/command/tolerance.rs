//! `truegap tolerance`: scatter and yield of a batch, and which tolerance to tighten first.
//!
//! Limits: reads, calls, prints.

use super::{Outcome, Run};
use crate::console::Console;
use crate::table::{digits, table};
use anyhow::Context;
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Instant;
use truegap::design::tolerance::{BatchOptions, Limit, Scatter, Specification, Tightened, Yield, batch, tighten};
use truegap::design::{METRICS, Metric};
use truegap::output::OutputFolder;
use truegap::sensors::{DEFAULT_SENSOR, find_sensor};

/// Scatter and yield of a batch of sensors within their tolerances, and which tolerance to tighten first
#[derive(Debug, clap::Args)]
pub struct Tolerance {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// Limit on a metric as METRIC=LOW:HIGH, either end may be left out (metrics: baseline, span, linearity, k_baseline, k_baseline_share, k_sensitivity, k_linearity)
    #[arg(long, value_name = "METRIC=LOW:HIGH")]
    limit: Vec<String>,
    /// Number of sensors
    #[arg(long, default_value_t = 1_000_000)]
    samples: usize,
    /// Seed
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Folder for scatter.csv and tighten.csv
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
}

#[derive(Serialize)]
struct Answer {
    sensor: String,
    samples: usize,
    seed: u64,
    specification: Specification,
    scatter: Vec<Scatter>,
    #[serde(rename = "yield")]
    good: Yield,
    tighten: Vec<Tightened>,
}

/// Sensors that decide which tolerance to tighten.
const TIGHTEN_SAMPLES: usize = 65_536;

impl Run for Tolerance {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let sensor = find_sensor(&self.sensor, None)?;
        let specification = Specification::new(self.limit.iter().map(|l| limit(l)).collect::<anyhow::Result<_>>()?)?;
        let options = BatchOptions { samples: self.samples, seed: self.seed, ..Default::default() };
        let begin = Instant::now();
        let made = batch(&sensor, options)?;
        let seconds = begin.elapsed().as_secs_f64();
        let fewer = BatchOptions { samples: self.samples.min(TIGHTEN_SAMPLES), ..options };
        let tighten = tighten(&sensor, &specification, fewer)?;
        let (scatter, good) = (made.scatter(), made.yield_of(&specification));
        let answer =
            Answer { sensor: sensor.name, samples: self.samples, seed: self.seed, specification, scatter, good, tighten };
        if let Some(folder) = &self.output {
            let folder = OutputFolder::begin(folder)?;
            folder.write("scatter.csv", scatter_csv(&answer.scatter))?;
            folder.write("tighten.csv", tighten_csv(&answer.tighten))?;
            folder.publish()?;
        }
        let outcome = if answer.good.share > 0.0 { Outcome::Fine } else { Outcome::LookAt };
        if console.json {
            console.print_json(&answer)?;
        } else {
            answer.print(console)?;
        }
        console.note(format!("{} sensors in {seconds:.2} s, seed {}", self.samples, self.seed));
        if outcome == Outcome::LookAt {
            console.note("no sensor meets the specification; the quantiles show what the design can reach");
        }
        Ok(outcome)
    }
}

impl Answer {
    fn print(&self, console: &Console) -> anyhow::Result<()> {
        console.print(format!("{}: {} sensors within their tolerances, seed {}", self.sensor, self.samples, self.seed))?;
        let scatter = self.scatter.iter().map(|s| {
            let numbers = [s.mean, s.sd, s.sd_pct, s.quantiles[1], s.quantiles[2], s.quantiles[3]].map(|v| digits(v, 4));
            [s.metric.name().to_owned(), s.metric.unit().to_owned()].into_iter().chain(numbers).collect()
        });
        console.print(table(&["metric", "unit", "mean", "sd", "sd\n% of mean", "2.5 %", "50 %", "97.5 %"], scatter))?;
        let good = &self.good;
        let error = good.standard_error.map_or_else(String::new, |e| format!(" +- {} (standard error)", digits(100.0 * e, 2)));
        console.print(format!("\nYield {:.3} %{error}; plates touch in {:.3} %", 100.0 * good.share, 100.0 * good.touching))?;
        for ((l, all), alone) in self.specification.limits.iter().zip(&good.excluded).zip(&good.excluded_alone) {
            let (all, alone) = (100.0 * all, 100.0 * alone);
            console.print(format!(
                "  {} from {} to {} {} excludes {all:.3} %, {alone:.3} % alone",
                l.metric,
                l.low,
                l.high,
                l.metric.unit()
            ))?;
        }
        console.print("\nWith one tolerance halved")?;
        let header: Vec<String> = ["tolerance".to_owned(), "yield gained\npoints".to_owned()]
            .into_iter()
            .chain(METRICS.iter().map(|m| format!("sd of {m}\nfalls by %")))
            .collect();
        let rows = self.tighten.iter().map(|t| {
            let falls = t.scatter_falls_pct.iter().map(|v| format!("{v:.1}"));
            [t.quantity.symbol().to_owned(), format!("{:.3}", 100.0 * t.gain)].into_iter().chain(falls).collect()
        });
        console.print(table(&header, rows))
    }
}

/// `METRIC=LOW:HIGH`.
fn limit(text: &str) -> anyhow::Result<Limit> {
    let remedy = || {
        format!(
            "--limit {text}: write METRIC=LOW:HIGH, for example span=10:20, with one of {}",
            METRICS.map(Metric::name).join(", ")
        )
    };
    let (name, range) = text.split_once('=').with_context(remedy)?;
    let (low, high) = range.split_once(':').with_context(remedy)?;
    let end =
        |text: &str, open: f64| if text.trim().is_empty() { Ok(open) } else { text.trim().parse::<f64>().with_context(remedy) };
    let metric = Metric::named(name.trim()).with_context(remedy)?;
    Ok(Limit::new(metric, end(low, f64::NEG_INFINITY)?, end(high, f64::INFINITY)?)?)
}

fn scatter_csv(scatter: &[Scatter]) -> String {
    let mut text = String::from("metric,unit,mean,sd,q0.00135,q0.025,q0.5,q0.975,q0.99865\n");
    for s in scatter {
        let [a, b, c, d, e] = s.quantiles;
        let _ = writeln!(text, "{},{},{},{},{a},{b},{c},{d},{e}", s.metric, s.metric.unit(), s.mean, s.sd); // a String takes everything
    }
    text
}

fn tighten_csv(rows: &[Tightened]) -> String {
    let mut text = format!("quantity,yield,yield_gained,{}\n", METRICS.map(|m| format!("{m}_sd_falls_pct")).join(","));
    for row in rows {
        let falls = row.scatter_falls_pct.map(|v| v.to_string()).join(",");
        let _ = writeln!(text, "{},{},{},{falls}", row.quantity, row.share, row.gain); // a String takes everything
    }
    text
}
