//! What an equilibrium says: displacements, reactions, strains, stresses, energy, the deformed mesh.
//!
//! Strains and stresses come from a local fit to the displacements (see `recovery`), one region at a time.

use super::body::Body;
use super::element::material;
use super::error::ElasticityError;
use super::kinematics::{R, T, Z};
use super::laws::{Law, Linear, NeoHookean, SaintVenantKirchhoff, Tensor};
use super::material::{Formulation, LawKind};
use super::point::{At, Moduli};
use super::problem::Component;
use super::recovery::{Patch, locate};
use super::thermal::ThermalStretch;
use crate::mesh::{Mesh, Point};
use crate::space::P2;
use crate::symmetry::Symmetry;
use std::fmt;
use std::sync::Arc;

/// The four components that an axisymmetric or planar tensor has; `tt` is the hoop or out-of-plane one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Components {
    /// Along r, or x.
    pub rr: f64,
    /// Along z, or y.
    pub zz: f64,
    /// Along the hoop, or out of plane.
    pub tt: f64,
    /// Shear (the tensor's component, half of the engineering shear strain).
    pub rz: f64,
}

impl Components {
    fn of(t: &Tensor) -> Components {
        Components { rr: t[(R, R)], zz: t[(Z, Z)], tt: t[(T, T)], rz: 0.5 * (t[(R, Z)] + t[(Z, R)]) }
    }

    /// The component called `rr`, `zz`, `tt` or `rz` (or `xx`, `yy`, `xy`).
    pub fn named(&self, name: &str) -> Option<f64> {
        match name {
            "rr" | "r" | "xx" | "x" => Some(self.rr),
            "zz" | "z" | "yy" | "y" => Some(self.zz),
            "tt" | "t" => Some(self.tt),
            "rz" | "xy" => Some(self.rz),
            _ => None,
        }
    }
}

/// An equilibrium.
#[derive(Clone)]
pub struct Solution {
    body: Arc<Body>,
    state: Vec<f64>,
    /// Load factor at which it holds.
    pub load: f64,
    forces: Vec<f64>,
    energy: f64,
    /// Largest last correction over largest displacement: the accuracy of the algebra.
    pub correction: f64,
}

impl fmt::Debug for Solution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Solution")
            .field("unknowns", &self.state.len())
            .field("load", &self.load)
            .field("energy", &self.energy)
            .field("correction", &self.correction)
            .finish_non_exhaustive()
    }
}

impl Solution {
    pub(crate) fn new(body: Arc<Body>, state: Vec<f64>, load: f64, forces: Vec<f64>, energy: f64, correction: f64) -> Solution {
        Solution { body, state, load, forces, energy, correction }
    }

    /// The body.
    pub fn body(&self) -> &Arc<Body> {
        &self.body
    }

    /// Values of all unknowns: displacements `2 node + component` (m), then pressures (Pa).
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// Displacement of a node (m).
    pub fn nodal(&self, node: usize) -> [f64; 2] {
        [self.state[2 * node], self.state[2 * node + 1]]
    }

    /// Stored elastic energy (J; J/m in planar bodies).
    pub fn energy(&self) -> f64 {
        self.energy
    }

    /// Force that the supports on a boundary exert on the body (N; N/m in planar bodies), all around the axis.
    ///
    /// From the residual of the discrete equations, not from stresses. An axisymmetric body has no net radial force:
    /// `First` there is the radial force summed over the circumference. A corner shared with another supported boundary
    /// counts with its whole force.
    pub fn reaction(&self, boundary: &str, component: Component) -> Result<f64, ElasticityError> {
        let nodes = self.body.boundary_nodes(boundary)?;
        Ok(nodes.iter().map(|&n| self.forces[2 * n as usize + component.index()]).sum())
    }

    /// Force of the supports on one node (N; N/m in planar bodies), zero but for rounding where nothing holds it.
    pub fn support_force(&self, node: usize) -> [f64; 2] {
        [self.forces[2 * node], self.forces[2 * node + 1]]
    }

    /// Displacement at a point of the undeformed body (m).
    pub fn displacement_at(&self, at: Point) -> Result<[f64; 2], ElasticityError> {
        let (element, reference) = self.locate(at, None)?;
        Ok(self.body.displacement_in(element, reference, &self.state))
    }

    /// Displacement gradient of the fit around a point.
    fn gradient_in(&self, patch: &Patch, at: Point, higher: bool) -> Tensor {
        patch.weights(&self.body, higher).iter().fold(Tensor::zeros(), |h, &(n, w)| {
            h + self.nodal_gradient(patch, at, w, 0) * self.state[2 * n]
                + self.nodal_gradient(patch, at, w, 1) * self.state[2 * n + 1]
        })
    }

    /// Gradient of the fit for a unit displacement of one node.
    fn nodal_gradient(&self, patch: &Patch, at: Point, weight: [f64; 3], component: usize) -> Tensor {
        let mut h = Tensor::zeros();
        h[(component, R)] = weight[1];
        h[(component, Z)] = weight[2];
        if component == R && self.body.problem.symmetry == Symmetry::Axisymmetric {
            // Both are the hoop strain; on the axis only the second exists.
            let on_axis = at[0] <= 1e-9 * patch.reach;
            h[(T, T)] = if on_axis { weight[1] } else { weight[0] / at[0] };
        }
        h
    }

    /// Total strain at a point of the undeformed body, thermal part included: small strain in linear materials, Green
    /// strain in the others.
    pub fn strain_at(&self, at: Point) -> Result<Components, ElasticityError> {
        self.tensor_at(at, false)
    }

