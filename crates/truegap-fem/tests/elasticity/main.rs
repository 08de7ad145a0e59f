//! Elasticity against exact fields, closed forms and published values.

#![allow(clippy::unwrap_used)]

mod bodies;
mod cases;
mod contact;
mod finite;
mod goals;
mod linear;
mod mixed;
mod mutations;
mod pressure;
mod punch;
mod refusals;
mod stability;
