//! Causes that no library holds and that words can describe: place, driver and kinetics of each stand in [`crate::score::words`].
//!
//! Limits: laws of the literature or of a workshop, none of them one of the forms that a fitter composes; sizes are set by detectability.

pub mod bottoming;
pub mod cold_flow;
pub mod compressor;
pub mod converter_memory;
pub mod cycle_fatigue;
pub mod glass_knee;
pub mod heating_gradient;
pub mod latch;
pub mod motor_pickup;
pub mod thermal_ratchet;
pub mod thixotropy;

/// `ln(1 + e^x)` without overflow: a knee that is soft over a unit of x.
fn softplus(x: f64) -> f64 {
    x.max(0.0) + (-x.abs()).exp().ln_1p()
}

#[cfg(test)]
mod tests {
    use super::softplus;

    #[test]
    fn a_soft_knee_is_straight_far_from_it_and_ln_2_at_it() {
        assert!((softplus(0.0) - 2f64.ln()).abs() < 1e-15);
        assert!((softplus(40.0) - 40.0).abs() < 1e-15 && softplus(-40.0) < 1e-15);
        assert!((softplus(1.0) - (1.0 + 1f64.exp()).ln()).abs() < 1e-15);
    }
}
