//! Stability of an axisymmetric equilibrium against harmonics around the axis, and the load at which it is lost.
//!
//! The second variation of the energy about the deformed state, per harmonic. Harmonic 1 (tilt of the whole body) is
//! left out: a free body is neutral against it. The eigenvalue found is the one nearest to zero, so the search for an
//! instability should start from the stable side.

use super::body::Body;
use super::element::evaluate_points;
use super::error::ElasticityError;
use super::harmonic::{harmonic_gradient, share_of_circle};
use super::kinematics::{R, T, Z};
use super::laws::{Law, Tensor};
use super::newton::NewtonOptions;
use super::point::{At, Visitor};
use super::quadrature_point::MappedQuadraturePoint;
use super::solver::Solver;
use super::vector::dot;
use crate::algebra::{Direct, Kind, Pattern, ScatterMap, assemble_vector};
use crate::space::{ElementDofs, Numbering};
use crate::symmetry::Symmetry;
use nalgebra_sparse::CscMatrix;

/// The softest mode of a harmonic.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Waves around the axis.
    pub harmonic: u32,
    /// Stiffness per volume against this mode (Pa/m^2): negative where the state is unstable.
    pub eigenvalue: f64,
    /// Amplitudes `3 node + (r, z, theta)`, largest magnitude 1.
    pub amplitude: Vec<f64>,
    /// Inverse iterations done.
    pub iterations: usize,
}

/// An instability.
#[derive(Debug, Clone, PartialEq)]
pub struct Instability {
    /// Load factor.
    pub load: f64,
    /// The mode that becomes soft there.
    pub mode: Mode,
    /// Equilibria computed on the way.
    pub equilibria: usize,
}

/// The second variation of one harmonic, its pattern and analysis kept from state to state.
pub struct Harmonic {
    n: u32,
    dofs: ElementDofs,
    numbering: Numbering,
    scatter: ScatterMap,
    matrix: CscMatrix<f64>,
    direct: Option<Direct>,
    mass: Vec<f64>,
    guess: Vec<f64>,
    /// Largest magnitude of an eigenvalue found so far: near an instability rounding stays relative to this.
    scale: f64,
}

impl Harmonic {
    /// Prepares harmonic `n` of a body.
    ///
    /// # Errors
    /// `Harmonic` for planar bodies, for n = 1, and for pressures that follow the surface.
    pub fn new(body: &Body, n: u32) -> Result<Harmonic, ElasticityError> {
        let refuse = |symmetry, remedy| Err(ElasticityError::Harmonic { harmonic: n, symmetry, remedy });
        if body.problem.symmetry == Symmetry::Planar {
            return refuse("planar", "only axisymmetric bodies have harmonics");
        }
        if n == 1 {
            return refuse("axisymmetric", "a free body is neutral against tilting; ask for 0, 2, 3, ...");
        }
        if !body.following.is_empty() {
            return refuse("pressed", "pressures that follow the surface are not part of harmonics; give dead ones");
        }
        let dofs = unknowns(body);
        let numbering = Numbering::new(&supports(body, &dofs, n));
        let (matrix, scatter) = Pattern::new(&dofs, &numbering)?.into_matrix();
        Ok(Harmonic {
            n,
            matrix,
            scatter,
            direct: None,
            mass: volumes(body, &dofs),
            // Uneven, so that no mode is orthogonal to it by symmetry.
            guess: (0..dofs.count).map(|i| 0.5 + (i as f64 * 0.754_877_666).fract()).collect(),
            scale: 0.0,
            numbering,
            dofs,
        })
    }

    /// Softest mode in the present state of `solver`.
    ///
    /// Inverse iteration. Residuals and quotients are formed from strains, point by point: products with element matrices
    /// lose five digits more in thin plates.
    pub fn softest(&mut self, solver: &Solver) -> Result<Mode, ElasticityError> {
        if solver.has_obstacles() {
            return Err(ElasticityError::Harmonic {
                harmonic: self.n,
                symmetry: "touching",
                remedy: "replace obstacles by prescribed displacements",
            });
        }
        const ITERATIONS: usize = 60;
        const SETTLED: f64 = 1e-7;
        const NEAR_ZERO: f64 = 1e-3;
        let form = second_variation(solver, self.n);
        self.scatter.assemble(&mut self.matrix, &form);
        let mut direct = match self.direct.take() {
            Some(direct) => direct,
            None => Direct::analyse(&self.matrix, Kind::Ldlt)?,
        };
        direct.factorise_unchecked(&self.matrix)?;
        let guess = std::mem::take(&mut self.guess);
        let mut x = self.normalised(guess);
        let (mut value, mut change) = (f64::NAN, f64::INFINITY);
        let mut iterations = 0;
        while iterations < ITERATIONS && !(change < SETTLED) {
            iterations += 1;
            let load: Vec<f64> = x.iter().zip(&self.mass).map(|(x, m)| x * m).collect();
            let y = self.refined(&mut direct, solver, &load);
            x = self.normalised(y);
            let next = dot(&self.forces(solver, &x), &x);
            change = (next - value).abs() / next.abs().max(NEAR_ZERO * self.scale);
            value = next;
        }
        self.guess = x.clone();
        self.direct = Some(direct);
        self.scale = self.scale.max(value.abs());
        if !(change < SETTLED) {
            return Err(ElasticityError::Eigenvalue { harmonic: self.n, iterations, change });
        }
        let top = x.iter().take(3 * solver.body().displacements / 2).fold(0.0f64, |m, v| if v.abs() > m.abs() { *v } else { m });
        x.iter_mut().for_each(|v| *v /= top);
        Ok(Mode { harmonic: self.n, eigenvalue: value, amplitude: x, iterations })
    }

