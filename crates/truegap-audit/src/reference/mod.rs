//! The sensor by finite elements: what [`crate::corrections::Corrected`] is compared with. Nothing here is taken from a table.
//!
//! [`FlatCells`] is the sensor as equal bead cells between flat plates, [`CellDisc`] the disc on rings that push and conduct as those cells do. Limits:
//! bonded beads, one temperature, a rigid load plate.

mod cell_disc;
mod cells;
mod ring_medium;

pub use cell_disc::{CellDisc, DiscState};
pub use cells::{CellSlopes, CellState, FlatCells};
