//! Elastic laws: energy per reference volume as a function of the displacement gradient, with its first and second
//! derivatives.
//!
//! Every law here has the form `W = mu s(H) + lambda / 2 g(H)^2`: a shear part `s` and a measure of volume `g`. In the
//! mixed formulation `lambda g` becomes an unknown of its own, so that the law holds up to incompressibility.

mod law;
mod linear;
mod neo_hookean;
mod saint_venant_kirchhoff;

pub use law::{Law, Tensor};
pub use linear::Linear;
pub use neo_hookean::NeoHookean;
pub use saint_venant_kirchhoff::SaintVenantKirchhoff;

#[cfg(test)]
mod tests;
