//! The paper's sensor: its numbers ([`Device`]), its rows ([`states`]), its data sheet ([`coefficients`]), and the model of a recording ([`Stack`]).
//!
//! Limits: what [`Device`] can describe; loads that close the gap are errors.

mod beside;
mod coefficients;
mod columns;
mod device;
mod knobs;
mod model;
mod options;
mod plates;
mod point;
mod sloped;
mod states;

pub use coefficients::{CoefficientOptions, Coefficients, coefficients};
pub use device::{Capacitances, Device, Squeeze, Warm};
pub use model::Stack;
pub use options::{SeriesOrder, StackOptions};
pub use states::{Point, State, states};
pub use truegap_core::Refusal;
