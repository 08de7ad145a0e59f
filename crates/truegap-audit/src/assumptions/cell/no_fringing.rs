//! NO-FRINGING: the plates as the model has them against electrode and shields of equal radius in open space.
//!
//! Limits: flat plates; shields that reach beyond the electrode hold some of the field that is lost here, so the edge's share depends on them.

use crate::{
    Assumption, AuditError, Finding, Study, Swap,
    assumptions::over_load,
    finding::{Measure, Measured},
    swap::Row,
};
use truegap_core::{VACUUM_PERMITTIVITY, sensor::Layout};
use truegap_fem::{
    Symmetry,
    mesh::{Geometry, MeshOptions, Outline, SizeField, SizeSource, mesh_geometry},
    physics::electrostatics::{Accuracy, Conductor, Goal, Problem, Quantity, solve_adaptive},
};

/// See the module.
pub struct NoFringing;

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
    let failed = "field at the rim";
    let sensor = study.sensor;
    let shielded = sensor.layout == Layout::Shielded;
    let stack = Stack {
        radius: row.warm.radius,
        backing: shielded.then_some(row.warm.layers.insulator),
        electrode: sensor.conductor.thickness.value + sensor.plating.as_ref().map_or(0.0, |p| p.thickness.value),
        film: row.warm.layers.insulator,
        beads: row.warm.layers.beads * (1.0 - row.squeeze.strain),
    };
    let area = std::f64::consts::PI * stack.radius * stack.radius;
    let film = VACUUM_PERMITTIVITY * sensor.insulator.material.permittivity;
    // flat at the reference temperature, where the bent plates' integral is area / gap
    let beads = row.parts.beads * stack.beads / area;
    let (value, error) = stack.solve(film, beads, 0.05 * study.options.target).map_err(AuditError::fem(failed))?;
    let main = area / (stack.beads / beads + stack.film / film);
    let backing = stack.backing.map_or(0.0, |thickness| film * area / thickness);
    Ok((value - main - backing, error))
}

/// Flat layers of one radius, from the lower shield upwards, m.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stack {
    radius: f64,
    backing: Option<f64>,
    electrode: f64,
    film: f64,
    beads: f64,
}

impl Stack {
    /// Capacitance of the electrode against shields and infinity, and its estimated error, F.
    fn solve(&self, film: f64, beads: f64, target: f64) -> Result<(f64, f64), truegap_fem::FemError> {
        let r = self.radius;
        let heights = [0.0, self.electrode, self.electrode + self.film, self.electrode + self.film + self.beads];
        let mut sources = heights.map(|z| SizeSource { at: [r, z], size: 0.1 * self.film }).to_vec();
        let layer = |low: f64, high: f64| Outline::rectangle([0.0, low], [r, high]);
        let far = 2.0 * r;
        let mut drawing = Geometry::default()
            .region("space", Outline::rectangle([0.0, -far], [far, far]))
            .region("electrode", layer(heights[0], heights[1]))
            .region("film", layer(heights[1], heights[2]))
            .region("beads", layer(heights[2], heights[3]))
            .boundary_of("electrode", "electrode")
            .boundary("upper", &[[0.0, heights[3]], [r, heights[3]]])
            .boundary("far", &[[0.0, -far], [far, -far], [far, far], [0.0, far]]);
        let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
        let mut conductors = vec![conductor("electrode", 1.0), conductor("upper", 0.0)];
        let mut permittivity: Vec<(String, f64)> =
            [("space", VACUUM_PERMITTIVITY), ("electrode", VACUUM_PERMITTIVITY), ("film", film), ("beads", beads)]
                .map(|(name, value)| (name.to_owned(), value))
                .to_vec();
        if let Some(backing) = self.backing {
            drawing = drawing.region("backing", layer(-backing, 0.0)).boundary("lower", &[[0.0, -backing], [r, -backing]]);
            conductors.push(conductor("lower", 0.0));
            permittivity.push(("backing".into(), film));
            sources.push(SizeSource { at: [r, -backing], size: 0.1 * backing });
        }
        let size = SizeField { max_edge: 0.3 * r, growth: 0.35, sources };
        let mut mesh = mesh_geometry(&drawing, &MeshOptions { size, ..MeshOptions::default() })?;
        let problem = Problem { symmetry: Symmetry::Axisymmetric, permittivity, conductors, open: vec!["far".into()] };
        let goal = Quantity { name: "C".into(), goal: Goal::Capacitance { boundary: "electrode".into() } };
        let accuracy = Accuracy { target, max_unknowns: 400_000, ..Accuracy::default() };
        let outcome = solve_adaptive(&problem, &[goal], &mut mesh, &accuracy)?;
        Ok((outcome.answers[0].value, outcome.answers[0].error_estimate))
    }
}