    /// Cauchy stress (Pa) at a point of the undeformed body; on an interface, that of the first region there.
    pub fn stress_at(&self, at: Point) -> Result<Components, ElasticityError> {
        self.tensor_at(at, true)
    }

    /// Cauchy stress (Pa) at a point of a named region.
    pub fn stress_in(&self, region: &str, at: Point) -> Result<Components, ElasticityError> {
        let (element, _) = self.locate(at, Some(region))?;
        Ok(self.tensor_in(element, at, true, false))
    }

    /// Stress or strain at a point.
    pub(crate) fn tensor_at(&self, at: Point, stress: bool) -> Result<Components, ElasticityError> {
        let (element, _) = self.locate(at, None)?;
        Ok(self.tensor_in(element, at, stress, false))
    }

    fn tensor_in(&self, element: usize, at: Point, stress: bool, higher: bool) -> Components {
        let patch = Patch::around(&self.body, element, at);
        let h = self.gradient_in(&patch, at, higher);
        self.tensor(element, at, &h, self.pressure(&patch, element), stress)
    }

    fn pressure(&self, patch: &Patch, element: usize) -> Option<f64> {
        let mixed = material(&self.body, element).formulation == Formulation::Mixed;
        mixed.then(|| patch.pressure_weights(&self.body).iter().map(|&(d, w)| w * self.state[d]).sum())
    }

    /// Stress or strain of the material of an element at a displacement gradient and a pressure.
    pub(crate) fn tensor(&self, element: usize, at: Point, h: &Tensor, pressure: Option<f64>, stress: bool) -> Components {
        let law = material(&self.body, element).law;
        if !stress {
            let green = if law == LawKind::Linear { Tensor::zeros() } else { h.tr_mul(h) };
            return Components::of(&((h + h.transpose() + green) * 0.5));
        }
        Components::of(&match law {
            LawKind::Linear => self.at::<Linear>(element, at, h, pressure).stress(),
            LawKind::SaintVenantKirchhoff => self.at::<SaintVenantKirchhoff>(element, at, h, pressure).cauchy(h),
            LawKind::NeoHookean => self.at::<NeoHookean>(element, at, h, pressure).cauchy(h),
        })
    }

    fn at<L: Law>(&self, element: usize, at: Point, h: &Tensor, pressure: Option<f64>) -> At<L> {
        let material = material(&self.body, element);
        let problem = &self.body.problem;
        let heat = material.expansion * self.load * problem.temperature.at(at);
        let split = ThermalStretch::new(material.law, heat);
        At::new(problem.symmetry, h, pressure, split, Moduli::from(material.lame()))
    }

    /// Weight of every unknown in the displacement at a point.
    pub(crate) fn displacement_weights(&self, at: Point, component: Component) -> Result<Vec<f64>, ElasticityError> {
        let (element, reference) = self.locate(at, None)?;
        let mut weights = vec![0.0; self.state.len()];
        let of = self.body.dofs.of(element);
        for (i, value) in P2::at(reference).0.iter().enumerate().take(self.body.problem.order.nodes()) {
            weights[of[2 * i + component.index()] as usize] = *value;
        }
        Ok(weights)
    }

    /// Derivative of a component of the recovered stress or strain by every unknown, and how far a fit of higher degree
    /// is from the one used.
    pub(crate) fn tensor_weights(
        &self,
        at: Point,
        stress: bool,
        pick: &dyn Fn(&Components) -> f64,
    ) -> Result<(Vec<f64>, f64), ElasticityError> {
        let (element, _) = self.locate(at, None)?;
        let patch = Patch::around(&self.body, element, at);
        let h = self.gradient_in(&patch, at, false);
        let p = self.pressure(&patch, element);
        // Central differences: the tensors are smooth in H on the scale of one, exact where they are linear.
        let step = 1e-5;
        let value = |h: &Tensor, p: Option<f64>| pick(&self.tensor(element, at, h, p, stress));
        let mut slope = Tensor::zeros();
        for (i, j) in [(R, R), (R, Z), (Z, R), (Z, Z), (T, T)] {
            let mut d = Tensor::zeros();
            d[(i, j)] = step;
            slope[(i, j)] = (value(&(h + d), p) - value(&(h - d), p)) / (2.0 * step);
        }
        let mut weights = vec![0.0; self.state.len()];
        for (n, w) in patch.weights(&self.body, false) {
            for c in [R, Z] {
                weights[2 * n + c] += slope.dot(&self.nodal_gradient(&patch, at, w, c));
            }
        }
        if let Some(p) = p {
            let step = 1e-5 * material(&self.body, element).young;
            let by_pressure = (value(&h, Some(p + step)) - value(&h, Some(p - step))) / (2.0 * step);
            patch.pressure_weights(&self.body).iter().for_each(|&(d, w)| weights[d] += w * by_pressure);
        }
        let higher = pick(&self.tensor_in(element, at, stress, true));
        Ok((weights, (higher - value(&h, p)).abs()))
    }

    /// Element and reference coordinates of a point, in a region if one is named.
    fn locate(&self, at: Point, region: Option<&str>) -> Result<(usize, [f64; 2]), ElasticityError> {
        locate(&self.body, at, region).ok_or(ElasticityError::Outside { at })
    }

    /// The mesh with its corners moved by the displacement, for problems on the deformed body.
    ///
    /// Edges become straight between displaced corners; edges on arcs lose their circle.
    pub fn deformed_mesh(&self) -> Mesh {
        let mut mesh = self.body.problem.mesh.clone();
        for (n, p) in mesh.points.iter_mut().enumerate() {
            let u = self.nodal(n);
            *p = [p[0] + u[0], p[1] + u[1]];
        }
        mesh.curved_edges.clear();
        mesh
    }
}
