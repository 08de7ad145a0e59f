//! The module graph of the workspace: which file names which, the circles among them, and the arrows that go up where they should go down.
//!
//! Sources are read as text ([`House::open`]); [`House::findings`] compares them with the declared order in `validation/house/order.toml`.
//!
//! Limits: macros are not expanded, and a method that is called on a value draws no arrow to the type's file; only names do.

mod check;
mod error;
mod face;
mod finding;
mod graph;
mod habits;
mod house;
mod import;
mod modules;
mod order;
mod print;
mod resolve;
mod review;
mod source;
mod vocabulary;
mod words;
mod workspace;

pub use error::HouseError;
pub use finding::Finding;
pub use graph::Arrow;
pub use house::House;
pub use order::ORDER;
pub use print::{Dot, Numbers, Plan, Reviewed, Unnamed};
pub use review::Row;
pub use workspace::Files;
