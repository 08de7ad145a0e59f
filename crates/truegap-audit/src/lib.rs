//! Every assumption of the analytic model, one file each: is it true, by how much is it wrong, and what does that do to the coefficients?
//!
//! A sensor becomes a [`Study`]; each [`Assumption`] compares one equation of the model with finite elements and says what the difference does by
//! running the analytic chain with that one piece replaced ([`Swap`]). Limits: axisymmetric bodies, steady state; recordings are not known here.

pub mod assumption;
pub mod assumptions;
pub mod audit;
pub mod cache;
pub mod cell;
pub mod corrections;
pub mod disc;
pub mod effect;
pub mod error;
pub mod finding;
pub mod fit;
pub mod ranking;
pub mod reference;
pub mod register;
pub mod study;
pub mod swap;

pub use assumption::Assumption;
pub use audit::{Audit, NotApplicable, run};
pub use cache::Cache;
pub use effect::{EffectOn, coefficients_of};
pub use error::AuditError;
pub use finding::{Curve, FemValue, Figure, Finding, Measure, Value, Verdict};
pub use ranking::{Ranked, Ranking, ranking};
pub use register::{chosen, register};
pub use study::{Options, Progress, Study, Watch};
pub use swap::{Chain, Swap};
