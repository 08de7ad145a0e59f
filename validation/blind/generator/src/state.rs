//! What a simulation is about, and the state of every row on its way through the chain.
//!
//! Limits: the stages of the base model; concealed causes act between them.

use crate::history::History;
use crate::physics::{beads, constants::EXPANSION_RTV, constants::REFERENCE, field, layers, warp};
use crate::sensor::Sensor;

/// What stays the same during a simulation.
#[derive(Debug, Clone, Copy)]
pub struct Scene<'a> {
    /// The sensor.
    pub sensor: &'a Sensor,
    /// What is done to it.
    pub history: &'a History,
}

/// State of every row on its way through the chain; SI units, temperatures in degC.
#[derive(Debug, Clone)]
pub struct State {
    /// Load that reaches the beads, N.
    pub force: Vec<f64>,
    /// Temperature of the sensor, degC.
    pub temperature: Vec<f64>,
    /// Factor on the modulus of the beads (or on the area that carries).
    pub stiffness: Vec<f64>,
    /// Power of the shape factor in the bead law.
    pub stiffening: f64,
    /// Compression of the beads (positive).
    pub compression: Vec<f64>,
    /// Shape of the gap.
    pub gap: Vec<field::Gap>,
    /// Factor on the permittivity of the silicone.
    pub silicone: Vec<f64>,
    /// Factor on the permittivity of the polyimide.
    pub polyimide: Vec<f64>,
    /// Capacitance read, pF.
    pub reading: Vec<f64>,
}

/// The plates touch: no capacitance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("row {row}: the plates touch; make the concealed effect smaller")]
pub struct PlatesTouch {
    /// First row where they do.
    pub row: usize,
}

impl State {
    pub(crate) fn untouched(history: &History) -> Self {
        let rows = history.rows();
        Self {
            force: history.force.clone(),
            temperature: history.temperature.clone(),
            stiffness: vec![1.0; rows],
            stiffening: 0.0,
            compression: vec![0.0; rows],
            gap: vec![field::Gap::default(); rows],
            silicone: vec![1.0; rows],
            polyimide: vec![1.0; rows],
            reading: vec![0.0; rows],
        }
    }

    /// Load over area and modulus of the beads at `row`.
    pub fn bead_load(&self, sensor: &Sensor, row: usize) -> f64 {
        let temperature = self.temperature[row];
        self.force[row] / (beads::area(sensor, temperature) * beads::young(sensor, temperature) * self.stiffness[row])
    }

    pub(crate) fn compress(&mut self, sensor: &Sensor) {
        for row in 0..self.force.len() {
            self.compression[row] = beads::compression(self.bead_load(sensor, row), self.stiffening);
        }
    }

    pub(crate) fn shape(&mut self, sensor: &Sensor, warp: bool) {
        for row in 0..self.force.len() {
            let temperature = self.temperature[row];
            let height = sensor.height_rtv * (1.0 + EXPANSION_RTV * (temperature - REFERENCE));
            self.gap[row].mean = height * (1.0 - self.compression[row]);
            self.gap[row].curvature = if warp { warp::curvature(sensor, temperature) } else { 0.0 };
        }
    }

    pub(crate) fn read(&mut self, sensor: &Sensor) -> Result<(), PlatesTouch> {
        let disc = field::Disc::new();
        for row in 0..self.force.len() {
            let moment = layers::Moment {
                force: self.force[row],
                temperature: self.temperature[row],
                compression: self.compression[row],
                gap: self.gap[row],
                silicone: self.silicone[row],
                polyimide: self.polyimide[row],
            };
            self.reading[row] = layers::parts(sensor, &moment, &disc).ok_or(PlatesTouch { row })?.total;
        }
        Ok(())
    }
}
