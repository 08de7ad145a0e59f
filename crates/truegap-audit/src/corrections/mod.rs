//! What finite elements find, condensed into smooth dimensionless tables over the paper's design space.
//!
//! Each table is made by `cargo run --release -p truegap-audit --example corrections` and committed under `tables/`; it carries its range and its
//! measured accuracy. Limits: Poisson's ratio and permittivities as the axes or the text of a table say.

mod corrected;
pub mod coupled;
pub mod designs;
mod library;
pub mod make;
mod table;

pub use corrected::Corrected;
pub use library::{Library, library};
pub use table::{Axis, Table};
