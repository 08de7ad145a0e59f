//! What the assumptions about the warp share: the paper's sag, the unloaded disc on two meshes, shapes as figures.
//!
//! Limits: shapes at the hot end of the range.

use crate::disc::{Disc, Fineness, Loading, Profile, Refined, refined};
use crate::{
    effect::EffectOn,
    error::AuditError,
    finding::{Curve, Figure, Finding, Verdict},
    study::Study,
    swap::Swap,
};
use truegap_core::Sensor;
use truegap_model::equations::warp::{Dome, rim_sag};

/// A sensor without plating has no warp to speak of.
pub(super) fn warps(sensor: &Sensor) -> Result<(), String> {
    match sensor.plating {
        Some(_) => Ok(()),
        None => Err("the electrode is one metal and does not warp".into()),
    }
}

/// Curvature of (9) at the hot end, 1/m.
pub(super) fn paper_curvature(study: &Study<'_>) -> Result<f64, AuditError> {
    Ok(study.chain(Swap::none()).row(0.0, study.options.hot_c)?.parts.curvature)
}

/// Shape of an unloaded disc so many kelvin above its reference temperature and its rim above centre, um; `make` meshes it.
pub(super) fn warped(kelvin: f64, make: impl Fn(Fineness) -> Result<Disc, AuditError>) -> Result<Refined<Profile>, AuditError> {
    let shape = |fineness| {
        let disc = make(fineness)?;
        disc.profile(&disc.solve(kelvin, &Loading::None, &[])?)
    };
    refined(shape, |shape: &Profile| 1e6 * shape.sag())
}

/// Rim above centre by (9) at the hot end, um.
pub(super) fn paper_sag_um(study: &Study<'_>) -> Result<f64, AuditError> {
    let radius = study.device.at(study.options.hot_c).radius;
    Ok(1e6 * rim_sag(Dome { curvature: paper_curvature(study)?, radius }))
}

/// Shapes of the electrode over its radius; heights above the mean.
pub(super) fn figure(study: &Study<'_>, title: &str, shapes: &[(&str, &Profile)]) -> Figure {
    let millimetres = 0.5e3 * study.sensor.diameter.value;
    let curve = |&(name, shape): &(&str, &Profile)| {
        let mean = shape.mean();
        let at = |i: u32| f64::from(i) / 60.0;
        let points = (0..=60).map(|i| (at(i) * millimetres, 1e6 * (shape.height(at(i)) - mean))).collect();
        Curve { name: name.into(), points, errors: Vec::new() }
    };
    Figure {
        title: title.into(),
        x: "distance from the axis (mm)".into(),
        y: "height above the mean (um)".into(),
        curves: shapes.iter().map(curve).collect(),
    }
}

/// The sphere of (9) at the hot end.
pub(super) fn paper_shape(study: &Study<'_>) -> Result<Profile, AuditError> {
    Ok(Profile::sphere(paper_curvature(study)?, study.device.at(study.options.hot_c).radius))
}

/// What a replaced shape does to the coefficients, or that the plates would touch with it.
pub(super) struct Effect {
    /// changes; none where the plates would touch
    pub on: EffectOn,
    touches: bool,
}

impl Effect {
    /// The effect of a swap.
    pub(super) fn of(study: &Study<'_>, swap: Swap<'_>) -> Result<Self, AuditError> {
        match study.effect(swap) {
            Ok(on) => Ok(Self { on, touches: false }),
            Err(AuditError::NoResponse { .. }) => Ok(Self { on: EffectOn::default(), touches: true }),
            Err(error) => Err(error),
        }
    }

    /// An assumption without which the plates touch is broken.
    pub(super) fn mark(&self, finding: &mut Finding) {
        if self.touches {
            finding.verdict = Verdict::Broken;
            finding.reason += "; with what finite elements find the plates would touch, so there are no coefficients";
        }
    }
}
