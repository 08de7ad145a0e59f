//! What is left of the warp on bonded beads, and what it does to the capacitances: a thin plate on rings of springs.
//!
//! Limits: beads as rings, small deflection, field straight across the gap. How fast a rigid load plate presses the rest flat is a formula that was
//! compared with the whole disc (`docs/audit.md`), not a solution of the contact.

use super::{Axis, Table, make, one_sensor::KELVIN};
use crate::{
    AuditError,
    assumptions::cell::filled,
    cell::{Cell, Filled},
    disc::{BeadSpring, Bent, Gap, Laminate, RingPlate, section::Ring, section::rings},
};
use truegap_core::Sensor;

/// A plate, its rings and what lies between it and the shield.
#[derive(Clone, Debug, PartialEq)]
pub struct Warped {
    /// the electrode with the insulator behind it
    pub plate: Laminate,
    /// rings of beads
    pub rings: Vec<Ring>,
    /// insulator on the shield, m
    pub film: f64,
    /// relative permittivities
    pub filled: Filled,
}

/// What a bent electrode does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gains {
    /// relative change of the gap's capacitance
    pub main: f64,
    /// relative change of the capacitance behind the electrode
    pub backing: f64,
}

/// What a bent electrode does, from no load to any.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bends {
    /// without load
    pub free: Gains,
    /// below a rigid plate with a large force, where the rim curls down: the plate lies on the electrode up to the outer edge of the beads
    pub pressed: Gains,
}

impl Warped {
    /// The electrode of a sensor.
    ///
    /// # Errors
    /// [`AuditError::Lacks`] without beads.
    pub fn of(sensor: &Sensor) -> Result<Self, AuditError> {
        let cell = Cell::of(sensor)?;
        let plate = Laminate::backed(sensor);
        let gap = Gap::Rings { height: cell.height, coverage: cell.coverage(), zones: BeadSpring::zones(sensor) };
        let rings = rings(&gap, plate.radius);
        Ok(Self { plate, rings, film: cell.film, filled: filled(sensor) })
    }

    /// Where the free plate would be bent to `curvature` (1/m), over a gap (m) and rings of a stiffness per their area (Pa/m).
    pub fn bends(&self, curvature: f64, gap: f64, stiffness: f64) -> Bends {
        let flat_to = self.rings.last().map_or(0.0, |ring| ring.outer);
        let [free, pressed] = [0.0, flat_to].map(|flat_to| self.on(stiffness, flat_to).bent(curvature, 0.0));
        Bends { free: self.gains(&free, gap, curvature), pressed: self.gains(&pressed, gap, curvature) }
    }

    /// Force on the way from no load to a large one, N: on a rim that curls up, and on the bulge within one that curls down.
    pub fn settling_n(&self, curvature: f64, gap: f64, stiffness: f64) -> [f64; 2] {
        let free = self.on(stiffness, 0.0).bent(curvature, 0.0);
        // inside of the rim the plate goes the other way
        let bulge = free.values.iter().map(|v| -v[0] * curvature.signum()).fold(0.0, f64::max);
        [self.flattening_n(&free, gap, stiffness).abs(), stiffness * self.ring_area() * bulge]
    }

    fn on(&self, stiffness: f64, flat_to: f64) -> RingPlate {
        let plate = &self.plate;
        let (bending, poisson, radius) = (plate.bending_stiffness(), plate.poisson(), plate.radius);
        RingPlate { bending, poisson, radius, stiffness, rings: self.rings.clone(), flat_to }
    }

    fn gains(&self, shape: &Bent, gap: f64, curvature: f64) -> Gains {
        Gains { main: self.main(shape, gap), backing: self.backing(shape, curvature) }
    }

    /// Force on a rim that curls up that takes its effect on the gap away, N.
    fn flattening_n(&self, heated: &Bent, gap: f64, stiffness: f64) -> f64 {
        // a force on the rim bends, and shortens all rings, which the strain of the beads has counted already
        let pushed = self.on(stiffness, 0.0).bent(0.0, PROBE_N);
        let even = PROBE_N / (stiffness * self.ring_area());
        let values = pushed.values.iter().map(|v| [v[0] + even, v[1]]).collect();
        let bends = self.main(&Bent { values, radii: pushed.radii }, gap);
        -self.main(heated, gap) / bends * PROBE_N
    }

