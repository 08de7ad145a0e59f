//! Radial positions of a disc's mesh: even between given stops, halving towards the rim where bending ends in an edge layer.
//!
//! Limits: one graded end.

/// Positions from 0 to the last of `stops` (increasing, m), at most `step` apart, shrinking to `finest` at the rim.
pub(super) fn columns(stops: &[f64], step: f64, finest: f64) -> Vec<f64> {
    const SHRINK: f64 = 0.6;
    let mut out = vec![0.0];
    let (Some(&rim), inner) = (stops.last(), &stops[..stops.len().saturating_sub(1)]) else { return out };
    for &stop in inner {
        even(&mut out, stop, step);
    }
    let last = out[out.len() - 1];
    let mut left = (rim - last).min(step);
    even(&mut out, rim - left, step);
    while left * SHRINK > finest {
        left *= SHRINK;
        out.push(rim - left);
    }
    out.push(rim);
    out
}

/// Appends equal steps up to `stop`.
fn even(out: &mut Vec<f64>, stop: f64, step: f64) {
    let from = out[out.len() - 1];
    let length = stop - from;
    if length <= 1e-9 * stop.abs().max(step) {
        return;
    }
    let count = (length / step - 1e-9).ceil().max(1.0);
    (1..=count as usize).for_each(|i| out.push(if i as f64 == count { stop } else { from + length * i as f64 / count }));
}

#[cfg(test)]
mod tests {
    use super::columns;

    #[test]
    fn columns_hit_every_stop_and_only_grow_outwards() {
        let stops = [0.3, 0.35, 1.0];
        let c = columns(&stops, 0.1, 0.004);
        assert!(stops.iter().all(|s| c.contains(s)), "{c:?}");
        assert!(c.windows(2).all(|w| w[1] > w[0] && w[1] - w[0] <= 0.1 + 1e-12), "{c:?}");
        let last = c[c.len() - 1] - c[c.len() - 2];
        assert!(last > 0.002 && last < 0.008, "{last}");
    }
}
