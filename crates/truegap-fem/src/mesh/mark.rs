//! Which triangles to halve: the fewest that carry a given share of the estimated error.

/// Marks the largest of `shares` (non-negative) until they sum to `fraction` of the total.
///
/// **Source:** Dörfler (1996), bulk criterion.
pub fn mark_largest(shares: &[f64], fraction: f64) -> Vec<bool> {
    let total: f64 = shares.iter().sum();
    let mut order: Vec<u32> = (0..shares.len() as u32).collect();
    order.sort_by(|&a, &b| shares[b as usize].total_cmp(&shares[a as usize]));
    let mut marked = vec![false; shares.len()];
    let mut sum = 0.0;
    for i in order {
        if sum >= fraction * total {
            break;
        }
        marked[i as usize] = true;
        sum += shares[i as usize];
    }
    marked
}
