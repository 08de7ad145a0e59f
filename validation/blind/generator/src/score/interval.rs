//! Intervals: how far a count or a median can be trusted.
//!
//! Limits: 95 %, two-sided; cases are taken as independent.

/// Normal quantile of a two-sided 95 % interval.
const Z: f64 = 1.959_963_984_540_054;

/// Wilson's interval for `hits` out of `of`; 0..1 where `of` is zero.
///
/// **Source:** Wilson, J. Am. Stat. Assoc. 22 (1927) 209.
pub fn wilson(hits: usize, of: usize) -> [f64; 2] {
    if of == 0 {
        return [0.0, 1.0];
    }
    let (n, p) = (of as f64, hits as f64 / of as f64);
    let middle = (p + Z * Z / (2.0 * n)) / (1.0 + Z * Z / n);
    let half = Z / (1.0 + Z * Z / n) * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt();
    // Exactly 0 and 1 at the ends, where rounding would leave 1e-17.
    let low = if hits == 0 { 0.0 } else { middle - half };
    let high = if hits == of { 1.0 } else { middle + half };
    [low, high]
}

/// Median of `values` with its interval by ranks; `None` for none.
pub fn median(values: &[f64]) -> Option<(f64, [f64; 2])> {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| !v.is_nan()).collect();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    let n = sorted.len() as f64;
    let reach = 0.5 * Z * n.sqrt();
    let rank = |place: f64| sorted[(place.round().max(0.0) as usize).min(last)];
    let middle = 0.5 * (sorted[last / 2] + sorted[sorted.len() / 2]);
    Some((middle, [rank(0.5 * n - reach - 1.0), rank(0.5 * n + reach)]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Root of the defining equation |p - q| = z sqrt(q (1 - q) / n), the other route to the same limits.
    #[test]
    fn wilson_s_limits_solve_their_equation() {
        for (hits, of) in [(3, 20), (1, 70), (19, 20), (0, 50)] {
            let p = hits as f64 / of as f64;
            for limit in wilson(hits, of).into_iter().filter(|q| *q > 0.0 && *q < 1.0) {
                let z = (p - limit).abs() / (limit * (1.0 - limit) / of as f64).sqrt();
                assert!((z - Z).abs() < 1e-9, "{hits}/{of}: {limit}");
            }
        }
        assert!((wilson(0, 120)[1] - 0.031).abs() < 0.001);
    }

    #[test]
    fn the_median_of_an_even_count_is_the_mean_of_the_middle_two() {
        assert_eq!(median(&[4.0, 1.0, 2.0, 3.0]).map(|(m, _)| m), Some(2.5));
        assert_eq!(median(&[f64::NAN]), None);
    }
}
