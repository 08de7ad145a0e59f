//! Base model and effects that are linear in their numbers.

use crate::{Context, Effect, FittedParameter};
use std::sync::Arc;
use truegap_core::{
    Drive, EffectId, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, StageName, walk_without_plates,
};

/// Names of terms.
const IDS: [&str; 5] = ["term_a", "term_b", "term_c", "term_d", "term_e"];

/// Courses that are far from one another and from constants: `cos(w row + phase)` with a slow growth.
pub(super) fn course(k: usize, rows: usize) -> Vec<f64> {
    let of = |row: usize| (0.23 * (k + 1) as f64 * row as f64 + k as f64).cos() + 0.5 * ((k * row) as f64 / rows as f64);
    (0..rows).map(of).collect()
}

/// A base model: the sum of columns, each times a number that is known to a standard deviation about 0.
pub(super) struct Line {
    pub(super) columns: Vec<(f64, Vec<f64>)>,
    parameters: Vec<Parameter>,
}

impl Line {
    pub(super) fn empty() -> Self {
        Self::with(Vec::new())
    }

    /// Columns with the standard deviation of the number of each.
    pub(super) fn with(columns: Vec<(f64, Vec<f64>)>) -> Self {
        let parameter = |(k, (sd, _)): (usize, &(f64, Vec<f64>))| Parameter::normal(&format!("c{k}"), "V", 0.0, *sd, "a number");
        Self { parameters: columns.iter().enumerate().map(parameter).collect(), columns }
    }
}

impl Simulator for Line {
    fn name(&self) -> &str {
        "line"
    }
    fn unit(&self) -> &str {
        "V"
    }
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }
    fn needs(&self) -> &[Role] {
        &[]
    }
    fn lacks(&self, _: StageName) -> Option<&'static str> {
        None
    }
    fn full_load(&self) -> Option<f64> {
        None
    }
    fn moves(&self) -> bool {
        false
    }
    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let sum = |row: usize| values.iter().zip(&self.columns).map(|(v, (_, c))| v * c[row]).sum();
        let all = || (0..inputs.len()).map(sum).collect();
        walk_without_plates(self, values, inputs, stages, |_| Ok((all(), Readout { zero: 0.0, span: 1.0 })))
    }
}

/// An effect that adds a column times its size.
#[derive(Clone)]
pub(super) struct Term {
    id: EffectId,
    pub(super) column: Arc<Vec<f64>>,
    pub(super) sd: f64,
    /// a Gaussian prior, where others have the mean of several widths
    pub(super) foreseen: bool,
    /// no size below 0
    pub(super) one_sided: bool,
}

impl Term {
    /// A term whose size is known to this standard deviation about 0, with a Gaussian prior.
    pub(super) fn new(k: usize, rows: usize, sd: f64) -> Self {
        Self { id: EffectId(IDS[k]), column: Arc::new(course(k, rows)), sd, foreseen: true, one_sided: false }
    }

    pub(super) fn of_one_deviation(&self) -> Vec<f64> {
        self.column.iter().map(|c| self.sd * c).collect()
    }

    pub(super) fn stage_of(&self, size: f64) -> Box<dyn Stage> {
        Box::new(Added(size, self.column.clone()))
    }
}

struct Added(f64, Arc<Vec<f64>>);

impl Stage for Added {
    fn readout(&self, _: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        value.iter_mut().zip(self.1.iter()).for_each(|(v, c)| *v += self.0 * c);
    }
}

impl Effect for Term {
    crate::tests::of_the_reading!();
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        let size = Parameter::normal("size", "V", 0.0, self.sd, "size of the term");
        vec![if self.one_sided { size.within(0.0, f64::INFINITY) } else { size }]
    }
    fn foreseen(&self) -> bool {
        self.foreseen
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        self.stage_of(values[0])
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("a term of {:.3} V is there", fitted[0].value)
    }
}
