//! Elasticity against exact fields, closed forms and published values.

#![allow(clippy::unwrap_used)]

mod bodies;
mod finite;
mod linear;
mod mixed;
mod stability;
