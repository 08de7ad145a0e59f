//! The contracts that every other crate shares: quantities with units, sensors, recordings, and the chain of physics that a simulator walks.
//!
//! Limits: nothing here computes a capacitance; this crate depends on no other crate of the workspace.

pub mod chain;
pub mod corrections;
pub mod curve;
pub mod effect;
pub mod inputs;
pub mod joined;
pub mod parameter;
pub mod recording;
pub mod sensor;
pub mod simulator;
pub mod units;

pub use chain::{Dielectric, Drive, FieldView, Geometry, Readout, Stage};
pub use corrections::Corrections;
pub use curve::{Curve, CurveError};
pub use effect::EffectId;
pub use inputs::Inputs;
pub use joined::Joined;
pub use parameter::{Parameter, Prior};
pub use recording::{BaseSpec, Note, Recording, RecordingError};
pub use sensor::{Material, Sensor};
pub use simulator::{Role, SimulationError, Simulator};
pub use units::{Dimension, Measure, UnitError};

/// Permittivity of vacuum as the paper's Table 1 gives it, F/m (CODATA 2018 is 8.8541878128e-12).
pub const VACUUM_PERMITTIVITY: f64 = 8.854e-12;
