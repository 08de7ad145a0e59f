//! `SMALL-DEFLECTION`: (9) lets a disc become a sphere at no cost; bending in two directions stretches it.
//!
//! Limits: free electrode that stays a bowl; `SPHERICAL-STABLE` asks whether it does.

use super::warp::{Effect, figure, paper_sag_um, paper_shape, warped, warps};
use crate::disc::{Disc, Laminate, Strains};
use crate::{
    assumption::Assumption,
    error::AuditError,
    finding::{Curve, Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::Sensor;

/// The warp is small against the electrode's thickness.
pub(super) struct SmallDeflection;

impl Assumption for SmallDeflection {
    fn id(&self) -> &'static str {
        "SMALL-DEFLECTION"
    }

    fn says(&self) -> &'static str {
        "the warp is so small against the electrode's thickness that it grows in proportion to the temperature"
    }

    fn source(&self) -> &'static str {
        "(9) against axisymmetric finite elements with large rotations (Saint Venant-Kirchhoff), free electrode"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        warps(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let kelvin = study.hot_kelvin();
        let plate = Laminate::electrode(study.sensor);
        let at = |part: f64| warped(part * kelvin, |fineness| Disc::free(plate.clone(), Strains::Large, fineness));
        let steps = [0.25, 0.5, 0.75].map(at);
        let fem = at(1.0)?;
        study.keep_going()?;
        let mut points = vec![(study.sensor.reference_c, 0.0)];
        let mut errors = vec![0.0];
        for (part, step) in [0.25, 0.5, 0.75].into_iter().zip(steps) {
            let step = step?;
            points.push((study.sensor.reference_c + part * kelvin, step.value));
            errors.push(step.error);
        }
        points.push((study.options.hot_c, fem.value));
        errors.push(fem.error);
        let mut figure = figure(study, "Rim above centre of the free electrode", &[]);
        (figure.x, figure.y) = ("temperature (degC)".into(), "rim above centre (um)".into());
        let analytic = paper_sag_um(study)?;
        let straight = vec![(study.sensor.reference_c, 0.0), (study.options.hot_c, analytic)];
        figure.curves = vec![
            Curve { name: "small deflection (9)".into(), points: straight, errors: Vec::new() },
            Curve { name: "finite elements, large deflection".into(), points, errors },
        ];
        // At the two temperatures of the coefficients: none, and all of it.
        let (hot, sphere) = (fem.result.clone(), paper_shape(study)?);
        let swap = Swap::none().shape(move |warm, _| {
            let t = if kelvin == 0.0 { 0.0 } else { warm.kelvin / kelvin };
            let large = hot.times(t);
            Ok(if t.abs() < 1.0 { sphere.times(t).towards(&large, t.abs()) } else { large })
        });
        let effect = Effect::of(study, swap)?;
        let mut finding = Measured {
            unit: "um",
            analytic,
            fem: fem.value,
            error_estimate: fem.error,
            measure: Measure {
                name: "rim above centre (9) / thickness".into(),
                value: (1e-6 * analytic / plate.thickness()).abs(),
                limit: 0.3,
            },
            effect_on: effect.on,
            figure: Some(figure),
        }
        .finding(self);
        effect.mark(&mut finding);
        Ok(finding)
    }
}
