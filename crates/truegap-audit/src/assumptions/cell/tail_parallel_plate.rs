//! TAIL-PARALLEL-PLATE: (22) against the field of a trace between two shields.
//!
//! Limits: a straight tail of constant section, as thick as the electrode's conductor, the insulator on all sides of it.

use crate::{
    assumption::Assumption,
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::{Sensor, sensor::Layout};
use truegap_fem::{
    Symmetry,
    electrostatics::{Accuracy, Conductor, Goal, Problem, Quantity, solve_adaptive},
    mesh::{Geometry, MeshOptions, Outline, SizeField, SizeSource, mesh_geometry},
};

/// See the module.
pub(super) struct TailParallelPlate;

/// Distance over width up to which the edge field of a thin trace is less than 1 %: 2 ln 2 / pi per edge pair is 0.88 distances.
const LIMIT: f64 = 0.011;

impl Assumption for TailParallelPlate {
    fn id(&self) -> &'static str {
        "TAIL-PARALLEL-PLATE"
    }

    fn says(&self) -> &'static str {
        "the tail's trace faces its shields like two parallel plates, without a field at its edges"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie (22); against the planar field of a trace as thick as the conductor between two wide shields"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        match sensor.layout {
            Layout::Mutual => Err("a mutual layout does not read its tail".into()),
            Layout::Shielded if sensor.tail.0 * sensor.tail.1 == 0.0 => Err("the sensor has no tail".into()),
            Layout::Shielded => Ok(()),
        }
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let section = Section::of(study.sensor);
        let factor = edge_factor(section, 0.1 * study.options.target)?;
        let analytic = study.chain(Swap::none()).row(0.0, study.options.cold_c)?.parts.shares.tail * 1e12;
        let swap = Swap::none().parts(|_, _, parts| {
            parts.shares.tail *= factor.value;
            Ok(())
        });
        Ok(Measured {
            unit: "pF",
            analytic,
            fem: analytic * factor.value,
            error_estimate: analytic * factor.error_estimate,
            measure: Measure {
                name: "insulator thickness / trace width".into(),
                value: section.distance / section.width,
                limit: LIMIT,
            },
            effect_on: study.effect(swap)?,
            figure: None,
        }
        .finding(self))
    }
}

/// Section of a trace between two shields, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Section {
    /// width of the trace
    pub width: f64,
    /// distance to each shield
    pub distance: f64,
    /// thickness of the trace
    pub thickness: f64,
}

impl Section {
    /// Of a sensor's tail.
    pub(crate) fn of(sensor: &Sensor) -> Self {
        Self { width: sensor.tail.1, distance: sensor.insulator.thickness.value, thickness: sensor.conductor.thickness.value }
    }
}

/// A factor and its estimated error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Factor {
    /// the factor
    pub value: f64,
    /// estimated magnitude of its error
    pub error_estimate: f64,
}

/// Capacitance of a trace between two shields over that of its two faces as parallel plates; the permittivity plays no part.
///
/// **Accuracy:** against elliptic integrals and other programs in `the_edge_field_of_a_trace_is_known`.
///
/// # Errors
/// [`AuditError::Fem`] where the target is not reached.
pub(crate) fn edge_factor(section: Section, target: f64) -> Result<Factor, AuditError> {
    let failed = "field of the tail";
    let Section { width, distance, thickness } = section;
    let (edge, half, top) = (0.5 * width, 0.5 * thickness, 0.5 * thickness + distance);
    let far = edge + 8.0 * distance + 2.0 * thickness;
    let drawing = Geometry::default()
        .region("insulator", Outline::rectangle([0.0, 0.0], [far, top]))
        .region("trace", Outline::rectangle([0.0, 0.0], [edge, half]))
        .boundary("shield", &[[0.0, top], [far, top]])
        .boundary_of("trace", "trace");
    let sources = vec![SizeSource { at: [edge, half], size: 0.05 * distance }];
    let size = SizeField { max_edge: 0.5 * distance, growth: 0.3, sources };
    let mut mesh = mesh_geometry(&drawing, &MeshOptions { size, ..MeshOptions::default() }).map_err(AuditError::fem(failed))?;
    let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    let problem = Problem {
        symmetry: Symmetry::Planar,
        permittivity: vec![("insulator".into(), 1.0), ("trace".into(), 1.0)],
        conductors: vec![conductor("trace", 1.0), conductor("shield", 0.0)],
        open: Vec::new(),
    };
    let goal = Quantity { name: "C".into(), goal: Goal::Capacitance { boundary: "trace".into() } };
    let accuracy = Accuracy { target, max_unknowns: 200_000, ..Accuracy::default() };
    let outcome = solve_adaptive(&problem, &[goal], &mut mesh, &accuracy).map_err(AuditError::fem(failed))?;
    // a quarter of the section: half a face as a plate
    let plate = edge / distance;
    let answer = &outcome.answers[0];
    Ok(Factor { value: answer.value / plate, error_estimate: answer.error_estimate / plate })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_edge_field_of_a_trace_is_known() {
        // C' / eps of a trace 100 um wide, 25 um from each of two shields, for thicknesses in um; converged values of other programs.
        for (thickness, exact) in [(5e-6, 10.276967843), (17e-6, 10.999940878), (35e-6, 11.732440504)] {
            let factor = edge_factor(Section { width: 100e-6, distance: 25e-6, thickness }, 1e-5).unwrap();
            // Two faces as plates: 2 w / d = 8.
            assert!((8.0 * factor.value / exact - 1.0).abs() < 1e-5, "{thickness}: {factor:?}");
            assert!(8.0 * factor.error_estimate < 1e-4 * exact);
        }
    }
}
