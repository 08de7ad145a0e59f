//! FREE-EXPANSION: (3) and (4) for the beads against beads whose faces are held by the plates.
//!
//! Limits: perfect bonding; plates expand like the electrode's conductor.

use super::beads::needs_beads;
use crate::{
    assumption::Assumption,
    cell::{Cell, Growth, held_expansion},
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::Sensor;

/// See the module.
pub(super) struct FreeExpansion;

/// Excess of the held expansion of the height up to which it may be called free.
const LIMIT: f64 = 0.05;

impl Assumption for FreeExpansion {
    fn id(&self) -> &'static str {
        "FREE-EXPANSION"
    }

    fn says(&self) -> &'static str {
        "beads expand with temperature as if the plates did not hold their faces"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie (3), (4); against a bead bonded to plates that expand like copper; bounds 1 and (1 + nu) / (1 - nu)"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        needs_beads(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let held = held_expansion(&Cell::of(study.sensor)?)?;
        let growth = Growth::of(study.sensor, held.value);
        let swap = Swap::none().warm(move |warm| {
            growth.apply(warm);
            Ok(())
        });
        Ok(Measured {
            unit: "ppm/K",
            analytic: growth.free * 1e6,
            fem: growth.height * 1e6,
            error_estimate: held.error_estimate * (growth.free - growth.plates).abs() * 1e6,
            measure: Measure {
                name: "held over free expansion of the height, less 1".into(),
                value: held.value - 1.0,
                limit: LIMIT,
            },
            effect_on: study.effect(swap)?,
            figure: None,
        }
        .finding(self))
    }
}
