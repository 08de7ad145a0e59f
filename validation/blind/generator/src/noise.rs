//! Noise on what is recorded: autocorrelated capacitance, white load and temperature, finite resolution.
//!
//! Limits: AR(1) from row to row, whatever the time between rows; resolutions as in the open recordings.

use crate::draws::Draws;
use serde::{Deserialize, Serialize};

/// Noise of a recording.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Noise {
    /// Standard deviation on capacitance, pF.
    pub sd_pf: f64,
    /// Share of its variance that is autocorrelated; the rest is white.
    pub coloured_share: f64,
    /// Correlation of the autocorrelated part from row to row.
    pub correlation: f64,
    /// Standard deviation on load, N.
    pub force_n: f64,
    /// Standard deviation on temperature, K.
    pub temperature_k: f64,
}

impl Noise {
    /// Nearly white, as most of the open recordings: correlation 0.2 from row to row.
    pub fn white(sd_pf: f64) -> Self {
        Self { sd_pf, coloured_share: 0.4, correlation: 0.5, force_n: 0.005, temperature_k: 0.05 }
    }

    /// Strongly autocorrelated: correlation about 0.6 from row to row.
    pub fn coloured(sd_pf: f64, correlation: f64) -> Self {
        Self { sd_pf, coloured_share: 0.95, correlation, force_n: 0.005, temperature_k: 0.05 }
    }

    /// Whether a test for white noise should fail on it.
    pub fn is_coloured(&self) -> bool {
        self.coloured_share > 0.5
    }

    /// Noise on `rows` readings, pF.
    pub fn capacitance(&self, rows: usize, draws: &mut Draws) -> Vec<f64> {
        let coloured = self.sd_pf * self.coloured_share.sqrt();
        let white = self.sd_pf * (1.0 - self.coloured_share).sqrt();
        let fresh = (1.0 - self.correlation * self.correlation).sqrt();
        let mut memory = draws.normal();
        (0..rows)
            .map(|_| {
                memory = self.correlation * memory + fresh * draws.normal();
                coloured * memory + white * draws.normal()
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 200 000 draws; three standard errors of a correlation are below 0.02 with this memory.
    #[test]
    fn noise_has_the_spread_and_the_memory_it_states() {
        for (noise, first) in [(Noise::white(0.004), 0.2), (Noise::coloured(0.004, 0.63), 0.6)] {
            let values = noise.capacitance(200_000, &mut Draws::of(3, "test"));
            let variance = values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64;
            let lagged = values.windows(2).map(|w| w[0] * w[1]).sum::<f64>() / values.len() as f64;
            assert!((variance.sqrt() / 0.004 - 1.0).abs() < 0.01);
            assert!((lagged / variance - first).abs() < 0.02, "{}", lagged / variance);
        }
    }
}
