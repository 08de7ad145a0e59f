//! Rings that push but do not pull, and a rigid plate that carries a given force.
//!
//! Sets of touching nodes and rings are changed until they agree with the forces (primal-dual active sets); a ring lets go as a whole. Under loads of
//! some thousandths of what presses the warp flat the sets may not settle, which is [`AuditError::NotConverged`].

use super::body::{Disc, Loading};
use crate::error::AuditError;
use std::collections::BTreeSet;
use truegap_fem::elasticity::{Component, Solution};
use truegap_fem::mesh::Point;

/// How the plate rests on the beads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bond {
    /// bonded: beads push and pull
    Bonded,
    /// touching: beads only push
    Touching,
}

/// A bent disc and the rings that carry it.
#[derive(Clone, Debug)]
pub struct Carried {
    /// the equilibrium
    pub solution: Solution,
    /// rings that push (or pull, if bonded)
    pub attached: Vec<bool>,
    /// force of each ring on the plate, N, positive in compression; empty where the beads are one layer or stand on an insulator
    pub forces: Vec<f64>,
    /// force of the load plate, N; zero without one
    pub plate_force: f64,
}

/// Rounds in which sets must settle.
const ROUNDS: usize = 40;
/// Solves at one travel of the load plate.
const PIVOTS: usize = 200;
/// A pull smaller than this share of the mean nodal force is rounding.
const SLACK_FORCE: f64 = 1e-4;
/// A node closer to the plate than this touches it, m.
const SLACK_GAP: f64 = 1e-12;

impl Disc {
    /// Equilibrium without a load plate; touching rings that would pull are let go, those that would be passed are taken back.
    ///
    /// # Errors
    /// Where Newton's method finds no equilibrium; [`AuditError::NotConverged`] where the set of touching rings does not settle, or no ring carries.
    pub fn carried(&self, kelvin: f64, loading: &Loading, bond: Bond) -> Result<Carried, AuditError> {
        let mut attached = vec![true; self.section.rings.len()];
        let at = || format!("{kelvin} K");
        let mut changing = 0;
        for step in 1..=ROUNDS {
            let solution = self.solve(kelvin, loading, &attached)?;
            let forces = self.forces(&solution, &attached)?;
            let next = self.next_rings(&solution, kelvin, bond, &attached, &forces)?;
            if next == attached {
                return Ok(Carried { solution, attached, forces, plate_force: 0.0 });
            }
            if let Some(lifted) = lifted(&next, at, step) {
                return Err(lifted);
            }
            changing = differences(&next, &attached);
            attached = next;
        }
        let what = "the set of rings that push";
        Err(not_converged(what, at(), ROUNDS, ("the number of rings that change", changing as f64, 0.0)))
    }

    /// Equilibrium under a rigid plate that carries `force_n`, to one part in ten thousand.
    ///
    /// # Errors
    /// As [`Disc::carried`]; [`AuditError::NotConverged`] also where no travel of the plate gives the force; [`AuditError::NoBeads`].
    pub fn pressed(&self, kelvin: f64, force_n: f64, bond: Bond) -> Result<Carried, AuditError> {
        let beads = self.beads.ok_or(AuditError::NoBeads { what: "a load plate" })?;
        let stiffness = std::f64::consts::PI * self.plate.radius * self.plate.radius * beads.stiffness();
        let mut contact = Contact::new(self);
        let mut travel = force_n / stiffness - beads.expansion * kelvin * beads.height;
        let (mut low, mut high): (Option<[f64; 2]>, Option<[f64; 2]>) = (None, None);
        let mut left = f64::INFINITY;
        for _ in 0..ROUNDS {
            let carried = self.under_plate(kelvin, travel, bond, &mut contact)?;
            let off = carried.plate_force - force_n;
            if off.abs() < 1e-4 * force_n {
                return Ok(carried);
            }
            left = off.abs();
            if off < 0.0 {
                low = Some([travel, off])
            } else {
                high = Some([travel, off])
            }
            travel = match (low, high) {
                (Some([a, fa]), Some([b, fb])) => (a - fa * (b - a) / (fb - fa)).clamp(a + 0.02 * (b - a), b - 0.02 * (b - a)),
                // The contact area may still grow, so a step short of it is taken back later.
                _ => travel - off / stiffness,
            };
        }
        let told = ("the load plate's distance from its force (N)", left, 1e-4 * force_n);
        Err(not_converged("the travel of the load plate", format!("{kelvin} K and {force_n} N"), ROUNDS, told))
    }

