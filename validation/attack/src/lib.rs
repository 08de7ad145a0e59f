//! Inputs that must not get through: a list of attacks on the command `truegap`, and mutated inputs for every reader.
//!
//! Limits: needs a Unix shell, which limits the memory of what is attacked; elsewhere the list is empty.

pub mod attack;
pub mod bench;
pub mod list;
#[cfg(all(feature = "fem", target_os = "linux"))]
pub mod moments;
#[cfg(feature = "fem")]
pub mod readers;
