//! Shape functions, quadrature, element geometry and numbering of unknowns.
//!
//! Triangles with linear or quadratic shapes; geometry is always the six-node (quadratic) triangle.

mod bubbles;
mod element;
mod numbering;
mod quadrature;
mod shape;

pub(crate) use bubbles::{ABOVE_QUADRATIC, Bubble, bubbles_above_linear, bubbles_above_quadratic};
pub(crate) use element::{EdgePoint, least_jacobian};
pub use element::{Element, Nodes, PointMap};
pub use numbering::{ElementDofs, Numbering};
pub(crate) use quadrature::edge_rule;
pub use quadrature::{QuadraturePoint, triangle_rule};
pub(crate) use shape::edge_shape;
pub use shape::{Order, P1, P2, Shape, ShapeTable};
