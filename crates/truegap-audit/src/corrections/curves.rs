//! The corrections of one sensor as plain curves without a free number, for whoever wants them as effects.
//!
//! Limits: at the sensor's reference temperature and nominal sizes; the ranges of the tables. Each curve says how far off it was measured to be.

use super::{
    library::{Library, library},
    one_sensor::KELVIN,
    pieces::Pieces,
};
use crate::{cell::Cell, error::AuditError};
use truegap_core::{Corrections, Curve, Sensor};
use truegap_model::equations::load::{BeadLaw, compressive_strain, reduced_load};

/// Samples of a curve, less one.
const STEPS: usize = 64;
/// Most that the thin plate of `Warped` was found to be off without load, of the warp's own part: printed by the example `corrected_check` for 24
/// sensors, median 2 %; the two above 14 % have a warp of less than 0.2 % of their span.
const WARP_ACCURACY: f64 = 0.32;

/// The corrections of a sensor.
///
/// **Accuracy:** plugged into the analytic chain they give [`super::Corrected`] again to 0.1 % of the span, `the_curves_in_the_chain_are_the_corrected_model`.
///
/// # Errors
/// As [`super::Corrected::new`]: where the tables do not reach there are no curves.
pub fn curves(sensor: &Sensor) -> Result<Corrections, AuditError> {
    let pieces = Pieces::new(sensor)?;
    let law = BeadLaw { poisson: Cell::of(sensor)?.poisson, stiffening: [0.0; 2] };
    let one = OneSensor { pieces, law, tables: library()?, full_n: sensor.full_scale };
    Ok(Corrections {
        sensor: sensor.name.clone(),
        stiffening: one.stiffening()?,
        bonded_strain: one.bonded_strain()?,
        mixing: one.mixing()?,
        fringing: one.fringing()?,
        warp: one.warp()?,
        warp_left: one.warp_left()?,
        tail_edge_pf: one.tail_edge_pf()?,
        held_growth_per_kelvin: one.pieces.growth.height - one.pieces.growth.free,
        insulator_growth_per_kelvin: one.pieces.layers.behind_per_kelvin,
    })
}

struct OneSensor {
    pieces: Pieces,
    law: BeadLaw,
    tables: &'static Library,
    full_n: f64,
}

/// A quantity and its unit.
type Named = (&'static str, &'static str);
const STRAIN: Named = ("compressive strain of bonded beads", "1");
const RATIO: Named = ("ratio", "1");

impl OneSensor {
    fn stiffening(&self) -> Result<Curve, AuditError> {
        let free = |strain: f64| if strain == 0.0 { 1.0 } else { reduced_load(self.law, strain) / strain };
        let points = sampled(0.0, self.pieces.beads.greatest(), |strain| Ok(self.pieces.beads.secant(strain)? / free(strain)))?;
        let says = "stress of bonded beads over that of sliding ones, (12), at the same strain";
        Ok(curve("stiffening", says, [STRAIN, RATIO], points, self.tables.bead_load.accuracy))
    }

    fn bonded_strain(&self) -> Result<Curve, AuditError> {
        let most = compressive_strain(self.pieces.beads.load(self.pieces.beads.greatest())?, self.law)
            .unwrap_or(self.pieces.beads.greatest());
        // the last sample would lie on the table's end, but for rounding
        let points = sampled(0.0, most * (1.0 - 1e-9), |free| self.pieces.beads.strain(reduced_load(self.law, free)))?;
        let says = "strain of bonded beads under the load that gives sliding ones, (12), the argument";
        let argument = ("compressive strain of sliding beads", "1");
        Ok(curve("bonded_strain", says, [argument, STRAIN], points, self.tables.bead_load.accuracy))
    }

    fn mixing(&self) -> Result<Curve, AuditError> {
        let points = sampled(0.0, self.pieces.beads.greatest(), |strain| self.pieces.field.at(&[0.0, strain]))?;
        let says = "capacitance of the gap by the field around bonded beads over that of (11), (20) and (21) at the same strain";
        Ok(curve("mixing", says, [STRAIN, RATIO], points, self.tables.cell_field.accuracy))
    }

    fn fringing(&self) -> Result<Curve, AuditError> {
        let mut points = sampled(0.0, self.pieces.beads.greatest(), Ok)?;
        for point in &mut points {
            *point = self.fringe(point[0])?;
        }
        points.reverse();
        let says = "capacitance by the field at all rims of the disc over that of the gap, (21)";
        let argument = ("mean separation of the electrodes over their radius", "1");
        Ok(curve("fringing", says, [argument, RATIO], points, self.tables.rim_field.accuracy))
    }

