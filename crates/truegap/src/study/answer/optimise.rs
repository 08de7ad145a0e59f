//! Designs with smaller temperature coefficients, as a study answers them.
//!
//! Limits: plain data.

use serde::Serialize;
use std::fmt::Write;
use truegap_design::Metrics;
use truegap_design::optimise::{Axis, Candidate, Exclusion, OBJECTIVES, SearchOptions, Useful};

/// Objectives of each front, as places in [`OBJECTIVES`].
pub const FRONTS: [&[usize]; 4] = [&[0, 1], &[0, 2], &[1, 2], &[0, 1, 2]];

/// What is answered.
#[derive(Clone, Debug, Serialize)]
pub struct OptimiseAnswer {
    pub(in crate::study) schema: &'static str,
    /// starting design
    pub sensor: String,
    /// metrics of the starting design
    pub base: Metrics,
    /// how each search went about it
    pub search: SearchOptions,
    /// whether all searches are in it
    pub complete: bool,
    /// what may be chosen
    pub axes: Vec<Axis>,
    /// how useful the sensor must stay
    pub useful: Useful,
    /// share of the space that meets all constraints
    pub feasible: f64,
    /// what each constraint excludes
    pub exclusions: Vec<Exclusion>,
    /// the design along the minimisation vector; `None` where the front of three was not searched
    pub vector: Option<Candidate>,
    /// fronts in the order of [`FRONTS`]
    pub fronts: Vec<FrontAnswer>,
}

/// One front.
#[derive(Clone, Debug, Serialize)]
pub struct FrontAnswer {
    /// names of the objectives
    pub objectives: Vec<&'static str>,
    /// their places in [`OBJECTIVES`]
    #[serde(skip)]
    pub places: &'static [usize],
    /// searches
    pub searches: usize,
    /// evaluations of all searches
    pub evaluations: usize,
    /// area or volume between the front and the starting design, whose ratios are 1: 0 where nothing is gained, 1 where all coefficients can vanish together
    pub hypervolume: f64,
    /// some of its designs, sorted by the first objective
    pub designs: Vec<Candidate>,
}

impl OptimiseAnswer {
    pub(in crate::study) fn csv(&self) -> String {
        let axes: Vec<String> = self.axes.iter().map(|a| format!("{}_si", a.quantity)).collect();
        let ratios = OBJECTIVES.map(|o| format!("{o}_ratio")).join(",");
        let mut text = format!("front,{},{ratios}\n", axes.join(","));
        for front in &self.fronts {
            for design in &front.designs {
                let numbers: Vec<String> = design.values.iter().chain(&design.ratios).map(f64::to_string).collect();
                let _ = writeln!(text, "{},{}", front.objectives.join("+"), numbers.join(",")); // a String takes everything
            }
        }
        text
    }
}
