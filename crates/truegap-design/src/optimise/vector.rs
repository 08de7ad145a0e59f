//! One design: a compass search from a start.
//!
//! Limits: local; steps along single axes and halving, which also crosses the steps of levels and whole numbers.

/// Lowers `function` (infinite where a design is not allowed) from a point of the unit cube; returns point, value and evaluations.
///
/// **Source:** Hooke and Jeeves (1961), without the pattern move.
pub fn descend(function: impl Fn(&[f64]) -> f64, start: &[f64], evaluations: usize) -> (Vec<f64>, f64, usize) {
    let (mut best, mut value, mut spent, mut step) = (start.to_vec(), function(start), 1, 0.25);
    while step > 1e-7 && spent < evaluations {
        let mut moved = false;
        for d in 0..best.len() {
            for sign in [1.0, -1.0] {
                let mut trial = best.clone();
                trial[d] = (trial[d] + sign * step).clamp(0.0, 1.0); // the edge of the space is part of it
                let new = function(&trial);
                spent += 1;
                if new < value {
                    (best, value, moved) = (trial, new, true);
                    break;
                }
            }
        }
        if !moved {
            step *= 0.5;
        }
    }
    (best, value, spent)
}
