//! A model file beside a recording that is to be corrected: which of the added effects hold there, and both models with these.
//!
//! Limits: what an effect is says the effect; nothing is fitted.

use super::left_out::LeftOut;
use super::model_file::{RunningModel, begin_anew, driver_of};
use super::model_file_error::ModelFileError;
use truegap_core::Inputs;
use truegap_diagnose::answer::{AddedEffect, Scales};
use truegap_diagnose::mechanism::{Driver, Kinetics};
use truegap_diagnose::other_clock::OtherClock;
use truegap_diagnose::{Augmented, Effect, Library};

/// The added effects, by whether a reading shows them and is corrected for them.
#[derive(Clone, Debug, Default)]
pub struct Parted {
    /// those that the reading shows; it is not corrected for those that are marked as carried
    pub kept: Vec<AddedEffect>,
    /// those for which the reading is not corrected, with the reason
    pub left_out: Vec<LeftOut>,
    /// those that are clocks of the recorded inputs
    pub clocks: Vec<AddedEffect>,
}

/// Ids of those of these effects for which a reading is corrected.
pub fn corrected_for(effects: &[AddedEffect]) -> impl Iterator<Item = String> + '_ {
    effects.iter().filter(|added| !added.carried).map(|added| added.id.clone())
}

/// Those of these effects that stay in a reading.
pub fn only_carried(effects: &[AddedEffect]) -> Vec<AddedEffect> {
    effects.iter().filter(|added| added.carried).cloned().collect()
}

/// What a reading is corrected for besides what is claimed and holds in any recording.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// what follows the clock: the recording began as that of the diagnosis did
    pub of_the_clock: bool,
    /// what the model carries without a claim to its name
    pub carried: bool,
}

const OF_A_CLOCK: &str = "it is a clock of the recorded input: a corrected reading stays on the clock of the reading";
const OF_THE_REFERENCE: &str = "it is an error of the recorded input and not of the reading";
const BOUND_TO_RUNS: &str = "it has a number for each run of the recording that it was fitted to";
const ONLY_CARRIED: &str = "the diagnosis carries it without a claim to its name: it may stand for a base model that is slightly off (--carried corrects for it as well)";
const ON_THE_CLOCK: &str = "it follows the time since the first row of the recording that it was fitted to";

impl RunningModel {
    /// The added effects for which the readings of a recording may be corrected; `same` says that it is the recording that they were fitted to.
    ///
    /// Numbers that say how the first recording began are 0 in another one.
    pub fn parted(&self, library: &Library, inputs: &Inputs, same: bool, wanted: Wanted) -> Parted {
        let (bound, dated) = (self.bound_to_runs(library), self.knows_dates(inputs));
        self.as_fitted(|context| {
            let mut parted = Parted::default();
            for added in &self.augmented.effects {
                let effect = library.find(&added.id);
                let is_clock = effect.is_some_and(Effect::of_recorder);
                let why = if is_clock {
                    Some(OF_A_CLOCK)
                } else if effect.is_some_and(Effect::of_reference) {
                    Some(OF_THE_REFERENCE)
                } else if !same && bound.contains(&added.id) {
                    Some(BOUND_TO_RUNS)
                } else if effect.is_some_and(Effect::by_date) && (same || dated) {
                    None
                } else if !same && !wanted.of_the_clock && driver_of(added, library, context) == Some(Driver::Time) {
                    Some(ON_THE_CLOCK)
                } else {
                    None
                };
                if is_clock {
                    parted.clocks.push(added.clone());
                }
                if let Some(why) = why {
                    parted.left_out.push(LeftOut { effect: added.id.clone(), why });
                    continue;
                }
                let mut added = added.clone();
                if !same {
                    begin_anew(&mut added, library, context);
                }
                added.carried &= !wanted.carried;
                if added.carried {
                    parted.left_out.push(LeftOut { effect: added.id.clone(), why: ONLY_CARRIED });
                }
                parted.kept.push(added);
            }
            parted
        })
    }

    /// An added effect that follows the temperature: without a thermometer it would be taken to add nothing.
    pub(super) fn follows_temperature(&self, library: &Library) -> Option<String> {
        self.as_fitted(|context| {
            let follows = |added: &&AddedEffect| {
                matches!(driver_of(added, library, context), Some(Driver::Temperature | Driver::TemperatureRate))
            };
            self.augmented.effects.iter().find(follows).map(|added| added.id.clone())
        })
    }

    /// What an added effect follows, and how in time, as its mechanism or the library says; `None` where no words say it.
    pub(crate) fn words_of(&self, library: &Library, added: &AddedEffect) -> Option<(Driver, Kinetics)> {
        self.as_fitted(|context| match &added.mechanism {
            Some(mechanism) => Some((mechanism.sentence.driver.clone(), mechanism.sentence.kinetics)),
            None => library.find(&added.id)?.in_words(context).map(|words| (words.driver, words.kinetics)),
        })
    }

    /// Response of each row with these effects alone, at the calibration of the augmented model.
    ///
    /// # Errors
    /// As [`RunningModel::respond`].
    pub fn respond_with(&self, effects: &[AddedEffect], inputs: &Inputs) -> Result<Vec<f64>, ModelFileError> {
        let augmented = Augmented { effects: effects.to_vec(), ..self.augmented.clone() };
        self.respond_as(&augmented, inputs, &OtherClock::default())
    }

    /// What the effects' equations take from the recording on which they were fitted.
    pub fn scales(&self) -> &Scales {
        &self.augmented.scales
    }
}
