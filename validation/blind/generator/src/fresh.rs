//! Fresh histories: the same sensor with the same causes under another protocol, to score a model on what it has never seen.
//!
//! Limits: the clock and the greatest load ever start again; random strangers go through their own course again.

use crate::case::{BlindCase, CaseError};
use crate::chain::{Act, simulate};
use crate::draws::Draws;
use crate::protocol::Kind;
use crate::recording::{Declared, Recording};
use crate::state::Scene;

/// A fresh recording of a known case.
#[derive(Debug, Clone)]
pub struct Fresh {
    /// What an experimenter would record.
    pub recording: Recording,
    /// Noise-free readings, pF.
    pub truth_pf: Vec<f64>,
    /// The same without noise on the inputs and the reading: drive a model with this to compare it with `truth_pf`.
    pub quiet: Recording,
    /// Readings of the declared base model with the true sensor, pF: what the causes change is `truth_pf` less this.
    pub base_pf: Vec<f64>,
    /// Kind of protocol.
    pub protocol: Kind,
}

impl BlindCase {
    /// Fresh history number `number` of this sensor and its causes.
    pub fn fresh(&self, number: u64) -> Result<Fresh, CaseError> {
        let stream = |purpose: &str| Draws::of(self.seed, &format!("{}/fresh/{number}/{purpose}", self.answer.case));
        let kinds = [Kind::Full, Kind::Thermal, Kind::Mechanical, Kind::Uneven];
        let protocol = kinds[stream("kind").index(kinds.len())];
        let history = protocol.history(true, &mut stream("protocol"));
        let scene = Scene { sensor: &self.answer.sensor, history: &history };
        let run = |acts: &[Act]| {
            simulate(scene, self.answer.warp_declared, acts)
                .map_err(|source| CaseError::Closed { case: self.answer.case.clone(), source })
        };
        let (truth_pf, base_pf) = (run(&self.acts)?, run(&[])?);
        let driver = self.acts.iter().find_map(|act| act.mechanism.records(&history));
        let declared = Declared { warp: self.answer.warp_declared, humidity: self.answer.humidity_column };
        let recording = Recording::noisy(&history, &truth_pf, &self.answer.noise, declared, &mut stream("noise"));
        let recording = Recording { driver, ..recording };
        let quiet = Recording {
            force_n: history.force.clone(),
            temperature_c: history.temperature.clone(),
            capacitance_pf: truth_pf.clone(),
            ..recording.clone()
        };
        Ok(Fresh { recording, truth_pf, quiet, base_pf, protocol })
    }
}
