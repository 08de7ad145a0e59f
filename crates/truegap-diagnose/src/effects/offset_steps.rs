//! The zero jumps from run to run.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter, ZeroCourse},
    text::{rounded, with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// A zero of its own for each run after the first; the size is the typical jump, the rest its multiples.
pub struct OffsetSteps;

/// Most runs with a zero of their own; beyond that the steps could follow anything.
const MOST_RUNS: usize = 24;

#[derive(Clone)]
struct Steps {
    size: f64,
    jumps: Vec<f64>,
    /// runs of other recordings before the first run
    runs_before: usize,
}

impl Steps {
    fn new(values: &[f64]) -> Self {
        Self { size: values[0], jumps: values[1..].to_vec(), runs_before: 0 }
    }

    fn after(&self, runs_before: usize) -> Self {
        Self { runs_before, ..self.clone() }
    }

    /// Jump before the run of this number from 0; runs beyond those fitted keep the last zero.
    fn jump(&self, run: usize) -> f64 {
        if run == 0 { 0.0 } else { self.size * self.jumps.get(run - 1).copied().unwrap_or(0.0) }
    }

    /// Adds the jumps so far to each row, the last one `arrived(share of the run's rows gone by)`.
    fn apply(&self, drive: &Drive<'_>, value: &mut [f64], arrived: impl Fn(f64) -> f64) {
        let mut before: f64 = (0..self.runs_before).map(|run| self.jump(run)).sum();
        for (index, run) in drive.inputs.runs().into_iter().enumerate() {
            let jump = self.jump(self.runs_before + index);
            let rows = run.len() as f64;
            for (gone, row) in run.enumerate() {
                value[row] += before + jump * arrived(gone as f64 / rows);
            }
            before += jump;
        }
    }
}

impl Stage for Steps {
    fn after_runs(&self, runs: usize) -> Option<Box<dyn Stage>> {
        Some(Box::new(self.after(runs)))
    }
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        self.apply(drive, value, |_| 1.0);
    }
}

/// Sibling: each jump settles over the first part of its run.
struct Settling(Steps);

impl Stage for Settling {
    fn after_runs(&self, runs: usize) -> Option<Box<dyn Stage>> {
        Some(Box::new(Self(self.0.after(runs))))
    }
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        self.0.apply(drive, value, |share| 1.0 - 0.5 * (-share / 0.05).exp());
    }
}

impl Effect for OffsetSteps {
    fn id(&self) -> EffectId {
        EffectId("offset_steps")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Time, kinetics: Kinetics::Event })
    }
    fn free_form(&self) -> bool {
        true
    }
    fn about(&self) -> About {
        About {
            physics: "the zero jumps where the sensor was plugged in again, or where a contact slipped, and stays there",
            equation: "value = true + z sum of u_k over the runs so far, u_k ~ normal(0, 1) for each run after the first, or for one to three of them and 0 for the others; jumps inside a run are for the locate stage to find",
            excitation: "two runs or more",
            impostors: &["offset_drift", "mullins_softening", "ageing"],
            separates: "constant inside each run and the same at every load",
            source: "Basseville & Nikiforov, Detection of Abrupt Changes, ch. 2",
        }
    }
    fn zero_course(&self) -> ZeroCourse {
        ZeroCourse::BetweenRuns
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let scale = 0.02 * context.response_span.abs();
        let size = Parameter::normal("size", context.simulator.unit(), 0.0, scale, "typical jump of the zero")
            .within(-50.0 * scale, 50.0 * scale);
        let jump = |run: usize| Parameter::normal(&format!("jump_{run}"), "sizes", 0.0, 1.0, "jump of the zero before this run");
        std::iter::once(size).chain((2..=context.runs).map(jump)).collect()
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        // not zeros: where size and jumps are all zero, nothing tells a search which way to go
        let jumps = context.runs.saturating_sub(1);
        let alternating = (0..jumps).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 }).collect();
        let middle = (0..jumps).map(|k| f64::from(k == jumps / 2)).collect();
        vec![vec![1.0; jumps], alternating, middle]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        match context.runs {
            0 | 1 => Err("one run only; a jump inside it shows in the map of the mismatch".into()),
            runs if runs > MOST_RUNS => Err(format!("{runs} runs, each with a zero of its own, could follow anything")),
            _ => Ok(()),
        }
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Steps::new(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Settling(Steps::new(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let (size, unit) = (fitted[0].value, &fitted[0].parameter.unit);
        let certain = |f: &&FittedParameter| f.value.abs() > 3.0 * f.sd;
        let largest = fitted[1..].iter().filter(certain).max_by(|a, b| a.value.abs().total_cmp(&b.value.abs()));
        let at = largest.map_or(String::new(), |f| {
            format!(
                "; the largest, {}, before run {}",
                rounded(size * f.value, unit),
                f.parameter.name.trim_start_matches("jump_")
            )
        });
        format!("the zero jumps between runs, by about {}{at}", with_sd(size.abs(), fitted[0].sd, unit))
    }
}
