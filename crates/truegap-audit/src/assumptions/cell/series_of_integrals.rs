//! SERIES-OF-INTEGRALS: (21) against the field under the bent electrode.
//!
//! Limits: the mixture is one medium, and nothing leaves the plates sideways, so that only the order of series and integral is judged.

use crate::{
    assumption::Assumption,
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::{Row, Swap},
};
use truegap_core::Sensor;
use truegap_fem::{
    Symmetry,
    electrostatics::{Accuracy, Answer, Conductor, Goal, Problem, Quantity, solve_adaptive},
    mesh::{Boundary, BoundaryPath, Geometry, MeshOptions, Outline, SizeField, Step, mesh_geometry},
};
use truegap_model::{
    SeriesOrder, StackOptions,
    equations::{
        integral::BentPlates,
        warp::{Dome, sag},
    },
    stack::Device,
};

/// See the module.
pub(super) struct SeriesOfIntegrals;

/// Rim sag over gap up to which the two orders differ by less than about 1e-4.
const LIMIT: f64 = 0.3;

impl Assumption for SeriesOfIntegrals {
    fn id(&self) -> &'static str {
        "SERIES-OF-INTEGRALS"
    }

    fn says(&self) -> &'static str {
        "bent gap and insulator may each be integrated over the plate and then put in series"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie (21); the exact order is series, then integral (docs/errata.md); against the field under the bent electrode"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        if sensor.plating.is_some() {
            Ok(())
        } else {
            Err("an electrode of one metal stays flat, where both orders are the same".into())
        }
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let row = study.chain(Swap::none()).row(0.0, study.options.hot_c)?;
        let answer = bent_field(study, &row)?;
        let exact = Device::new(study.sensor, StackOptions { series: SeriesOrder::SeriesThenIntegrate, ..study.options.stack });
        let swap = Swap::none().parts(|warm, squeeze, parts| {
            if let Ok(exact) = exact.capacitances(warm, squeeze) {
                parts.shares.main = exact.shares.main;
            }
            Ok(())
        });
        let dome = Dome { curvature: row.parts.curvature, radius: row.warm.radius };
        let bent = (sag(dome, row.warm.radius) / row.warm.layers.beads).abs();
        Ok(Measured {
            unit: "pF",
            analytic: row.parts.shares.main * 1e12,
            fem: answer.value * 1e12,
            error_estimate: answer.error_estimate * 1e12,
            measure: Measure { name: "rim sag / gap, hot".into(), value: bent, limit: LIMIT },
            effect_on: study.effect(swap)?,
            figure: None,
        }
        .finding(self))
    }
}

/// Capacitance of the bent gap with the flat insulator below it, F.
fn bent_field(study: &Study<'_>, row: &Row) -> Result<Answer, AuditError> {
    let failed = "field under the bent electrode";
    let dome = Dome { curvature: row.parts.curvature, radius: row.warm.radius };
    let plates = BentPlates::settled(row.warm.layers.beads, dome);
    let film = row.warm.layers.insulator;
    let size = SizeField::uniform(0.5 * (row.warm.layers.beads + film));
    let drawing = drawing(plates, film);
    let mut mesh = mesh_geometry(&drawing, &MeshOptions { size, ..MeshOptions::default() }).map_err(AuditError::fem(failed))?;
    // the arc ends on the axis but for rounding
    mesh.points.iter_mut().filter(|p| p[0].abs() < 1e-12 * dome.radius).for_each(|p| p[0] = 0.0);
    let vacuum = truegap_core::VACUUM_PERMITTIVITY;
    let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    let problem = Problem {
        symmetry: Symmetry::Axisymmetric,
        permittivity: vec![
            ("beads".into(), row.parts.beads / plates.integral()),
            ("film".into(), vacuum * study.sensor.insulator.material.permittivity),
        ],
        conductors: vec![conductor("bent", 1.0), conductor("flat", 0.0)],
        open: Vec::new(),
    };
    let goal = Quantity { name: "C".into(), goal: Goal::Capacitance { boundary: "bent".into() } };
    let accuracy = Accuracy { target: 0.05 * study.options.target, max_unknowns: 300_000, ..Accuracy::default() };
    let outcome = solve_adaptive(&problem, &[goal], &mut mesh, &accuracy).map_err(AuditError::fem(failed))?;
    Ok(outcome.answers[0].clone())
}

fn drawing(plates: BentPlates, film: f64) -> Geometry {
    let r = plates.dome.radius;
    let height = |at: f64| film + plates.centre_gap + sag(plates.dome, at);
    let arc = Step::Arc { via: [0.6 * r, height(0.6 * r)], to: [0.0, height(0.0)] };
    let rim = [r, height(r)];
    let beads = Outline { start: [0.0, film], steps: vec![Step::Line([r, film]), Step::Line(rim), arc] };
    let mut drawing = Geometry::default()
        .region("film", Outline::rectangle([0.0, 0.0], [r, film]))
        .region("beads", beads)
        .boundary("flat", &[[0.0, 0.0], [r, 0.0]]);
    drawing.boundaries.push(Boundary { name: "bent".into(), path: BoundaryPath::Path(Outline { start: rim, steps: vec![arc] }) });
    drawing
}
