//! Every assumption of the analytic model, one file each: is it true, by how much is it wrong, and what does that do to the coefficients?
//!
//! A sensor becomes a [`Study`]; each [`Assumption`] compares one equation of the model with finite elements and says what the difference does by
//! running the analytic chain with that one piece replaced ([`Swap`]). Limits: axisymmetric bodies, steady state; recordings are not known here.
//!
//! | question | where |
//! |---|---|
//! | Which assumptions hold for a sensor? | [`register`], [`run`] |
//! | What does the analytic chain say with a piece replaced? | [`Study::effect`] |
//! | What corrects the chain at analytic speed? | [`corrections`] |
//! | What do finite elements say of the sensor? | [`reference`](mod@reference) by bead cells, [`disc`] for warp and contact, [`cell`] for one bead |
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

mod assumption;
mod assumptions;
mod audit;
mod cache;
pub mod cell;
pub mod corrections;
pub mod disc;
mod effect;
mod error;
mod finding;
mod fit;
mod measured;
mod ranking;
pub mod reference;
mod register;
mod study;
mod swap;

pub use assumption::Assumption;
pub use audit::{Audit, NotApplicable, run};
pub use cache::Cache;
pub use effect::{Corners, EffectOn, coefficients_of};
pub use error::AuditError;
pub use finding::{Curve, FemValue, Figure, Finding, Measure, Value, Verdict};
pub use ranking::{Ranked, Ranking};
pub use register::{chosen, register};
pub use study::{Options, Progress, Study, Watch};
pub use swap::{Chain, Row, Swap};
