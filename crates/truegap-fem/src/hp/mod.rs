//! The hp version: polynomials of high degree on meshes that are graded geometrically into the singular corners.
//!
//! Near a corner a solution grows as `d^a` with an exponent that angle, materials and conditions give before anything is solved
//! ([`corner`]). Layers that shrink by a constant factor toward such corners, with a degree that rises with the number of layers,
//! converge exponentially where refinement at fixed degree converges algebraically. Straight edges and linear problems only; what
//! else there is stays with the refinement of quadratic elements.
//!
//! **Source:** Babuska & Guo (1988); Schwab, p- and hp-Finite Element Methods (1998).

mod corner;
mod dense;
mod error;
mod fan;
mod fronts;
mod grading;
mod order;
mod reference;
mod sequence;
mod shapes;
mod space;
mod system;

pub(crate) use corner::{Laplace, Side, Williams};
pub use error::HpError;
pub(crate) use error::check_straight;
pub(crate) use fan::Edge;
pub(crate) use reference::{AffineElement, Reference};
pub(crate) use sequence::{Functional, Level, Physics, refine};
pub use sequence::{HpOutcome, HpSeconds};
pub(crate) use shapes::line_shapes;
pub(crate) use space::{Local, Space};
pub(crate) use system::{Gram, gram};
