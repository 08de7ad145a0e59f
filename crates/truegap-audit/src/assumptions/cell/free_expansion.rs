//! FREE-EXPANSION: (3) and (4) for the beads against beads whose faces are held by the plates.
//!
//! Limits: perfect bonding; plates expand like the electrode's conductor.

use crate::{
    Assumption, AuditError, Finding, Study, Swap,
    cell::{Cell, Estimated, held_expansion},
    finding::{Measure, Measured},
};
use truegap_core::Sensor;
use truegap_model::stack::Warm;

/// See the module.
pub struct FreeExpansion;

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
        super::needs_beads(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let held = held_expansion(&Cell::of(study.sensor)?)?;
        let growth = Growth::of(study.sensor, held);
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

/// Coefficients of expansion of a bead between plates, 1/K.
#[derive(Clone, Copy, Debug)]
struct Growth {
    free: f64,
    plates: f64,
    height: f64,
}

impl Growth {
    fn of(sensor: &Sensor, held: Estimated) -> Self {
        let (free, plates) = (sensor.dielectric.layer.material.expansion, sensor.conductor.material.expansion);
        Self { free, plates, height: plates + held.value * (free - plates) }
    }

    /// Height as held; mean area by the volume, which expands freely.
    fn apply(&self, warm: &mut Warm) {
        let (free, held) = (1.0 + self.free * warm.kelvin, 1.0 + self.height * warm.kelvin);
        warm.layers.beads *= held / free;
        warm.areas.solid *= free / held;
    }
}
