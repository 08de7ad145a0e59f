//! `saturation`: the reading bends over near the end of the converter's range.
//!
//! Limits: memoryless; the ceiling is set by this recording. The size is the share of the recording's span beyond the ceiling.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::state::{Scene, State};

/// Ceiling at (1 - s) of the span, rounded off over a tenth of what is cut: `ceiling - w ln(1 + exp((ceiling - c)/w))`.
#[derive(Debug, Clone)]
pub struct Saturation;

/// Nothing to draw.
pub fn draw(_: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Saturation)
}

impl Mechanism for Saturation {
    fn id(&self) -> &'static str {
        "saturation"
    }
    fn size_start(&self) -> f64 {
        0.005
    }
    fn size_limit(&self) -> f64 {
        0.5
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_of_span_cut", size)])
    }
    fn readout(&self, size: f64, _: Scene, state: &mut State) {
        let low = state.reading.iter().copied().fold(f64::INFINITY, f64::min);
        let high = state.reading.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let cut = size * (high - low);
        let (ceiling, width) = (high - cut, 0.1 * cut);
        for reading in &mut state.reading {
            let room = (ceiling - *reading) / width;
            let soft = if room > 40.0 { room } else { room.exp().ln_1p() };
            *reading = ceiling - width * soft;
        }
    }
}
