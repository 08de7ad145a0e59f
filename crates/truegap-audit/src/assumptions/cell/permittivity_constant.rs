//! PERMITTIVITY-CONSTANT: one permittivity at all temperatures against polymers that thin out as they expand.
//!
//! Limits: density only, by Clausius and Mossotti, without a free number; dipoles and water act beside it with either sign, so that it is no lower bound.

use crate::{
    assumption::Assumption,
    cell::{Cell, Filled, Profile, cell_capacitance, filled},
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::sensor::{Filling, Material};

/// See the module.
pub(super) struct PermittivityConstant;

/// Drift of the baseline by permittivity, over the span, up to which it does not matter.
const LIMIT: f64 = 0.01;

impl Assumption for PermittivityConstant {
    fn id(&self) -> &'static str {
        "PERMITTIVITY-CONSTANT"
    }

    fn says(&self) -> &'static str {
        "silicone and polyimide have one permittivity at all temperatures"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie, Table 1; against (eps - 1) / (eps + 2) in proportion to density (Clausius and Mossotti; Kittel, Introduction to Solid State Physics, ch. 16) \
         with the sensor's own expansions, in the field of the bead cell"
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let sensor = study.sensor;
        let (beads, insulator) = (&sensor.dielectric.layer.material, &sensor.insulator.material);
        let swap = || {
            Swap::none().squeeze(|warm, row| {
                row.beads *= thinned(beads, warm.kelvin) / beads.permittivity;
                row.insulator *= thinned(insulator, warm.kelvin) / insulator.permittivity;
                Ok(())
            })
        };
        let hot = study.chain(Swap::none()).row(0.0, study.options.hot_c)?;
        let replaced = study.chain(swap()).row(0.0, study.options.hot_c)?;
        let (factor, relative_error) = main_factor(study)?.unwrap_or((replaced.parts.shares.main / hot.parts.shares.main, 0.0));
        let beside = study.device.beside(&replaced.parts.shares);
        let main = hot.parts.shares.main * factor;
        let drift = (replaced.total - hot.total).abs() * 1e12 / study.base().span_pf;
        Ok(Measured {
            unit: "pF",
            analytic: hot.total * 1e12,
            fem: (main + beside) * 1e12,
            error_estimate: main * relative_error * 1e12,
            measure: Measure {
                name: "baseline drift by permittivity, cold to hot, over the span".into(),
                value: drift,
                limit: LIMIT,
            },
            effect_on: study.effect(swap())?,
            figure: None,
        }
        .finding(self))
    }
}

/// Permittivity of a material that has expanded.
fn thinned(material: &Material, kelvin: f64) -> f64 {
    let stretch = 1.0 + material.expansion * kelvin;
    let filling = (material.permittivity - 1.0) / (material.permittivity + 2.0) / (stretch * stretch * stretch);
    (1.0 + 2.0 * filling) / (1.0 - filling)
}

/// Field of the bead cell with hot permittivities over that with cold ones, and its relative error; `None` without beads.
fn main_factor(study: &Study<'_>) -> Result<Option<(f64, f64)>, AuditError> {
    let sensor = study.sensor;
    if !matches!(sensor.dielectric.filling, Filling::Beads { .. }) {
        return Ok(None);
    }
    let (cell, cold) = (Cell::of(sensor)?, filled(sensor));
    let kelvin = study.hot_kelvin();
    let hot = Filled {
        bead: thinned(&sensor.dielectric.layer.material, kelvin),
        film: thinned(&sensor.insulator.material, kelvin),
        ..cold
    };
    let rest = Profile::cylinder(0.0, cell.poisson);
    let solve = |filled| cell_capacitance(&cell, &rest, filled, 0.1 * study.options.target);
    let (before, after) = (solve(cold)?, solve(hot)?);
    let relative = before.error_estimate / before.capacitance + after.error_estimate / after.capacitance;
    Ok(Some((after.capacitance / before.capacitance, relative)))
}
