//! What is added up to the capacitance of a sensor.
//!
//! Limits: shielded layouts have all of them, mutual ones neither backing nor tail.

/// Capacitances, pF.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parts {
    /// gap between electrode and shield, without the field at the rim
    pub main: f64,
    /// insulator behind the electrode
    pub backing: f64,
    /// what the field at the rim adds
    pub rim: f64,
    /// tail with its edges
    pub tail: f64,
    /// beside the sensor
    pub stray: f64,
}

impl Parts {
    /// What is read, pF.
    pub fn total(&self) -> f64 {
        self.main + self.backing + self.rim + self.tail + self.stray
    }
}
