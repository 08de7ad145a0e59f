//! `LAYERS-OUTSIDE-IGNORED`: what is bonded behind the electrode bends with it.
//!
//! Limits: the insulator of the sensor file only; shields and covers behind it are not described there and would stiffen the electrode further.

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

/// Only the two metals of the electrode bend.
pub(super) struct LayersOutsideIgnored;

impl Assumption for LayersOutsideIgnored {
    fn id(&self) -> &'static str {
        "LAYERS-OUTSIDE-IGNORED"
    }

    fn says(&self) -> &'static str {
        "the insulator bonded behind the electrode does not change its warp"
    }

    fn source(&self) -> &'static str {
        "(9), text: where only the centre electrode is said to matter; against finite elements with the insulator bonded on, small deflection"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        warps(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let kelvin = study.hot_kelvin();
        let (bare, plate) = (Laminate::electrode(study.sensor), Laminate::backed(study.sensor));
        let fem = warped(kelvin, |fineness| Disc::free(plate.clone(), Strains::Small, fineness))?;
        let stretching = |p: &Laminate| p.sheets.iter().map(|s| s.young * s.thickness).sum::<f64>();
        let effect = Effect::of(study, shaped(&fem.result, kelvin))?;
        let mut finding = Measured {
            unit: "um",
            analytic: paper_sag_um(study)?,
            fem: fem.value,
            error_estimate: fem.error,
            measure: Measure {
                name: "E h of the layers outside / E h of the metals".into(),
                value: stretching(&plate) / stretching(&bare) - 1.0,
                limit: 0.003,
            },
            effect_on: effect.on,
            figure: Some(figure(
                study,
                "Free electrode with the insulator behind it at the hot end",
                &[("two metals (9)", &paper_shape(study)?), ("finite elements, insulator bonded", &fem.result)],
            )),
        }
        .finding(self);
        finding.reason += &format!(
            "; rim above centre by plate theory {:.3} um with the insulator, {:.3} um without",
            1e6 * plate.free_sag(kelvin),
            1e6 * bare.free_sag(kelvin)
        );
        effect.mark(&mut finding);
        Ok(finding)
    }
}
