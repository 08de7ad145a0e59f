//! Several recordings as one problem: one model whose rows are blocks, each with its own sensor, inputs, clock and runs.
//!
//! Fit, search, lack-of-fit tests and report see a [`Simulator`] like any other. History and clock never cross from one recording to another, because each
//! block is simulated by itself; what is common are shared parameters and added physics.
//!
//! Limits: one response unit; a run belongs to one recording; runs that no recording holds are played on the first recording's sensor.

use crate::data::joint::{
    columns,
    free::{Free, Freed},
    member::Member,
    share::{self, Sharing},
};
use std::{ops::Range, sync::Arc};
use truegap_core::{Corrections, Inputs, Joined, Parameter, Role, SimulationError, Simulator, Stage, simulator::StageName};

/// Recordings that cannot be joined.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum JointError {
    /// None given.
    #[error("no recording is given; name at least one")]
    None,
    /// Readings in different units.
    #[error("{second} is read in {second_unit} where {first} is read in {first_unit}; give both the same unit under [units]")]
    Units {
        /// a recording
        first: String,
        /// its unit
        first_unit: String,
        /// another
        second: String,
        /// its unit
        second_unit: String,
    },
}

/// The joint model, and the recordings as one.
pub struct Together<'a> {
    /// the model
    pub model: Joint<'a>,
    /// inputs of all rows, runs numbered on from 1, each recording on its own clock
    pub inputs: Inputs,
    /// readings of all rows
    pub response: Vec<f64>,
    /// which parameters are common
    pub sharing: Sharing,
}

/// One model of several recordings.
pub struct Joint<'a> {
    parts: Vec<Part<'a>>,
    parameters: Vec<Parameter>,
    needs: Vec<Role>,
    /// number of the last run
    last_run: u32,
}

/// A recording inside a [`Joint`].
struct Part<'a> {
    model: Freed<'a>,
    /// number of its first run
    first_run: u32,
    /// runs of the recordings before it
    runs_before: usize,
    /// columns that it has
    has: Vec<Role>,
    /// index of each of its parameters in the joint model
    places: Vec<usize>,
}

impl<'a> Together<'a> {
    /// Joins recordings; parameters whose names are in `materials` are shared where their priors are the same, `free` gives each recording
    /// after the first a gain or an offset of its own.
    ///
    /// # Errors
    /// [`JointError`] where there is nothing to join, or readings differ in unit.
    pub fn new(members: &[Member<'a>], materials: &[&str], free: Free) -> Result<Self, JointError> {
        let first = members.first().ok_or(JointError::None)?;
        if let Some(other) = members.iter().find(|m| m.simulator.unit() != first.simulator.unit()) {
            return Err(JointError::Units {
                first: first.name.clone(),
                first_unit: first.simulator.unit().into(),
                second: other.name.clone(),
                second_unit: other.simulator.unit().into(),
            });
        }
        let own: Vec<Vec<Parameter>> = members.iter().enumerate().map(|(k, m)| free.parameters(k, m)).collect();
        let shared = share::share(members, own.as_slice(), materials);
        let (inputs, first_runs) =
            columns::behind_one_another(&members.iter().map(|m| (m.inputs, m.simulator.reference_c())).collect::<Vec<_>>());
        let runs_before = |k: usize| (first_runs[k] - 1) as usize;
        let mut needs: Vec<Role> = members.iter().flat_map(|m| m.simulator.needs().to_vec()).collect();
        needs.sort_unstable();
        needs.dedup();
        let part = |(k, (member, own)): (usize, (&Member<'a>, Vec<Parameter>))| Part {
            model: Freed::new(member.simulator, if k == 0 { Free::default() } else { free }, own),
            first_run: first_runs[k],
            runs_before: runs_before(k),
            has: columns::recorded(member.inputs),
            places: shared.places[k].clone(),
        };
        let last_run = inputs.run.last().copied().unwrap_or(1);
        let parts = members.iter().zip(own).enumerate().map(part).collect();
        let model = Joint { parts, parameters: shared.parameters, needs, last_run };
        let response = members.iter().flat_map(|m| m.response.iter().copied()).collect();
        Ok(Self { model, inputs, response, sharing: shared.sharing })
    }
}

impl Joint<'_> {
    /// Recording of a run.
    fn part_of(&self, run: u32) -> usize {
        if run > self.last_run {
            return 0;
        }
        self.parts.iter().rposition(|part| part.first_run <= run).unwrap_or(0)
    }

    /// Blocks of rows of one recording each, in order.
    fn blocks(&self, inputs: &Inputs) -> Vec<(usize, Range<usize>)> {
        let mut blocks: Vec<(usize, Range<usize>)> = Vec::new();
        for run in inputs.runs() {
            let part = self.part_of(inputs.run[run.start]);
            match blocks.last_mut() {
                Some((last, rows)) if *last == part => rows.end = run.end,
                _ => blocks.push((part, run)),
            }
        }
        blocks
    }

    fn values(&self, part: usize, values: &[f64]) -> Vec<f64> {
        self.parts[part].places.iter().filter_map(|place| values.get(*place).copied()).collect()
    }
}

impl Joined for Joint<'_> {
    fn count(&self) -> usize {
        self.parts.len()
    }

