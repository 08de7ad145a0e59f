//! Cases with rigid plates: from the drawing to obstacles, and from outputs to what is asked of a contact.

use super::description::{Case, Drive, Output, OutputKind, Plate};
use super::elastic_outputs::quantity;
use super::error::CaseError;
use crate::elasticity::{
    Accuracy, Component, Condition, ContactGoal, ContactQuantity, Outcome, Press, Problem, Side, solve_contact,
};
use crate::error::FemError;
use crate::mesh::Mesh;
use crate::symmetry::Symmetry;

pub(super) fn solve(case: &Case, problem: &mut Problem) -> Result<Outcome, FemError> {
    let quantities = case.outputs.iter().map(|o| asked(case, problem, o)).collect::<Result<Vec<_>, _>>()?;
    let mut presses = case.conditions.iter().filter_map(|c| match c.plate {
        Some(Plate { drive: Drive::Force(force), .. }) => Some((c.boundary.as_str(), force)),
        _ => None,
    });
    let press = match (presses.next(), presses.next()) {
        (None, _) => None,
        (Some((boundary, force)), None) => Some(Press { condition: obstacle_of(case, problem, boundary)?, force }),
        (Some(_), Some((boundary, _))) => {
            let what = "only one plate may press with a force; give the other a travel (0 where it stands still)";
            return Err(invalid(case, boundary, what).into());
        }
    };
    let accuracy = case.mesh.target_error.map(|target| Accuracy { target, ..Accuracy::default() });
    solve_contact(problem, press, &quantities, accuracy.as_ref())
}

fn invalid(case: &Case, boundary: &str, what: &str) -> CaseError {
    CaseError::Invalid { file: case.file.clone(), place: format!("boundary `{boundary}`, plate"), what: what.into() }
}

/// The obstacle of a boundary with a plate; the side is the one on which the drawing lies.
pub(super) fn obstacle(case: &Case, c: &super::Condition, mesh: &Mesh) -> Result<Option<Condition>, FemError> {
    let Some(plate) = c.plate else { return Ok(None) };
    let id = mesh.boundary(&c.boundary)?;
    let places = mesh.edges_of(id).flatten().map(|i| mesh.points[i as usize][plate.component]);
    let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
    let slack = 1e-9 * (high - low).max(high.abs()).max(low.abs());
    let side = match (low >= plate.position - slack, high <= plate.position + slack) {
        (true, false) => Side::Above,
        (false, true) => Side::Below,
        (true, true) => side_of_body(mesh, plate),
        (false, false) => {
            let what = "the plate cuts the boundary before it has moved; put it outside of the body or touching it";
            return Err(invalid(case, &c.boundary, what).into());
        }
    };
    let towards = if side == Side::Above { 1.0 } else { -1.0 };
    let travel = match plate.drive {
        Drive::Travel(travel) => towards * travel,
        Drive::Force(_) => 0.0,
    };
    let component = if plate.component == 0 { Component::First } else { Component::Second };
    Ok(Some(Condition::Obstacle { boundary: c.boundary.clone(), component, position: plate.position, travel, side }))
}

/// A flat face lies on the plate: the rest of the body tells the side.
fn side_of_body(mesh: &Mesh, plate: Plate) -> Side {
    let mean = mesh.points.iter().map(|p| p[plate.component]).sum::<f64>() / mesh.points.len() as f64;
    if mean > plate.position { Side::Above } else { Side::Below }
}

fn obstacle_of(case: &Case, problem: &Problem, name: &str) -> Result<usize, CaseError> {
    let found = |c: &Condition| matches!(c, Condition::Obstacle { boundary, .. } if boundary == name);
    problem.conditions.iter().position(found).ok_or_else(|| invalid(case, name, "is missing; give the boundary a plate"))
}

fn asked(case: &Case, problem: &Problem, output: &Output) -> Result<ContactQuantity, CaseError> {
    let plate = || obstacle_of(case, problem, output.boundary.as_deref().unwrap_or_default());
    let goal = match output.kind {
        OutputKind::ContactForce => ContactGoal::Force(plate()?),
        OutputKind::PeakPressure => ContactGoal::PeakPressure(plate()?),
        OutputKind::PlateTravel => ContactGoal::Travel(plate()?),
        OutputKind::ContactRadius if case.symmetry == Symmetry::Axisymmetric => ContactGoal::Radius(plate()?),
        OutputKind::ContactRadius => {
            let what = "a contact has a radius in axisymmetric cases only";
            let place = format!("output `{}`", output.name);
            return Err(CaseError::Invalid { file: case.file.clone(), place, what: what.into() });
        }
        _ => ContactGoal::Body(quantity(case, output)?.goal),
    };
    Ok(ContactQuantity { name: output.name.clone(), goal })
}
