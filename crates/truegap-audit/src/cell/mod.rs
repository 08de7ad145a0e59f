//! The unit cell of a bead: a cylinder of silicone between two plates, in the cylinder of air that is its share of the electrode.
//!
//! `press` squeezes the bead at finite strain, `cell_capacitance` solves the field around a bead of any profile. Limits: the cell is a cylinder of equal
//! area, so the directions towards the nearest neighbours are all alike; its side wall is a mirror for the field.

#[cfg(feature = "fem")]
mod charge;
mod filled;
mod geometry;
mod growth;
#[cfg(feature = "fem")]
mod heat;
#[cfg(feature = "fem")]
mod law;
#[cfg(feature = "fem")]
mod press;
#[cfg(feature = "fem")]
mod rim;

#[cfg(feature = "fem")]
pub use charge::{Charged, cell_capacitance};
pub use filled::Filled;
pub use geometry::{Cell, Profile};

pub(crate) use filled::filled;
#[cfg(feature = "fem")]
pub use heat::{Estimated, held_expansion};
#[cfg(feature = "fem")]
pub use law::{Law, bonded_law};
#[cfg(feature = "fem")]
pub use press::{Bonding, Pressed, PressedAt, heated_and_loaded, press};
#[cfg(feature = "fem")]
pub use rim::Layered;

pub(crate) use growth::Growth;
#[cfg(feature = "fem")]
pub(crate) use heat::heated_stiffness;
#[cfg(feature = "fem")]
pub(crate) use press::heated_and_squeezed;
