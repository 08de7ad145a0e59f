//! `WARP-UNDER-LOAD`: (9) gives the same radius at full load; a load plate presses the electrode onto its beads.
//!
//! Limits: beads that touch but do not pull (bonded ones are `BEADS-DO-NOT-HOLD`), rings for beads, a rigid load plate without friction, small
//! deflection.

use super::warp::{Effect, figure, paper_sag_um, paper_shape, warps};
use crate::disc::{BeadSpring, Bond, Carried, Disc, Fineness, Laminate, Profile, Strains};
use crate::{
    assumption::Assumption,
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::{Sensor, sensor::Filling};

/// The electrode keeps its warp under load.
pub(super) struct WarpUnderLoad;

/// Shares of the full load at which the shape is computed beside the whole.
const SHARES: [f64; 2] = [0.02, 0.1];

impl Assumption for WarpUnderLoad {
    fn id(&self) -> &'static str {
        "WARP-UNDER-LOAD"
    }

    fn says(&self) -> &'static str {
        "the electrode keeps the curvature of (9) under load"
    }

    fn source(&self) -> &'static str {
        "(9), (18) at full load against finite elements: electrode between a rigid load plate and rings of beads that push but do not pull"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        warps(sensor)?;
        match sensor.dielectric.filling {
            Filling::Beads { .. } => Ok(()),
            Filling::Solid { .. } => Err("a solid dielectric has no beads to touch".into()),
        }
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let plate = Laminate::electrode(study.sensor);
        let full = study.full_n();
        let coarse = self.pressed(study, &plate, full, Fineness::COARSE)?.1;
        let (carried, hot) = self.pressed(study, &plate, full, Fineness { columns: 64, rows: 1 })?;
        let sphere = paper_shape(study)?;
        let mut shapes = vec![(0.0, sphere.clone())];
        let mut not_converged = String::new();
        for share in SHARES {
            study.keep_going()?;
            match self.pressed(study, &plate, share * full, Fineness::COARSE) {
                Ok((_, shape)) => shapes.push((share * full, shape)),
                // Between the neighbours in load the shape is interpolated.
                Err(AuditError::NotConverged { .. }) => {
                    not_converged += &format!("; contact does not settle at {:.3} N", share * full)
                }
                Err(error) => return Err(error),
            }
        }
        shapes.push((full, hot.clone()));
        let light = shapes[1].clone();
        let kelvin = study.hot_kelvin();
        let analytic = paper_sag_um(study)?;
        let pressure = full / (std::f64::consts::PI * plate.radius * plate.radius);
        let resisting = 1e-6 * analytic.abs() * plate.bending_stiffness() / plate.radius.powi(4);
        let figure = figure(
            study,
            "Electrode at the hot end, free and under full load",
            &[
                ("(9), any load", &sphere),
                ("finite elements, full load", &hot),
                (&format!("finite elements, {:.3} N", light.0), &light.1),
            ],
        );
        let swap = Swap::none().shape(move |warm, force| {
            let t = if kelvin == 0.0 { 0.0 } else { warm.kelvin / kelvin };
            Ok(between(&shapes, force).times(t))
        });
        let effect = Effect::of(study, swap)?;
        let mut finding = Measured {
            unit: "um",
            analytic,
            fem: 1e6 * hot.sag(),
            error_estimate: 1e6 * (hot.sag() - coarse.sag()).abs(),
            measure: Measure { name: "pressure R^4 / (64 D sag)".into(), value: pressure / (64.0 * resisting), limit: 0.05 },
            effect_on: effect.on,
            figure: Some(figure),
        }
        .finding(self);
        let carrying = carried.attached.iter().filter(|on| **on).count();
        finding.reason += &format!("; at full load {carrying} of {} rings of beads carry", carried.attached.len());
        finding.reason += &not_converged;
        effect.mark(&mut finding);
        Ok(finding)
    }
}

impl WarpUnderLoad {
    fn pressed(
        &self,
        study: &Study<'_>,
        plate: &Laminate,
        force_n: f64,
        fineness: Fineness,
    ) -> Result<(Carried, Profile), AuditError> {
        let beads = BeadSpring::of_paper(study.sensor, &study.device, &study.device.at(study.options.hot_c), force_n)?;
        let disc = Disc::on_rings(plate.clone(), beads, BeadSpring::zones(study.sensor), Strains::Small, fineness)?;
        let carried = disc.pressed(study.hot_kelvin(), force_n, Bond::Touching)?;
        let shape = disc.profile(&carried.solution)?;
        Ok((carried, shape))
    }
}

/// The shape at a force between those of increasing forces.
fn between(shapes: &[(f64, Profile)], force: f64) -> Profile {
    let after = shapes.partition_point(|s| s.0 < force).clamp(1, shapes.len() - 1);
    let ((a, low), (b, high)) = (&shapes[after - 1], &shapes[after]);
    high.towards(low, ((b - force) / (b - a)).max(0.0))
}
