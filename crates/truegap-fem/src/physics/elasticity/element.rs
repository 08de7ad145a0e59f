//! Element energy, residual and tangent: the forms of `point` summed over quadrature points.
//!
//! One loop for all laws, symmetries and formulations.

use super::body::Body;
use super::kinematics::displacement_gradient;
use super::laws::{Law, Linear, NeoHookean, SaintVenantKirchhoff};
use super::material::{Formulation, LawKind, Material};
use super::point::{At, Moduli};
use super::problem::Order;
use super::thermal::ThermalStretch;
use crate::Symmetry;
use crate::mesh::Point;
use crate::space::{P1, P2, Shape, ShapeTable, triangle_rule};

/// Softest stand-in for an incompressible volume in the *matrix*, relative to the shear modulus: pivots stay away from
/// zero, and refinement with the true residual removes the difference.
const LEAST_COMPLIANCE: f64 = 1e-7;

/// Shape values at the quadrature points of the three laws.
pub(crate) struct Tables {
    quadratic: [Vec<ShapeTable<6>>; 2],
    linear: [Vec<ShapeTable<3>>; 2],
}

impl Tables {
    pub(crate) fn new() -> Tables {
        let rules = [Linear::QUADRATURE_DEGREE, NeoHookean::QUADRATURE_DEGREE].map(triangle_rule);
        Tables { quadratic: [P2::table(&rules[0]), P2::table(&rules[1])], linear: [P1::table(&rules[0]), P1::table(&rules[1])] }
    }

    fn of(&self, law: LawKind) -> (&[ShapeTable<6>], &[ShapeTable<3>]) {
        let k = usize::from(law != LawKind::Linear);
        (&self.quadratic[k], &self.linear[k])
    }
}

/// A quadrature point of an element: where, how heavy, the shapes there.
pub(crate) struct Station<'a> {
    pub at: Point,
    /// Quadrature weight, Jacobian and 2 pi r together.
    pub weight: f64,
    /// Displacement shapes.
    pub shapes: &'a [Shape],
    /// Pressure shapes, empty without pressure.
    pub pressures: &'a [f64],
}

/// Visits the quadrature points of an element.
pub(crate) fn stations(body: &Body, tables: &Tables, e: usize, mut visit: impl FnMut(Station)) {
    let problem = &body.problem;
    let material = material(body, e);
    let element = body.nodes.element(e);
    let (quadratic, linear) = tables.of(material.law);
    for (q, l) in quadratic.iter().zip(linear) {
        let map = element.map(q);
        let weight = q.weight * map.jacobian * problem.symmetry.weight(map.at[0]);
        let six = map.shapes(q);
        let three = map.shapes(l);
        let shapes: &[Shape] = match problem.order {
            Order::Linear => &three,
            Order::Quadratic => &six,
        };
        let pressures: &[f64] = match material.formulation {
            Formulation::Displacement => &[],
            Formulation::Mixed => &l.value,
        };
        visit(Station { at: map.at, weight, shapes, pressures });
    }
}

/// Material of an element.
pub(crate) fn material(body: &Body, e: usize) -> &Material {
    &body.problem.materials[body.problem.mesh.triangle_regions[e] as usize]
}

/// What is asked of an element.
pub(crate) enum Ask<'a> {
    /// Energy, added to the number.
    Energy(&'a mut f64),
    /// Inner forces, added to the vector.
    Residual(&'a mut [f64]),
    /// Tangent, column by column, added to the matrix.
    Tangent(&'a mut [f64]),
}

/// Evaluates an element at the unknowns `state` (of the whole body) under the load factor `load`.
pub(crate) fn evaluate(body: &Body, tables: &Tables, e: usize, state: &[f64], load: f64, ask: Ask) {
    match material(body, e).law {
        LawKind::Linear => with_law::<Linear>(body, tables, e, state, load, ask),
        LawKind::SaintVenantKirchhoff => with_law::<SaintVenantKirchhoff>(body, tables, e, state, load, ask),
        LawKind::NeoHookean => with_law::<NeoHookean>(body, tables, e, state, load, ask),
    }
}

fn with_law<L: Law>(body: &Body, tables: &Tables, e: usize, state: &[f64], load: f64, mut ask: Ask) {
    let material = material(body, e);
    let symmetry: Symmetry = body.problem.symmetry;
    let mut local = [0.0; 15];
    let of = body.dofs.of(e);
    of.iter().zip(&mut local).for_each(|(&d, l)| *l = state[d as usize]);
    let inner = 2 * body.problem.order.nodes();
    let mut moduli = Moduli::from(material.lame());
    if let Ask::Tangent(_) = ask {
        moduli.compliance = moduli.compliance.max(LEAST_COMPLIANCE / moduli.mu);
    }
    stations(body, tables, e, |s| {
        let h = displacement_gradient(symmetry, s.at[0], s.shapes, &local[..inner]);
        let pressure = (!s.pressures.is_empty()).then(|| {
            let p = &local[inner..];
            s.pressures.iter().zip(p).map(|(n, p)| n * p).sum()
        });
        let heat = material.expansion * load * body.problem.temperature.at(s.at);
        let split = ThermalStretch::new(material.law, heat);
        let at = At::<L>::new(symmetry, &h, pressure, split, moduli);
        match &mut ask {
            Ask::Energy(sum) => **sum += s.weight * at.energy(),
            Ask::Residual(out) => at.add_residual(&s, out),
            Ask::Tangent(out) => at.add_tangent(&s, out),
        }
    });
}
