//! What was concealed, from a study's answers or from the `truth.json` files of the shared open recordings.
//!
//! Limits: an open `truth.json` does not say whether the noise was coloured; such cases count in neither column of false alarms.

use super::stated::{Drawn, drawn};
use super::words::{Words, words_of};
use crate::answer::Answer;
use crate::logger::Logger;
use serde_json::Value;
use std::collections::BTreeSet;

/// What a scorer needs of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// Case.
    pub case: String,
    /// Library effects at work.
    pub causes: BTreeSet<String>,
    /// A cause outside the library.
    pub stranger: Option<String>,
    /// Detectability of all together.
    pub detectability: f64,
    /// The same with the noise of the recorded inputs counted, where known.
    pub beside_input_noise: Option<f64>,
    /// Detectability of the weakest cause alone.
    pub weakest: f64,
    /// The same with the other causes known but for their size: whether several can be told apart at all.
    pub weakest_apart: f64,
    /// Coloured noise, where known.
    pub coloured: Option<bool>,
    /// The logger, in studies of loggers.
    pub logger: Option<Logger>,
    /// Kind of protocol.
    pub protocol: String,
    /// Weak imperfections under the causes.
    pub bath: BTreeSet<String>,
    /// The words that describe it, where the cause is in no library (or was taken out of it).
    pub words: Option<Words>,
    /// Whether the diagnosis did without the effect at work.
    pub left_out: bool,
    /// Numbers of the sensor and of what is concealed, by the names that a diagnosis states.
    pub drawn: Drawn,
}

impl Truth {
    /// Whether nothing was concealed.
    pub fn is_null(&self) -> bool {
        self.causes.is_empty() && self.stranger.is_none()
    }

    /// From the `truth.json` of a shared recording; `None` where it has another shape.
    pub fn of_shared(case: &str, truth: &Value) -> Option<Self> {
        let effects: Vec<&str> = truth["effects"].as_array()?.iter().map(Value::as_str).collect::<Option<_>>()?;
        let (unlisted, causes): (Vec<&str>, Vec<&str>) = effects.into_iter().partition(|e| e.starts_with("unlisted:"));
        let detectability = truth["detectability"].as_f64()?;
        let of_words = Words::of_shared(&truth["mechanism"]);
        let unlisted = unlisted.first().map(|name| name.trim_start_matches("unlisted:").to_owned());
        Some(Self {
            case: case.to_owned(),
            causes: causes.into_iter().map(str::to_owned).collect(),
            stranger: unlisted.or_else(|| truth["mechanism"]["kind"].as_str().map(str::to_owned)),
            bath: truth["bath"].as_object().into_iter().flatten().map(|(name, _)| name.clone()).collect(),
            words: of_words,
            left_out: false,
            drawn: drawn(&truth["sensor"], &truth["parameters"]),
            detectability,
            beside_input_noise: None,
            weakest: detectability,
            weakest_apart: detectability,
            coloured: None,
            logger: None,
            protocol: truth["protocol"].as_str()?.to_owned(),
        })
    }
}

impl From<&Answer> for Truth {
    fn from(answer: &Answer) -> Self {
        Self {
            case: answer.case.clone(),
            causes: answer.effects.iter().cloned().collect(),
            stranger: answer.stranger.clone(),
            detectability: answer.detectability,
            beside_input_noise: answer.detectability_beside_input_noise,
            weakest: answer.each.iter().copied().reduce(f64::min).unwrap_or(0.0),
            weakest_apart: answer.apart.iter().chain(&answer.each).copied().reduce(f64::min).unwrap_or(0.0),
            coloured: Some(answer.noise.is_coloured()),
            logger: answer.logger,
            bath: answer.bath.keys().cloned().collect(),
            words: answer.stranger.as_deref().and_then(words_of),
            left_out: answer.without.is_some(),
            drawn: of_answer(answer),
            protocol: format!("{:?}", answer.protocol).to_lowercase(),
        }
    }
}

/// Both sides of an answer are plain data.
fn of_answer(answer: &Answer) -> Drawn {
    let value = |part: serde_json::Result<Value>| part.unwrap_or_default();
    drawn(&value(serde_json::to_value(&answer.sensor)), &value(serde_json::to_value(&answer.parameters)))
}
