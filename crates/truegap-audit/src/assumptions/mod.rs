//! The register's entries: bead cell and field in [`cell`], the warping and bending plate in [`plate`].
//!
//! Limits: a new assumption is a file in one of the two folders and a line in its list.

pub mod cell;
pub mod plate;
