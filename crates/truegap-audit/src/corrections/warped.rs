//! What is left of the warp on bonded beads below a rigid load plate, and what it does to the capacitances: a thin plate on rings of springs, with contact.
//!
//! Limits: beads as rings, small deflection, field straight across the gap.

use super::{one_sensor::KELVIN, range};
use crate::{
    cell::{Cell, Filled, filled},
    disc::{BeadSpring, Bent, Gap, Laminate, Ring, RingPlate, rings},
    error::AuditError,
};
use truegap_core::{Curve, Sensor};

/// A plate, its rings and what lies between it and the shield.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Warped {
    /// the electrode with the insulator behind it
    pub plate: Laminate,
    /// rings of beads
    pub rings: Vec<Ring>,
    /// insulator on the shield, m
    pub film: f64,
    /// relative permittivities
    pub filled: Filled,
}

/// Beads below a bent electrode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BeadsAt {
    /// their height, m
    pub gap: f64,
    /// slope of their force over their height, per their cold area, Pa/m
    pub stiffness: f64,
}

/// What a bent electrode does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gains {
    /// relative change of the gap's capacitance
    pub main: f64,
    /// relative change of the capacitance behind the electrode
    pub backing: f64,
}

impl Warped {
    /// The electrode of a sensor.
    ///
    /// # Errors
    /// [`AuditError::Lacks`] without beads.
    pub(super) fn of(sensor: &Sensor) -> Result<Self, AuditError> {
        let cell = Cell::of(sensor)?;
        let plate = Laminate::backed(sensor);
        let gap = Gap::Rings { height: cell.height, coverage: cell.coverage(), zones: BeadSpring::zones(sensor) };
        let rings = rings(&gap, plate.radius);
        Ok(Self { plate, rings, film: cell.film, filled: filled(sensor) })
    }

    /// What the electrode does where it would be bent to `curvature` (1/m) if it were free, below a rigid plate with a force (N), and in `start` which nodes
    /// the load plate touches; before, `start` is where it touches under a similar load.
    ///
    /// # Errors
    /// [`AuditError::NotConverged`] where the load plate finds no place to rest.
    fn pressed(&self, curvature: f64, force_n: f64, beads: BeadsAt, start: &mut Option<Vec<bool>>) -> Result<Gains, AuditError> {
        let plate = self.on(beads.stiffness);
        let shape = if force_n > 0.0 {
            let pressed = plate.pressed(curvature, force_n, start.as_deref())?;
            *start = Some(pressed.touching);
            pressed.shape
        } else {
            plate.bent(curvature, 0.0)
        };
        Ok(Gains { main: self.main(&shape, beads.gap), backing: self.backing(&shape, curvature) })
    }

    /// Force on the rim that brings it down to where it would be without heat, N: the scale of the loads that press a warp flat.
    fn flattening_n(&self, curvature: f64, stiffness: f64) -> f64 {
        let plate = self.on(stiffness);
        (plate.bent(curvature, 0.0).rim() / plate.bent(0.0, PROBE_N).rim() * PROBE_N).abs()
    }

    fn on(&self, stiffness: f64) -> RingPlate {
        let plate = &self.plate;
        let (bending, poisson, radius) = (plate.bending_stiffness(), plate.poisson(), plate.radius);
        RingPlate { bending, poisson, radius, stiffness, tilt: 1.0, rings: self.rings.clone() }
    }

    fn on_ring(&self, radius: f64) -> bool {
        self.rings.iter().any(|ring| ring.inner <= radius && radius <= ring.outer)
    }

    /// Field lines go straight across, through bead or air.
    fn main(&self, shape: &Bent, gap: f64) -> f64 {
        let density = |r: f64, w: f64| {
            let between = if self.on_ring(r) { self.filled.bead } else { self.filled.air };
            1.0 / ((gap + w) / between + self.film / self.filled.film)
        };
        let flat = shape.mean_of(|r, _| density(r, 0.0));
        // the face widens by as much as it lies below the neutral plane; what it gains lies in the air at the rim
        let wider = self.plate.neutral() * shape.mean_bending() * density(self.plate.radius, 0.0);
        (shape.mean_of(density) + wider) / flat - 1.0
    }

