//! A capacitive tactile sensor as its maker would describe it: layers, materials, tolerances. SI inside.
//!
//! Limits: a circular electrode; one compressible dielectric; at most two metals in the warping electrode.

mod builtin;
mod check;
mod description;
mod error;
mod file;
mod materials;
mod table;

pub use builtin::{BuiltIn, builtin_sensor, builtin_sensors};
pub use description::{CompressibleDielectric, Filling, Layer, Layout, Material, Sensor};
pub use error::{SensorError, SensorProblem};
