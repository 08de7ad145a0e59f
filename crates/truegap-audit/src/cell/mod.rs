//! The unit cell of a bead: a cylinder of silicone between two plates, in the cylinder of air that is its share of the electrode.
//!
//! [`press`] squeezes the bead at finite strain, [`cell_capacitance`] solves the field around a bead of any profile. Limits: the cell is a cylinder of equal
//! area, so the directions towards the nearest neighbours are all alike; its side wall is a mirror for the field.

mod charge;
mod geometry;
mod growth;
mod heat;
mod law;
mod press;
mod rim;

pub use charge::{Charged, Filled, cell_capacitance};
pub use geometry::{Cell, Profile};
pub use heat::{Estimated, held_expansion};
pub use law::{Law, bonded_law};
pub use press::{Bonding, Pressed, PressedAt, heated_and_loaded, press};
pub use rim::Layered;

pub(crate) use growth::Growth;
pub(crate) use heat::heated_stiffness;
pub(crate) use press::heated_and_squeezed;
