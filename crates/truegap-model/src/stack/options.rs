//! What the stack takes to be true.
//!
//! Limits: one choice for the whole sensor.

use serde::{Deserialize, Serialize};

/// In which order the layers of the main gap are added up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SeriesOrder {
    /// each layer over the plate, then in series: (21) as printed
    #[default]
    IntegrateThenSeries,
    /// in series at each point, then over the plate: exact for a bent gap
    SeriesThenIntegrate,
}

/// What the base model takes to be true.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct StackOptions {
    /// whether a two-metal electrode warps with temperature
    pub warp: bool,
    /// order of (19) and (21)
    pub series: SeriesOrder,
}

impl Default for StackOptions {
    fn default() -> Self {
        Self { warp: true, series: SeriesOrder::default() }
    }
}
