//! FREE-BEAD-SPREAD: (11) and (12) against beads that stick to both plates.
//!
//! Limits: perfect bonding; a bead that slides a little lies between the two.

use super::beads::needs_beads;
use crate::{
    assumption::Assumption,
    assumptions::over_load::over_load,
    cell::{Cell, Law, bonded_law},
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::Sensor;

/// See the module.
pub(super) struct FreeBeadSpread;

/// Shape factor up to which bonding stiffens a nearly incompressible bead by less than 10 %: 1 + 2 S² < 1.1.
const LIMIT: f64 = 0.22;

impl Assumption for FreeBeadSpread {
    fn id(&self) -> &'static str {
        "FREE-BEAD-SPREAD"
    }

    fn says(&self) -> &'static str {
        "beads slide freely on the plates and stay cylinders while they are squeezed"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie (11), (12); against bonded neo-Hookean beads at finite strain; shape factor after Gent & Lindley (1959)"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        needs_beads(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let cell = Cell::of(study.sensor)?;
        let law = bonded_law(study)?;
        let swap = || bonded(&law);
        let (full, cold) = (study.full_n(), study.options.cold_c);
        let strain = |swap| Ok::<f64, AuditError>(study.chain(swap).row(full, cold)?.squeeze.strain);
        let (analytic, fem) = (strain(Swap::none())?, strain(swap())?);
        let curves = [("free beads, (12)", Swap::none()), ("bonded beads, finite elements", swap())];
        let figure =
            over_load(study, ("Strain of the beads", "compressive strain (%)"), curves, |row| 100.0 * row.squeeze.strain)?;
        Ok(Measured {
            unit: "",
            analytic,
            fem,
            error_estimate: fem * law.relative_error,
            measure: Measure {
                name: "shape factor, bead diameter / (4 height)".into(),
                value: cell.shape_factor(),
                limit: LIMIT,
            },
            effect_on: study.effect(swap())?,
            figure: Some(figure.with_errors(1, law.relative_error)),
        }
        .finding(self))
    }
}

/// The chain with bonded beads.
pub(super) fn bonded(law: &Law) -> Swap<'_> {
    Swap::none().strain(|warm, force| law.strain(force / (warm.areas.solid * warm.young)))
}