    fn rows(&self, index: usize, inputs: &Inputs) -> Range<usize> {
        self.blocks(inputs).into_iter().find(|(part, _)| *part == index).map_or(0..0, |(_, rows)| rows)
    }

    fn inputs(&self, index: usize, inputs: &Inputs) -> Inputs {
        columns::block(inputs, self.rows(index, inputs), &self.parts[index].has)
    }

    fn model(&self, index: usize) -> &dyn Simulator {
        &self.parts[index].model
    }

    fn places(&self, index: usize) -> &[usize] {
        &self.parts[index].places
    }
}

impl Simulator for Joint<'_> {
    fn name(&self) -> &str {
        self.parts[0].model.name()
    }

    fn unit(&self) -> &str {
        self.parts[0].model.unit()
    }

    fn simulated_unit(&self) -> &str {
        self.parts[0].model.simulated_unit()
    }

    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn needs(&self) -> &[Role] {
        &self.needs
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        let all: Option<Vec<&'static str>> = self.parts.iter().map(|part| part.model.lacks(stage)).collect();
        all.and_then(|reasons| reasons.first().copied())
    }

    fn full_load(&self) -> Option<f64> {
        self.parts.iter().find_map(|part| part.model.full_load())
    }

    fn warps(&self) -> Option<bool> {
        self.parts.iter().find_map(|part| part.model.warps())
    }

    fn has_insulator(&self) -> bool {
        self.parts.iter().any(|part| part.model.has_insulator())
    }

    fn feeds_back(&self) -> bool {
        self.parts.iter().all(|part| part.model.feeds_back())
    }

    fn moves(&self) -> bool {
        self.parts.iter().any(|part| part.model.moves())
    }

    fn knows_its_level(&self) -> bool {
        self.parts.iter().all(|part| part.model.knows_its_level())
    }

    fn reference_c(&self) -> f64 {
        self.parts[0].model.reference_c()
    }

    /// Those of the sensor, where all recordings are of one.
    fn corrections(&self) -> Option<&Arc<Corrections>> {
        let first = self.parts[0].model.corrections()?;
        self.parts.iter().all(|part| part.model.corrections() == Some(first)).then_some(first)
    }

    fn joined(&self) -> Option<&dyn Joined> {
        Some(self)
    }

    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        let mut all = vec![0.0; inputs.len()];
        let mut found = false;
        for (part, rows) in self.blocks(inputs) {
            if let Some(load) = self.parts[part].model.load(&columns::block(inputs, rows.clone(), &self.parts[part].has)) {
                all[rows].copy_from_slice(&load);
                found = true;
            }
        }
        found.then_some(all)
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let mut all = vec![0.0; inputs.len()];
        for (index, rows) in self.blocks(inputs) {
            let part = &self.parts[index];
            let moved: Vec<Option<Box<dyn Stage>>> = stages.iter().map(|stage| stage.after_runs(part.runs_before)).collect();
            let stages: Vec<&dyn Stage> = moved.iter().zip(stages).map(|(m, stage)| m.as_deref().unwrap_or(*stage)).collect();
            let own = columns::block(inputs, rows.clone(), &part.has);
            let value = part.model.respond(&self.values(index, values), &own, &stages);
            all[rows.clone()].copy_from_slice(&value.map_err(|error| moved_down(error, rows.start))?);
        }
        Ok(all)
    }
}

/// The error with its row counted in all recordings.
fn moved_down(error: SimulationError, rows: usize) -> SimulationError {
    match error {
        SimulationError::GapCloses { row, load_si, strain } => SimulationError::GapCloses { row: row + rows, load_si, strain },
        SimulationError::NotFinite { row, parameters } => SimulationError::NotFinite { row: row + rows, parameters },
        other => other,
    }
}
