//! A gain and an offset of its own for each recording after the first, which is the reference.
//!
//! Limits: both act on the reading before any other added physics of the readout; the gain turns about the reading at rest.

use crate::{data::joint::member::Member, stats::spread};
use std::sync::Arc;
use truegap_core::{
    Corrections, Drive, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, simulator::StageName,
};

/// What each recording may have of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Free {
    /// a gain
    pub gain: bool,
    /// an offset
    pub offset: bool,
}

/// Standard deviation of a recording's own gain: amplifiers and cables set up again.
const GAIN_SD: f64 = 0.05;
/// Standard deviation of a recording's own offset, as a share of the range that it was read over.
const OFFSET_SD: f64 = 0.1;

impl Free {
    /// Parameters of recording `index` (from 0) beside those of its base model; none for the first.
    pub(crate) fn parameters(self, index: usize, member: &Member<'_>) -> Vec<Parameter> {
        let mut list = Vec::new();
        if index == 0 {
            return list;
        }
        let number = index + 1;
        let taken = |name: &str| member.simulator.parameters().iter().any(|p| p.name == name);
        let name = |word: &str| if taken(word) { format!("own_{word}_{number}") } else { format!("{word}_{number}") };
        if self.gain {
            let meaning = format!("gain of recording {number} against recording 1");
            list.push(Parameter::normal(&name("gain"), "1", 1.0, GAIN_SD, &meaning).within(0.05, 20.0));
        }
        if self.offset {
            let meaning = format!("zero of recording {number} against recording 1");
            let sd = OFFSET_SD * spread(member.response).max(f64::MIN_POSITIVE);
            list.push(Parameter::normal(&name("offset"), member.simulator.unit(), 0.0, sd, &meaning));
        }
        list
    }
}

/// A base model with its recording's own gain and offset.
pub(crate) struct Freed<'a> {
    inner: &'a dyn Simulator,
    free: Free,
    parameters: Vec<Parameter>,
}

impl<'a> Freed<'a> {
    pub(crate) fn new(inner: &'a dyn Simulator, free: Free, own: Vec<Parameter>) -> Self {
        Self { inner, free, parameters: inner.parameters().iter().cloned().chain(own).collect() }
    }
}

struct GainAndOffset {
    gain: f64,
    offset: f64,
}

impl Stage for GainAndOffset {
    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        value.iter_mut().for_each(|v| *v = readout.zero + self.gain * (*v - readout.zero) + self.offset);
    }
}

impl Simulator for Freed<'_> {
    fn name(&self) -> &str {
        self.inner.name()
    }

    fn unit(&self) -> &str {
        self.inner.unit()
    }

    fn simulated_unit(&self) -> &str {
        self.inner.simulated_unit()
    }

    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn needs(&self) -> &[Role] {
        self.inner.needs()
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        self.inner.lacks(stage)
    }

    fn full_load(&self) -> Option<f64> {
        self.inner.full_load()
    }

    fn warps(&self) -> Option<bool> {
        self.inner.warps()
    }

    fn has_insulator(&self) -> bool {
        self.inner.has_insulator()
    }

    fn feeds_back(&self) -> bool {
        self.inner.feeds_back()
    }

    fn moves(&self) -> bool {
        self.inner.moves()
    }

    fn knows_its_level(&self) -> bool {
        self.inner.knows_its_level()
    }

    fn reference_c(&self) -> f64 {
        self.inner.reference_c()
    }

    fn corrections(&self) -> Option<&Arc<Corrections>> {
        self.inner.corrections()
    }

    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        self.inner.load(inputs)
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let (base, own) = values.split_at(self.inner.parameters().len().min(values.len()));
        if own.is_empty() {
            return self.inner.respond(base, inputs, stages);
        }
        let mut own = own.iter().copied();
        let mut next = |is_free: bool, fixed: f64| if is_free { own.next().unwrap_or(fixed) } else { fixed };
        let readout = GainAndOffset { gain: next(self.free.gain, 1.0), offset: next(self.free.offset, 0.0) };
        let mut all: Vec<&dyn Stage> = vec![&readout];
        all.extend(stages);
        self.inner.respond(base, inputs, &all)
    }
}
