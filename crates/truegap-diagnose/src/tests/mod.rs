//! Tests of several stages together, which no user of the crate can reach.

#![allow(clippy::unwrap_used)]

mod around;
mod evidence;
mod linear;
mod noise;
pub(crate) mod search;
