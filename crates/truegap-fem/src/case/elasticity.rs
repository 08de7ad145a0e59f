//! Elastic cases: from conditions and outputs to the solver and back.
//!
//! Rubber (Poisson's ratio from 0.45 on) is solved in the mixed formulation; a boundary of a single point is a pin.

use super::contact;
use super::description::{Case, Law, Method};
use super::elastic_outputs::quantity;
use super::error::CaseError;
use super::first_mesh::mesh_case;
use super::result::{CaseResult, ErrorsFrom, MeshCounts, PressureActs, SecondsSpent, quantities};
use crate::elasticity::{
    Accuracy, Acts, Body, Component, Condition, Formulation, LawKind, Material, Order, Outcome, Place, PressureLoad, Problem,
    Temperature, solve_goals, solve_goals_adaptive,
};
use crate::error::FemError;
use crate::mesh::{BoundaryPath, Mesh};
use std::sync::Arc;
use std::time::Instant;

pub(super) fn solve(case: &Case) -> Result<(CaseResult, Outcome), FemError> {
    let has_plates = case.conditions.iter().any(|c| c.plate.is_some());
    let begin = Instant::now();
    let mut problem = problem(case, mesh_case(case)?)?;
    check_following(case, &problem)?;
    let meshing = begin.elapsed().as_secs_f64();
    if has_plates {
        let outcome = contact::solve(case, &mut problem)?;
        return Ok((CaseResult { errors: ErrorsFrom::Meshes, ..result(&outcome, meshing) }, outcome));
    }
    let quantities = case.outputs.iter().map(|o| quantity(case, o)).collect::<Result<Vec<_>, _>>()?;
    let outcome = match case.mesh.target_error {
        Some(target) => solve_goals_adaptive(&mut problem, &quantities, &Accuracy { target, ..Accuracy::default() })?,
        None => solve_goals(&problem, &quantities)?,
    };
    Ok((result(&outcome, meshing), outcome))
}

/// A pressure that is asked to follow must have a material that knows large strain behind all of it.
pub(super) fn check_following(case: &Case, problem: &Problem) -> Result<(), FemError> {
    let body = Body::new(problem.clone())?;
    let asked =
        |name: &str| case.conditions.iter().any(|c| c.boundary == name && c.pressure_load == Some(PressureLoad::Following));
    if let Some((boundary, ..)) = body.pressures().into_iter().find(|(b, _, acts)| *acts == Acts::SmallStrain && asked(b)) {
        let what = "the material there has law = \"linear\", small strain, which knows only the undeformed surface; \
                    leave pressure_load out, or give the material law = \"neo-hookean\"";
        let place = format!("boundary `{boundary}`, pressure_load");
        return Err(CaseError::Invalid { file: case.file.clone(), place, what: what.into() }.into());
    }
    Ok(())
}

fn result(outcome: &Outcome, meshing: f64) -> CaseResult {
    let body = outcome.solution.body();
    CaseResult {
        method: Method::Refine,
        errors: ErrorsFrom::Residuals,
        quantities: quantities(&outcome.answers),
        pressures: body
            .pressures()
            .into_iter()
            .map(|(boundary, pressure_pa, acts)| PressureActs { boundary, pressure_pa, acts: acts.word() })
            .collect(),
        mesh: MeshCounts { triangles: body.problem.mesh.triangles.len(), unknowns: body.numbering.free.len() },
        seconds: SecondsSpent {
            mesh: meshing + outcome.seconds[0],
            assemble: outcome.assembling,
            solve: outcome.seconds[1] - outcome.assembling,
        },
    }
}

/// The elastic problem of a case on a mesh of its geometry.
pub fn problem(case: &Case, mesh: Mesh) -> Result<Problem, FemError> {
    if case.mesh.order != 2 {
        let what = "elasticity is solved with order 2; remove `order` or set it to 2".into();
        return Err(CaseError::Invalid { file: case.file.clone(), place: "mesh, order".into(), what }.into());
    }
    let regions = case.geometry.regions.iter().zip(&case.region_materials);
    let mut materials = Vec::new();
    for name in &mesh.region_names {
        if let Some((_, &m)) = regions.clone().find(|(r, _)| r.name == *name) {
            materials.push(material(case, name, m)?);
        }
    }
    let mut conditions = Vec::new();
    for c in &case.conditions {
        conditions.extend(condition(case, c)?);
        conditions.extend(contact::obstacle(case, c, &mesh)?);
    }
    let temperature = temperature(case, &mesh)?;
    Ok(Problem { mesh, symmetry: case.symmetry, materials, conditions, temperature, body_force: None, order: Order::Quadratic })
}

fn temperature(case: &Case, mesh: &Mesh) -> Result<Temperature, CaseError> {
    let (field, symmetry) = (case.temperature, case.symmetry);
    if field.is_linear() {
        return Ok(Temperature::Linear { base: field.base, gradient: field.gradient });
    }
    if let Some(p) = mesh.points.iter().find(|&&p| !field.at(symmetry, p).is_finite()) {
        let what = format!("is infinite at {p:?} m, in the body; keep the axis and the origin out of it, or leave the term out");
        return Err(CaseError::Invalid { file: case.file.clone(), place: "temperature".into(), what });
    }
    Ok(Temperature::Field(Arc::new(move |p| field.at(symmetry, p))))
}

fn material(case: &Case, region: &str, index: usize) -> Result<Material, CaseError> {
    let m = &case.materials[index];
    let needs = |value: Option<f64>, what| {
        value.ok_or_else(|| CaseError::Missing {
            file: case.file.clone(),
            place: format!("material `{}` (of region `{region}`)", m.name),
            what,
            remedy: "elasticity needs it",
        })
    };
    let poisson = needs(m.poisson, "poisson")?;
    let (law, formulation) = match m.law {
        Law::Linear => (LawKind::Linear, Formulation::suited(poisson)),
        Law::NeoHookean => (LawKind::NeoHookean, Formulation::suited(poisson)),
        Law::StVenantKirchhoff => (LawKind::SaintVenantKirchhoff, Formulation::Displacement),
    };
    Ok(Material { young: needs(m.young, "young")?, poisson, expansion: m.expansion, law, formulation })
}

fn condition(case: &Case, c: &super::Condition) -> Result<Vec<Condition>, CaseError> {
    if c.potential.is_some() || c.open {
        let what = "an elastic body has no potential and no open boundary; remove them".into();
        return Err(CaseError::Invalid { file: case.file.clone(), place: format!("boundary `{}`", c.boundary), what });
    }
    let mut out = Vec::new();
    for (k, component) in [Component::First, Component::Second].into_iter().enumerate() {
        let fixed = c.fix[k].then_some(0.0);
        for value in [fixed, c.displace[k]].into_iter().flatten() {
            out.push(Condition::Displacement { place: place(case, &c.boundary), component, value });
        }
    }
    if let Some(pressure) = c.pressure {
        out.push(Condition::Pressure { boundary: c.boundary.clone(), pressure, load: c.pressure_load.unwrap_or_default() });
    }
    Ok(out)
}

fn place(case: &Case, boundary: &str) -> Place {
    let path = case.geometry.boundaries.iter().find(|b| b.name == boundary).map(|b| &b.path);
    match path {
        Some(BoundaryPath::Path(outline)) if outline.steps.is_empty() => Place::Point(outline.start),
        _ => Place::Boundary(boundary.into()),
    }
}
