//! Named outputs: their values from a solution, and the error estimate of each.

use super::error::ElectrostaticsError;
use super::estimate::{PointLoad, estimate_pairs};
use super::problem::{Conductor, Problem};
use super::system::Solved;
use crate::error::FemError;
use crate::goal::{Answer, Judged};
use crate::mesh::Point;
use crate::space::P2;
use crate::symmetry::Symmetry;

/// What is asked for.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// Charge on a conductor over the largest potential difference between conductors (F or F/m). A single conductor
    /// is measured against infinity.
    Capacitance {
        /// Boundary of the conductor.
        boundary: String,
    },
    /// All entries of Maxwell's capacitance matrix (F or F/m), each an answer `name[a,b]`.
    CapacitanceMatrix,
    /// Field energy (J or J/m).
    Energy,
    /// Potential at a point (V).
    Potential {
        /// Where (m).
        at: Point,
    },
    /// Component 0 or 1 of the field E at a point (V/m).
    Field {
        /// Where (m).
        at: Point,
        /// 0: along the first coordinate, 1: along the second.
        component: usize,
    },
}

/// A named goal.
pub type Quantity = crate::goal::Quantity<Goal>;

/// A linear or bilinear functional: `factor` times the energy product of two fields.
pub(super) struct Functional {
    pub name: String,
    pub value: f64,
    pub unit: &'static str,
    pub scale: f64,
    /// Fields: the unit potential of a conductor by its number, then the whole potential, then duals.
    pub pair: (usize, usize),
    pub factor: f64,
}

/// The local problems see 0.6 to 0.85 of the error of capacitances at electrode edges (disc capacitors with d/a from
/// 0.01 to 1, errors from 1e-3 to 1e-6) and nearly all of it in smooth fields; the estimate is raised by this factor so
/// that a target is met.
const SAFETY: f64 = 1.5;
/// Smallest part of the sum of all local magnitudes that an estimate may fall to when local errors cancel: the true
/// error of point potentials was about that part where their signed sum passed through zero.
const CANCELLATION_FLOOR: f64 = 0.03;

pub(super) fn judge(solved: &mut Solved, quantities: &[Quantity]) -> Result<Vec<Judged>, FemError> {
    let matrix = solved.capacitance_matrix();
    let mut duals: Vec<Vec<f64>> = Vec::new();
    let mut loads: Vec<PointLoad> = Vec::new();
    let mut functionals = Vec::new();
    for q in quantities {
        match &q.goal {
            Goal::Capacitance { boundary } => {
                let touches = |a: &Conductor, b: &Conductor| a.boundary == *boundary || b.boundary == *boundary;
                refuse_touching(solved, &q.name, |a, b| a.potential != b.potential && touches(a, b))?;
                functionals.push(capacitance(solved.problem, solved.exterior.is_some(), &matrix, &q.name, boundary)?);
            }
            Goal::CapacitanceMatrix => {
                refuse_touching(solved, &q.name, |_, _| true)?;
                functionals.extend(entries(solved.problem, &matrix, &q.name));
            }
            Goal::Energy => {
                refuse_touching(solved, &q.name, |a, b| a.potential != b.potential)?;
                functionals.push(energy(solved.problem, &matrix, &q.name));
            }
            Goal::Potential { at } => {
                let (dual, load) = point_dual(solved, *at, None, duals.len())?;
                functionals.push(potential(solved, &q.name, &load));
                duals.push(dual);
                loads.push(load);
            }
            Goal::Field { at, component } => {
                let (dual, load) = point_dual(solved, *at, Some(*component), duals.len())?;
                functionals.push(field(solved, &q.name, &load, *component));
                duals.push(dual);
                loads.push(load);
            }
        }
    }
    let mut fields: Vec<&[f64]> = solved.units.iter().map(Vec::as_slice).collect();
    fields.push(&solved.potential);
    fields.extend(duals.iter().map(Vec::as_slice));
    let pairs: Vec<_> = functionals.iter().map(|f| f.pair).collect();
    let parts = estimate_pairs(solved, &fields, &loads, &pairs);
    Ok(functionals.into_iter().zip(parts).map(|(f, parts)| judged(f, parts)).collect())
}

/// The outputs that are energy products of the conductors' fields, from their capacitance matrix; `None` where one of them is not.
pub(super) fn charges(
    problem: &Problem,
    quantities: &[Quantity],
    matrix: &[Vec<f64>],
) -> Result<Option<Vec<Functional>>, ElectrostaticsError> {
    let open = !problem.open.is_empty();
    let mut out = Vec::new();
    for q in quantities {
        match &q.goal {
            Goal::Capacitance { boundary } => out.push(capacitance(problem, open, matrix, &q.name, boundary)?),
            Goal::CapacitanceMatrix => out.extend(entries(problem, matrix, &q.name)),
            Goal::Energy => out.push(energy(problem, matrix, &q.name)),
            Goal::Potential { .. } | Goal::Field { .. } => return Ok(None),
        }
    }
    Ok(Some(out))
}

fn judged(f: Functional, parts: Vec<f64>) -> Judged {
    let sum: f64 = parts.iter().sum();
    let shares: Vec<f64> = parts.iter().map(|p| (f.factor * p).abs()).collect();
    let magnitude: f64 = shares.iter().sum();
    let error_estimate = SAFETY * (f.factor * sum).abs().max(CANCELLATION_FLOOR * magnitude);
    Judged { answer: Answer { name: f.name, value: f.value, unit: f.unit, error_estimate, scale: f.scale }, shares }
}

