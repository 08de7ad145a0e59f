//! MIXING-PARALLEL: (20) and (21) against the field of a bead in its cell.
//!
//! Limits: the bead keeps the model's own shape, a cylinder that spreads by (11), so that only the field is judged.

use super::beads::{greatest_strain, needs_beads};
use crate::{
    assumption::Assumption,
    assumptions::over_load::over_load,
    cell::{Cell, Charged, Filled, Profile, cell_capacitance, filled},
    error::AuditError,
    finding::{Finding, Measure},
    fit::Chebyshev,
    measured::Measured,
    study::Study,
    swap::Swap,
};
use std::f64::consts::PI;
use truegap_core::{Sensor, VACUUM_PERMITTIVITY};
use truegap_model::equations::electrodes::series;

/// See the module.
pub(super) struct MixingParallel;

/// Contrast times insulator share up to which both bounds of the mixture lie within about 1 %.
const LIMIT: f64 = 0.02;

impl Assumption for MixingParallel {
    fn id(&self) -> &'static str {
        "MIXING-PARALLEL"
    }

    fn says(&self) -> &'static str {
        "beads and air side by side act as one layer of the mean permittivity, in series with the insulator"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie (20), (21): an upper bound; against the field in a bead's cell"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        needs_beads(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let mixing = Mixing::of(study)?;
        let swap = || mixing.swap();
        let cold = study.options.cold_c;
        let main = |swap| Ok::<f64, AuditError>(study.chain(swap).row(0.0, cold)?.parts.shares.main * 1e12);
        let (analytic, fem) = (main(Swap::none())?, main(swap())?);
        let curves = [("mean permittivity, (20) and (21)", Swap::none()), ("field in the cell", swap())];
        let figure = over_load(study, ("Main capacitance", "C_main (pF)"), curves, |row| row.parts.shares.main * 1e12)?;
        Ok(Measured {
            unit: "pF",
            analytic,
            fem,
            error_estimate: fem * mixing.relative_error,
            measure: mixing.measure(study),
            effect_on: study.effect(swap())?,
            figure: Some(figure.with_errors(1, mixing.relative_error)),
        }
        .finding(self))
    }
}

/// Field over mixture as a factor that depends on the strain.
pub(super) struct Mixing {
    factor: Chebyshev,
    relative_error: f64,
}

impl Mixing {
    fn of(study: &Study<'_>) -> Result<Self, AuditError> {
        let (cell, filled) = (Cell::of(study.sensor)?, filled(study.sensor));
        let greatest = greatest_strain(study)?;
        let mut points = Vec::new();
        let mut relative_error: f64 = 0.0;
        for i in 0..4 {
            study.keep_going()?;
            let strain = greatest * f64::from(i) / 3.0;
            let profile = Profile::cylinder(strain, cell.poisson);
            let Charged { capacitance, error_estimate, .. } =
                cell_capacitance(&cell, &profile, filled, 0.5 * study.options.target)?;
            relative_error = relative_error.max(error_estimate / capacitance);
            points.push((strain, capacitance / mixed_capacitance(&cell, strain, filled)));
        }
        let factor = Chebyshev::fit(&points, 2, 0.0, greatest)?;
        relative_error += factor.misfit(&points)?;
        Ok(Self { factor, relative_error })
    }

    fn swap(&self) -> Swap<'_> {
        Swap::none().parts(|_, squeeze, parts| {
            parts.shares.main *= self.factor.at(squeeze.strain)?;
            Ok(())
        })
    }

    fn measure(&self, study: &Study<'_>) -> Measure {
        let sensor = study.sensor;
        let filled = filled(sensor);
        let (film, beads) = (sensor.insulator.thickness.value, sensor.dielectric.layer.thickness.value);
        let value = (filled.bead / filled.air - 1.0) * film / beads;
        Measure { name: "(permittivity contrast - 1) x insulator / bead height".into(), value, limit: LIMIT }
    }
}

/// Capacitance of a cell by (11), (20) and (21), F.
pub(crate) fn mixed_capacitance(cell: &Cell, strain: f64, filled: Filled) -> f64 {
    let spread = 1.0 + cell.poisson * strain;
    let mixed = filled.air + (filled.bead - filled.air) * cell.coverage() * spread * spread;
    let area = PI * cell.outer * cell.outer * VACUUM_PERMITTIVITY;
    series([mixed * area / (cell.height * (1.0 - strain)), filled.film * area / cell.film])
}
