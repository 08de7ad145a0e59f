//! Electrostatic cases: from conditions and outputs to the solver and back.

use super::description::{Case, Method, Output, OutputKind};
use super::error::CaseError;
use super::first_mesh::mesh_case;
use super::result::{CaseResult, ErrorsFrom, MeshCounts, SecondsSpent, quantities};
use crate::electrostatics::{
    Accuracy, Conductor, Goal, Order, Outcome, Problem, Quantity, VACUUM_PERMITTIVITY, solve_adaptive, solve_on_with,
};
use crate::error::FemError;
use crate::mesh::Mesh;
use crate::symmetry::Symmetry;
use std::time::Instant;

pub(super) fn solve(case: &Case) -> Result<(CaseResult, Mesh, Outcome), FemError> {
    let problem = problem(case)?;
    let quantities = case.outputs.iter().map(|o| quantity(case, o)).collect::<Result<Vec<_>, _>>()?;
    let begin = Instant::now();
    let mut mesh = mesh_case(case)?;
    let order = if case.mesh.order == 1 { Order::Linear } else { Order::Quadratic };
    let meshing = begin.elapsed().as_secs_f64();
    let outcome = match case.mesh.target_error {
        Some(target) => solve_adaptive(&problem, &quantities, &mut mesh, &Accuracy { target, order, ..Accuracy::default() })?,
        None => solve_on_with(&problem, &quantities, &mesh, order)?,
    };
    Ok((result(&outcome, meshing), mesh, outcome))
}

fn result(outcome: &Outcome, meshing: f64) -> CaseResult {
    let seconds = outcome.seconds;
    CaseResult {
        method: Method::Refine,
        errors: ErrorsFrom::Residuals,
        quantities: quantities(&outcome.answers),
        pressures: Vec::new(),
        mesh: MeshCounts { triangles: outcome.triangles, unknowns: outcome.unknowns },
        seconds: SecondsSpent { mesh: meshing + seconds.mesh, assemble: seconds.assemble, solve: seconds.solve },
    }
}

pub(super) fn problem(case: &Case) -> Result<Problem, CaseError> {
    let permittivity = |(region, &m): (&crate::mesh::Region, &usize)| {
        let material = &case.materials[m];
        let relative = material.relative_permittivity.ok_or_else(|| CaseError::Missing {
            file: case.file.clone(),
            place: format!("material `{}` (of region `{}`)", material.name, region.name),
            what: "relative_permittivity",
            remedy: "electrostatics needs it; vacuum is 1.0",
        })?;
        Ok::<_, CaseError>((region.name.clone(), relative * VACUUM_PERMITTIVITY))
    };
    let mut conductors = Vec::new();
    let mut open = Vec::new();
    for c in &case.conditions {
        match (c.potential, c.open) {
            (Some(potential), false) => conductors.push(Conductor { boundary: c.boundary.clone(), potential }),
            (None, true) => open.push(c.boundary.clone()),
            (None, false) => {
                let remedy = "a conductor needs potential = \"1 V\", a far side open = true; a wall without normal field needs no boundary at all";
                return Err(CaseError::Missing {
                    file: case.file.clone(),
                    place: format!("boundary `{}`", c.boundary),
                    what: "its potential",
                    remedy,
                });
            }
            (Some(_), true) => {
                let what = "an open boundary has no potential; remove one of the two".into();
                return Err(CaseError::Invalid { file: case.file.clone(), place: format!("boundary `{}`", c.boundary), what });
            }
        }
    }
    Ok(Problem {
        symmetry: case.symmetry,
        permittivity: case.geometry.regions.iter().zip(&case.region_materials).map(permittivity).collect::<Result<_, _>>()?,
        conductors,
        open,
    })
}

pub(super) fn quantity(case: &Case, output: &Output) -> Result<Quantity, CaseError> {
    let at = output.at.unwrap_or([f64::NAN; 2]);
    let goal = match output.kind {
        OutputKind::Capacitance => Goal::Capacitance { boundary: output.boundary.clone().unwrap_or_default() },
        OutputKind::CapacitanceMatrix => Goal::CapacitanceMatrix,
        OutputKind::Energy => Goal::Energy,
        OutputKind::Potential => Goal::Potential { at },
        OutputKind::Field => Goal::Field { at, component: component(case, output)? },
        _ => {
            return Err(CaseError::UnknownWord {
                file: case.file.clone(),
                place: format!("output `{}` of an electrostatic case, kind", output.name),
                found: format!("{:?}", output.kind).to_lowercase(),
                known: "capacitance, capacitance_matrix, energy, potential, field".into(),
            });
        }
    };
    Ok(Quantity { name: output.name.clone(), goal })
}

fn component(case: &Case, output: &Output) -> Result<usize, CaseError> {
    let names = match case.symmetry {
        Symmetry::Axisymmetric => ["r", "z"],
        Symmetry::Planar => ["x", "y"],
    };
    let found = output.component.as_deref().unwrap_or("(none)");
    names.iter().position(|n| *n == found).ok_or_else(|| CaseError::UnknownWord {
        file: case.file.clone(),
        place: format!("output `{}`, component", output.name),
        found: found.into(),
        known: names.join(", "),
    })
}
