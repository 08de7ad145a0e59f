//! LINEAR-SOFTENING: (7) against a silicone network, whose modulus is proportional to absolute temperature.
//!
//! Limits: the network is ideal and without filler; fillers and free chains soften a real silicone with temperature.

use super::beads::needs_beads;
use crate::{
    assumption::Assumption,
    cell::{Cell, heated_stiffness},
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::{Sensor, units::ABSOLUTE_ZERO_C};

/// See the module.
pub(super) struct LinearSoftening;

/// Difference of the modulus at the hot end up to which the two laws say the same.
const LIMIT: f64 = 0.05;

impl Assumption for LinearSoftening {
    fn id(&self) -> &'static str {
        "LINEAR-SOFTENING"
    }

    fn says(&self) -> &'static str {
        "the modulus of the silicone changes linearly with temperature, by K_SE"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie (7), whose sign is ambiguous (docs/errata.md); against an ideal network, E in proportion to absolute temperature \
         (Treloar, The Physics of Rubber Elasticity), in a bonded bead that heating has strained"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        needs_beads(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let (cell, kelvin) = (Cell::of(study.sensor)?, study.hot_kelvin());
        let (silicone, plates) = (&study.sensor.dielectric.layer.material, &study.sensor.conductor.material);
        let strain = (silicone.expansion - plates.expansion) * kelvin;
        let stiffer = heated_stiffness(&cell, strain, 0.05)?;
        let network = 1.0 + kelvin / (study.sensor.reference_c - ABSOLUTE_ZERO_C);
        let (analytic, fem) = (1.0 + silicone.softening.value * kelvin / silicone.young.value, network * stiffer.value);
        let young = silicone.young.value;
        let swap = Swap::none().warm(move |warm| {
            warm.young = young * (1.0 + (fem - 1.0) * warm.kelvin / kelvin);
            Ok(())
        });
        let name = "modulus at the hot end against that of a network".into();
        let mut finding = Measured {
            unit: "",
            analytic,
            fem,
            error_estimate: network * stiffer.error_estimate,
            measure: Measure { name, value: (analytic / fem - 1.0).abs(), limit: LIMIT },
            effect_on: study.effect(swap)?,
            figure: None,
        }
        .finding(self);
        if (analytic - 1.0) * (fem - 1.0) < 0.0 {
            finding.reason += "; a network stiffens where the model softens: the sign of K_SE stands for fillers or creep, not for rubber elasticity";
        }
        Ok(finding)
    }
}