    /// Product of the second variation with the amplitudes `x`.
    fn forces(&self, solver: &Solver, x: &[f64]) -> Vec<f64> {
        assemble_vector(&self.dofs, |e, out| {
            let local: Vec<f64> = self.dofs.of(e).iter().map(|&d| x[d as usize]).collect();
            let mut force = WaveForce { n: self.n, local: &local, out };
            evaluate_points(solver.body(), solver.tables(), e, solver.state(), solver.load(), true, &mut force);
        })
    }

    fn refined(&self, direct: &mut Direct, solver: &Solver, load: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; load.len()];
        for _ in 0..3 {
            let rest: Vec<f64> = self.forces(solver, &all).iter().zip(load).map(|(k, b)| b - k).collect();
            let mut step = self.numbering.restrict(&rest);
            direct.apply_inverse(&mut step);
            self.numbering.scatter_add(&step, &mut all);
        }
        all
    }

    /// Scaled so that `x . M x = 1`; fixed entries zero.
    fn normalised(&self, mut x: Vec<f64>) -> Vec<f64> {
        x.iter_mut().zip(&self.numbering.rows).filter(|(_, r)| **r == crate::mesh::NONE).for_each(|(x, _)| *x = 0.0);
        let norm = x.iter().zip(&self.mass).map(|(x, m)| m * x * x).sum::<f64>().sqrt();
        x.iter_mut().for_each(|v| *v /= norm);
        x
    }
}

impl Solver {
    /// Softest mode of harmonic `n` in the present state.
    pub fn softest_mode(&self, n: u32) -> Result<Mode, ElasticityError> {
        Harmonic::new(self.body(), n)?.softest(self)
    }

    /// Load factor between `low` and `high` at which the softest mode of harmonic `n` loses its stiffness.
    ///
    /// False position with the Illinois rule, to the relative `tolerance`. The solver is left at that load.
    ///
    /// # Errors
    /// `NoInstability` where the eigenvalue has one sign at both ends; what `advance` and `softest` refuse.
    pub fn critical_load(
        &mut self,
        n: u32,
        [low, high]: [f64; 2],
        tolerance: f64,
        options: &NewtonOptions,
    ) -> Result<Instability, ElasticityError> {
        let mut harmonic = Harmonic::new(self.body(), n)?;
        let mut equilibria = 0;
        let mut at = |solver: &mut Solver, load: f64| {
            equilibria += 1;
            solver.advance(load, options)?;
            harmonic.softest(solver)
        };
        let (mut a, mut b) = (low, high);
        let first = at(self, a)?;
        let mut mode = at(self, b)?;
        let (mut fa, mut fb) = (first.eigenvalue, mode.eigenvalue);
        if fa * fb > 0.0 {
            return Err(ElasticityError::NoInstability { harmonic: n, low, high, at_low: fa, at_high: fb });
        }
        let mut load = b;
        for _ in 0..40 {
            let next = (a * fb - b * fa) / (fb - fa);
            let moved = (next - load).abs();
            load = next;
            mode = at(self, load)?;
            if moved <= tolerance * load.abs() || mode.eigenvalue == 0.0 {
                break;
            }
            if mode.eigenvalue * fb < 0.0 {
                (a, fa) = (b, fb);
            } else {
                fa *= 0.5;
            }
            (b, fb) = (load, mode.eigenvalue);
        }
        Ok(Instability { load, mode, equilibria })
    }
}

/// Element matrices of the second variation about the solver's state.
fn second_variation(solver: &Solver, n: u32) -> impl Fn(usize, &mut [f64]) + Sync + '_ {
    move |e, out| {
        evaluate_points(solver.body(), solver.tables(), e, solver.state(), solver.load(), true, &mut Wave { n, out });
    }
}