    /// Force (N) of a rigid plate that holds all of the top and has gone down so far (m).
    ///
    /// # Errors
    /// Where Newton's method finds no equilibrium.
    pub fn flattened(&self, kelvin: f64, travel: f64) -> Result<f64, AuditError> {
        let contact = Contact::new(self);
        let all = vec![true; self.section.rings.len()];
        let solution = self.solve(kelvin, &Loading::Plate { travel, touched: contact.touched() }, &all)?;
        Ok(contact.plate_force(&solution))
    }

    /// Equilibrium below a rigid plate that holds all of the top flat, pulling where it must, and carries `force_n`, to one part in ten thousand of
    /// what heats and loads it.
    ///
    /// # Errors
    /// Where Newton's method finds no equilibrium; [`AuditError::NotConverged`] where no travel of the plate gives the force; [`AuditError::NoBeads`].
    pub fn held_flat(&self, kelvin: f64, force_n: f64) -> Result<Carried, AuditError> {
        let beads = self.beads.ok_or(AuditError::NoBeads { what: "a load plate that holds the disc flat" })?;
        let attached = vec![true; self.section.rings.len()];
        let touched = Contact::new(self).touched();
        let at = |travel: f64| -> Result<Carried, AuditError> {
            let solution = self.solve(kelvin, &Loading::Plate { travel, touched: touched.clone() }, &attached)?;
            let plate_force = Contact::new(self).plate_force(&solution);
            Ok(Carried { solution, attached: attached.clone(), forces: Vec::new(), plate_force })
        };
        let area = std::f64::consts::PI * self.plate.radius * self.plate.radius;
        let stiffness = area * beads.stiffness();
        let mut last = at(0.0)?;
        let tolerance_n = 1e-4 * force_n.abs().max(last.plate_force.abs());
        let (mut here, mut slope) = (0.0, stiffness);
        for _ in 0..ROUNDS {
            let off = last.plate_force - force_n;
            if off.abs() <= tolerance_n {
                return Ok(last);
            }
            let step = -off / slope;
            let next = at(here + step)?;
            slope = (next.plate_force - last.plate_force) / step;
            (here, last) = (here + step, next);
        }
        let told = ("the load plate's distance from its force (N)", (last.plate_force - force_n).abs(), tolerance_n);
        Err(not_converged("the travel of a plate that holds the disc flat", format!("{kelvin} K and {force_n} N"), ROUNDS, told))
    }

    /// Equilibrium below a rigid plate at a given travel; `contact` starts from the last one.
    fn under_plate(&self, kelvin: f64, travel: f64, bond: Bond, contact: &mut Contact) -> Result<Carried, AuditError> {
        let mut seen = BTreeSet::new();
        let mut one_by_one = false;
        let at = || format!("{kelvin} K and {travel:.3e} m of travel");
        let mut changing = 0;
        for step in 1..=PIVOTS {
            let touched = contact.touched();
            if touched.is_empty() {
                // Out of reach: the plate carries nothing, and the disc rests as it would without it.
                let carried = self.carried(kelvin, &Loading::None, bond)?;
                *contact = Contact::new(self);
                return Ok(carried);
            }
            let solution = self.solve(kelvin, &Loading::Plate { travel, touched }, &contact.attached)?;
            let nodes = contact.next_nodes(&solution, travel);
            changing = differences(&nodes, &contact.touching);
            if changing > 0 {
                // All at once while that leads somewhere new, then by the rule of the last index, which cannot cycle.
                one_by_one |= !seen.insert(contact.touching.clone());
                contact.change(&nodes, one_by_one);
                continue;
            }
            let forces = self.forces(&solution, &contact.attached)?;
            let rings = self.next_rings(&solution, kelvin, bond, &contact.attached, &forces)?;
            if rings == contact.attached {
                let plate_force = contact.plate_force(&solution);
                return Ok(Carried { solution, attached: rings, forces, plate_force });
            }
            if let Some(lifted) = lifted(&rings, at, step) {
                return Err(lifted);
            }
            contact.attached = rings;
            (one_by_one, seen) = (false, BTreeSet::new());
        }
        let told = ("the number of nodes that change", changing as f64, 0.0);
        Err(not_converged("the set of nodes under the load plate", at(), PIVOTS, told))
    }

