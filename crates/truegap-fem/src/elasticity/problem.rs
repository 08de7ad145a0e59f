//! The description of an elastic problem: mesh, materials, conditions, temperature, body force.
//!
//! A body force keeps its direction and its size per *undeformed* volume; of a pressure [`PressureLoad`] says on which surface it acts.

use super::material::Material;
use crate::mesh::{Mesh, Point};
use crate::space::Order;
use crate::symmetry::Symmetry;
use std::fmt;
use std::sync::Arc;

/// Direction of a displacement or force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Component {
    /// r, or x.
    First,
    /// z, or y.
    Second,
}

impl Component {
    /// 0 or 1.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// Where a displacement is prescribed.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
    /// A named boundary, which may run inside the body.
    Boundary(String),
    /// A node of the mesh: a corner, or the middle of an edge (m).
    Point(Point),
}

/// On which side of a plane a body stays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// At larger coordinates.
    Above,
    /// At smaller coordinates.
    Below,
}

/// On which surface a pressure acts in large strain. In materials of small strain (`LawKind::Linear`) the two are the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PressureLoad {
    /// On the deformed surface, along its normal, per deformed area: a gas or a liquid.
    #[default]
    Following,
    /// On the undeformed surface, along its normal, per undeformed area: the total force and its direction are given.
    Dead,
}

/// A condition on the body.
#[derive(Debug, Clone, PartialEq)]
pub enum Condition {
    /// A displacement component has this value (m); 0 is a fixed support.
    Displacement {
        /// Where.
        place: Place,
        /// Which component.
        component: Component,
        /// Value (m).
        value: f64,
    },
    /// Pressure against the outer boundary (Pa).
    Pressure {
        /// Name of the boundary.
        boundary: String,
        /// Pressure (Pa), positive when it pushes.
        pressure: f64,
        /// On which surface.
        load: PressureLoad,
    },
    /// A rigid plane without friction that the boundary may touch and leave, not pass.
    Obstacle {
        /// Name of the boundary.
        boundary: String,
        /// Coordinate that the plane cuts.
        component: Component,
        /// Its value at the plane without load (m).
        position: f64,
        /// How far the plane moves at load factor 1 (m).
        travel: f64,
        /// Where the body stays.
        side: Side,
    },
}

impl Condition {
    /// Fixes a component on a boundary.
    pub fn fix(boundary: &str, component: Component) -> Condition {
        Condition::displace(boundary, component, 0.0)
    }

    /// Prescribes a component on a boundary (m).
    pub fn displace(boundary: &str, component: Component, value: f64) -> Condition {
        Condition::Displacement { place: Place::Boundary(boundary.into()), component, value }
    }

    /// Fixes a component at a node of the mesh.
    pub fn pin(point: Point, component: Component) -> Condition {
        Condition::Displacement { place: Place::Point(point), component, value: 0.0 }
    }

    /// Pressure on a boundary (Pa), which follows the surface in large strain.
    pub fn pressure(boundary: &str, pressure: f64) -> Condition {
        Condition::Pressure { boundary: boundary.into(), pressure, load: PressureLoad::Following }
    }

    /// Pressure on a boundary (Pa) as a dead load: per undeformed area and along the undeformed normal.
    pub fn dead_pressure(boundary: &str, pressure: f64) -> Condition {
        Condition::Pressure { boundary: boundary.into(), pressure, load: PressureLoad::Dead }
    }
}

/// A function of the place.
pub type Field<T> = Arc<dyn Fn(Point) -> T + Send + Sync>;

/// Temperature above the stress-free one (K).
#[derive(Clone)]
pub enum Temperature {
    /// `base + gradient . x`.
    Linear {
        /// At the origin (K).
        base: f64,
        /// Slopes (K/m).
        gradient: [f64; 2],
    },
    /// Any function of the place (K).
    Field(Field<f64>),
}

impl Temperature {
    /// The same everywhere (K).
    pub fn uniform(base: f64) -> Temperature {
        Temperature::Linear { base, gradient: [0.0; 2] }
    }

    /// Value at a point (K).
    #[inline]
    pub fn at(&self, p: Point) -> f64 {
        match self {
            Temperature::Linear { base, gradient } => base + gradient[0] * p[0] + gradient[1] * p[1],
            Temperature::Field(f) => f(p),
        }
    }
}

impl fmt::Debug for Temperature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Temperature::Linear { base, gradient } => {
                write!(f, "{base} K + {gradient:?} K/m")
            }
            Temperature::Field(_) => write!(f, "a function of the place"),
        }
    }
}

/// An elastic problem. Loads, prescribed displacements and temperature together are the load at factor 1.
#[derive(Clone)]
pub struct Problem {
    /// The undeformed body.
    pub mesh: Mesh,
    /// What the two coordinates mean; planar is plane strain.
    pub symmetry: Symmetry,
    /// One for each region of the mesh, in its order.
    pub materials: Vec<Material>,
    /// Supports and loads. In axisymmetric bodies nodes on the axis keep r = 0 without being told.
    pub conditions: Vec<Condition>,
    /// Temperature above the stress-free one.
    pub temperature: Temperature,
    /// Force per volume (N/m^3).
    pub body_force: Option<Field<[f64; 2]>>,
    /// Shapes.
    pub order: Order,
}

impl fmt::Debug for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Problem")
            .field("triangles", &self.mesh.triangles.len())
            .field("symmetry", &self.symmetry)
            .field("materials", &self.materials)
            .field("conditions", &self.conditions)
            .field("temperature", &self.temperature)
            .field("body_force", &self.body_force.is_some())
            .field("order", &self.order)
            .finish()
    }
}
