//! What a model predicts of a recording with what is free fitted, and base and augmented model compared.
//!
//! Limits: nothing else is fitted.

use super::ConfirmError;
use crate::models::{ModelFileError, RunningModel};
use truegap_core::Recording;
use truegap_diagnose::answer::Errors;
use truegap_diagnose::confirmation::{Compared, Reading, compared};
use truegap_diagnose::other_clock::{OtherClock, with_clock};
use truegap_diagnose::{joint, rms};

/// What is fitted to the other recording: the same for base and augmented model, each by itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Free {
    /// gain of the reading
    pub gain: bool,
    /// offset of the reading
    pub offset: bool,
    /// clock of the load against that of the reading
    pub clock: bool,
}

impl Free {
    /// From words of the command line.
    ///
    /// # Errors
    /// [`ConfirmError::Free`] for any word but `gain`, `offset` and `clock`.
    pub fn of(words: &[String]) -> Result<Self, ConfirmError> {
        if let Some(word) = words.iter().find(|word| !matches!(word.as_str(), "gain" | "offset" | "clock")) {
            return Err(ConfirmError::Free { word: word.clone() });
        }
        let has = |word: &str| words.iter().any(|w| w == word);
        Ok(Self { gain: has("gain"), offset: has("offset"), clock: has("clock") })
    }

    pub(super) fn words(self) -> Vec<&'static str> {
        let words = [("gain", self.gain), ("offset", self.offset), ("clock", self.clock)];
        words.into_iter().filter_map(|(word, is)| is.then_some(word)).collect()
    }

    fn reading(self) -> joint::Free {
        joint::Free { gain: self.gain, offset: self.offset }
    }
}

/// Base and augmented model, in this order, with what is free fitted, and their comparison.
pub(super) struct Judged {
    /// predictions
    pub columns: [Vec<f64>; 2],
    /// their errors
    pub errors: [Errors; 2],
    /// the comparison
    pub test: Compared,
}

/// What a model predicts of a recording with what is free fitted, and its errors; `predict` answers with a clock.
pub(super) fn judged_model(
    recording: &Recording,
    free: Free,
    predict: &dyn Fn(&OtherClock) -> Result<Vec<f64>, ModelFileError>,
) -> Result<(Vec<f64>, Errors), ModelFileError> {
    let (inputs, response) = (&recording.inputs, &recording.response);
    let (clock, predicted) = match free.clock {
        true => with_clock(inputs, response, free.reading(), predict)?,
        false => (OtherClock::default(), predict(&OtherClock::default())?),
    };
    let reading = Reading::fitted(&predicted, response, free.reading());
    let column = reading.of(&predicted);
    let rmse = rms(column.iter().zip(response).map(|(p, r)| p - r));
    Ok((column, Errors { rmse, reading, clock: free.clock.then_some(clock) }))
}

impl Judged {
    pub fn new(model: &RunningModel, recording: &Recording, free: Free) -> Result<Self, ModelFileError> {
        let (inputs, response) = (&recording.inputs, &recording.response);
        let (base, of_base) = judged_model(recording, free, &|clock| model.respond_alone_by(clock, inputs))?;
        let (augmented, of_augmented) = judged_model(recording, free, &|clock| model.respond_by(clock, inputs))?;
        let test = compared(&base, &augmented, response, &inputs.runs());
        Ok(Self { columns: [base, augmented], errors: [of_base, of_augmented], test })
    }
}
