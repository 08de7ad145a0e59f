//! `BIMETAL-STRIP`: (9) is a strip's curvature; a disc bends in two directions.
//!
//! Limits: free electrode of two metals, small deflection.

use super::warp::{Effect, figure, paper_sag_um, paper_shape, warped, warps};
use crate::disc::{Disc, Laminate, Strains, shaped};
use crate::{
    assumption::Assumption,
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
};
use truegap_core::Sensor;

/// The curvature of a disc is that of a strip of the same two layers.
pub(super) struct BimetalStrip;

impl Assumption for BimetalStrip {
    fn id(&self) -> &'static str {
        "BIMETAL-STRIP"
    }

    fn says(&self) -> &'static str {
        "the electrode curves like a strip of its two metals, although a disc bends in two directions at once"
    }

    fn source(&self) -> &'static str {
        "(9) against biaxial plate theory (E / (1 - nu) for E) and axisymmetric finite elements, small deflection"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        warps(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let kelvin = study.hot_kelvin();
        let plate = Laminate::electrode(study.sensor);
        let fem = warped(kelvin, |fineness| Disc::free(plate.clone(), Strains::Small, fineness))?;
        let ratio = plate.sheets.first().zip(plate.sheets.last()).map_or(1.0, |(a, b)| (1.0 - b.poisson) / (1.0 - a.poisson));
        let theory = 1e6 * plate.free_sag(kelvin);
        let effect = Effect::of(study, shaped(&fem.result, kelvin))?;
        let mut finding = Measured {
            unit: "um",
            analytic: paper_sag_um(study)?,
            fem: fem.value,
            error_estimate: fem.error,
            measure: Measure {
                name: "|biaxial over uniaxial modulus ratio - 1|".into(),
                value: (ratio - 1.0).abs(),
                limit: 0.05,
            },
            effect_on: effect.on,
            figure: Some(figure(
                study,
                "Free electrode at the hot end, small deflection",
                &[("strip (9)", &paper_shape(study)?), ("finite elements", &fem.result)],
            )),
        }
        .finding(self);
        finding.reason += &format!("; rim above centre at +{kelvin} K: plate theory {theory:.3} um");
        effect.mark(&mut finding);
        Ok(finding)
    }
}
