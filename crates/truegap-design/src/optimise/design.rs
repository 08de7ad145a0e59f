//! What a search hands on about a design.
//!
//! Limits: a point of the unit cube means nothing without its space.

use serde::{Deserialize, Serialize};

/// A feasible design of a front.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Design {
    /// point of the unit cube
    pub unit: Vec<f64>,
    /// sizes of the three coefficients over those of the starting design
    pub ratios: [f64; 3],
}
