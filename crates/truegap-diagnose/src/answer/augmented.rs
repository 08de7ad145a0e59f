//! The model that a diagnosis ends with: a calibrated base and effects with numbers, ready to be written to a file.
//!
//! Limits: names and numbers only; whoever knows the base models rebuilds a simulator from it.

use crate::{
    data::{context::Context, moved::Moved},
    effects::{collection::Library, composed::mechanism::Mechanism},
};
use serde::{Deserialize, Serialize};
use truegap_core::Stage;

/// A calibrated model with added physics.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Augmented {
    /// base parameters
    pub parameters: Vec<NamedValue>,
    /// the same parameters where the base model alone was calibrated; empty where that is not known
    #[serde(default)]
    pub base_alone: Vec<NamedValue>,
    /// added effects
    pub effects: Vec<AddedEffect>,
    /// facts that the effects scale by
    pub scales: Scales,
    /// the same model with a rival in the place of an effect, for each that the recording cannot tell from it
    #[serde(default)]
    pub rivals: Vec<RivalModel>,
}

/// The augmented model with another effect in the place of one that is named: what the recording cannot tell from it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RivalModel {
    /// id of the named effect
    pub instead_of: String,
    /// id of the rival
    pub id: String,
    /// base parameters beside it
    pub parameters: Vec<NamedValue>,
    /// added effects, the rival among them
    pub effects: Vec<AddedEffect>,
}

/// A number with its name, unit and standard deviation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NamedValue {
    /// name
    pub name: String,
    /// unit
    pub unit: String,
    /// value
    pub value: f64,
    /// standard deviation
    pub sd: f64,
}

/// An effect with its numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AddedEffect {
    /// id
    pub id: String,
    /// parameters, each by its name
    pub parameters: Vec<NamedValue>,
    /// words and fixed numbers of a mechanism that no library holds
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mechanism: Option<Mechanism>,
    /// whether the model only carries it, without a claim to its name
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub carried: bool,
}

/// What an effect's equations take from the recording on which it was fitted.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Scales {
    /// longest run, s
    pub longest_run_s: f64,
    /// shortest step, s; 0 without a clock
    pub shortest_step_s: f64,
    /// from first to last row, s
    pub duration_s: f64,
    /// response span, response unit
    pub response_span: f64,
    /// noise, response unit
    pub noise_sd: f64,
    /// runs; an effect may have a number for each
    #[serde(default)]
    pub runs: Option<usize>,
    /// columns that moved; a file of an earlier version has none, and what its effects follow is looked up in the inputs
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moved: Option<Moved>,
}

/// An effect that the library does not have.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("the library has no effect `{id}`; known: {known}")]
pub struct UnknownEffect {
    /// the id asked for
    pub id: String,
    /// all ids
    pub known: String,
}

impl Augmented {
    /// The stages of the added effects; `context` describes the inputs to be simulated.
    ///
    /// # Errors
    /// [`UnknownEffect`] for an id that the library does not have.
    pub fn stages(&self, library: &Library, context: &Context<'_>) -> Result<Vec<Box<dyn Stage>>, UnknownEffect> {
        let stage = |added: &AddedEffect| {
            if let Some(mechanism) = &added.mechanism {
                let values = added.parameters.iter().map(|p| (p.name.as_str(), p.value));
                return Ok(mechanism.stage(values, context.reference_c));
            }
            let unknown = || UnknownEffect { id: added.id.clone(), known: library.ids().join(", ") };
            let effect = library.find(&added.id).ok_or_else(unknown)?;
            Ok(effect.with(&added.parameters.iter().map(|p| p.value).collect::<Vec<_>>(), context))
        };
        self.effects.iter().map(stage).collect()
    }

    /// Sets the scales of a context to those of the fit, so that an effect means the same on other inputs.
    pub fn apply_scales(&self, context: &mut Context<'_>) {
        context.longest_run_s = self.scales.longest_run_s;
        context.duration_s = self.scales.duration_s;
        context.shortest_step_s = (self.scales.shortest_step_s > 0.0).then_some(self.scales.shortest_step_s);
        context.response_span = self.scales.response_span;
        context.noise_sd = self.scales.noise_sd;
        context.runs = self.scales.runs.unwrap_or(context.runs);
        if let Some(moved) = &self.scales.moved {
            context.moved.clone_from(moved);
        }
    }
}
