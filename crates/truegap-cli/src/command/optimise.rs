//! `truegap optimise`: smaller temperature coefficients within the paper's space, or one's own.
//!
//! Limits: reads, calls, prints.

use super::run::{Outcome, Run};
use super::study::{Where, outcome};
use crate::console::Console;
use crate::table::{digits, table};
use anyhow::ensure;
use std::time::Instant;
use truegap::design::METRICS;
use truegap::design::optimise::{OBJECTIVES, SearchOptions, Useful};
use truegap::predict::DEFAULT_SENSOR;
use truegap::study::SensorText;
use truegap::study::answer::optimise::OptimiseAnswer;
use truegap::study::optimise::OptimiseRequest;
use truegap::study::vary::axes;

/// Designs with smaller temperature coefficients: three two-metric fronts, the three-metric front, the minimisation vector
#[derive(Debug, clap::Args)]
pub struct Optimise {
    /// Starting design: built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// What a quantity may be, in place of the paper's range: "height=150 um:210 um", "conductor=10 um,17 um", "bead_count=50:97"
    #[arg(long, value_name = "QUANTITY=RANGE")]
    vary: Vec<String>,
    /// Keep a quantity as the starting design has it
    #[arg(long, value_name = "QUANTITY")]
    hold: Vec<String>,
    /// Least baseline, share of the starting design's
    #[arg(long, default_value_t = Useful::default().baseline)]
    least_baseline: f64,
    /// Least span, share of the starting design's
    #[arg(long, default_value_t = Useful::default().span)]
    least_span: f64,
    /// Greatest linearity error, multiple of the starting design's
    #[arg(long, default_value_t = Useful::default().linearity)]
    most_linearity: f64,
    /// Greatest share of the electrode that the unloaded beads may cover
    #[arg(long, default_value_t = Useful::default().covered)]
    most_covered: f64,
    /// Searches for each front, each with its own seed; their union is told
    #[arg(long, default_value_t = 4)]
    searches: u64,
    /// Seed of the first search
    #[arg(long, default_value_t = 1)]
    seed: u64,
    #[command(flatten)]
    place: Where,
}

impl Run for Optimise {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        ensure!(self.searches > 0, "--searches 0: there is nothing to search with; give 1 or more");
        let sensor = SensorText::find(&self.sensor)?;
        let request = OptimiseRequest {
            axes: axes(&sensor, &self.hold, &self.vary)?,
            sensor,
            useful: Useful {
                baseline: self.least_baseline,
                span: self.least_span,
                linearity: self.most_linearity,
                covered: self.most_covered,
            },
            search: SearchOptions { seed: self.seed, ..Default::default() },
            searches: self.searches,
        };
        let begin = Instant::now();
        let Some(answer) = self.place.run(console, |work| request.run(work))? else { return Ok(Outcome::Fine) };
        let outcome = tell(console, &answer)?;
        let evaluations: usize = answer.fronts.iter().map(|f| f.evaluations).sum();
        console.note(format!("{evaluations} evaluations, seed {}, {:.2} s", self.seed, begin.elapsed().as_secs_f64()));
        Ok(outcome)
    }
}

/// Prints an answer.
pub(super) fn tell(console: &Console, answer: &OptimiseAnswer) -> anyhow::Result<Outcome> {
    if console.json {
        console.print_json(answer)?;
        return Ok(outcome(answer.complete));
    }
    let (feasible, seed) = (100.0 * answer.feasible, answer.search.seed);
    console.print(format!("{}: {feasible:.1} % of the space is feasible (seed {seed})", answer.sensor))?;
    let rows = answer
        .exclusions
        .iter()
        .map(|e| vec![e.constraint.says().to_owned(), format!("{:.1}", 100.0 * e.share), format!("{:.1}", 100.0 * e.alone)]);
    console.print(table(&["constraint", "broken by\n%", "by this one alone\n%"], rows))?;
    print_vector(console, answer)?;
    let rows = answer.fronts.iter().map(|f| {
        let numbers =
            [f.searches.to_string(), f.evaluations.to_string(), f.designs.len().to_string(), format!("{:.4}", f.hypervolume)];
        std::iter::once(f.objectives.join(", ")).chain(numbers).collect()
    });
    console.print(table(&["\nfront of", "searches", "evaluations", "designs told", "hypervolume"], rows))?;
    Ok(outcome(answer.complete))
}

fn print_vector(console: &Console, answer: &OptimiseAnswer) -> anyhow::Result<()> {
    let Some(vector) = &answer.vector else { return Ok(()) };
    let gains = OBJECTIVES.iter().zip(vector.ratios).map(|(o, r)| format!("{o} by {:.2} %", 100.0 * (1.0 - r)));
    console.print(format!("\nAlong the minimisation vector, in size: {}", gains.collect::<Vec<_>>().join(", ")))?;
    let axes = answer.axes.iter().zip(&vector.values).map(|(axis, value)| {
        let (unit, factor) = axis.quantity.unit();
        vec![axis.quantity.symbol().to_owned(), digits(value * factor, 4), unit.to_owned()]
    });
    console.print(table(&["quantity", "value", "unit"], axes))?;
    let Some(found) = vector.metrics else { return Ok(()) };
    let rows =
        METRICS.map(|m| vec![m.name().to_owned(), digits(answer.base.of(m), 4), digits(found.of(m), 4), m.unit().to_owned()]);
    console.print(format!("\n{}", table(&["metric", "before", "after", "unit"], rows)))
}
