//! What is left of the warp on bonded beads, and what it does to the capacitances: a thin plate on rings of springs.
//!
//! Limits: beads as rings, small deflection, field straight across the gap; a rigid load plate presses a rim that curls up flat in proportion to its
//! force and does nothing to one that curls down.

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
    /// force of a rigid plate that presses it flat, N; negative where pulling would be needed
    pub flattening_n: f64,
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

    /// Without load, where the free plate would be bent to `curvature` (1/m), over a gap (m) and rings of a stiffness per their area (Pa/m).
    pub fn gains(&self, curvature: f64, gap: f64, stiffness: f64) -> Gains {
        let plate = RingPlate {
            bending: self.plate.bending_stiffness(),
            poisson: self.plate.poisson(),
            radius: self.plate.radius,
            stiffness,
            rings: self.rings.clone(),
        };
        let heated = plate.bent(curvature, 0.0);
        let main = self.main(&heated, gap);
        // a force on the rim bends, and shortens all rings, which the strain of the beads has counted already
        let pushed = plate.bent(0.0, PROBE_N);
        let even = PROBE_N / (stiffness * heated.mean_of(|r, _| f64::from(u8::from(self.on_ring(r)))) * self.area());
        let bends = self.main(&Bent { values: pushed.values.iter().map(|v| [v[0] + even, v[1]]).collect(), ..pushed }, gap);
        Gains { main, backing: self.backing(&heated), flattening_n: -main / bends * PROBE_N }
    }

    fn area(&self) -> f64 {
        std::f64::consts::PI * self.plate.radius * self.plate.radius
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

    /// Bending stretches the insulator and, by its Poisson's ratio, thins it: both at the middle of its thickness.
    fn backing(&self, shape: &Bent) -> f64 {
        let Some((film, metals)) = self.plate.sheets.split_last() else { return 0.0 };
        let middle = metals.iter().map(|s| s.thickness).sum::<f64>() + 0.5 * film.thickness - self.plate.neutral();
        -middle / (1.0 - film.poisson) * shape.mean_bending()
    }
}

/// A force so small that all is linear, N.
const PROBE_N: f64 = 1e-3;

/// The gains of one sensor, at analytic speed.
#[derive(Clone, Debug)]
pub(super) struct Warp {
    /// over (temperature above the reference, strain), per kelvin
    main: Table,
    backing: Table,
    flattening_n_per_kelvin: f64,
}

impl Warp {
    /// A flat electrode.
    pub fn none() -> Self {
        let axes = || vec![Axis::linear("temperature above the reference (K)", KELVIN[0], KELVIN[1], 1)];
        let nothing = || Table::interpolating("warp", "", axes(), vec![0.0]);
        Self { main: nothing(), backing: nothing(), flattening_n_per_kelvin: f64::INFINITY }
    }

    /// The electrode of a sensor; `state` gives gap (m) and stiffness of the beads (Pa/m) at a temperature above the reference and a strain.
    ///
    /// # Errors
    /// What `state` refuses.
    pub fn of(warped: &Warped, state: impl Fn(f64, f64) -> Result<[f64; 2], AuditError>) -> Result<Self, AuditError> {
        let axes = vec![
            Axis::linear("temperature above the reference (K)", KELVIN[0], KELVIN[1], 3),
            Axis::linear("compressive strain", 0.0, make::GREATEST_STRAIN, 3),
        ];
        let per_kelvin = warped.plate.curvature_per_kelvin();
        let at = |kelvin: f64, strain: f64| -> Result<Gains, AuditError> {
            let [gap, stiffness] = state(kelvin, strain)?;
            Ok(warped.gains(per_kelvin * kelvin, gap, stiffness))
        };
        let nodes = Table::nodes(&axes);
        let gains = nodes.iter().map(|p| at(p[0], p[1])).collect::<Result<Vec<_>, _>>()?;
        let table = |of: fn(&Gains) -> f64, says: &str| {
            let values = gains.iter().zip(&nodes).map(|(g, p)| of(g) / p[0]).collect();
            Table::interpolating("warp", says, axes.clone(), values)
        };
        Ok(Self {
            main: table(|g| g.main, "relative change of the gap's capacitance, 1/K"),
            backing: table(|g| g.backing, "relative change of the capacitance behind the electrode, 1/K"),
            flattening_n_per_kelvin: at(1.0, 0.0)?.flattening_n,
        })
    }

    /// The gains at a temperature above the reference, a strain and the force (N) of a rigid plate.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] beyond the table.
    pub fn gains(&self, kelvin: f64, strain: f64, force_n: f64) -> Result<Gains, AuditError> {
        let flattening_n = self.flattening_n_per_kelvin * kelvin;
        let left = self.left(kelvin, force_n);
        if left == 0.0 || kelvin == 0.0 {
            return Ok(Gains { flattening_n, ..Gains::default() });
        }
        let at = [kelvin, strain];
        let [main, backing] = [self.main.at(&at)?, self.backing.at(&at)?].map(|g| g * kelvin * left);
        Ok(Gains { main, backing, flattening_n })
    }

    /// Share of the warp that is left below a rigid plate with a force (N).
    pub fn left(&self, kelvin: f64, force_n: f64) -> f64 {
        let flat = self.flattening_n_per_kelvin * kelvin;
        if flat > 0.0 { (1.0 - force_n.max(0.0) / flat).max(0.0) } else { 1.0 }
    }
}
