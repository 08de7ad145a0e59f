//! What an effect of the library says of itself, for a reader: physics, equation, what shows it, what it is mistaken for and what tells it apart.
//!
//! Limits: all words are the library's own; numbers of a recording are in its report.

use crate::diagnosis::example::example_recording;
use crate::models::{BaseModelError, base_model};
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt;
use truegap_core::nearest::nearest;
use truegap_core::{Driver, Inputs, RecordingError, StageName};
use truegap_diagnose::text::{capitalised, spoken};
use truegap_diagnose::{Context, Effect, Family, Library};

/// Why an effect cannot be explained.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum ExplainError {
    /// No effect has that name.
    #[error("the library has no effect `{name}`; {hint}")]
    Unknown { name: String, hint: String },
    /// The built-in recording cannot be read, which a test excludes.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// Its base model cannot be built, which a test excludes.
    #[error(transparent)]
    Base(#[from] BaseModelError),
}

/// A fitted number of an effect.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Number {
    /// name in files
    pub name: String,
    /// unit
    pub unit: String,
    /// what it is
    pub meaning: String,
}

/// An instrument change that tells two effects apart.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ToldBy {
    /// id of the other effect
    pub rival: String,
    /// what to do
    pub says: String,
}

/// An effect, as it explains itself.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Explained {
    /// id
    pub effect: String,
    /// place in the chain
    pub stage: StageName,
    /// kind of thing
    pub family: Family,
    /// the physics in one sentence
    pub physics: String,
    /// the equation as fitted
    pub equation: String,
    /// what a recording must contain to show it
    pub needs: String,
    /// effects that it is usually mistaken for
    pub mistaken_for: Vec<String>,
    /// what tells it from them
    pub told_apart_by: String,
    /// changes of the instrument that tell it from another effect where no profile does
    pub instrument_changes: Vec<ToldBy>,
    /// fitted numbers, the size first; as for the sensor stack, and one of each run where there is one a run
    pub parameters: Vec<Number>,
    /// where the physics is described
    pub source: String,
}

/// The effect with this id; blanks and capitals may stand for `_` and small letters.
///
/// # Errors
/// [`ExplainError::Unknown`] names the closest ids.
pub fn explained(name: &str, library: &Library) -> Result<Explained, ExplainError> {
    let id = name.trim().to_lowercase().replace([' ', '-'], "_");
    let effect = library.find(&id).ok_or_else(|| unknown(name, library))?;
    let recording = example_recording()?;
    let base = base_model(&recording)?;
    let inputs = with_all_columns(recording.inputs);
    let context = Context::new(&inputs, base.simulator.as_ref(), 1.0, 0.01);
    Ok(of(effect, &context, library))
}

/// Every effect in one line: id, physics.
pub fn effects(library: &Library) -> Vec<(&'static str, &'static str)> {
    library.iter().map(|effect| (effect.id().0, effect.about().physics)).collect()
}

fn unknown(name: &str, library: &Library) -> ExplainError {
    let close: Vec<String> = nearest(name, library.ids()).iter().map(|id| format!("`{id}`")).collect();
    let hint = match close.is_empty() {
        true => "`truegap explain` lists them".to_owned(),
        false => format!("did you mean {}? `truegap explain` lists them", close.join(" or ")),
    };
    ExplainError::Unknown { name: name.to_owned(), hint }
}

/// The inputs with columns that effects may follow and the built-in recording lacks, so that each effect can say its parameters.
fn with_all_columns(mut inputs: Inputs) -> Inputs {
    let rows = inputs.len();
    let ramp = |low: f64, high: f64| (0..rows).map(|row| low + (high - low) * row as f64 / rows as f64).collect::<Vec<f64>>();
    inputs.humidity_pct.get_or_insert_with(|| ramp(30.0, 70.0));
    inputs.drivers = ["first driver", "second driver"]
        .map(|name| Driver { name: name.into(), unit: "1".into(), values: ramp(0.0, 1.0) })
        .to_vec();
    inputs
}

