//! Linear elements as quadratic ones whose middle nodes are constrained to the mean of their ends.
//!
//! Everything that reads a solution sees quadratic nodes; only the unknowns of the system differ.

use super::exterior::{POWERS, UNKNOWNS};
use crate::mesh::Topology;
use crate::space::{ElementDofs, Nodes, Order};

/// The constrained dofs, each the mean of two others: (middle, start, end) of every edge, none in quadratic elements.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct ConstrainedDofs(Vec<[u32; 3]>);

impl ConstrainedDofs {
    pub fn new(order: Order, nodes: &Nodes, topology: &Topology) -> ConstrainedDofs {
        match order {
            Order::Quadratic => ConstrainedDofs::default(),
            Order::Linear => {
                let corners = nodes.corners as u32;
                ConstrainedDofs(topology.edges.iter().zip(corners..).map(|(&[a, b], middle)| [middle, a, b]).collect())
            }
        }
    }

    /// Marks the constrained dofs in a list over all unknowns.
    pub fn mark(&self, marks: &mut [bool]) {
        self.0.iter().for_each(|f| marks[f[0] as usize] = true);
    }

    /// Gives the constrained dofs their values.
    pub fn fill(&self, u: &mut [f64]) {
        for [middle, a, b] in self.0.iter().map(|f| f.map(|i| i as usize)) {
            u[middle] = 0.5 * (u[a] + u[b]);
        }
    }

    /// Moves the forces on constrained dofs to the two dofs of each constraint.
    pub fn gather(&self, load: &mut [f64]) {
        for [middle, a, b] in self.0.iter().map(|f| f.map(|i| i as usize)) {
            load[a] += 0.5 * load[middle];
            load[b] += 0.5 * load[middle];
            load[middle] = 0.0;
        }
    }

    /// Elements without their constrained dofs, or `None` where there are none.
    pub fn without(&self, dofs: &ElementDofs) -> Option<ElementDofs> {
        if self.0.is_empty() {
            return None;
        }
        let mut out = ElementDofs::empty(dofs.count);
        for e in 0..dofs.elements() {
            let of = dofs.of(e);
            let kept: Vec<u32> = kept(of.len()).map(|i| of[i]).collect();
            out.push(&kept);
        }
        Some(out)
    }
}

/// Constraints within an element of `m` unknowns, as local (constrained, one end, other end).
fn constraints(m: usize) -> &'static [[usize; 3]] {
    if m == UNKNOWNS { &[[2 * POWERS, 0, POWERS]] } else { &[[3, 0, 1], [4, 1, 2], [5, 2, 0]] }
}

fn kept(m: usize) -> impl Iterator<Item = usize> {
    (0..m).filter(move |i| constraints(m).iter().all(|f| f[0] != *i))
}

/// Adds a symmetric matrix over `m` unknowns (full) to one without the constrained dofs.
pub(super) fn reduce(full: &mut [f64], m: usize, out: &mut [f64]) {
    for &[middle, a, b] in constraints(m) {
        for i in 0..m {
            let half = 0.5 * full[middle * m + i];
            full[a * m + i] += half;
            full[b * m + i] += half;
        }
        for j in 0..m {
            let half = 0.5 * full[j * m + middle];
            full[j * m + a] += half;
            full[j * m + b] += half;
        }
    }
    for (entry, (j, i)) in out.iter_mut().zip(kept(m).flat_map(|j| kept(m).map(move |i| (j, i)))) {
        *entry += full[j * m + i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reduced_matrix_has_the_energy_of_the_whole_one() {
        let whole: Vec<f64> = (0..36).map(|k| ((k / 6 + k % 6) as f64).sin()).collect();
        let u = [0.3, -1.2, 2.0];
        let all = [u[0], u[1], u[2], 0.5 * (u[0] + u[1]), 0.5 * (u[1] + u[2]), 0.5 * (u[2] + u[0])];
        let mut small = [0.0; 9];
        reduce(&mut whole.clone(), 6, &mut small);
        let energy = |m: usize, k: &[f64], u: &[f64]| -> f64 { (0..m * m).map(|e| u[e / m] * k[e] * u[e % m]).sum() };
        // Sums of 36 terms of size 4: rounding.
        assert!((energy(3, &small, &u) - energy(6, &whole, &all)).abs() < 1e-13);
    }
}
