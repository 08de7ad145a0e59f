//! NO-FRINGING: the plates as the model has them against electrode and shields of equal radius in open space.
//!
//! Limits: flat plates; shields that reach beyond the electrode hold some of the field that is lost here, so the edge's share depends on them.

use crate::{
    assumption::Assumption,
    assumptions::over_load::over_load,
    cell::{Estimated, Layered},
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::{Row, Swap},
};
use truegap_core::{VACUUM_PERMITTIVITY, sensor::Layout};

/// See the module.
pub(super) struct NoFringing;

/// Gap over radius up to which Kirchhoff's edge term (d / pi a) (ln(16 pi a / d) - 1) of two discs is less than 1 %.
const LIMIT: f64 = 0.0037;

impl Assumption for NoFringing {
    fn id(&self) -> &'static str {
        "NO-FRINGING"
    }

    fn says(&self) -> &'static str {
        "the field ends at the rim of the electrode"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie (1), (19), section III; against the open field of electrode and shields of one radius; two discs: Love, Kirchhoff"
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let edge = Edge::of(study)?;
        let cold = study.options.cold_c;
        let read = |swap| study.chain(swap).capacitance_pf(0.0, cold);
        let (analytic, fem) = (read(Swap::none())?, read(edge.swap())?);
        let curves = [("parallel plates", Swap::none()), ("open field", edge.swap())];
        let figure =
            over_load(study, ("Capacitance with and without the field at the rim", "C (pF)"), curves, |row| row.total * 1e12)?;
        let row = study.chain(Swap::none()).row(0.0, cold)?;
        let gap = row.warm.layers.beads + row.warm.layers.insulator;
        Ok(Measured {
            unit: "pF",
            analytic,
            fem,
            error_estimate: edge.error_estimate * 1e12,
            measure: Measure { name: "gap / radius".into(), value: gap / row.warm.radius, limit: LIMIT },
            effect_on: study.effect(edge.swap())?,
            figure: Some(figure.with_errors(1, edge.error_estimate * 1e12 / fem)),
        }
        .finding(self))
    }
}

/// Capacitance of the rim, logarithmic in the gap of the beads: the form of Kirchhoff's edge term.
struct Edge {
    /// at the gap `rest`, F
    at_rest: f64,
    /// change per factor e of the gap, F
    slope: f64,
    rest: f64,
    error_estimate: f64,
}

impl Edge {
    fn of(study: &Study<'_>) -> Result<Self, AuditError> {
        let chain = study.chain(Swap::none());
        let cold = study.options.cold_c;
        let (free, full) = (chain.row(0.0, cold)?, chain.row(study.full_n(), cold)?);
        let (at_rest, error_estimate) = rim(study, &free)?;
        study.keep_going()?;
        let (loaded, second) = rim(study, &full)?;
        let gap = |row: &Row| row.warm.layers.beads * (1.0 - row.squeeze.strain);
        let slope = (loaded - at_rest) / (gap(&full) / gap(&free)).ln();
        Ok(Self { at_rest, slope, rest: gap(&free), error_estimate: error_estimate.max(second) })
    }

    fn swap(&self) -> Swap<'_> {
        Swap::none().parts(|warm, squeeze, parts| {
            let gap = warm.layers.beads * (1.0 - squeeze.strain);
            parts.shares.main += self.at_rest + self.slope * (gap / self.rest).ln();
            Ok(())
        })
    }
}

/// Capacitance that the open field adds to the parallel plates of a flat, squeezed sensor, and its estimated error, F.
fn rim(study: &Study<'_>, row: &Row) -> Result<(f64, f64), AuditError> {
    let sensor = study.sensor;
    let radius = row.warm.radius;
    let beads = row.warm.layers.beads * (1.0 - row.squeeze.strain);
    let layered = Layered {
        radius,
        backing: (sensor.layout == Layout::Shielded).then_some(row.warm.layers.insulator),
        electrode: sensor.conductor.thickness.value + sensor.plating.as_ref().map_or(0.0, |p| p.thickness.value),
        film: row.warm.layers.insulator,
        beads,
        film_permittivity: VACUUM_PERMITTIVITY * sensor.insulator.material.permittivity,
        // flat at the reference temperature, where the bent plates' integral is area / gap
        bead_permittivity: row.parts.beads * beads / (std::f64::consts::PI * radius * radius),
    };
    let Estimated { value, error_estimate } = layered.rim(0.05 * study.options.target)?;
    Ok((value, error_estimate))
}