fn of(effect: &dyn Effect, context: &Context<'_>, library: &Library) -> Explained {
    let about = effect.about();
    Explained {
        effect: effect.id().0.to_owned(),
        stage: effect.stage(),
        family: effect.family(),
        physics: about.physics.to_owned(),
        equation: about.equation.to_owned(),
        needs: about.excitation.to_owned(),
        mistaken_for: about.impostors.iter().map(|&id| id.to_owned()).collect(),
        told_apart_by: about.separates.to_owned(),
        instrument_changes: instrument_changes(effect, library),
        parameters: numbers(effect, context),
        source: about.source.to_owned(),
    }
}

/// A pair of effects is listed by one of the two: both are asked.
fn instrument_changes(effect: &dyn Effect, library: &Library) -> Vec<ToldBy> {
    let told = |rival: &str, says: &str| ToldBy { rival: rival.to_owned(), says: says.to_owned() };
    let own = effect.separations().iter().map(|s| told(s.rival, s.says));
    let of_others = library.iter().flat_map(|other| other.separations().iter().map(move |s| (other.id().0, s)));
    own.chain(of_others.filter(|(_, s)| s.rival == effect.id().0).map(|(other, s)| told(other, s.says))).collect()
}

/// One a meaning: an effect may have the same number for each run.
fn numbers(effect: &dyn Effect, context: &Context<'_>) -> Vec<Number> {
    let mut seen = BTreeSet::new();
    let parameters = effect.parameters(context).into_iter().filter(|p| seen.insert((p.unit.clone(), p.meaning.clone())));
    parameters.map(|p| Number { name: p.name, unit: p.unit, meaning: p.meaning }).collect()
}

fn word(value: impl Serialize) -> String {
    serde_json::to_value(value).ok().and_then(|v| v.as_str().map(spoken)).unwrap_or_default()
}

impl fmt::Display for Explained {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let line = |f: &mut fmt::Formatter<'_>, name: &str, text: &str| writeln!(f, "{name:15}{text}");
        writeln!(f, "{}: {}.\n\n    {}\n", self.effect, capitalised(&self.physics), self.equation)?;
        line(f, "acts at", &format!("{} (family: {})", word(self.stage), word(self.family)))?;
        line(f, "needs", &self.needs)?;
        line(f, "mistaken for", &self.mistaken_for.join(", "))?;
        line(f, "told apart by", &self.told_apart_by)?;
        self.instrument_changes.iter().try_for_each(|change| line(f, "", &format!("from {}: {}", change.rival, change.says)))?;
        for (index, number) in self.parameters.iter().enumerate() {
            let lead = if index == 0 { "fitted" } else { "" };
            line(f, lead, &format!("{} [{}]: {}", number.name, number.unit, number.meaning))?;
        }
        write!(f, "{:15}{}", "source", self.source)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_explains_itself_and_names_effects_as_its_rivals() {
        let library = Library::default();
        let known: BTreeSet<&str> = library.ids().into_iter().collect();
        for id in library.ids() {
            let explained = explained(id, &library).unwrap();
            assert!(!explained.parameters.is_empty() && !explained.mistaken_for.is_empty(), "{explained:?}");
            let rivals = explained.mistaken_for.iter().chain(explained.instrument_changes.iter().map(|c| &c.rival));
            for rival in rivals {
                assert!(known.contains(rival.as_str()) || rival == "wrong_sensor", "{id}: {rival}");
            }
        }
    }

    #[test]
    fn what_tells_two_effects_apart_is_said_from_both_sides() {
        let library = Library::default();
        for effect in library.iter() {
            for change in effect.separations() {
                let Ok(other) = explained(change.rival, &library) else { continue };
                assert!(
                    other.instrument_changes.iter().any(|c| c.rival == effect.id().0),
                    "{} and {}",
                    effect.id(),
                    change.rival
                );
            }
        }
    }

    #[test]
    fn a_misspelt_effect_is_answered_with_the_nearest() {
        let told = explained("thermal_lagg", &Library::default()).unwrap_err().to_string();
        assert!(told.contains("`thermal_lag`"), "{told}");
        assert_eq!(explained("Thermal lag", &Library::default()).unwrap().effect, "thermal_lag");
    }
}
