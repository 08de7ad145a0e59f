//! `truegap optimise`: smaller temperature coefficients within the paper's space.
//!
//! Limits: reads, calls, prints.

use super::{Outcome, Run};
use crate::console::Console;
use crate::table::{digits, table};
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;
use truegap::design::optimise::{Candidate, DesignProblem, Exclusion, OBJECTIVES, SearchOptions, Space, Useful};
use truegap::design::{METRICS, MetricOptions};
use truegap::output::OutputFolder;
use truegap::scene::figure::Figure;
use truegap::sensors::{DEFAULT_SENSOR, find_sensor};

/// Designs with smaller temperature coefficients: three two-metric fronts, the three-metric front, the minimisation vector
#[derive(Debug, clap::Args)]
pub struct Optimise {
    /// Starting design: built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
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
    /// Seed
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Folder for fronts.csv and an SVG a front
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
}

#[derive(Serialize)]
struct Answer {
    sensor: String,
    seed: u64,
    feasible: f64,
    exclusions: Vec<Exclusion>,
    axes: Vec<&'static str>,
    vector: Candidate,
    fronts: Vec<Shown>,
}

#[derive(Serialize)]
struct Shown {
    objectives: Vec<&'static str>,
    evaluations: usize,
    designs: Vec<Candidate>,
}

impl Run for Optimise {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let sensor = find_sensor(&self.sensor, None)?;
        let useful = Useful {
            baseline: self.least_baseline,
            span: self.least_span,
            linearity: self.most_linearity,
            covered: self.most_covered,
        };
        let problem = DesignProblem::new(Space::paper(sensor.clone())?, useful, MetricOptions::default())?;
        let search = SearchOptions { seed: self.seed, ..Default::default() };
        let vector = problem.candidate(&problem.along_vector(search)?);
        let mut fronts = Vec::new();
        for pair in [[0, 1], [0, 2], [1, 2]] {
            fronts.push(shown(&problem, pair, search)?);
        }
        fronts.push(shown(&problem, [0, 1, 2], search)?);
        let (exclusions, feasible) = problem.exclusions(search.starts, self.seed);
        let axes = problem.space().axes().iter().map(|a| a.quantity.symbol()).collect();
        let answer = Answer { sensor: sensor.name, seed: self.seed, feasible, exclusions, axes, vector, fronts };
        if let Some(folder) = &self.output {
            let folder = OutputFolder::begin(folder)?;
            folder.write("fronts.csv", answer.csv())?;
            for (front, [a, b]) in answer.fronts.iter().zip([[0, 1], [0, 2], [1, 2]]) {
                folder.write(format!("{}_{}.svg", OBJECTIVES[a], OBJECTIVES[b]), figure(front, [a, b])?)?;
            }
            folder.publish()?;
        }
        if console.json {
            console.print_json(&answer)?
        } else {
            answer.print(console, &problem)?
        }
        Ok(Outcome::Fine)
    }
}

fn shown<const M: usize>(problem: &DesignProblem, objectives: [usize; M], search: SearchOptions) -> anyhow::Result<Shown> {
    let front = problem.front(objectives, search)?;
    Ok(Shown {
        objectives: objectives.iter().map(|&o| OBJECTIVES[o].name()).collect(),
        evaluations: front.evaluations,
        designs: front.points.iter().map(|p| problem.candidate(&p.unit)).collect(),
    })
}

impl Answer {
    fn print(&self, console: &Console, problem: &DesignProblem) -> anyhow::Result<()> {
        console.print(format!(
            "{}: {:.1} % of the space is feasible (seed {})",
            self.sensor,
            100.0 * self.feasible,
            self.seed
        ))?;
        let rows = self
            .exclusions
            .iter()
            .map(|e| vec![e.constraint.says().to_owned(), format!("{:.1}", 100.0 * e.share), format!("{:.1}", 100.0 * e.alone)]);
        console.print(table(&["constraint", "broken by\n%", "by this one alone\n%"], rows))?;
        console.print("\nDesign along the minimisation vector")?;
        let axes = problem.space().axes().iter().zip(&self.vector.values).map(|(axis, value)| {
            let (unit, factor) = axis.quantity.unit();
            vec![axis.quantity.symbol().to_owned(), digits(value * factor, 4), unit.to_owned()]
        });
        console.print(table(&["quantity", "value", "unit"], axes))?;
        if let Some(found) = self.vector.metrics {
            let rows = METRICS
                .map(|m| vec![m.name().to_owned(), digits(problem.base().of(m), 4), digits(found.of(m), 4), m.unit().to_owned()]);
            console.print(table(&["metric", "before", "after", "unit"], rows))?;
        }
        for front in &self.fronts {
            let (names, count) = (front.objectives.join(", "), front.designs.len());
            console.print(format!("Front of {names}: {count} designs from {} evaluations", front.evaluations))?;
        }
        Ok(())
    }

    fn csv(&self) -> String {
        let mut text =
            format!("front,{},{}\n", self.axes.join("_si,") + "_si", OBJECTIVES.map(|o| format!("{o}_ratio")).join(","));
        for front in &self.fronts {
            for design in &front.designs {
                let numbers: Vec<String> = design.values.iter().chain(&design.ratios).map(f64::to_string).collect();
                let _ = writeln!(text, "{},{}", front.objectives.join("+"), numbers.join(",")); // a String takes everything
            }
        }
        text
    }
}

fn figure(front: &Shown, [a, b]: [usize; 2]) -> anyhow::Result<String> {
    let column = |o: usize| -> Vec<f64> { front.designs.iter().map(|d| d.ratios[o]).collect() };
    let (x, y) = (OBJECTIVES[a], OBJECTIVES[b]);
    let figure = Figure::new(&format!("{x} against {y}"))
        .x(&format!("size of {x} over the starting design's"), "")
        .y(&format!("size of {y} over the starting design's"), "")
        .points("front", &column(a), &column(b))
        .points("starting design", &[1.0], &[1.0]);
    Ok(figure.to_svg()?)
}
