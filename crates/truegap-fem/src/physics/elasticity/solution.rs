//! What an equilibrium says: displacements, reactions, strains, stresses, energy, the deformed mesh.
//!
//! Strains and stresses come from a local fit to the displacements (see `recovery`), one region at a time.

use super::ElasticityError;
use super::body::Body;
use super::element::material;
use super::kinematics::{R, T, Z};
use super::laws::{Law, Linear, NeoHookean, SaintVenantKirchhoff, Tensor};
use super::material::{Formulation, LawKind};
use super::point::{At, Moduli};
use super::problem::Component;
use super::recovery::Patch;
use super::thermal::ThermalStretch;
use crate::Symmetry;
use crate::mesh::{Mesh, Point};
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
#[derive(Debug, Clone)]
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
    /// `First` there is the radial force summed over the circumference.
    pub fn reaction(&self, boundary: &str, component: Component) -> Result<f64, ElasticityError> {
        let nodes = self.body.boundary_nodes(boundary)?;
        Ok(nodes.iter().map(|&n| self.forces[2 * n as usize + component.index()]).sum())
    }

    /// Displacement at a point of the undeformed body (m).
    pub fn displacement_at(&self, at: Point) -> Result<[f64; 2], ElasticityError> {
        let (element, reference) = self.locate(at, None)?;
        Ok(self.body.displacement_in(element, reference, &self.state))
    }

    /// Recovered displacement gradient at a point, in the first region that has it.
    pub fn gradient_at(&self, at: Point) -> Result<Tensor, ElasticityError> {
        let (element, _) = self.locate(at, None)?;
        self.gradient_in(element, at)
    }

    fn gradient_in(&self, element: usize, at: Point) -> Result<Tensor, ElasticityError> {
        let patch = Patch::around(&self.body, element, at);
        let [r, z] = [0, 1].map(|c| patch.fit(&self.body, |n| self.state[2 * n + c]));
        let mut h = Tensor::zeros();
        h[(R, R)] = r.gradient[0];
        h[(R, Z)] = r.gradient[1];
        h[(Z, R)] = z.gradient[0];
        h[(Z, Z)] = z.gradient[1];
        if self.body.problem.symmetry == Symmetry::Axisymmetric {
            // Both are the hoop strain; on the axis only the second exists.
            let on_axis = at[0] <= 1e-9 * patch.reach;
            h[(T, T)] = if on_axis { r.gradient[0] } else { r.value / at[0] };
        }
        Ok(h)
    }

    /// Total strain at a point of the undeformed body, thermal part included: small strain in linear materials, Green
    /// strain in the others.
    pub fn strain_at(&self, at: Point) -> Result<Components, ElasticityError> {
        let (element, _) = self.locate(at, None)?;
        let h = self.gradient_in(element, at)?;
        let mut strain = (h + h.transpose()) * 0.5;
        if material(&self.body, element).law != LawKind::Linear {
            strain += h.tr_mul(&h) * 0.5;
        }
        Ok(Components::of(&strain))
    }

    /// Cauchy stress (Pa) at a point of the undeformed body; on an interface, that of the first region there.
    pub fn stress_at(&self, at: Point) -> Result<Components, ElasticityError> {
        self.stress(self.locate(at, None)?.0, at)
    }

    /// Cauchy stress (Pa) at a point of a named region.
    pub fn stress_in(&self, region: &str, at: Point) -> Result<Components, ElasticityError> {
        self.stress(self.locate(at, Some(region))?.0, at)
    }

    fn stress(&self, element: usize, at: Point) -> Result<Components, ElasticityError> {
        let h = self.gradient_in(element, at)?;
        let stress = match material(&self.body, element).law {
            LawKind::Linear => self.at::<Linear>(element, at, &h).stress(),
            LawKind::SaintVenantKirchhoff => self.at::<SaintVenantKirchhoff>(element, at, &h).cauchy(&h),
            LawKind::NeoHookean => self.at::<NeoHookean>(element, at, &h).cauchy(&h),
        };
        Ok(Components::of(&stress))
    }

    fn at<L: Law>(&self, element: usize, at: Point, h: &Tensor) -> At<L> {
        let material = material(&self.body, element);
        let problem = &self.body.problem;
        let pressure = (material.formulation == Formulation::Mixed)
            .then(|| Patch::around(&self.body, element, at).pressure(&self.body, &self.state));
        let heat = material.expansion * self.load * problem.temperature.at(at);
        At::new(problem.symmetry, h, pressure, ThermalStretch::new(material.law, heat), Moduli::from(material.lame()))
    }

    /// Element and reference coordinates of a point, in a region if one is named.
    fn locate(&self, at: Point, region: Option<&str>) -> Result<(usize, [f64; 2]), ElasticityError> {
        super::recovery::locate(&self.body, at, region).ok_or(ElasticityError::Outside { at })
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
