//! Equations (1)-(28) of the paper, one function each, grouped as the paper groups them.
//!
//! Limits: corrected forms (see `docs/errata.md`); printed forms of (12) and (17) carry `_as_printed` in their name. SI in, SI out, and no
//! physical constant hidden inside: a permittivity is always the absolute one, F/m, so that every formula survives a change of base units.
//! Compressive strain, pressure and load are positive, unlike in the paper.

pub mod coefficients;
pub mod curvature;
pub mod electrodes;
pub mod integral;
pub mod load;
pub mod plates;
pub mod quadrature;
pub mod slopes;
pub mod thermal;
pub mod warp;