    /// Mean separation over the radius at a strain, and the field at the rim over that between the plates.
    fn fringe(&self, strain: f64) -> Result<[f64; 2], AuditError> {
        let pieces = &self.pieces;
        let warm = pieces.device.warmed_by(0.0);
        let force = self.pieces.beads.load(strain)? * warm.areas.solid * warm.young;
        let row = pieces.device.plain(&warm, force, strain);
        let closed = |_| AuditError::NoResponse { force_n: force, temperature_c: pieces.device.reference_c, strain };
        let parts = pieces.device.capacitances(&warm, &row).map_err(closed)?;
        Ok([parts.aspect, pieces.field_and_rim(&warm, strain, &parts)?[1] / parts.shares.main])
    }

    fn tail_edge_pf(&self) -> Result<f64, AuditError> {
        let warm = self.pieces.device.warmed_by(0.0);
        let row = self.pieces.device.plain(&warm, 0.0, 0.0);
        let closed = |_| AuditError::NoResponse { force_n: 0.0, temperature_c: self.pieces.device.reference_c, strain: 0.0 };
        let tail = self.pieces.device.capacitances(&warm, &row).map_err(closed)?.shares.tail;
        Ok(1e12 * tail * (self.pieces.tail - 1.0))
    }

    fn warp(&self) -> Result<Curve, AuditError> {
        let points = sampled(KELVIN[0], KELVIN[1], |kelvin| {
            let bent = self.pieces.warp.gains(kelvin, 0.0);
            let warm = self.pieces.device.warmed_by(kelvin);
            let row = self.pieces.device.plain(&warm, 0.0, 0.0);
            let closed = |_| AuditError::NoResponse { force_n: 0.0, temperature_c: kelvin, strain: 0.0 };
            let shares = self.pieces.device.capacitances(&warm, &row).map_err(closed)?.shares;
            Ok(1.0 + bent.main + bent.backing * shares.backing / shares.main)
        })?;
        let says = "capacitance of the gap without load over that of flat plates, with what bonded beads leave of the warp; what it does behind the electrode included; its accuracy is that of its distance from 1";
        Ok(curve("warp", says, [("temperature above the reference", "K"), RATIO], points, WARP_ACCURACY))
    }

    fn warp_left(&self) -> Result<Curve, AuditError> {
        // at the middle of what is heated: the forces that press the warp flat are in proportion to it
        let kelvin = 0.5 * KELVIN[1];
        let warm = self.pieces.device.warmed_by(kelvin);
        let row = self.pieces.device.plain(&warm, 0.0, 0.0);
        let closed = |_| AuditError::NoResponse { force_n: 0.0, temperature_c: kelvin, strain: 0.0 };
        let shares = self.pieces.device.capacitances(&warm, &row).map_err(closed)?.shares;
        let added = |force_n: f64| {
            let bent = self.pieces.warp.gains(kelvin, force_n);
            bent.main * shares.main + bent.backing * shares.backing
        };
        let free = added(0.0);
        // most of it happens under little load
        let load = |t: f64| t * t * t;
        let mut points = sampled(0.0, 1.0, |t| if free == 0.0 { Ok(1.0) } else { Ok(added(load(t) * self.full_n) / free) })?;
        points.iter_mut().for_each(|p| p[0] = load(p[0]));
        let says = "share of the warp's effect that a rigid load plate leaves";
        Ok(curve("warp_left", says, [("load over full load", "1"), ("share", "1")], points, WARP_ACCURACY))
    }
}

/// A function at even steps.
fn sampled(low: f64, high: f64, f: impl Fn(f64) -> Result<f64, AuditError>) -> Result<Vec<[f64; 2]>, AuditError> {
    let at = |i: usize| low + (high - low) * i as f64 / STEPS as f64;
    (0..=STEPS).map(|i| Ok([at(i), f(at(i))?])).collect()
}

fn curve(id: &str, says: &str, [argument, value]: [Named; 2], points: Vec<[f64; 2]>, accuracy: f64) -> Curve {
    Curve {
        id: id.into(),
        says: says.into(),
        argument: argument.0.into(),
        argument_unit: argument.1.into(),
        value: value.0.into(),
        value_unit: value.1.into(),
        points,
        accuracy,
    }
}
