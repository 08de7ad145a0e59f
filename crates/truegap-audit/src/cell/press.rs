//! A bead squeezed between plates: finite-strain, nearly incompressible neo-Hookean finite elements.
//!
//! The side of a bonded bead folds onto the plate from the first load on (the corner is singular), so the plate is an obstacle to it, without
//! friction. Half a bead is meshed and mirrored at its middle: both faces are held alike.

use super::geometry::{Cell, Profile};
use crate::error::AuditError;
use truegap_fem::{
    FemError, Symmetry,
    elasticity::{
        Component, Condition, ElasticityError, Formulation, LawKind, Material, NewtonOptions, Order, Problem, Side, Solution,
        Solver, Temperature,
    },
    mesh::{Geometry, Mesh, MeshOptions, Outline, Point, SizeField, SizeSource, mesh_geometry},
};

/// How the faces of a bead are held by the plates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bonding {
    /// no sliding
    Bonded,
    /// no friction
    Smooth,
}

/// A bead at one strain.
#[derive(Clone, Debug, PartialEq)]
pub struct PressedAt {
    /// compressive strain of the bead's height
    pub strain: f64,
    /// force over Young's modulus and face at rest
    pub reduced_load: f64,
    /// its side
    pub profile: Profile,
}

/// A bead squeezed step by step.
#[derive(Clone, Debug, PartialEq)]
pub struct Pressed {
    /// from rest to the greatest strain
    pub steps: Vec<PressedAt>,
    /// apparent over true modulus at a strain of 1e-4
    pub stiffness: f64,
    /// edge at the bonded rim, over the height
    pub rim: f64,
    /// free unknowns
    pub unknowns: usize,
}

/// Edges at the bonded rim, over the height, finest first: the next one is tried where the corner folds too sharply for the one before.
const RIMS: [f64; 4] = [4e-3, 6e-3, 8e-3, 12e-3];
/// Largest edge, over the height.
const EDGE: f64 = 0.08;
/// Strain at which the stiffness at rest is taken.
const AT_REST: f64 = 1e-4;

/// Squeezes a bead to each of `strains`, which rise from above 0.
///
/// **Accuracy:** the stiffness at rest 5e-4, `a_bonded_bead_is_as_stiff_as_other_programs_say`; at a strain of 0.15 the force falls by 0.3 % when the rim's
/// edge falls from 6e-3 to 4e-3 (see `error_by_rim`).
///
/// # Errors
/// [`AuditError::Fem`] where no equilibrium is found with any rim.
pub fn press(cell: &Cell, bonding: Bonding, strains: &[f64]) -> Result<Pressed, AuditError> {
    let mut last = None;
    for rim in RIMS {
        match press_with(cell, bonding, strains, rim) {
            Err(FemError::Elasticity(e @ (ElasticityError::NotConverged { .. } | ElasticityError::Contact { .. }))) => {
                last = Some(e)
            }
            other => return other.map_err(AuditError::fem("squeezed bead")),
        }
    }
    let source = last.map_or(ElasticityError::IllConditioned { correction: f64::INFINITY }, |e| e);
    Err(AuditError::Fem { problem: "squeezed bead".into(), source: Box::new(source.into()) })
}

/// Relative error of the force: its greatest change, at four of the strains, to a rim meshed twice as coarsely. The error is of first order in the rim,
/// so what is left is about as much.
///
/// # Errors
/// As [`press`].
pub(crate) fn error_by_rim(cell: &Cell, bonding: Bonding, pressed: &Pressed) -> Result<f64, AuditError> {
    let every = (pressed.steps.len() / 4).max(1);
    let some: Vec<&PressedAt> = pressed.steps.iter().skip(every - 1).step_by(every).collect();
    let strains: Vec<f64> = some.iter().map(|s| s.strain).collect();
    let coarse = press_with(cell, bonding, &strains, 2.0 * pressed.rim).map_err(AuditError::fem("squeezed bead, coarse"))?;
    let change = |(fine, coarse): (&&PressedAt, &PressedAt)| (coarse.reduced_load / fine.reduced_load - 1.0).abs();
    Ok(some.iter().zip(&coarse.steps).map(change).fold(0.0, f64::max))
}

fn press_with(cell: &Cell, bonding: Bonding, strains: &[f64], rim: f64) -> Result<Pressed, FemError> {
    let greatest = strains.last().copied().unwrap_or(AT_REST);
    let mut solver = Solver::new(half_bead(cell, bonding, greatest, 0.0, rim)?)?;
    let mut squeeze = |strain: f64| -> Result<PressedAt, FemError> {
        let solution = solver.advance(strain / greatest, &NewtonOptions::default())?;
        pressed_at(cell, strain, &solution)
    };
    let stiffness = squeeze(AT_REST)?.reduced_load / AT_REST;
    let steps = strains.iter().map(|&strain| squeeze(strain)).collect::<Result<Vec<_>, _>>()?;
    Ok(Pressed { steps, stiffness, rim, unknowns: solver.body().numbering.free.len() })
}

/// Lower half of a bead of unit height and unit modulus, at load factor 1 squeezed by `strain` and heated by a thermal strain.
fn half_bead(cell: &Cell, bonding: Bonding, strain: f64, heat: f64, rim: f64) -> Result<Problem, FemError> {
    let mut conditions =
        vec![Condition::fix("face", Component::Second), Condition::displace("middle", Component::Second, -0.5 * strain)];
    if bonding == Bonding::Bonded {
        conditions.push(Condition::fix("face", Component::First));
        let (boundary, component) = ("side".into(), Component::Second);
        conditions.push(Condition::Obstacle { boundary, component, position: 0.0, travel: 0.0, side: Side::Above });
    }
    Ok(Problem {
        mesh: half_mesh(cell.bead / cell.height, bonding, rim)?,
        symmetry: Symmetry::Axisymmetric,
        materials: vec![silicone(cell.poisson)],
        conditions,
        temperature: Temperature::uniform(heat),
        body_force: None,
        order: Order::Quadratic,
    })
}