    fn forces(&self, solution: &Solution, attached: &[bool]) -> Result<Vec<f64>, AuditError> {
        if self.facing.is_some() {
            return Ok(Vec::new()); // the feet stand on an insulator, not on supports
        }
        let force = |(j, &on): (usize, &bool)| {
            if !on {
                return Ok(0.0);
            }
            solution.reaction(&format!("foot {}", j + 1), Component::Second).map_err(AuditError::fem("force of a ring"))
        };
        attached.iter().enumerate().map(force).collect()
    }

    /// Rings that touch: attached ones that push, and free ones whose top would be passed.
    fn next_rings(
        &self,
        solution: &Solution,
        kelvin: f64,
        bond: Bond,
        attached: &[bool],
        forces: &[f64],
    ) -> Result<Vec<bool>, AuditError> {
        if bond == Bond::Bonded {
            return Ok(attached.to_vec());
        }
        let profile = self.profile(solution)?;
        let grown = self.beads.map_or(0.0, |b| b.expansion * kelvin * b.height);
        // The height that the force of a ring works on: its middle's, not that of the edge that tilts down.
        let above = |j: usize| {
            let ring = self.section.rings[j];
            0.5 * (profile.height(ring.inner / self.plate.radius) + profile.height(ring.outer / self.plate.radius))
        };
        Ok((0..attached.len()).map(|j| if attached[j] { forces[j] > 0.0 } else { above(j) < grown }).collect())
    }
}

/// How many entries of two sets differ.
fn differences(next: &[bool], last: &[bool]) -> usize {
    next.iter().zip(last).filter(|(a, b)| a != b).count()
}

/// What is wrong where all rings let go: nothing carries the plate any more.
fn lifted(next: &[bool], at: impl Fn() -> String, step: usize) -> Option<AuditError> {
    let rings = next.len();
    let told = ("the number of rings that let go", rings as f64, rings as f64 - 1.0);
    (rings > 0 && !next.contains(&true)).then(|| not_converged("the set of rings that push", at(), step, told))
}

/// `told` is what tells how far it came, its value and its greatest value that would have done.
fn not_converged(what: &'static str, at: String, steps: usize, told: (&'static str, f64, f64)) -> AuditError {
    let (measure, left, target) = told;
    let remedy = "take an even load, a larger one, or bonded beads";
    AuditError::NotConverged { what, at, steps, measure, left, target, remedy }
}

/// Nodes of the top and rings, and which of them touch.
struct Contact {
    /// nodes of the top, from the axis outwards
    nodes: Vec<Point>,
    touching: Vec<bool>,
    attached: Vec<bool>,
}

impl Contact {
    fn new(disc: &Disc) -> Self {
        let nodes = disc.section.level(disc.section.top);
        Self { touching: vec![true; nodes.len()], attached: vec![true; disc.section.rings.len()], nodes }
    }

    fn touched(&self) -> Vec<Point> {
        self.nodes.iter().zip(&self.touching).filter(|(_, on)| **on).map(|(p, _)| *p).collect()
    }

    /// Displacement and force of every node of the top, from the axis outwards.
    fn states(&self, solution: &Solution) -> Vec<[f64; 2]> {
        let body = solution.body();
        let mut found: Vec<usize> = body.boundary_nodes("top").unwrap_or_default().into_iter().map(|n| n as usize).collect();
        found.sort_by(|a, b| body.nodes.points[*a][0].total_cmp(&body.nodes.points[*b][0]));
        found.into_iter().map(|n| [solution.nodal(n)[1], solution.support_force(n)[1]]).collect()
    }

    fn plate_force(&self, solution: &Solution) -> f64 {
        let states = self.states(solution);
        -states.iter().zip(&self.touching).filter(|(_, on)| **on).map(|(s, _)| s[1]).sum::<f64>()
    }

    /// Takes over the next set, or only its last difference.
    fn change(&mut self, next: &[bool], one: bool) {
        match (0..next.len()).rev().find(|&i| next[i] != self.touching[i]) {
            Some(i) if one => self.touching[i] = next[i],
            _ => self.touching.copy_from_slice(next),
        }
    }

    fn next_nodes(&self, solution: &Solution, travel: f64) -> Vec<bool> {
        let states = self.states(solution);
        let mean = self.plate_force(solution).abs() / self.nodes.len() as f64;
        let next = |(state, &on): (&[f64; 2], &bool)| {
            if on { state[1] < SLACK_FORCE * mean } else { state[0] > -travel + SLACK_GAP }
        };
        states.iter().zip(&self.touching).map(next).collect()
    }
}
