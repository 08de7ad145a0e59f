//! The words of a mechanism: place, driver, kinetics, form, action. A value of a word is one line here and one arm where it is computed.
//!
//! Limits: words only; the numbers of a mechanism stand in [`crate::effects::composed::mechanism`], its columns are made in [`crate::effects::composed::signal`].

use serde::{Deserialize, Serialize};

/// Where in the chain a mechanism acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Place {
    /// load or temperature on their way to the sensor
    Inputs,
    /// what strain a load makes
    Mechanics,
    /// gap
    Geometry,
    /// permittivity
    Dielectric,
    /// electronics
    Readout,
}

/// The quantity at a place that is changed, which settles its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// load on the sensor, full loads
    Load,
    /// temperature of the sensor, K
    Temperature,
    /// Young's modulus, relative
    Modulus,
    /// compressive strain
    Strain,
    /// mean separation, unloaded gaps
    Gap,
    /// temperature difference that bends the electrode, K
    Warp,
    /// relative permittivity, relative
    Permittivity,
    /// reading, in its unit
    Reading,
}

/// How the quantity is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Action {
    /// something is added to it
    Adds,
    /// it is multiplied by one plus something
    Scales,
}

/// What a mechanism follows.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Driver {
    /// load, full loads
    Load,
    /// rate of the load, full loads a second
    LoadRate,
    /// what the load has done so far: its greatest value, its sum over time, its path, its crossings
    LoadHistory,
    /// temperature above that at which the sensor is described, K
    Temperature,
    /// rate of the temperature, K/s
    TemperatureRate,
    /// time since the first row, s
    Time,
    /// the reading above its zero, in its unit
    Reading,
    /// a recorded column, by name
    Recorded(String),
    /// its rate, a second
    RateOf(String),
}

/// How it follows in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kinetics {
    /// at once
    Static,
    /// late, with a time constant
    FirstOrder,
    /// by the way the driver moves, at any speed
    RateIndependent,
    /// it adds up and does not come back
    Accumulating,
    /// at a moment, or each time that a level is passed
    Event,
    /// up and down with a period in the driver
    Periodic,
}

/// The law between driver and change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Form {
    /// in proportion
    Linear,
    /// with an exponent
    Power,
    /// beyond a threshold, in proportion to the distance from it
    Threshold,
    /// levels off
    Saturating,
    /// about one place, a bell
    Peak,
}

/// What an effect is in words, whatever its name and its equation.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct InWords {
    /// where in the chain
    pub place: Place,
    /// what it follows
    pub driver: Driver,
    /// how in time
    pub kinetics: Kinetics,
}

impl Place {
    /// As in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Inputs => "inputs",
            Self::Mechanics => "mechanics",
            Self::Geometry => "geometry",
            Self::Dielectric => "dielectric",
            Self::Readout => "readout",
        }
    }
}

impl Quantity {
    /// As in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Load => "load",
            Self::Temperature => "temperature",
            Self::Modulus => "modulus",
            Self::Strain => "strain",
            Self::Gap => "gap",
            Self::Warp => "warp",
            Self::Permittivity => "permittivity",
            Self::Reading => "reading",
        }
    }
    /// Where it is.
    pub fn place(self) -> Place {
        match self {
            Self::Load | Self::Temperature => Place::Inputs,
            Self::Modulus | Self::Strain => Place::Mechanics,
            Self::Gap | Self::Warp => Place::Geometry,
            Self::Permittivity => Place::Dielectric,
            Self::Reading => Place::Readout,
        }
    }
}

impl Action {
    /// As in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Adds => "adds",
            Self::Scales => "scales",
        }
    }
}

impl Driver {
    /// As in files; a recorded column by its own name.
    pub fn word(&self) -> String {
        match self {
            Self::Load => "load".into(),
            Self::LoadRate => "load_rate".into(),
            Self::LoadHistory => "load_history".into(),
            Self::Temperature => "temperature".into(),
            Self::TemperatureRate => "temperature_rate".into(),
            Self::Time => "time".into(),
            Self::Reading => "reading".into(),
            Self::Recorded(name) => name.clone(),
            Self::RateOf(name) => format!("{name}_rate"),
        }
    }

    /// Whether it is a rate, which has a sign and is 0 at rest.
    pub fn is_rate(&self) -> bool {
        matches!(self, Self::LoadRate | Self::TemperatureRate | Self::RateOf(_))
    }
}

impl Kinetics {
    /// As in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Static => "static",
            Self::FirstOrder => "first_order",
            Self::RateIndependent => "rate_independent",
            Self::Accumulating => "accumulating",
            Self::Event => "event",
            Self::Periodic => "periodic",
        }
    }
}

impl Form {
    /// As in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Power => "power",
            Self::Threshold => "threshold",
            Self::Saturating => "saturating",
            Self::Peak => "peak",
        }
    }
}
