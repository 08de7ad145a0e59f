//! `RIGID-PLATES`: between the beads and beyond the outermost ring a loaded electrode sags.
//!
//! Limits: rings for beads (a ring spans one way only, a bead two), an even load, small deflection; a rigid load plate would prevent it.

use super::warp::{Effect, figure};
use crate::disc::{BeadSpring, Disc, Laminate, Loading, Profile, Strains, refined};
use crate::{
    assumption::Assumption,
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::{Sensor, sensor::Filling};

/// The electrodes stay flat between the beads.
pub(super) struct RigidPlates;

impl Assumption for RigidPlates {
    fn id(&self) -> &'static str {
        "RIGID-PLATES"
    }

    fn says(&self) -> &'static str {
        "the electrode does not bend between the beads nor beyond the outermost ones when it is loaded"
    }

    fn source(&self) -> &'static str {
        "(12), (13): one strain for all beads; against finite elements of the electrode on rings of beads under an even load"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        match sensor.dielectric.filling {
            Filling::Beads { .. } => Ok(()),
            Filling::Solid { .. } => Err("a solid dielectric supports the electrode everywhere".into()),
        }
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let (full, warm) = (study.full_n(), study.device.at(study.options.cold_c));
        let plate = Laminate::electrode(study.sensor);
        let beads = BeadSpring::of_paper(study.sensor, &study.device, &warm, full)?;
        let zones = BeadSpring::zones(study.sensor);
        let row = study.chain(Swap::none()).row(full, study.options.cold_c)?;
        let gap = row.warm.layers.beads * (1.0 - row.squeeze.strain);
        let fem = refined(
            |fineness| {
                let disc = Disc::on_rings(plate.clone(), beads, zones, Strains::Small, fineness)?;
                let shape = disc.profile(&disc.solve(0.0, &Loading::Even(full), &[])?)?;
                Ok(shape)
            },
            |shape: &Profile| 1.0 + (shape.lowest() - shape.mean()) / gap,
        )?;
        let shape = fem.result;
        let flat = Profile::from_fn(1, |_| 0.0);
        let span = (1.0 - beads.coverage) * plate.radius / zones as f64;
        let pressure = full / (std::f64::consts::PI * plate.radius * plate.radius);
        let overhang = pressure * (0.5 * span).powi(4) / (8.0 * plate.bending_stiffness());
        let drawn = figure(study, "Electrode under full load", &[("flat (13)", &flat), ("finite elements, even load", &shape)]);
        let deviation = 1e6 * shape.largest_deviation();
        let device = &study.device;
        let swap = Swap::none().shape(move |warm, force| {
            let curvature = device.capacitances(warm, &device.plain(warm, 0.0, 0.0)).map_or(f64::NAN, |c| c.curvature);
            Ok(shape.times(force / full).plus(&Profile::sphere(curvature, warm.radius)))
        });
        let effect = Effect::of(study, swap)?;
        let mut finding = Measured {
            unit: "",
            analytic: 1.0,
            fem: fem.value,
            error_estimate: fem.error,
            measure: Measure { name: "sag of half a span / gap".into(), value: overhang / gap, limit: 0.002 },
            effect_on: effect.on,
            figure: Some(drawn),
        }
        .finding(self);
        finding.reason += &format!(
            "; values are the least gap over the mean gap; the gap departs by up to {deviation:.2} um from its mean under an even load, not at all \
             under a rigid load plate"
        );
        effect.mark(&mut finding);
        Ok(finding)
    }
}
