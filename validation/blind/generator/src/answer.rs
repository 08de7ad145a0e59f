//! The sealed answer of a case.
//!
//! Limits: holds everything that was drawn, so that a case can be understood once opened; nothing of it is published before.

use crate::logger::Logger;
use crate::mechanism::Numbers;
use crate::noise::Noise;
use crate::protocol::Kind;
use crate::sensor::Sensor;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What is concealed in a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// Name of the case.
    pub case: String,
    /// 128 random bits, so that the answer cannot be guessed from its hash.
    pub salt: String,
    /// Library effects at work (ids of `design.md`).
    pub effects: Vec<String>,
    /// A cause that no library holds.
    pub stranger: Option<String>,
    /// Weak imperfections under them, each with its detectability; naming one of them is not wrong.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub bath: BTreeMap<String, f64>,
    /// The effect that the diagnosis is to do without; it stands under `stranger`, since that is what it then is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub without: Option<String>,
    /// Detectability of all causes together, without the bath; 0 where there is none.
    pub detectability: f64,
    /// The same with the noise of the recorded inputs counted; absent in studies before it was.
    #[serde(default)]
    pub detectability_beside_input_noise: Option<f64>,
    /// Detectability of each cause alone, in the order of `effects` (or of the stranger).
    pub each: Vec<f64>,
    /// Detectability of each cause once the others are known but for their size: small where two look alike.
    pub apart: Vec<f64>,
    /// Share of the detectability that is seen in the residual; the rest is conflict with the tolerances.
    pub residual_share: f64,
    /// Spread of the causes over the noise, before calibration.
    pub rms_before_calibration_over_noise: f64,
    /// And after it.
    pub rms_after_calibration_over_noise: f64,
    /// Kind of protocol.
    pub protocol: Kind,
    /// Noise.
    pub noise: Noise,
    /// The logger, in studies of loggers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub logger: Option<Logger>,
    /// The sensor, SI units.
    pub sensor: Sensor,
    /// Whether the declared base model has the warp.
    pub warp_declared: bool,
    /// Whether a humidity column is recorded.
    pub humidity_column: bool,
    /// Shape and size of each cause.
    pub parameters: Numbers,
}

impl Answer {
    /// The sealed text, whose hash is published.
    pub fn text(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(self)
    }
}
