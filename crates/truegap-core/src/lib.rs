//! The contracts that every other crate shares: quantities with units, sensors, recordings, and the chain of physics that a simulator walks.
//!
//! Limits: nothing here computes a capacitance; this crate depends on no other crate of the workspace.
//!
//! # What is where
//!
//! | what | items |
//! |---|---|
//! | quantities with units | [`units`], [`Measure`], [`Dimension`] |
//! | a sensor, from its file or built in | [`Sensor`], [`sensor`] |
//! | a recording, from its files | [`Recording`], [`recording`] |
//! | what was done to a sensor | [`Inputs`], [`Role`], [`INPUT_ROLES`] |
//! | the chain from load to reading, and what plugs in | [`Stage`], [`StageName`], [`Drive`], [`Geometry`], [`Dielectric`], [`FieldView`], [`Readout`] |
//! | a model of the response | [`Instrument`], where it is an equation of the load; [`Simulator`], [`Parameter`], [`Prior`], [`SimulationError`] |
//! | how a model walks the chain | [`walk`], [`Plates`], [`walk_without_plates`] |
//! | what finite elements say of a sensor | [`Corrections`], [`Curve`] |
//!
//! # A sensor and a recording, from text
//!
//! ```
//! use truegap_core::{Recording, sensor::builtin_sensors};
//!
//! // a built-in sensor is the text of a sensor file; `Sensor::from_toml` reads one of your own
//! let sensor = builtin_sensors()[0].sensor()?;
//! assert_eq!((sensor.name.as_str(), sensor.full_scale), ("singletact-s15-4.5n", 4.5));
//!
//! // units are converted once, here: millinewtons become newtons, counts stay counts
//! let toml = r#"
//! schema = "truegap.recording/1"
//! file = "press.csv"
//! [columns]
//! force = "load"
//! response = "read"
//! [units]
//! force = "mN"
//! response = "counts"
//! "#;
//! let recording = Recording::from_text("press", toml, "load,read\n0,240\n1500,238\n4500,229\n")?;
//! assert_eq!(recording.inputs.force_n.as_deref(), Some(&[0.0, 1.5, 4.5][..]));
//! assert_eq!((recording.response.as_slice(), recording.response_unit.as_str()), (&[240.0, 238.0, 229.0][..], "counts"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Types that need one another
//!
//! [`Simulator`] and [`Joined`] stand in one file, because a joint model is a `Simulator` that hands out the `Simulator`s that it joins. No two files of this
//! crate need one another.

mod asked_last;
mod chain;
mod column;
mod corrections;
mod curve;
mod effect;
mod given_again;
mod inputs;
mod instrument;
pub mod nearest;
mod parameter;
pub mod recording;
pub mod sensor;
mod simulation_error;
pub mod simulator;
pub mod units;
mod walk;

pub use asked_last::asked_last;
pub use chain::{Dielectric, Drive, FieldView, Geometry, Readout, Stage, StageName};
pub use column::{MEDIAN_NORMAL, ends, median, same_column, sd_of_differences};
pub use corrections::Corrections;
pub use curve::{Curve, CurveError, Smooth};
pub use effect::EffectId;
pub use given_again::given_again;
pub use inputs::{Driver, INPUT_ROLES, Inputs, LOADS, Role};
pub use instrument::Instrument;
pub use parameter::{Parameter, Prior};
pub use recording::{BaseSpec, Note, Recording, RecordingError};
pub use sensor::{Material, Sensor};
pub use simulation_error::{Refusal, SimulationError, check_finite};
pub use simulator::{Beside, Joined, Simulator, named_values};
pub use units::{Dimension, Measure, UnitError};
pub use walk::{
    GapReading, GapReadings, PlateColumns, PlateReading, Plates, Readings, RefusedRow, Stiffness, beyond_the_ends, walk,
    walk_without_plates,
};

/// Permittivity of vacuum as the paper's Table 1 gives it, F/m (CODATA 2018 is 8.8541878128e-12).
pub const VACUUM_PERMITTIVITY: f64 = 8.854e-12;
