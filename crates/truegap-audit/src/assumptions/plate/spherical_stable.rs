//! `SPHERICAL-STABLE`: beyond a critical temperature a free bowl turns into a cylinder.
//!
//! Limits: the critical temperature by finite elements (second variation per harmonic), the shape beyond it by energy with two curvatures.

use super::warp::{Effect, paper_curvature, warps};
use crate::disc::{Disc, Laminate, Loading, Strains, critical_curvature, cylindrical, refined};
use crate::{
    assumption::Assumption,
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::Sensor;
use truegap_fem::elasticity::{NewtonOptions, Solver};

/// The warped electrode stays a body of revolution.
pub(super) struct SphericalStable;

impl Assumption for SphericalStable {
    fn id(&self) -> &'static str {
        "SPHERICAL-STABLE"
    }

    fn says(&self) -> &'static str {
        "the warped electrode stays a spherical cap over the whole range of temperatures and does not buckle into a cylinder"
    }

    fn source(&self) -> &'static str {
        "(9), (18) against the temperature rise at which harmonic 2 of the heated free disc loses its stiffness (finite elements); shape beyond by energy"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        warps(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let range = study.hot_kelvin().abs();
        let plate = Laminate::electrode(study.sensor);
        let fem = refined(|fineness| critical_kelvin(&plate, fineness), |kelvin| *kelvin)?;
        let stays = range < fem.value;
        let swap = if stays { Swap::none() } else { cylindrical(&plate, paper_curvature(study)? / study.hot_kelvin()) };
        let effect = Effect::of(study, swap)?;
        let mut finding = Measured {
            unit: "K",
            analytic: range,
            fem: fem.value,
            error_estimate: fem.error,
            measure: Measure { name: "range / critical temperature rise".into(), value: range / fem.value, limit: 1.0 },
            effect_on: effect.on,
            figure: None,
        }
        .finding(self);
        finding.reason = if stays {
            format!("the free electrode would buckle {:.1} K above the reference; the range ends at {range:.1} K", fem.value)
        } else {
            format!("the free electrode buckles {:.1} K above the reference, within the range; {}", fem.value, finding.reason)
        };
        effect.mark(&mut finding);
        Ok(finding)
    }
}

/// Temperature rise at which the free disc buckles, K.
fn critical_kelvin(plate: &Laminate, fineness: crate::disc::Fineness) -> Result<f64, AuditError> {
    let disc = Disc::free(plate.clone(), Strains::Large, fineness)?;
    let nu = plate.poisson();
    let guess = 2.0 * critical_curvature(plate) / ((1.0 + nu) * plate.curvature_per_kelvin().abs());
    let named = || AuditError::fem("instability of the heated disc");
    let mut solver = Solver::new(disc.problem(1.0, &Loading::None, &[])).map_err(named())?;
    let found = solver.critical_load(2, [0.5 * guess, 1.3 * guess], 1e-4, &NewtonOptions::default()).map_err(named())?;
    Ok(found.load)
}
