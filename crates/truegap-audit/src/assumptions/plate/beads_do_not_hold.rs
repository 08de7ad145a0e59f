//! `BEADS-DO-NOT-HOLD`: bonded beads are springs that press the warp flat.
//!
//! Limits: beads as an even layer with the model's own stiffness; whether real beads are bonded is for recordings to decide.

use super::warp::{Effect, figure, paper_curvature, paper_sag_um, paper_shape, warped, warps};
use crate::disc::{BeadSpring, Disc, Foundation, Laminate, Profile, Strains, shaped};
use crate::{
    assumption::Assumption,
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
};
use truegap_core::Sensor;

/// The beads do not hold the warping electrode down.
pub(super) struct BeadsDoNotHold;

impl Assumption for BeadsDoNotHold {
    fn id(&self) -> &'static str {
        "BEADS-DO-NOT-HOLD"
    }

    fn says(&self) -> &'static str {
        "the beads do not hold the electrode: it warps as if it were free (`the forces are small`)"
    }

    fn source(&self) -> &'static str {
        "text at Fig. 3, (9), (18) against finite elements on a bonded layer of the beads' stiffness, and the plate on springs in closed form"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        warps(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let kelvin = study.hot_kelvin();
        let plate = Laminate::electrode(study.sensor);
        let beads = BeadSpring::of_paper(study.sensor, &study.device, &study.device.at(study.options.hot_c), 0.0)?;
        let fem = warped(kelvin, |fineness| Disc::on_layer(plate.clone(), beads, Strains::Small, fineness))?;
        let springs = foundation(&plate, &beads);
        let closed = springs.held(plate.curvature_per_kelvin() * kelvin);
        let closed = closed.map(|held| Profile::from_fn(200, |share| held.height(share * plate.radius)));
        let sphere = paper_shape(study)?;
        let mut shapes = vec![("free (9)", &sphere), ("bonded: finite elements", &fem.result)];
        shapes.extend(closed.as_ref().map(|shape| ("bonded: plate on springs", shape)));
        let effect = Effect::of(study, shaped(&fem.result, kelvin))?;
        let mut finding = Measured {
            unit: "um",
            analytic: paper_sag_um(study)?,
            fem: fem.value,
            error_estimate: fem.error,
            measure: Measure { name: "radius / (D / k)^(1/4)".into(), value: plate.radius / springs.length(), limit: 1.0 },
            effect_on: effect.on,
            figure: Some(figure(study, "Electrode at the hot end, free and on bonded beads", &shapes)),
        }
        .finding(self);
        finding.reason += &states(study, &plate, &beads, closed.as_ref())?;
        effect.mark(&mut finding);
        Ok(finding)
    }
}

/// The plate on its beads.
pub(super) fn foundation(plate: &Laminate, beads: &BeadSpring) -> Foundation {
    Foundation {
        bending: plate.bending_stiffness(),
        poisson: plate.poisson(),
        radius: plate.radius,
        stiffness: beads.stiffness(),
    }
}

/// Bonded, touching and lifted off, in words.
fn states(study: &Study<'_>, plate: &Laminate, beads: &BeadSpring, closed: Option<&Profile>) -> Result<String, AuditError> {
    let springs = closed.map_or(String::new(), |shape| format!(" (plate on springs: {:.3} um)", 1e6 * shape.sag()));
    // The largest pull that holding the plate flat takes, at the rim: the moment is carried over a length of the springs.
    let foundation = foundation(plate, beads);
    let pull =
        foundation.held(paper_curvature(study)?).map_or(f64::NAN, |held| held.height(plate.radius)) * beads.young / beads.height;
    Ok(format!(
        "; bonded beads flatten all but a rim about {:.2} mm wide{springs} and pull there with up to {:.0} kPa of bead area; beads that only touch let \
         an unloaded electrode go and leave it free, and so do beads that have lifted off",
        1e3 * std::f64::consts::SQRT_2 * foundation.length(),
        1e-3 * pull.abs()
    ))
}
