//! A rigid flat load plate on a heated plate on rings: where it touches, and what it leaves of the warp.
//!
//! Limits: as [`RingPlate`]; no friction; the load plate touches at nodes; heights are from where the rings carry the load evenly.

use super::banded::Banded;
use super::ring_plate::{Bent, RingPlate};
use crate::error::AuditError;
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

/// A bent plate below a load plate.
#[derive(Clone, Debug, PartialEq)]
pub struct Pressed {
    /// its shape
    pub shape: Bent,
    /// height of the load plate, m
    pub level: f64,
    /// which nodes it touches, from the axis outwards
    pub touching: Vec<bool>,
    /// its force at each node, N
    pub forces: Vec<f64>,
}

/// Sets tried from that of a similar load, and from all nodes.
const PIVOTS: [usize; 2] = [40, 400];
/// A node that is above the load plate by less than this share of the largest deflection touches it.
const SLACK: f64 = 1e-9;

impl RingPlate {
    /// Shape where the plate would have `curvature` (1/m) if it were free and a rigid plate presses with `force_n`: the least energy of [`RingPlate::bent`] less
    /// the work of the load plate, with no node above it,
    ///
    /// $$ w(r_i) \le W, \qquad \lambda_i \ge 0, \qquad \lambda_i (W - w(r_i)) = 0, \qquad \sum_i \lambda_i = F $$
    ///
    /// where rings that carry the load evenly are the zero of w. The set of touching nodes is changed until it agrees with the forces (primal-dual active
    /// set; one node at a time where that does not lead on). `start` is a set to begin with, of a similar load.
    ///
    /// **Source:** Hintermüller, Ito & Kunisch, SIAM J. Optim. 13 (2002) 865. **Accuracy:** `a_large_load_leaves_the_overhang_on_a_prop`, and against the disc by
    /// finite elements in `tests/plate_contact.rs`.
    ///
    /// # Errors
    /// [`AuditError::NotConverged`] where no set agrees.
    pub fn pressed(&self, curvature: f64, force_n: f64, start: Option<&[bool]>) -> Result<Pressed, AuditError> {
        let radii = self.radii();
        let area: f64 = self.rings.iter().map(|ring| PI * (ring.outer * ring.outer - ring.inner * ring.inner)).sum();
        let system = self.system(&radii, curvature, force_n / area);
        // a set of a similar load lacks a few nodes, and changing many at once leads off
        let warm = start.filter(|set| set.len() == radii.len()).map_or_else(|| self.highest(curvature), <[bool]>::to_vec);
        let found = equilibrium(&system, warm, force_n, PIVOTS[0])
            .or_else(|_| equilibrium(&system, vec![true; radii.len()], force_n, PIVOTS[1]));
        let Rest { touching, values, level, mut forces } = found.map_err(|changing| AuditError::NotConverged {
            what: "the set of nodes that the load plate touches",
            at: format!("{curvature} 1/m and {force_n} N"),
            steps: PIVOTS.iter().sum(),
            measure: "the number of nodes that change",
            left: changing as f64,
            target: 0.0,
            remedy: "the load plate finds no place to rest; take another load",
        })?;
        forces.iter_mut().zip(&touching).filter(|(_, on)| !**on).for_each(|(force, _)| *force = 0.0);
        Ok(Pressed { shape: Bent::of(radii, &values), level, touching, forces })
    }
}

impl RingPlate {
    /// The node that a load plate touches first.
    fn highest(&self, curvature: f64) -> Vec<bool> {
        let free = self.bent(curvature, 0.0);
        let top = (0..free.values.len()).max_by(|&a, &b| free.values[a][0].total_cmp(&free.values[b][0]));
        (0..free.values.len()).map(|i| Some(i) == top).collect()
    }
}

/// A set that agrees with its forces.
struct Rest {
    touching: Vec<bool>,
    values: Vec<f64>,
    level: f64,
    forces: Vec<f64>,
}

/// Changes a set until it agrees with the forces: where all nodes touch, all at once while that leads somewhere new, else one node at a time. Without
/// agreement, how many nodes the last step would change.
fn equilibrium(system: &Banded, mut touching: Vec<bool>, force_n: f64, pivots: usize) -> Result<Rest, usize> {
    let (mut seen, mut one) = (BTreeSet::new(), touching.contains(&false));
    let mut changing = touching.len();
    for _ in 0..pivots {
        let (values, level) = below(system, &touching, force_n);
        let forces: Vec<f64> = (0..touching.len()).map(|i| -TAU * system.residual(2 * i, &values)).collect();
        let largest = values.iter().step_by(2).fold(0.0, |most: f64, w| most.max(w.abs()));
        let above = |i: usize| values[2 * i] > level + SLACK * largest;
        let next: Vec<bool> = (0..touching.len()).map(|i| if touching[i] { forces[i] >= 0.0 } else { above(i) }).collect();
        if next == touching {
            return Ok(Rest { touching, values, level, forces });
        }
        changing = next.iter().zip(&touching).filter(|(a, b)| a != b).count();
        one |= !seen.insert(touching.clone());
        change(&mut touching, &next, one);
    }
    Err(changing)
}

/// Heights and slopes below a load plate that holds some nodes, and its height: all is straight in that height, so two solutions tell.
fn below(system: &Banded, touching: &[bool], force_n: f64) -> (Vec<f64>, f64) {
    let held: Vec<usize> = (0..touching.len()).filter(|&i| touching[i]).map(|i| 2 * i).collect();
    let force = |values: &[f64]| -TAU * held.iter().map(|&i| system.residual(i, values)).sum::<f64>();
    let at = |level: f64| {
        let mut fixed = system.clone();
        held.iter().for_each(|&i| fixed.fix(i, level));
        fixed
    };
    let (mut low, high) = (at(0.0), at(UNIT).right);
    let right = std::mem::take(&mut low.right);
    let factored = low.factored();
    let (low, high) = (factored.solve(right), factored.solve(high));
    let pushed = force(&low);
    let share = (force_n - pushed) / (force(&high) - pushed);
    (low.iter().zip(&high).map(|(a, b)| a + share * (b - a)).collect(), UNIT * share)
}

/// A height for the second solution, m: that of a warp.
const UNIT: f64 = 1e-6;

/// Takes over the next set, or only its last difference; a set is never left empty.
fn change(touching: &mut [bool], next: &[bool], one: bool) {
    match (0..next.len()).rev().find(|&i| next[i] != touching[i]) {
        Some(i) if one => touching[i] = next[i],
        _ => touching.copy_from_slice(next),
    }
    if !touching.contains(&true) {
        touching[next.len() - 1] = true;
    }
}
