//! Sizes of the unit cell, and the profile of a bead.

use crate::error::AuditError;
use std::f64::consts::PI;
use truegap_core::{Sensor, sensor::Filling};

/// Radius and height.
type Point = [f64; 2];

/// The cylinder that one bead stands in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// radius of the bead, m
    pub bead: f64,
    /// height of the bead, m
    pub height: f64,
    /// radius of the bead's share of the electrode, m
    pub outer: f64,
    /// thickness of the insulating film below the bead, m
    pub film: f64,
    /// Poisson's ratio of the bead
    pub poisson: f64,
}

impl Cell {
    /// The cell of a sensor at its reference temperature.
    ///
    /// # Errors
    /// [`AuditError::Lacks`] where the dielectric has no beads.
    pub fn of(sensor: &Sensor) -> Result<Self, AuditError> {
        let Filling::Beads { count, diameter } = sensor.dielectric.filling else {
            return Err(AuditError::Lacks { sensor: sensor.name.clone(), part: "beads" });
        };
        Ok(Self {
            bead: 0.5 * diameter.value,
            height: sensor.dielectric.layer.thickness.value,
            outer: 0.5 * sensor.diameter.value / f64::from(count).sqrt(),
            film: sensor.insulator.thickness.value,
            poisson: sensor.dielectric.layer.material.poisson,
        })
    }

    /// Loaded over free area of a bead: diameter / (4 height).
    pub fn shape_factor(&self) -> f64 {
        0.5 * self.bead / self.height
    }

    /// Face of the bead, m².
    pub(crate) fn face(&self) -> f64 {
        PI * self.bead * self.bead
    }

    /// Share of the electrode that the beads cover.
    pub fn coverage(&self) -> f64 {
        let ratio = self.bead / self.outer;
        ratio * ratio
    }
}

/// Side of a squeezed bead from its lower face to its upper one, over the radius and the height of the bead at rest: `(r, z)` with z from 0 to 1 - strain.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// compressive strain
    pub strain: f64,
    /// points from the lower to the upper face
    pub points: Vec<Point>,
}

impl Profile {
    /// A profile from the points of a side, without those that lie on a plate or hardly bend the line.
    pub fn new(strain: f64, points: Vec<Point>) -> Self {
        let top = 1.0 - strain;
        let on_plate = |z: f64| {
            if z < SNAP {
                0.0
            } else if z > top - SNAP {
                top
            } else {
                z
            }
        };
        let mut points: Vec<Point> = points.into_iter().map(|p| [p[0], on_plate(p[1])]).collect();
        // where the side lies on a plate, only its outermost point counts
        let first = points.iter().rposition(|p| p[1] == 0.0).unwrap_or(0);
        points.drain(..first);
        let last = points.iter().position(|p| p[1] == top).unwrap_or(points.len().saturating_sub(1));
        points.truncate(last + 1);
        Self { strain, points: simplified(&points) }
    }

    /// A cylinder that spreads by its Poisson's ratio: (11) of the paper.
    pub fn cylinder(strain: f64, poisson: f64) -> Self {
        let radius = 1.0 + poisson * strain;
        Self { strain, points: vec![[radius, 0.0], [radius, 1.0 - strain]] }
    }

    /// Greatest radius, over the radius at rest.
    pub fn belly(&self) -> f64 {
        self.points.iter().map(|p| p[0]).fold(0.0, f64::max)
    }

    /// Volume over that at rest, cones between the points.
    pub fn volume(&self) -> f64 {
        let frustum = |w: &[Point]| (w[1][1] - w[0][1]) * (w[0][0] * w[0][0] + w[0][0] * w[1][0] + w[1][0] * w[1][0]) / 3.0;
        self.points.windows(2).map(frustum).sum()
    }
}

/// Distance, over the height, within which a point lies on a plate.
const SNAP: f64 = 1e-4;
/// Greatest distance of a dropped point from the line that replaces it.
const FLAT: f64 = 2e-5;

/// Drops points that lie on the line between their neighbours (Douglas and Peucker).
fn simplified(points: &[Point]) -> Vec<Point> {
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return Vec::new() };
    let along = [last[0] - first[0], last[1] - first[1]];
    let off = |p: &Point| (along[0] * (p[1] - first[1]) - along[1] * (p[0] - first[0])).abs() / along[0].hypot(along[1]);
    let farthest = (1..points.len().saturating_sub(1)).max_by(|&a, &b| off(&points[a]).total_cmp(&off(&points[b])));
    match farthest.filter(|&k| off(&points[k]) > FLAT) {
        None => vec![first, last],
        Some(k) => {
            let mut kept = simplified(&points[..=k]);
            kept.pop();
            kept.extend(simplified(&points[k..]));
            kept
        }
    }
}