    fn ring_area(&self) -> f64 {
        self.rings.iter().map(|ring| std::f64::consts::PI * (ring.outer * ring.outer - ring.inner * ring.inner)).sum()
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

/// What a rigid plate leaves behind the electrode of a rim that curls up: between the places where it touches, the electrode still bends. Found with the
/// whole disc: 5 to 9 % at 2 N, of five sensors.
const RIPPLE: f64 = 0.07;
/// A force so small that all is linear, N.
const PROBE_N: f64 = 1e-3;

/// The gains of one sensor, at analytic speed.
#[derive(Clone, Debug)]
pub(super) struct Warp {
    /// over (temperature above the reference, strain), per kelvin: main and backing, free and then pressed
    tables: [Table; 4],
    curvature_per_kelvin: f64,
    settling_n_per_kelvin: [f64; 2],
}

impl Warp {
    /// The electrode of a sensor; `state` gives gap (m) and stiffness of the beads (Pa/m) at a temperature above the reference and a strain.
    ///
    /// # Errors
    /// What `state` refuses.
    pub fn of(warped: &Warped, state: impl Fn(f64, f64) -> Result<[f64; 2], AuditError>) -> Result<Self, AuditError> {
        let axes = vec![
            Axis::linear("temperature above the reference (K)", KELVIN[0], KELVIN[1], 2),
            Axis::linear("compressive strain", 0.0, make::GREATEST_STRAIN, 2),
        ];
        let curvature_per_kelvin = warped.plate.curvature_per_kelvin();
        let at = |kelvin: f64, strain: f64| -> Result<Bends, AuditError> {
            let [gap, stiffness] = state(kelvin, strain)?;
            Ok(warped.bends(curvature_per_kelvin * kelvin, gap, stiffness))
        };
        let nodes = Table::nodes(&axes);
        let bends = nodes.iter().map(|p| at(p[0], p[1])).collect::<Result<Vec<_>, _>>()?;
        let parts: [fn(&Bends) -> f64; 4] = [|b| b.free.main, |b| b.free.backing, |b| b.pressed.main, |b| b.pressed.backing];
        let tables = parts.map(|of| {
            let values = bends.iter().zip(&nodes).map(|(b, p)| of(b) / p[0]).collect();
            Table::interpolating("warp", "relative change of a capacitance, 1/K", axes.clone(), values)
        });
        let [gap, stiffness] = state(0.0, 0.0)?;
        Ok(Self { tables, curvature_per_kelvin, settling_n_per_kelvin: warped.settling_n(curvature_per_kelvin, gap, stiffness) })
    }

    /// The gains at a temperature above the reference, a strain and the force (N) of a rigid plate.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] beyond the table.
    pub fn gains(&self, kelvin: f64, strain: f64, force_n: f64) -> Result<Gains, AuditError> {
        if kelvin == 0.0 {
            return Ok(Gains::default());
        }
        let at = [kelvin, strain];
        let up = self.curvature_per_kelvin * kelvin >= 0.0;
        let left = self.left(kelvin, force_n);
        let part = |free: usize, ripple: f64| -> Result<f64, AuditError> {
            let table = |place: usize| self.tables[place].at(&at);
            let below = if left == 1.0 {
                0.0
            } else if up {
                ripple * table(free)?
            } else {
                table(free + 2)?
            };
            Ok(kelvin * (left * table(free)? + (1.0 - left) * below))
        };
        Ok(Gains { main: part(0, 0.0)?, backing: part(1, RIPPLE)? })
    }

    /// How far a rigid plate with a force (N) is from having settled: 1 without load.
    ///
    /// A rim that curls up is pressed flat with 1 / (1 + F / F0)², a bulge within one that curls down with 1 / (1 + F / F0).
    fn left(&self, kelvin: f64, force_n: f64) -> f64 {
        let up = self.curvature_per_kelvin * kelvin >= 0.0;
        let settling = (self.settling_n_per_kelvin[usize::from(!up)] * kelvin).abs();
        let share = 1.0 / (1.0 + force_n.max(0.0) / settling);
        if up { share * share } else { share }
    }
}
