//! A lag in closed form, which no model of the workspace takes part in.

/// At rest first, then `y' = (x - y) / tau` with x straight between rows of a second, by the formula for a ramp.
pub fn late(column: &[f64], tau: f64) -> Vec<f64> {
    let keeps = (-1.0 / tau).exp();
    let mut y = column[0];
    let next = |pair: &[f64]| {
        let slope = pair[1] - pair[0];
        y = pair[1] - slope * tau + (y - pair[0] + slope * tau) * keeps;
        y
    };
    std::iter::once(column[0]).chain(column.windows(2).map(next)).collect()
}
