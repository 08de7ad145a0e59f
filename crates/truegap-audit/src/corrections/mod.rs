//! What finite elements find, condensed into smooth dimensionless tables over the paper's design space.
//!
//! Each table is made by `cargo run --release -p truegap-audit --example corrections` and committed under `tables/`; it carries its range and its
//! measured accuracy. Limits: Poisson's ratio and permittivities as the axes or the text of a table say.

mod bead_law;
mod bonded;
mod corrected;
mod curves;
mod designs;
mod library;
#[cfg(feature = "fem")]
mod make;
mod one_sensor;
mod parts;
mod pieces;
mod range;
mod table;
mod warped;

pub use corrected::Corrected;
pub use curves::curves;
pub use designs::held_out;
pub use library::{Library, library};
#[cfg(feature = "fem")]
pub use make::{MAKERS, Maker};
pub use parts::Parts;
pub use table::{Axis, Table};
pub use warped::Gains;

pub(crate) use bonded::BondedLayers;
