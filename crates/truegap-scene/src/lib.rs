//! Surfaces and fields as glTF, VTU and figures.
//!
//! Everything here takes plain arrays and returns text or bytes; nothing here knows a sensor, a solver or a file format of
//! the project. What is drawn is what was given: no smoothing, no silent clamps; thinning keeps every extreme.

pub mod colour;
pub mod figure;
pub mod glb;
pub mod page;
pub mod solid;
pub mod viewer;
pub mod vtu;
