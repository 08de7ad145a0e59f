//! POLYIMIDE-UNIFORM-STRESS: (14) against a film that is pressed under the beads only and held by its electrode.
//!
//! Limits: small strain; the film behind the electrode is taken to be pressed like the one under the beads.

use super::beads::needs_beads;
use crate::{
    assumption::Assumption,
    cell::Cell,
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::Sensor;
use truegap_fem::{
    FemError, Symmetry,
    elasticity::{Component, Condition, Formulation, LawKind, Material, Order, Problem, Solution, Solver, Temperature},
    mesh::{Geometry, MeshOptions, Outline, SizeField, SizeSource, mesh_geometry},
};
use truegap_model::equations::electrodes::series;

/// See the module.
pub(super) struct PolyimideUniformStress;

/// Strain of the film up to which its law plays no part in a capacitance that is read to 1e-4.
const LIMIT: f64 = 1e-4;

impl Assumption for PolyimideUniformStress {
    fn id(&self) -> &'static str {
        "POLYIMIDE-UNIFORM-STRESS"
    }

    fn says(&self) -> &'static str {
        "the load spreads evenly over the insulator, which yields by its Young's modulus"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie (14); against a film under one bead, bonded to its electrode"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        needs_beads(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let cell = Cell::of(study.sensor)?;
        let failed = "film under a bead";
        let ratio = yielding(study.sensor, &cell, 0.5 * cell.film).map_err(AuditError::fem(failed))?;
        let finer = yielding(study.sensor, &cell, 0.3 * cell.film).map_err(AuditError::fem(failed))?;
        let young = study.sensor.insulator.material.young.value;
        let row = study.chain(Swap::none()).row(study.full_n(), study.options.cold_c)?;
        let strain = study.full_n() / (row.warm.areas.electrode * young);
        let nanometres = strain * cell.film * 1e9;
        let swap = Swap::none().parts(move |warm, squeeze, parts| {
            let strain = squeeze.force_n / (warm.areas.electrode * young);
            let thinner = (1.0 - strain) / (1.0 - finer * strain);
            parts.insulator *= thinner;
            parts.shares.main *= series([parts.beads, parts.insulator]) / series([parts.beads, parts.insulator / thinner]);
            parts.shares.backing *= thinner;
            Ok(())
        });
        Ok(Measured {
            unit: "nm",
            analytic: nanometres,
            fem: nanometres * finer,
            error_estimate: nanometres * (finer - ratio).abs(),
            measure: Measure { name: "strain of the insulator at full load".into(), value: strain, limit: LIMIT },
            effect_on: study.effect(swap)?,
            figure: None,
        }
        .finding(self))
    }
}

/// Mean compression of the film under a bead over that of (14).
fn yielding(sensor: &Sensor, cell: &Cell, edge: f64) -> Result<f64, FemError> {
    let press = 1e-3 * cell.height;
    let film = sensor.insulator.material.young.value;
    let mut solver = Solver::new(problem(sensor, cell, edge, press)?)?;
    let solution = solver.solve()?;
    let force = -solution.reaction("top", Component::Second)?;
    let uniform = force * cell.film / (std::f64::consts::PI * cell.outer * cell.outer * film);
    Ok(-mean_rise(&solution, cell)? / uniform)
}

fn problem(sensor: &Sensor, cell: &Cell, edge: f64, press: f64) -> Result<Problem, FemError> {
    let (low, top) = (cell.film, cell.film + cell.height);
    let drawing = Geometry::default()
        .region("film", Outline::rectangle([0.0, 0.0], [cell.outer, low]))
        .region("bead", Outline::rectangle([0.0, low], [cell.bead, top]))
        .boundary("bottom", &[[0.0, 0.0], [cell.outer, 0.0]])
        .boundary("wall", &[[cell.outer, 0.0], [cell.outer, low]])
        .boundary("top", &[[0.0, top], [cell.bead, top]]);
    let sources = [[cell.bead, low], [cell.bead, top]].map(|at| SizeSource { at, size: 0.05 * edge }).to_vec();
    let size = SizeField { max_edge: 2.0 * edge, growth: 0.25, sources };
    let solid = |m: &truegap_core::sensor::Material| Material {
        young: m.young.value,
        poisson: m.poisson,
        expansion: 0.0,
        law: LawKind::Linear,
        formulation: Formulation::suited(m.poisson),
    };
    use Component::{First, Second};
    let mut conditions: Vec<Condition> =
        [("bottom", First), ("bottom", Second), ("wall", First), ("top", First)].map(|(b, c)| Condition::fix(b, c)).to_vec();
    conditions.push(Condition::displace("top", Second, -press));
    Ok(Problem {
        mesh: mesh_geometry(&drawing, &MeshOptions { size, ..MeshOptions::default() })?,
        symmetry: Symmetry::Axisymmetric,
        materials: vec![solid(&sensor.insulator.material), solid(&sensor.dielectric.layer.material)],
        conditions,
        temperature: Temperature::uniform(0.0),
        body_force: None,
        order: Order::Quadratic,
    })
}

/// Mean displacement of the film's upper side over the cell, m: Simpson's rule in r², separately under the bead and beside it.
fn mean_rise(solution: &Solution, cell: &Cell) -> Result<f64, FemError> {
    const STEPS: usize = 200;
    let part = |low: f64, high: f64| -> Result<f64, FemError> {
        let (low, high) = (low * low, high * high);
        let mut sum = 0.0;
        for i in 0..=STEPS {
            let weight = if i == 0 || i == STEPS {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            };
            let r = (low + (high - low) * i as f64 / STEPS as f64).sqrt();
            sum += weight * solution.displacement_at([r, cell.film])?[1];
        }
        Ok(sum * (high - low) / (3.0 * STEPS as f64))
    };
    Ok((part(0.0, cell.bead)? + part(cell.bead, cell.outer)?) / (cell.outer * cell.outer))
}
