//! What a small change of each quantity does to the reading, row by row, about a fit; and the courses that a mechanism could follow there.
//!
//! A base model has no memory behind any quantity, so that one simulation with the quantity a little larger in every row gives the derivative of every row.
//!
//! Limits: where the fit holds effects that remember, the lever of a quantity before them is that of a steady change.

use crate::{
    effects::composed::{
        acting::Acting,
        signal::Courses,
        words::{Action, Quantity},
    },
    fit::model::Model,
};
use std::sync::Mutex;
use truegap_core::{Drive, Readout, Simulator, Stage, simulator::StageName};

/// A quantity and an action with the derivative of each row's reading by the size of a column of ones.
pub struct Lever {
    /// what is changed
    pub quantity: Quantity,
    /// how
    pub action: Action,
    /// derivative, response unit per unit of the quantity
    pub of_row: Vec<f64>,
}

/// What the chain carries about a fit.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// load that arrives, full loads
    pub load: Vec<f64>,
    /// temperature above the reference, K
    pub temperature: Vec<f64>,
    /// reading above its zero
    pub reading: Vec<f64>,
}

/// Writes down what reaches the readout.
struct Witness(Mutex<Seen>);

impl Stage for Witness {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        let seen = Seen {
            load: drive.load.to_vec(),
            temperature: drive.temperature_c.iter().map(|t| t - drive.reference_c).collect(),
            reading: value.iter().map(|v| v - readout.zero).collect(),
        };
        if let Ok(mut place) = self.0.lock() {
            *place = seen;
        }
    }
}

/// Every quantity with the actions that make sense for it, where it acts, and the step of its difference quotient.
const CHANGES: [(Quantity, Action, StageName, f64); 9] = [
    (Quantity::Load, Action::Adds, StageName::LoadPath, 1e-4),
    (Quantity::Temperature, Action::Adds, StageName::ThermalPath, 1e-2),
    (Quantity::Modulus, Action::Scales, StageName::Beads, 1e-4),
    (Quantity::Strain, Action::Adds, StageName::Beads, 1e-5),
    (Quantity::Gap, Action::Adds, StageName::Geometry, 1e-5),
    (Quantity::Warp, Action::Adds, StageName::Geometry, 1e-2),
    (Quantity::Permittivity, Action::Scales, StageName::Dielectric, 1e-4),
    (Quantity::Reading, Action::Adds, StageName::Readout, 1.0),
    (Quantity::Reading, Action::Scales, StageName::Readout, 1e-4),
];

/// The levers of `model` at `z`, and what the chain carries there; `None` where the model has no answer there.
pub fn levers(model: &Model<'_>, z: &[f64]) -> Option<(Vec<Lever>, Seen)> {
    let witness = Witness(Mutex::new(Seen::default()));
    let stages = model.stages(z);
    let values = model.values(&z[..model.base_count()]);
    let simulator = model.problem.simulator;
    let respond = |extra: &dyn Stage| {
        let all: Vec<&dyn Stage> = stages.iter().map(AsRef::as_ref).chain(std::iter::once(extra)).collect();
        simulator.respond(&values, model.problem.inputs, &all).ok()
    };
    let at_rest = respond(&witness)?;
    let of = |(quantity, action, step): (Quantity, Action, f64)| {
        let sides = [1.0, -1.0].map(|sign| respond(&steady(quantity, action, sign * step, simulator)));
        let of_row = match sides {
            [Some(up), Some(down)] => difference(&up, &down, 2.0 * step),
            [Some(up), None] => difference(&up, &at_rest, step),
            [None, Some(down)] => difference(&at_rest, &down, step),
            [None, None] => return None,
        };
        of_row.iter().any(|d| *d != 0.0).then_some(Lever { quantity, action, of_row })
    };
    let acts = |stage: StageName| simulator.lacks(stage).is_none();
    let levers = CHANGES.into_iter().filter(|(_, _, stage, _)| acts(*stage)).filter_map(|(q, a, _, step)| of((q, a, step)));
    let levers = levers.collect();
    let seen = witness.0.into_inner().ok()?;
    Some((levers, seen))
}

fn difference(up: &[f64], down: &[f64], step: f64) -> Vec<f64> {
    up.iter().zip(down).map(|(up, down)| (up - down) / step).collect()
}

fn steady(quantity: Quantity, action: Action, size: f64, simulator: &dyn Simulator) -> Acting {
    let column = Box::new(|courses: &Courses<'_>| Some(vec![1.0; courses.inputs.len()]));
    Acting { quantity, action, size, reference_c: simulator.reference_c(), column }
}