/// A bonded bead that was heated by a thermal strain (its own less that of the plates) and carries a load over modulus and face: strain and profile are
/// relative to the cold bead.
///
/// Heat and load at once, at finite strain; the load is met by the secant rule to 1e-9.
///
/// # Errors
/// [`AuditError::Fem`] where no equilibrium is found with any rim.
pub fn heated_and_loaded(cell: &Cell, heat: f64, reduced_load: f64, start: f64) -> Result<PressedAt, AuditError> {
    with_some_rim("heated and loaded bead", |rim| equilibrium(cell, heat, reduced_load, start, rim))
}

/// A bonded bead that was heated by a thermal strain and squeezed to a strain of its cold height.
///
/// # Errors
/// As [`heated_and_loaded`].
pub(crate) fn heated_and_squeezed(cell: &Cell, heat: f64, strain: f64) -> Result<PressedAt, AuditError> {
    with_some_rim("heated and squeezed bead", |rim| {
        let solution = Solver::new(half_bead(cell, Bonding::Bonded, strain, heat, rim)?)?.solve()?;
        pressed_at(cell, strain, &solution)
    })
}

/// The first mesh of the rim on which there is an equilibrium.
fn with_some_rim(problem: &str, solve: impl Fn(f64) -> Result<PressedAt, FemError>) -> Result<PressedAt, AuditError> {
    let mut last = ElasticityError::IllConditioned { correction: f64::INFINITY };
    for rim in RIMS {
        match solve(rim) {
            Err(FemError::Elasticity(e @ (ElasticityError::NotConverged { .. } | ElasticityError::Contact { .. }))) => last = e,
            other => return other.map_err(|e| AuditError::Fem { problem: problem.into(), source: Box::new(e) }),
        }
    }
    Err(AuditError::Fem { problem: problem.into(), source: Box::new(last.into()) })
}

fn equilibrium(cell: &Cell, heat: f64, reduced_load: f64, start: f64, rim: f64) -> Result<PressedAt, FemError> {
    let at = |strain: f64| -> Result<PressedAt, FemError> {
        let solution = Solver::new(half_bead(cell, Bonding::Bonded, strain, heat, rim)?)?.solve()?;
        pressed_at(cell, strain, &solution)
    };
    let (mut before, mut now) = (at(start)?, at(start + 1e-3)?);
    for _ in 0..12 {
        let slope = (now.reduced_load - before.reduced_load) / (now.strain - before.strain);
        let step = (reduced_load - now.reduced_load) / slope;
        if step.abs() < 1e-9 || slope == 0.0 {
            break;
        }
        let next = at(now.strain + step)?;
        before = std::mem::replace(&mut now, next);
    }
    Ok(now)
}

/// Rubber of unit modulus and unit expansion; the volumetric stress is an unknown of its own from a Poisson's ratio of 0.45 on.
pub(crate) fn silicone(poisson: f64) -> Material {
    Material { young: 1.0, poisson, expansion: 1.0, law: LawKind::NeoHookean, formulation: Formulation::suited(poisson) }
}

/// Lower half of a bead of unit height, with boundaries `face`, `side` and `middle`.
pub(crate) fn half_mesh(radius: f64, bonding: Bonding, rim: f64) -> Result<Mesh, FemError> {
    let drawing = Geometry::default()
        .region("bead", Outline::rectangle([0.0, 0.0], [radius, 0.5]))
        .boundary("face", &[[0.0, 0.0], [radius, 0.0]])
        .boundary("side", &[[radius, 0.0], [radius, 0.5]])
        .boundary("middle", &[[0.0, 0.5], [radius, 0.5]]);
    let sources = if bonding == Bonding::Bonded { vec![SizeSource { at: [radius, 0.0], size: rim }] } else { Vec::new() };
    let size = SizeField { max_edge: EDGE, growth: 0.25, sources };
    Ok(mesh_geometry(&drawing, &MeshOptions { size, ..MeshOptions::default() })?)
}

fn pressed_at(cell: &Cell, strain: f64, solution: &Solution) -> Result<PressedAt, FemError> {
    let radius = cell.bead / cell.height;
    // the middle carries what the face and the touching side carry together
    let force = -solution.reaction("middle", Component::Second)?;
    let face = std::f64::consts::PI * radius * radius;
    let profile = Profile::new(strain, side(solution, radius, strain)?);
    Ok(PressedAt { strain, reduced_load: force / face, profile })
}

/// Deformed side, mirrored to the whole height; quadratic nodes.
fn side(solution: &Solution, radius: f64, strain: f64) -> Result<Vec<Point>, FemError> {
    let body = solution.body();
    let mut nodes: Vec<usize> = body.boundary_nodes("side")?.into_iter().map(|n| n as usize).collect();
    nodes.sort_by(|&a, &b| body.nodes.points[a][1].total_cmp(&body.nodes.points[b][1]));
    let moved = |&n: &usize| {
        let (at, u) = (body.nodes.points[n], solution.nodal(n));
        [(at[0] + u[0]) / radius, at[1] + u[1]]
    };
    let mut points: Vec<Point> = nodes.iter().map(moved).collect();
    let upper: Vec<Point> = points.iter().rev().skip(1).map(|p| [p[0], 1.0 - strain - p[1]]).collect();
    points.extend(upper);
    Ok(points)
}
