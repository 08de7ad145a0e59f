//! Building blocks of memory: relaxation toward an input, plays.
//!
//! Limits: relaxation is exact for inputs that are linear between samples; plays are exact for any sampling of a monotone path.

/// One step of `tau dq/dt = x - q` over `dt`, x going linearly from `x0` to `x1`.
pub fn relax(q: f64, x0: f64, x1: f64, dt: f64, tau: f64) -> f64 {
    if tau <= 0.0 {
        return x1;
    }
    let h = dt / tau;
    let decay = (-h).exp();
    // Share of the end value in the mean of the ramp seen through the exponential window: 1 - (1 - e^-h)/h.
    let late = if h < 1e-4 { h * (0.5 - h / 6.0) } else { 1.0 - (1.0 - decay) / h };
    decay * q + (1.0 - decay - late) * x0 + late * x1
}

/// Play with half-width `width` : follows `x` only as far as the slack forces it.
pub fn play(before: f64, x: f64, width: f64) -> f64 {
    before.max(x - width).min(x + width)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Many small steps of the exact answer to a ramp, q = t - tau (1 - e^(-t/tau)), against one large step.
    #[test]
    fn relaxation_of_a_ramp_is_exact_for_any_step() {
        for (dt, tau) in [(1.0, 0.3), (1.0, 50.0), (4.0, 1e6), (0.05, 0.003)] {
            let exact = dt - tau * (-(-dt / tau_f(tau)).exp_m1());
            assert!((relax(0.0, 0.0, dt, dt, tau) - exact).abs() < 1e-9 * dt, "{dt} {tau}");
        }
        fn tau_f(tau: f64) -> f64 {
            tau
        }
    }
}
