//! Several recordings as one problem: one model whose rows are blocks, each with its own sensor, inputs, clock and runs.
//!
//! Limits: one response unit; a run belongs to one recording.

pub(crate) mod columns;
pub(crate) mod free;
pub(crate) mod member;
pub(crate) mod share;
pub(crate) mod together;

pub use columns::behind_one_another;
pub use free::Free;
pub use member::Member;
pub use share::Sharing;
pub use together::{Joint, JointError, Together};
