//! Every assumption of the analytic model, one file each: is it true, by how much is it wrong, and what does that do to the coefficients?
//!
//! A sensor becomes a `Study`; each `Assumption` compares one equation of the model with finite elements and says what the difference does by
//! running the analytic chain with that one piece replaced (`Swap`). Limits: axisymmetric bodies, steady state; recordings are not known here.
//!
//! | question | where |
//! |---|---|
//! | Which assumptions hold for a sensor? | `register`, `run` |
//! | What does the analytic chain say with a piece replaced? | `Study::effect` |
//! | What corrects the chain at analytic speed? | [`corrections`] |
//! | What do finite elements say of the sensor? | `reference` by bead cells, [`disc`] for warp and contact, [`cell`] for one bead |
//!
//! # Example
//!
//! One assumption of the register for a built-in sensor, and the correction that follows from it:
//!
//! ```
//! use truegap_audit::corrections::curves;
//! use truegap_audit::{Options, Study, Watch, chosen, register};
//! use truegap_core::sensor::builtin_sensor;
//!
//! let sensor = builtin_sensor("singletact-s15-4.5n").ok_or("no such sensor")??;
//! for assumption in register() {
//!     println!("{:26} {}", assumption.id(), assumption.says());
//! }
//!
//! let watch = Watch::default(); // nobody watches
//! let study = Study::new(&sensor, Options::default(), &watch)?;
//! let finding = chosen(&["TAIL-PARALLEL-PLATE".into()])?[0].examine(&study)?;
//! println!("{:?}: {}", finding.verdict, finding.reason);
//! // parallel plates leave out the field at the edges of the trace
//! assert!(finding.fem.value > finding.analytic.value);
//!
//! let missing_pf = curves(&sensor)?.tail_edge_pf;
//! assert!((missing_pf / (finding.fem.value - finding.analytic.value) - 1.0).abs() < 0.05);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Files that need one another
//!
//! None: every file uses files below it only.

#![warn(unreachable_pub)]
// Used by what solves; the tables need no more than a part of it.
#![cfg_attr(not(feature = "fem"), allow(dead_code, unused_imports))]

#[cfg(feature = "fem")]
mod assumption;
#[cfg(feature = "fem")]
mod assumptions;
#[cfg(feature = "fem")]
mod audit;
#[cfg(feature = "fem")]
mod cache;
pub mod cell;
pub mod corrections;
pub mod disc;
#[cfg(feature = "fem")]
mod effect;
mod error;
#[cfg(feature = "fem")]
mod finding;
mod fit;
#[cfg(feature = "fem")]
mod measured;
#[cfg(feature = "fem")]
mod ranking;
#[cfg(feature = "fem")]
pub mod reference;
#[cfg(feature = "fem")]
mod register;
#[cfg(feature = "fem")]
mod study;
#[cfg(feature = "fem")]
mod swap;

#[cfg(feature = "fem")]
pub use assumption::Assumption;
#[cfg(feature = "fem")]
pub use audit::{Audit, NotApplicable, run};
#[cfg(feature = "fem")]
pub use cache::Cache;
#[cfg(feature = "fem")]
pub use effect::{Corners, EffectOn, coefficients_of};
pub use error::AuditError;
#[cfg(feature = "fem")]
pub use finding::{Curve, FemValue, Figure, Finding, Measure, Value, Verdict};
#[cfg(feature = "fem")]
pub use ranking::{Ranked, Ranking};
#[cfg(feature = "fem")]
pub use register::{chosen, register};
#[cfg(feature = "fem")]
pub use study::{Options, Progress, Study, Watch};
#[cfg(feature = "fem")]
pub use swap::{Chain, Row, Swap};
