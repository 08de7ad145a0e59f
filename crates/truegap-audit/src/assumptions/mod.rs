//! The register's entries: bead cell and field in [`cell`], the warping and bending plate in [`plate`].
//!
//! Limits: a new assumption is a file in one of the two folders and a line in its list.

pub(crate) mod cell;
mod over_load;
pub(crate) mod plate;
