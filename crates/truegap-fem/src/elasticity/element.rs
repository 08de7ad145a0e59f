//! Element energy, residual and tangent: the forms of `point` summed over quadrature points.
//!
//! One loop for all laws, symmetries and formulations.

use super::body::Body;
use super::kinematics::displacement_gradient;
use super::laws::{Law, Linear, NeoHookean, SaintVenantKirchhoff};
use super::material::{Formulation, LawKind, Material};
use super::point::{At, Moduli, Visitor};
use super::quadrature_point::MappedQuadraturePoint;
use super::thermal::ThermalStretch;
use crate::space::{Order, P1, P2, PointMap, QuadraturePoint, ShapeTable, triangle_rule};

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

    /// The same rule for all laws.
    pub(crate) fn of_degree(degree: usize) -> Tables {
        let rule = triangle_rule(degree);
        let (quadratic, linear) = (P2::table(&rule), P1::table(&rule));
        Tables { quadratic: [quadratic.clone(), quadratic], linear: [linear.clone(), linear] }
    }

    fn of(&self, law: LawKind) -> (&[ShapeTable<6>], &[ShapeTable<3>]) {
        let k = usize::from(law != LawKind::Linear);
        (&self.quadratic[k], &self.linear[k])
    }
}

/// Visits the quadrature points of an element.
pub(crate) fn for_each_quadrature_point(body: &Body, tables: &Tables, e: usize, mut visit: impl FnMut(MappedQuadraturePoint)) {
    let (quadratic, linear) = tables.of(material(body, e).law);
    let element = body.nodes.element(e);
    for (q, l) in quadratic.iter().zip(linear) {
        visit_mapped(body, e, element.map(q), q, l, &mut visit);
    }
}

fn visit_mapped(
    body: &Body,
    e: usize,
    map: PointMap,
    q: &ShapeTable<6>,
    l: &ShapeTable<3>,
    visit: &mut impl FnMut(MappedQuadraturePoint),
) {
    let problem = &body.problem;
    let (six, three) = (map.shapes(q), map.shapes(l));
    visit(MappedQuadraturePoint {
        at: map.at,
        weight: q.weight * map.jacobian * problem.symmetry.weight(map.at[0]),
        shapes: match problem.order {
            Order::Linear => &three,
            Order::Quadratic => &six,
        },
        pressures: match material(body, e).formulation {
            Formulation::Displacement => &[],
            Formulation::Mixed => &l.value,
        },
        barycentric: l.value,
        map,
    });
}

/// Material of an element.
pub(crate) fn material(body: &Body, e: usize) -> &Material {
    &body.problem.materials[body.problem.mesh.triangle_regions[e] as usize]
}

/// Adds up the energy of an element.
pub(crate) struct Energy(pub f64);

impl Visitor for Energy {
    fn visit<L: Law>(&mut self, at: &At<L>, s: &MappedQuadraturePoint) {
        self.0 += s.weight * at.energy();
    }
}

/// Adds up the inner forces of an element.
pub(crate) struct Residual<'a>(pub &'a mut [f64]);

impl Visitor for Residual<'_> {
    fn visit<L: Law>(&mut self, at: &At<L>, s: &MappedQuadraturePoint) {
        at.add_residual(s, self.0);
    }
}

/// Adds up the tangent of an element, column by column.
pub(crate) struct Tangent<'a>(pub &'a mut [f64]);

impl Visitor for Tangent<'_> {
    fn visit<L: Law>(&mut self, at: &At<L>, s: &MappedQuadraturePoint) {
        at.add_tangent(s, self.0);
    }
}

/// Visits the quadrature points of an element at the unknowns `state` (of the whole body) under the load factor `load`.
///
/// `for_matrix` keeps an incompressible volume from a zero pivot.
pub(crate) fn evaluate_points(
    body: &Body,
    tables: &Tables,
    e: usize,
    state: &[f64],
    load: f64,
    for_matrix: bool,
    visitor: &mut impl Visitor,
) {
    dispatch(Place { body, e, state, load, moduli: moduli(body, e, for_matrix), points: Points::Rule(tables) }, visitor);
}

/// Visits one reference point of an element.
pub(crate) fn evaluate_at(
    body: &Body,
    e: usize,
    reference: [f64; 2],
    state: &[f64],
    load: f64,
    for_matrix: bool,
    visitor: &mut impl Visitor,
) {
    dispatch(Place { body, e, state, load, moduli: moduli(body, e, for_matrix), points: Points::One(reference) }, visitor);
}

fn moduli(body: &Body, e: usize, for_matrix: bool) -> Moduli {
    let mut moduli = Moduli::from(material(body, e).lame());
    if for_matrix {
        moduli.compliance = moduli.compliance.max(LEAST_COMPLIANCE / moduli.mu);
    }
    moduli
}

fn dispatch(place: Place, visitor: &mut impl Visitor) {
    match material(place.body, place.e).law {
        LawKind::Linear => place.visit::<Linear>(visitor),
        LawKind::SaintVenantKirchhoff => place.visit::<SaintVenantKirchhoff>(visitor),
        LawKind::NeoHookean => place.visit::<NeoHookean>(visitor),
    }
}

enum Points<'a> {
    Rule(&'a Tables),
    One([f64; 2]),
}

struct Place<'a> {
    body: &'a Body,
    points: Points<'a>,
    e: usize,
    state: &'a [f64],
    load: f64,
    moduli: Moduli,
}

impl Place<'_> {
    fn visit<L: Law>(&self, visitor: &mut impl Visitor) {
        let material = material(self.body, self.e);
        let symmetry = self.body.problem.symmetry;
        let mut local = [0.0; 15];
        let of = self.body.dofs.of(self.e);
        of.iter().zip(&mut local).for_each(|(&d, l)| *l = self.state[d as usize]);
        let inner = 2 * self.body.problem.order.nodes();
        let mut visit = |s: MappedQuadraturePoint| {
            let h = displacement_gradient(symmetry, s.at[0], s.shapes, &local[..inner]);
            let pressure = (!s.pressures.is_empty()).then(|| {
                let p = &local[inner..];
                s.pressures.iter().zip(p).map(|(n, p)| n * p).sum()
            });
            let heat = material.expansion * self.load * self.body.problem.temperature.at(s.at);
            let split = ThermalStretch::new(material.law, heat);
            visitor.visit(&At::<L>::new(symmetry, &h, pressure, split, self.moduli), &s);
        };
        match self.points {
            Points::Rule(tables) => for_each_quadrature_point(self.body, tables, self.e, visit),
            Points::One(reference) => {
                let rule = [QuadraturePoint { at: reference, weight: 1.0 }];
                let map = self.body.nodes.element(self.e).map_at(reference);
                visit_mapped(self.body, self.e, map, &P2::table(&rule)[0], &P1::table(&rule)[0], &mut visit);
            }
        }
    }
}

#[cfg(test)]
mod tests;
