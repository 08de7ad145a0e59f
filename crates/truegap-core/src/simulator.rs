//! What a diagnosis needs of a model: parameters with priors, a response that omitted physics can be plugged into, and what the model can say at all.
//!
//! Limits: one scalar response a row. [`Simulator`] and [`Joined`] stand in one file because each hands out the other.

use crate::{
    chain::Stage,
    corrections::Corrections,
    inputs::{Inputs, Role},
    parameter::Parameter,
    simulation_error::SimulationError,
};
use std::{ops::Range, sync::Arc};

pub use crate::chain::StageName;

/// A model of the response, in SI or in the recording's own unit ([`Simulator::unit`]).
///
/// The equations are walked by [`walk`](crate::walk) or [`walk_without_plates`](crate::walk_without_plates); a base model gives its physics only.
pub trait Simulator: Send + Sync {
    /// Name of the base model as in files and reports: `stack`, `parallel-plate`, ...; what a model can do is asked of the methods below, not of its name.
    fn name(&self) -> &str;
    /// Unit of the response.
    fn unit(&self) -> &str;
    /// Unit of the simulated column, where the model reads one; the response's where it has none of its own.
    fn simulated_unit(&self) -> &str {
        self.unit()
    }
    /// Numbers that calibration may adjust, with what is known of them.
    fn parameters(&self) -> &[Parameter];
    /// The centre of what is known of them, in their units.
    fn centre(&self) -> Vec<f64> {
        self.parameters().iter().map(Parameter::centre).collect()
    }
    /// Columns without which there is no response.
    fn needs(&self) -> &[Role];
    /// Why a stage means nothing in this model; `None` where it acts.
    fn lacks(&self, stage: StageName) -> Option<&'static str>;
    /// Full load in SI, to which [`crate::Drive::load`] is relative; `None` where load plays no part.
    fn full_load(&self) -> Option<f64>;
    /// Whether the electrode of the base model warps with temperature; `None` where it has no electrode to warp.
    fn warps(&self) -> Option<bool> {
        None
    }
    /// Whether an insulator lies in series with the compressible dielectric, with a permittivity of its own ([`crate::Dielectric::insulator`]).
    fn has_insulator(&self) -> bool {
        false
    }
    /// Whether effects that make the load depend on the model's own response ([`Stage::feedback`]) are to be tried: it is then asked many times for one answer.
    fn feeds_back(&self) -> bool {
        false
    }
    /// Whether the model predicts any movement of the response; `false` for a value that should stay as it is, which shows no gain and does not clip.
    fn moves(&self) -> bool {
        true
    }
    /// Whether the response of a row follows from the inputs of that row alone, as long as nothing is plugged in: then any rows may be asked for by themselves.
    fn row_by_row(&self) -> bool {
        false
    }
    /// Whether the priors give the absolute level of the response before the recording is seen, from dimensions and materials; `false` where they are scaled
    /// from the recording itself, so that another sensor or another unit cannot be told from it.
    fn knows_its_level(&self) -> bool {
        false
    }
    /// Temperature at which the model is described, degrees Celsius.
    fn reference_c(&self) -> f64 {
        20.0
    }
    /// What finite elements say of this sensor, without a free number; `None` where nobody has asked them, or they have no answer.
    fn corrections(&self) -> Option<&Arc<Corrections>> {
        None
    }
    /// The recordings that the model joins; `None` where it is of one.
    fn joined(&self) -> Option<&dyn Joined> {
        None
    }
    /// Recorded load over [`Simulator::full_load`], before any stage: the force or pressure that the model needs. `None` where load plays no part or was not
    /// recorded.
    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        let full_load = self.full_load()?;
        let role = self.needs().iter().find(|role| matches!(role, Role::Force | Role::Pressure))?;
        Some(inputs.column(*role)?.iter().map(|load| load / full_load).collect())
    }
    /// The recorded column of a role.
    ///
    /// # Errors
    /// [`SimulationError::MissingColumn`] where it was not recorded.
    fn column<'a>(&self, inputs: &'a Inputs, role: Role) -> Result<&'a [f64], SimulationError> {
        inputs.column(role).ok_or_else(|| SimulationError::MissingColumn { model: self.name().to_owned(), role })
    }
    /// Whether there is one value for each parameter, and every column that the model needs.
    ///
    /// # Errors
    /// [`SimulationError::WrongNumberOfValues`] or [`SimulationError::MissingColumn`].
    fn check(&self, values: &[f64], inputs: &Inputs) -> Result<(), SimulationError> {
        let (expected, given) = (self.parameters().len(), values.len());
        if expected != given {
            return Err(SimulationError::WrongNumberOfValues { model: self.name().to_owned(), expected, given });
        }
        self.needs().iter().try_for_each(|role| self.column(inputs, *role).map(|_| ()))
    }
    /// Response of each row, one pass down the chain with `stages` plugged in; `values` in the order of [`Simulator::parameters`].
    ///
    /// # Errors
    /// [`SimulationError`] where a row has no physical answer (closed gap), a column is missing, or there is not one value for each parameter.
    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError>;
    /// The response beside a point, to first order in the difference to it; `None` where there is no shorter way than [`Simulator::respond`].
    ///
    /// # Errors
    /// As [`Simulator::respond`], at the point itself.
    #[allow(unused_variables)]
    fn beside<'s>(
        &'s self,
        values: &[f64],
        inputs: &'s Inputs,
        stages: &[&dyn Stage],
    ) -> Result<Option<Box<dyn Beside + 's>>, SimulationError> {
        Ok(None)
    }
}

/// The response of a [`Simulator`] near the point for which it was made: for difference quotients, each of which costs less than a response, and which are taken side by side.
pub trait Beside: Sync {
    /// Response of each row at other values and with other stages, the physics of the base model to first order in the difference; stages act in full.
    ///
    /// # Errors
    /// [`SimulationError`] where a stage or a parameter has no answer.
    fn respond(&self, values: &[f64], stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError>;
}

/// What a [`Simulator`] that joins several recordings of one physics tells of them.
///
/// A run belongs to one recording; nothing but parameters and added physics is common to all.
pub trait Joined: Send + Sync {
    /// Number of recordings.
    fn count(&self) -> usize;
    /// Rows of recording `index`, in order and without a gap.
    fn rows(&self, index: usize, inputs: &Inputs) -> Range<usize>;
    /// What was done in recording `index`: its rows, with the columns that were recorded there, on its own clock.
    fn inputs(&self, index: usize, inputs: &Inputs) -> Inputs;
    /// Model of recording `index` by itself.
    fn model(&self, index: usize) -> &dyn Simulator;
    /// For each parameter of that model, its index among the parameters of the joint model.
    fn places(&self, index: usize) -> &[usize];
    /// Whether recording `index` has parameters that no other recording has.
    fn has_own(&self, index: usize) -> bool {
        let others = |place: &usize| (0..self.count()).any(|k| k != index && self.places(k).contains(place));
        !self.places(index).iter().all(others)
    }
}

/// Parameter values as an array, so that each gets its name in one line: `let [offset, gain] = named_values(self, values)?`.
///
/// # Errors
/// [`SimulationError::WrongNumberOfValues`] where there are not `N` of them.
pub fn named_values<const N: usize>(simulator: &dyn Simulator, values: &[f64]) -> Result<[f64; N], SimulationError> {
    let wrong = |_| SimulationError::WrongNumberOfValues { model: simulator.name().to_owned(), expected: N, given: values.len() };
    values.try_into().map_err(wrong)
}
