//! A mechanism: one sentence of words with its numbers.
//!
//! Limits: one driver, one kinetics, one form; two mechanisms stand side by side.

use crate::effects::composed::words::{Action, Driver, Form, InWords, Kinetics, Quantity};
use serde::{Deserialize, Serialize};

/// What adds up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sum {
    /// the greatest value so far
    Greatest,
    /// the driver over time
    Dose,
    /// the way that the driver has come, up and down alike
    Path,
}

/// The words of a mechanism, and which variety of a word it is.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct Sentence {
    /// what is changed, and so the place
    pub quantity: Quantity,
    /// how
    pub action: Action,
    /// what it follows
    pub driver: Driver,
    /// how in time
    pub kinetics: Kinetics,
    /// the law
    pub form: Form,
    /// up and down alike: the driver counts by its size, not its sign
    #[serde(default)]
    pub even: bool,
    /// below the threshold instead of above it
    #[serde(default)]
    pub below: bool,
    /// what is late less what is now: it comes and goes
    #[serde(default)]
    pub passing: bool,
    /// what adds up, where something does
    #[serde(default)]
    pub sum: Option<Sum>,
}

/// The numbers inside a mechanism, in the units of driver and clock; those that its words do not use play no part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Numbers {
    /// time constant, s
    #[serde(default)]
    pub tau_s: f64,
    /// half width of the play, driver's unit
    #[serde(default)]
    pub width: f64,
    /// threshold, driver's unit; of an event in time, its moment, s; the place of a peak
    #[serde(default)]
    pub threshold: f64,
    /// exponent
    #[serde(default)]
    pub exponent: f64,
    /// scale at which it levels off, driver's unit; half width of a peak, the standard deviation of its bell
    #[serde(default)]
    pub scale: f64,
    /// period, driver's unit
    #[serde(default)]
    pub period: f64,
    /// phase, rad
    #[serde(default)]
    pub phase: f64,
    /// a whole turn of a driver that is an angle, driver's unit; 0 of any other
    #[serde(default)]
    pub turn: f64,
}

impl Sentence {
    /// The words that decide what it is, whatever its law.
    pub fn in_words(&self) -> InWords {
        InWords { place: self.quantity.place(), driver: self.driver.clone(), kinetics: self.kinetics }
    }

    /// A name for files: what follows what.
    pub fn name(&self) -> String {
        let driver = self.driver.word();
        let plain: String = driver.to_lowercase().chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        format!("{}_follows_{plain}", self.quantity.word())
    }

    /// Names of the numbers that its words use, with the word that does.
    pub fn needs(&self) -> Vec<(&'static str, &'static str)> {
        let mut needs = Vec::new();
        match self.kinetics {
            Kinetics::FirstOrder => needs.push(("tau", "first_order")),
            Kinetics::RateIndependent => needs.push(("width", "rate_independent")),
            Kinetics::Periodic => needs.extend([("period", "periodic")]),
            Kinetics::Event => needs.push(("threshold", "event")),
            Kinetics::Static | Kinetics::Accumulating => {}
        }
        if matches!(self.kinetics, Kinetics::Static | Kinetics::FirstOrder | Kinetics::Accumulating) {
            match self.form {
                Form::Linear => {}
                Form::Power => needs.push(("exponent", "power")),
                Form::Threshold => needs.push(("threshold", "threshold")),
                Form::Saturating => needs.push(("scale", "saturating")),
                Form::Peak => needs.extend([("threshold", "peak"), ("scale", "peak")]),
            }
        }
        needs
    }
}

impl Numbers {
    /// The numbers with these values, by the names of parameters; and the value that is none of them, the size.
    pub fn with<'v>(mut self, values: impl Iterator<Item = (&'v str, f64)>) -> (Self, f64) {
        let mut size = 0.0;
        for (name, value) in values {
            *self.by_name(name).unwrap_or(&mut size) = value;
        }
        (self, size)
    }

    /// Names of the numbers, as [`Numbers::by_name`] knows them.
    pub const NAMES: [&'static str; 8] = ["tau", "width", "threshold", "exponent", "scale", "period", "phase", "turn"];

    /// The number of this name.
    pub fn by_name(&mut self, name: &str) -> Option<&mut f64> {
        Some(match name {
            "tau" => &mut self.tau_s,
            "width" => &mut self.width,
            "threshold" => &mut self.threshold,
            "exponent" => &mut self.exponent,
            "scale" => &mut self.scale,
            "period" => &mut self.period,
            "phase" => &mut self.phase,
            "turn" => &mut self.turn,
            _ => return None,
        })
    }
}

/// A mechanism as a file holds it, beside its free parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mechanism {
    /// words
    #[serde(flatten)]
    pub sentence: Sentence,
    /// numbers that are not free
    #[serde(default)]
    pub numbers: Numbers,
}
