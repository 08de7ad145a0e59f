//! What drives the sensor, as one column.
//!
//! Limits: the recorded load or gap, before anything that happens to it on the way.

use truegap_core::{Inputs, Simulator};

/// What drives the sensor, as a share of its greatest value: load over full load, or the closing of the gap where the gap is given.
pub fn load_column(inputs: &Inputs, simulator: &dyn Simulator) -> Option<Vec<f64>> {
    simulator.load(inputs).or_else(|| {
        let gap = inputs.gap_m.as_ref()?;
        let widest = gap.iter().copied().fold(0.0, f64::max);
        Some(gap.iter().map(|g| 1.0 - g / widest).collect())
    })
}
