//! A sequence of nested spaces, each with one degree and some layers more than the last, until the estimate meets the target.
//!
//! Spaces are nested, so that for every pair of fields the change of an energy product from one space to the next is the product of two
//! energy errors less that of the next: nothing cancels in it but what cancels in the error itself.

use super::corner::Side;
use super::error::HpError;
use super::fan::{Edge, Wedge, wedges};
use super::grading::{Graded, Layers, graded, separated};
use super::system::Gram;
use crate::error::FemError;
use crate::goal::Answer;
use crate::mesh::{Mesh, Topology};
use nalgebra::{DMatrix, DVector};
use std::time::Instant;

/// Degrees that are tried at most.
const LAST_DEGREE: usize = 11;
/// Triangles of a first mesh above which the refinement of quadratic elements is left to do it.
const MOST_TRIANGLES: usize = 3000;

/// The sum of changes to come is raised by this factor: changes shrink the slower the higher the degree, by a ratio of 1 / 6 at the degree 4 and 1 / 4 at
/// 6, so that without it 0.6 to 1.0 of the errors of disc capacitor and rubber disc were foretold.
const SAFETY: f64 = 2.0;
/// Ratio of two changes where only one is known; those measured lie between 1 / 7 and 1 / 3.
const UNKNOWN_RATIO: f64 = 0.5;
/// Bounds of the ratio: a change may be small by accident, or not shrink at all.
const RATIOS: [f64; 2] = [0.1, 0.9];
/// Smallest part of the product of two energy norms that a change counts for: products of different fields may cancel by accident.
const CANCELLATION_FLOOR: f64 = 0.1;

/// A corner of the mesh and the exponent of its singularity.
pub(crate) type Corners = Vec<(u32, f64)>;

/// One space of the sequence.
pub(crate) struct Level<'a> {
    pub mesh: &'a Mesh,
    pub topology: &'a Topology,
    /// Degree of every triangle.
    pub degrees: &'a [usize],
}

/// An output: `factor * left^T G right` of the energy products G of the solutions.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Functional {
    pub name: String,
    pub value: f64,
    pub unit: &'static str,
    pub scale: f64,
    pub left: Vec<f64>,
    pub right: Vec<f64>,
    pub factor: f64,
}

/// What a problem is to the sequence.
pub(crate) trait Physics {
    /// The condition on every edge of a mesh, `None` where there is none.
    fn edges(&self, mesh: &Mesh, topology: &Topology) -> Vec<Option<Edge>>;
    /// What is known of exponents.
    fn side(&self) -> impl Side;
    /// Energy products of the solutions in one space.
    fn solve(&self, level: &Level) -> Result<Gram, FemError>;
    /// The outputs.
    fn functionals(&self, products: &DMatrix<f64>) -> Vec<Functional>;
}

/// What the hp version gives.
#[derive(Debug, Clone, PartialEq)]
pub struct HpOutcome {
    /// The outputs, in the order asked for.
    pub answers: Vec<Answer>,
    /// Triangles of the last mesh.
    pub triangles: usize,
    /// Free unknowns of the last space.
    pub unknowns: usize,
    /// Spaces solved in.
    pub levels: usize,
    /// Bound of the largest normwise backward error of the last solves.
    pub residual: f64,
    /// Time spent on all spaces.
    pub seconds: HpSeconds,
}

/// Wall-clock seconds, all spaces together.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct HpSeconds {
    /// Grading the first mesh.
    pub mesh: f64,
    /// Shapes, element matrices, assembling.
    pub assemble: f64,
    /// Factorising and solving.
    pub solve: f64,
}

/// The least exponent at every singular corner.
pub(super) fn singular(physics: &impl Physics, mesh: &Mesh) -> Corners {
    let topology = Topology::new(mesh);
    let special = physics.edges(mesh, &topology);
    let side = physics.side();
    // most points of a straight boundary see the same
    let mut known: Vec<(Wedge, Option<f64>)> = Vec::new();
    let mut exponent = |w: Wedge| match known.iter().find(|(k, _)| k.is_like(&w)) {
        Some((_, exponent)) => *exponent,
        None => {
            let exponent = side.exponent(&w);
            known.push((w, exponent));
            exponent
        }
    };
    let mut least = |wedges: Vec<Wedge>| wedges.into_iter().filter_map(&mut exponent).reduce(f64::min);
    wedges(mesh, &topology, &|e| special[e]).into_iter().filter_map(|(n, w)| Some((n, least(w)?))).collect()
}

