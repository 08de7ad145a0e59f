//! Directions that spread a search over a front.
//!
//! Limits: one to three objectives are laid out evenly; every weight is at least 0.001, so no objective is forgotten.

/// About `count` weight vectors that add up to 1.
///
/// **Source:** the simplex lattice of Das and Dennis (1998).
pub(super) fn directions<const M: usize>(count: usize) -> Vec<[f64; M]> {
    let points = |steps: usize| (1..M).fold(1, |n, k| n * (steps + k) / k);
    let steps = (1..=count.max(2)).rev().find(|&s| points(s) <= count).unwrap_or(1);
    let mut all = Vec::new();
    lattice::<M>(steps, 0, steps, &mut [0; M], &mut all);
    all
}

fn lattice<const M: usize>(steps: usize, axis: usize, left: usize, now: &mut [usize; M], all: &mut Vec<[f64; M]>) {
    if axis + 1 == M {
        now[axis] = left;
        all.push(now.map(|n| (n as f64 / steps as f64).max(1e-3)));
        return;
    }
    for n in 0..=left {
        now[axis] = n;
        lattice(steps, axis + 1, left - n, now, all);
    }
}
