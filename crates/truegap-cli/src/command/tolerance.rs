//! `truegap tolerance`: scatter and yield of a batch, and which tolerance to tighten first.
//!
//! Limits: reads, calls, prints.

use super::run::{Outcome, Run};
use super::study::{Where, outcome};
use crate::console::Console;
use crate::table::{digits, table};
use anyhow::Context;
use std::time::Instant;
use truegap::design::{METRICS, Metric};
use truegap::predict::DEFAULT_SENSOR;
use truegap::study::SensorText;
use truegap::study::answer::tolerance::{BatchAnswer, ToleranceAnswer};
use truegap::study::tolerance::{Between, ToleranceRequest};

/// Scatter and yield of a batch of sensors within their tolerances, and which tolerance to tighten first
#[derive(Debug, clap::Args)]
pub struct Tolerance {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// A second sensor to set beside it, such as an optimised one
    #[arg(long, value_name = "SENSOR")]
    compare: Option<String>,
    /// Limit on a metric as METRIC=LOW:HIGH, either end may be left out (metrics: baseline, span, linearity, k_baseline, k_baseline_share, k_sensitivity, k_linearity)
    #[arg(long, value_name = "METRIC=LOW:HIGH")]
    limit: Vec<String>,
    /// Number of sensors in a batch
    #[arg(long, default_value_t = 1_000_000)]
    samples: usize,
    /// Seed
    #[arg(long, default_value_t = 1)]
    seed: u64,
    #[command(flatten)]
    place: Where,
}

impl Run for Tolerance {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let sensors = [Some(&self.sensor), self.compare.as_ref()].into_iter().flatten();
        let request = ToleranceRequest {
            sensors: sensors.map(|name| SensorText::find(name)).collect::<Result<_, _>>()?,
            limits: self.limit.iter().map(|l| limit(l)).collect::<anyhow::Result<_>>()?,
            samples: self.samples,
            seed: self.seed,
        };
        let begin = Instant::now();
        let Some(answer) = self.place.run(console, |work| request.run(work))? else { return Ok(Outcome::Fine) };
        let outcome = tell(console, &answer)?;
        let drawn: usize = answer.sensors.iter().map(|b| b.samples).sum();
        console.note(format!(
            "{drawn} sensors and {} tightened tolerances in {:.2} s",
            answer.tighten.len(),
            begin.elapsed().as_secs_f64()
        ));
        Ok(outcome)
    }
}

/// Prints an answer.
pub(super) fn tell(console: &Console, answer: &ToleranceAnswer) -> anyhow::Result<Outcome> {
    if console.json {
        console.print_json(answer)?;
    } else {
        answer.sensors.iter().try_for_each(|batch| print_batch(console, answer, batch))?;
        print_tighten(console, answer)?;
    }
    let none: Vec<&str> = answer.sensors.iter().filter(|b| b.good.share == 0.0).map(|b| b.sensor.as_str()).collect();
    if none.is_empty() {
        return Ok(outcome(answer.complete));
    }
    let told = "meets the specification; what each limit excludes is above, and the quantiles show what the design can reach";
    console.note(format!("no sensor of {} {told}", none.join(" and of ")));
    Ok(Outcome::LookAt)
}

fn print_batch(console: &Console, answer: &ToleranceAnswer, batch: &BatchAnswer) -> anyhow::Result<()> {
    console.print(format!("{}: {} sensors within their tolerances, seed {}", batch.sensor, batch.samples, answer.seed))?;
    let scatter = batch.scatter.iter().map(|s| {
        let quantile = |p: f64| s.quantile(p).unwrap_or(f64::NAN);
        let numbers = [s.mean, s.sd, s.sd_pct, quantile(0.025), quantile(0.5), quantile(0.975)].map(|v| digits(v, 4));
        [s.metric.name().to_owned(), s.metric.unit().to_owned()].into_iter().chain(numbers).collect()
    });
    console.print(table(&["metric", "unit", "mean", "sd", "sd\n% of mean", "2.5 %", "50 %", "97.5 %"], scatter))?;
    let good = &batch.good;
    let error = good.standard_error.map_or_else(String::new, |e| format!(" +- {} (standard error)", digits(100.0 * e, 2)));
    console.print(format!("\nYield {:.3} %{error}; plates touch in {:.3} %", 100.0 * good.share, 100.0 * good.touching))?;
    for ((l, all), alone) in answer.specification.limits.iter().zip(&good.excluded).zip(&good.excluded_alone) {
        let (all, alone) = (100.0 * all, 100.0 * alone);
        let range = format!("{} from {} to {} {}", l.metric, l.low, l.high, l.metric.unit());
        console.print(format!("  {range} excludes {all:.3} %, {alone:.3} % alone"))?;
    }
    console.print("")
}

fn print_tighten(console: &Console, answer: &ToleranceAnswer) -> anyhow::Result<()> {
    let name = answer.sensors.first().map_or("", |b| &b.sensor);
    console.print(format!("{name} with one tolerance halved"))?;
    let header: Vec<String> = ["tolerance".to_owned(), "yield gained\npoints".to_owned()]
        .into_iter()
        .chain(METRICS.iter().map(|m| format!("sd of {m}\nfalls by %")))
        .collect();
    let rows = answer.tighten.iter().map(|t| {
        let falls = t.scatter_falls_pct.iter().map(|v| format!("{v:.1}"));
        [t.quantity.symbol().to_owned(), format!("{:.3}", 100.0 * t.gain)].into_iter().chain(falls).collect()
    });
    console.print(table(&header, rows))
}

/// `METRIC=LOW:HIGH`.
fn limit(text: &str) -> anyhow::Result<Between> {
    let remedy = || {
        let known = METRICS.map(Metric::name).join(", ");
        format!("--limit {text}: write METRIC=LOW:HIGH, for example span=10:20, with one of {known}")
    };
    let (name, range) = text.split_once('=').with_context(remedy)?;
    let (low, high) = range.split_once(':').with_context(remedy)?;
    let end = |text: &str| -> anyhow::Result<Option<f64>> {
        let text = text.trim();
        if text.is_empty() {
            return Ok(None);
        }
        let value = text.parse::<f64>().ok().filter(|v| v.is_finite());
        value.map(Some).with_context(remedy)
    };
    let metric = Metric::named(name.trim()).with_context(remedy)?;
    Ok(Between { metric, low: end(low)?, high: end(high)? })
}