/// Adds the second variation of a harmonic at a quadrature point.
struct Wave<'a> {
    n: u32,
    out: &'a mut [f64],
}

impl Visitor for Wave<'_> {
    fn visit<L: Law>(&mut self, at: &At<L>, s: &MappedQuadraturePoint) {
        let inner = 3 * s.shapes.len();
        let m = inner + s.pressures.len();
        let weight = s.weight * share_of_circle(self.n);
        let gradient = |i: usize, c: usize| harmonic_gradient(self.n, s.at[0], s.shapes[i], c);
        let slope = at.volume_slope() * weight;
        for j in 0..s.shapes.len() {
            for c in [R, Z, T] {
                let trial = gradient(j, c);
                let stress = at.tangent(&trial) * weight;
                let column = &mut self.out[(3 * j + c) * m..(3 * j + c + 1) * m];
                for i in j..s.shapes.len() {
                    for d in [R, Z, T] {
                        column[3 * i + d] += stress.dot(&gradient(i, d));
                    }
                }
                for (a, n) in s.pressures.iter().enumerate() {
                    column[inner + a] += n * slope.dot(&trial);
                }
            }
        }
        let diagonal = weight * at.pressure_compliance();
        for (b, nb) in s.pressures.iter().enumerate() {
            for (a, na) in s.pressures.iter().enumerate() {
                self.out[(inner + b) * m + inner + a] -= diagonal * na * nb;
            }
        }
    }
}

/// Adds the product of the second variation at a quadrature point with the amplitudes of the element.
struct WaveForce<'a> {
    n: u32,
    local: &'a [f64],
    out: &'a mut [f64],
}

impl Visitor for WaveForce<'_> {
    fn visit<L: Law>(&mut self, at: &At<L>, s: &MappedQuadraturePoint) {
        let (shapes, inner) = (s.shapes, 3 * s.shapes.len());
        let weight = s.weight * share_of_circle(self.n);
        let gradient = |i: usize| harmonic_gradient(self.n, s.at[0], shapes[i / 3], i % 3);
        let h = (0..inner).fold(Tensor::zeros(), |h, i| h + gradient(i) * self.local[i]);
        let p: f64 = s.pressures.iter().zip(&self.local[inner..]).map(|(n, p)| n * p).sum();
        let stress = (at.tangent(&h) + at.volume_slope() * p) * weight;
        for i in 0..inner {
            self.out[i] += stress.dot(&gradient(i));
        }
        let gap = weight * (at.volume_slope().dot(&h) - at.pressure_compliance() * p);
        for (a, n) in s.pressures.iter().enumerate() {
            self.out[inner + a] += n * gap;
        }
    }
}

/// Unknowns `3 node + component`, then the pressures.
fn unknowns(body: &Body) -> ElementDofs {
    let shift = (3 * body.displacements / 2 - body.displacements) as u32;
    let inner = 2 * body.problem.order.nodes();
    let mut dofs = ElementDofs::empty(body.dofs.count + shift as usize);
    for e in 0..body.dofs.elements() {
        let of = body.dofs.of(e);
        let nodes = of[..inner].iter().step_by(2).map(|d| d / 2);
        let mut list: Vec<u32> = nodes.flat_map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
        list.extend(of[inner..].iter().map(|p| p + shift));
        dofs.push(&list);
    }
    dofs
}

/// Prescribed r and z stay fixed; theta is fixed where both are (clamped), on the axis, and without waves.
fn supports(body: &Body, dofs: &ElementDofs, n: u32) -> Vec<bool> {
    let mut fixed = vec![false; dofs.count];
    let size = body.nodes.points.iter().map(|p| p[0]).fold(0.0, f64::max);
    for node in 0..body.displacements / 2 {
        let [r, z] = [body.fixed[2 * node], body.fixed[2 * node + 1]];
        let axis = body.nodes.points[node][0] <= 1e-12 * size;
        fixed[3 * node] = r;
        fixed[3 * node + 1] = z || (axis && n > 0);
        fixed[3 * node + 2] = n == 0 || axis || (r && z);
    }
    fixed
}

/// Volume that belongs to every displacement unknown (m^3); zero for pressures.
fn volumes(body: &Body, dofs: &ElementDofs) -> Vec<f64> {
    let count = body.problem.order.nodes();
    assemble_vector(dofs, |e, out| {
        let corners = body.problem.mesh.corners(e);
        let area = 0.5 * crate::mesh::plane::twice_area(corners[0], corners[1], corners[2]);
        let r = (corners[0][0] + corners[1][0] + corners[2][0]) / 3.0;
        out[..3 * count].fill(area * body.problem.symmetry.weight(r) / count as f64);
    })
}