/// An error where two conductors touch for which the output is infinite.
fn refuse_touching(
    solved: &Solved,
    output: &str,
    infinite: impl Fn(&Conductor, &Conductor) -> bool,
) -> Result<(), ElectrostaticsError> {
    let conductors = &solved.problem.conductors;
    for (&node, touching) in &solved.junctions {
        let pairs = touching.iter().flat_map(|&i| touching.iter().map(move |&j| (i, j))).filter(|(i, j)| i < j);
        for (a, b) in pairs.map(|(i, j)| (&conductors[i as usize], &conductors[j as usize])) {
            if infinite(a, b) {
                let at = solved.nodes.points[node as usize];
                return Err(ElectrostaticsError::Touching {
                    output: output.into(),
                    a: a.boundary.clone(),
                    b: b.boundary.clone(),
                    at,
                });
            }
        }
    }
    Ok(())
}

fn unit(problem: &Problem, planar: &'static str, body: &'static str) -> &'static str {
    match problem.symmetry {
        Symmetry::Planar => planar,
        Symmetry::Axisymmetric => body,
    }
}

/// Largest difference of the conductors' potentials; against infinity for a single conductor (V).
fn difference(problem: &Problem, open: bool) -> f64 {
    let v = problem.conductors.iter().map(|c| c.potential);
    let (low, high) = v.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if problem.conductors.len() == 1 && open { high.abs() } else { high - low }
}

fn capacitance(
    problem: &Problem,
    open: bool,
    matrix: &[Vec<f64>],
    name: &str,
    boundary: &str,
) -> Result<Functional, ElectrostaticsError> {
    let conductors = &problem.conductors;
    let i = conductors.iter().position(|c| c.boundary == boundary).ok_or_else(|| ElectrostaticsError::NotAConductor {
        boundary: boundary.into(),
        known: conductors.iter().map(|c| c.boundary.as_str()).collect::<Vec<_>>().join(", "),
    })?;
    let difference = difference(problem, open);
    if difference == 0.0 {
        return Err(ElectrostaticsError::NoDifference { potential: conductors[i].potential, boundary: boundary.into() });
    }
    let charge: f64 = matrix[i].iter().zip(conductors).map(|(c, v)| c * v.potential).sum();
    let value = charge / difference;
    Ok(Functional {
        name: name.into(),
        value,
        unit: unit(problem, "F/m", "F"),
        scale: value.abs().max(1e-9 * matrix[i][i]),
        pair: (i, conductors.len()),
        factor: 1.0 / difference,
    })
}

fn entries(problem: &Problem, matrix: &[Vec<f64>], name: &str) -> Vec<Functional> {
    let conductors = &problem.conductors;
    let entry = |i: usize, j: usize| Functional {
        name: format!("{name}[{},{}]", conductors[i].boundary, conductors[j].boundary),
        value: matrix[i][j],
        unit: unit(problem, "F/m", "F"),
        // Conductors that hardly see each other are judged against their own capacitances.
        scale: matrix[i][j].abs().max(1e-3 * (matrix[i][i] * matrix[j][j]).sqrt()),
        pair: (i, j),
        factor: 1.0,
    };
    (0..conductors.len()).flat_map(|i| (0..conductors.len()).map(move |j| (i, j))).map(|(i, j)| entry(i, j)).collect()
}

fn energy(problem: &Problem, matrix: &[Vec<f64>], name: &str) -> Functional {
    let v: Vec<f64> = problem.conductors.iter().map(|c| c.potential).collect();
    let value = 0.5 * (0..v.len()).map(|i| v[i] * matrix[i].iter().zip(&v).map(|(c, v)| c * v).sum::<f64>()).sum::<f64>();
    Functional {
        name: name.into(),
        value,
        unit: unit(problem, "J/m", "J"),
        scale: value.abs(),
        pair: (v.len(), v.len()),
        factor: 0.5,
    }
}

fn potential(solved: &Solved, name: &str, load: &PointLoad) -> Functional {
    let value = solved.sample_in(load.triangle, load.reference).potential;
    let largest = solved.problem.conductors.iter().map(|c| c.potential.abs()).fold(0.0, f64::max);
    let scale = value.abs().max(1e-3 * largest);
    Functional { name: name.into(), value, unit: "V", scale, pair: (solved.units.len(), load.field), factor: 1.0 }
}

fn field(solved: &Solved, name: &str, load: &PointLoad, component: usize) -> Functional {
    let sample = solved.sample_in(load.triangle, load.reference);
    let scale = sample.field[0].hypot(sample.field[1]);
    Functional {
        name: name.into(),
        value: sample.field[component],
        unit: "V/m",
        scale,
        pair: (solved.units.len(), load.field),
        factor: 1.0,
    }
}

/// The field whose energy product with an error is the error of the potential, or of a component of E, at a point.
fn point_dual(
    solved: &mut Solved,
    at: Point,
    component: Option<usize>,
    earlier: usize,
) -> Result<(Vec<f64>, PointLoad), FemError> {
    let (triangle, reference) = solved.find(at)?;
    let weights = match component {
        None => [1.0, 0.0, 0.0],
        Some(0) => [0.0, -1.0, 0.0],
        Some(_) => [0.0, 0.0, -1.0],
    };
    let field = solved.units.len() + 1 + earlier;
    let (value, slope) = P2::at(reference);
    let map = solved.nodes.element(triangle).map_at(reference);
    let mut rhs = vec![0.0; solved.dofs.count];
    for (k, &node) in solved.nodes.triangles[triangle].iter().enumerate() {
        let g = map.gradient(slope[k]);
        rhs[node as usize] += weights[0] * value[k] + weights[1] * g[0] + weights[2] * g[1];
    }
    let dual = solved.response(rhs)?;
    Ok((dual, PointLoad { field, triangle, reference, weights }))
}