    /// Bending stretches the insulator and, by its Poisson's ratio, thins it: both at the middle of its thickness, and up to about a thickness of the
    /// plate from its edge, where the stress that does it fades.
    fn backing(&self, shape: &Bent, curvature: f64) -> f64 {
        let Some((film, metals)) = self.plate.sheets.split_last() else { return 0.0 };
        let middle = metals.iter().map(|s| s.thickness).sum::<f64>() + 0.5 * film.thickness - self.plate.neutral();
        let edge = 2.0 * (1.0 + self.plate.poisson()) * curvature * self.plate.thickness() / self.plate.radius;
        -middle / (1.0 - film.poisson) * (shape.mean_bending() - edge)
    }
}

/// A force so small that all is linear, N.
const PROBE_N: f64 = 1e-3;
/// Samples over the load, less one.
const STEPS: usize = 24;
/// Temperatures above the reference at which the gains are taken, K: below and above it, since the plate bends the other way there.
const NODES: [[f64; 2]; 2] = [[0.2 * KELVIN[0], KELVIN[0]], [0.2 * KELVIN[1], KELVIN[1]]];

/// The gains of one sensor, at analytic speed: curves over the load's share s = F / (F + F0) of itself and the force F0 that presses the rim flat.
#[derive(Clone, Debug)]
pub(super) struct Warp {
    /// per kelvin, below and above the reference, at both temperatures of [`NODES`]: main and backing
    curves: [[[Curve; 2]; 2]; 2],
    flattening_n_per_kelvin: f64,
}

impl Warp {
    /// The electrode of a sensor; `state` gives the beads and the force (N) that squeezes them, at a temperature above the reference and a strain.
    ///
    /// # Errors
    /// What `state` refuses, and where a load plate finds no place to rest.
    pub(super) fn of(
        warped: &Warped,
        state: impl Fn(f64, f64) -> Result<(BeadsAt, f64), AuditError>,
    ) -> Result<Self, AuditError> {
        let per_kelvin = warped.plate.curvature_per_kelvin();
        let flattening_n_per_kelvin = warped.flattening_n(per_kelvin, state(0.0, 0.0)?.0.stiffness);
        let at = |kelvin: f64| -> Result<[Curve; 2], AuditError> {
            let scale = (flattening_n_per_kelvin * kelvin).abs();
            let ratio = scale / state(kelvin, range::GREATEST_STRAIN)?.1;
            let (mut main, mut backing, mut start) = (Vec::new(), Vec::new(), None);
            for i in 0..=STEPS {
                // about even in the load's share, closer where the load plate has nearly settled
                let u = 1.0 - (1.0 - i as f64 / STEPS as f64).powf(1.5);
                let (beads, force_n) = state(kelvin, range::GREATEST_STRAIN * u * ratio / (1.0 + ratio - u))?;
                let gains = warped.pressed(per_kelvin * kelvin, force_n, beads, &mut start)?;
                let share = if force_n > 0.0 { force_n / (force_n + scale) } else { 0.0 };
                main.push([share, gains.main / kelvin]);
                backing.push([share, gains.backing / kelvin]);
            }
            Ok([main, backing].map(curve))
        };
        let side = |[near, far]: [f64; 2]| Ok::<_, AuditError>([at(near)?, at(far)?]);
        Ok(Self { curves: [side(NODES[0])?, side(NODES[1])?], flattening_n_per_kelvin })
    }

    /// The gains at a temperature above the reference and the force (N) of a rigid plate.
    pub(super) fn gains(&self, kelvin: f64, force_n: f64) -> Gains {
        if kelvin == 0.0 {
            return Gains::default();
        }
        let side = usize::from(kelvin > 0.0);
        let [near, far] = NODES[side];
        let t = (kelvin - near) / (far - near);
        let force_n = force_n.max(0.0);
        let share = force_n / (force_n + (self.flattening_n_per_kelvin * kelvin).abs());
        // beyond the last sample the load plate has settled
        let at = |curve: &Curve| curve.at(share.min(curve.range()[1]));
        let [main, backing] = [0, 1].map(|part| {
            let [near, far] = [0, 1].map(|node| at(&self.curves[side][node][part]));
            kelvin * (near + t * (far - near))
        });
        Gains { main, backing }
    }
}

fn curve(points: Vec<[f64; 2]>) -> Curve {
    let says = "relative change of a capacitance by bending".into();
    let (argument, value) = ("share of the load".into(), "change".into());
    let (argument_unit, value_unit) = ("1".into(), "1/K".into());
    Curve { id: "warp".into(), says, argument, argument_unit, value, value_unit, points, accuracy: f64::NAN }
}
