//! Shape functions, quadrature, element geometry and numbering of unknowns.
//!
//! Triangles with linear or quadratic shapes; geometry is always the six-node (quadratic) triangle.

mod element;
mod numbering;
mod quadrature;
mod shape;

pub use element::{EdgePoint, Element, Nodes, PointMap, least_jacobian};
pub use numbering::{ElementDofs, Numbering};
pub use quadrature::{QuadraturePoint, edge_rule, triangle_rule};
pub use shape::{Order, P1, P2, Shape, ShapeTable, edge_shape};