/// Raises degree and layers until the estimated relative error of every output is at most `target`.
///
/// # Errors
/// [`HpError::FirstMesh`] before anything is solved, [`HpError::NotReached`] after the last degree, and those of the solver.
pub(crate) fn refine(physics: &impl Physics, mesh: &Mesh, target: f64) -> Result<HpOutcome, FemError> {
    let mut begin = Instant::now();
    let corners = singular(physics, mesh);
    let mesh = separated(mesh, &corners.iter().map(|c| c.0).collect::<Vec<_>>());
    if mesh.triangles.len() > MOST_TRIANGLES {
        return Err(HpError::FirstMesh { triangles: mesh.triangles.len(), most: MOST_TRIANGLES }.into());
    }
    let mut seconds = HpSeconds::default();
    let mut products: Vec<DMatrix<f64>> = Vec::new();
    let mut degree = first_degree(target);
    loop {
        let Graded { mesh, layers } = graded(&mesh, &layers(&corners, degree));
        let degrees: Vec<usize> = layers.iter().map(|l| l.map_or(degree, |l| degree_in(l, degree))).collect();
        let topology = Topology::new(&mesh);
        seconds.mesh += begin.elapsed().as_secs_f64();
        begin = Instant::now();
        let gram = physics.solve(&Level { mesh: &mesh, topology: &topology, degrees: &degrees })?;
        seconds.solve += gram.seconds;
        seconds.assemble += begin.elapsed().as_secs_f64() - gram.seconds;
        begin = Instant::now();
        products.push(gram.products);
        let answers = judged(&physics.functionals(&products[products.len() - 1]), &products);
        let worst = answers.iter().max_by(|a, b| a.error_over_scale().total_cmp(&b.error_over_scale()));
        let Some(worst) = worst.filter(|w| !(w.error_over_scale() <= target)) else {
            let (triangles, levels) = (mesh.triangles.len(), products.len());
            return Ok(HpOutcome { answers, triangles, unknowns: gram.unknowns, levels, residual: gram.residual, seconds });
        };
        if degree == LAST_DEGREE {
            let (output, estimate) = (worst.name.clone(), worst.error_over_scale());
            return Err(HpError::NotReached { output, estimate, unknowns: gram.unknowns, wanted: target }.into());
        }
        degree += 1;
    }
}

/// The degree to begin with: the third space from there meets most targets, and two changes are what an estimate needs.
fn first_degree(target: f64) -> usize {
    let digits = -target.clamp(1e-12, 1.0).log10();
    (digits.round() as usize).saturating_sub(1).clamp(2, LAST_DEGREE - 2)
}

/// Layers around every corner: what they leave of the energy of `d^a`, the size of the last to the power 2 a, falls by the same factor
/// with every degree whatever the exponent is.
fn layers(corners: &Corners, degree: usize) -> Layers {
    corners.iter().map(|&(n, exponent)| (n, (degree as f64 * 0.5 / exponent).ceil() as usize)).collect()
}

/// Degree in a layer counted from the corner, where little energy is left.
fn degree_in(layer: usize, degree: usize) -> usize {
    degree.min(2 + layer)
}

fn judged(functionals: &[Functional], products: &[DMatrix<f64>]) -> Vec<Answer> {
    functionals
        .iter()
        .map(|f| {
            let changes: Vec<f64> = products.windows(2).map(|p| change(f, &(&p[0] - &p[1]))).collect();
            let error_estimate = remaining(&changes);
            Answer { name: f.name.clone(), value: f.value, unit: f.unit, error_estimate, scale: f.scale }
        })
        .collect()
}

/// Change of an output between two spaces; not less than a part of the product of the two energy norms that bounds it.
fn change(f: &Functional, difference: &DMatrix<f64>) -> f64 {
    let [left, right] = [&f.left, &f.right].map(|v| DVector::from_column_slice(v));
    let of = |a: &DVector<f64>, b: &DVector<f64>| a.dot(&(difference * b));
    let bound = (of(&left, &left).max(0.0) * of(&right, &right).max(0.0)).sqrt();
    f.factor.abs() * of(&left, &right).abs().max(CANCELLATION_FLOOR * bound)
}

/// What is left after changes that shrink geometrically; infinite before the first one.
fn remaining(changes: &[f64]) -> f64 {
    let Some(&last) = changes.last() else { return f64::INFINITY };
    let before = changes.len().checked_sub(2).map(|k| changes[k]);
    let ratio = before.map_or(UNKNOWN_RATIO, |b| last / b).clamp(RATIOS[0], RATIOS[1]);
    if last == 0.0 { 0.0 } else { SAFETY * last * ratio / (1.0 - ratio) }
}
