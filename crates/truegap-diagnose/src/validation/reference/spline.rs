//! Natural cubic splines with few knots.
//!
//! Limits: knots lie at quantiles; fewer than three apart from one another leave a straight line.

/// Share of the rows below the first knot and above the last.
const TAIL: f64 = 0.05;

/// Columns of a natural cubic spline of `x` beside a constant: `x` itself, then one for each knot but two.
///
/// $$ N_{k+2}(x) = d_k(x) - d_{K-1}(x), \quad d_k(x) = \frac{(x - \xi_k)_+^3 - (x - \xi_K)_+^3}{\xi_K - \xi_k} $$
///
/// Straight beyond the outer knots, so that rows left out are not reached by a cubic. In units of the distance of the outer knots, squared.
///
/// **Source:** Hastie, Tibshirani & Friedman, The Elements of Statistical Learning, 2nd ed., (5.4) and (5.5).
pub(super) fn basis(x: &[f64], knots: usize) -> Vec<Vec<f64>> {
    let mut columns = vec![x.to_vec()];
    let knots = quantiles(x, knots);
    let [.., before, last] = knots[..] else { return columns };
    let width = last - knots[0];
    let cube = |v: f64| v.max(0.0).powi(3);
    let d = |knot: f64, v: f64| (cube(v - knot) - cube(v - last)) / (last - knot);
    for &knot in &knots[..knots.len() - 2] {
        columns.push(x.iter().map(|v| (d(knot, *v) - d(before, *v)) / (width * width)).collect());
    }
    columns
}

/// Different quantiles of a column, ascending, the outer ones [`TAIL`] from its ends.
fn quantiles(x: &[f64], count: usize) -> Vec<f64> {
    let mut sorted = x.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |k: usize| TAIL + (1.0 - 2.0 * TAIL) * k as f64 / (count.max(2) - 1) as f64;
    let value = |share: f64| sorted.get((share * (sorted.len().saturating_sub(1)) as f64).round() as usize).copied();
    let mut list: Vec<f64> = (0..count).filter_map(|k| value(at(k))).collect();
    let least = 1e-3 * (sorted.last().copied().unwrap_or(0.0) - sorted.first().copied().unwrap_or(0.0));
    list.dedup_by(|next, kept| *next - *kept <= least);
    list
}
