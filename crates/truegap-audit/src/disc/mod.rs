//! The whole disc: a stack of layers on beads, heated and pressed, as finite elements and as the closed forms it is checked against.
//!
//! Axisymmetric: beads become rings of equal area fraction. What has no axis (a cylinder after buckling) is in `buckled`, by energy.

mod banded;
#[cfg(feature = "fem")]
mod baselines;
mod bead_spring;
#[cfg(feature = "fem")]
mod body;
#[cfg(feature = "fem")]
mod buckled;
mod columns;
#[cfg(feature = "fem")]
mod contact;
#[cfg(feature = "fem")]
mod corners;
#[cfg(feature = "fem")]
mod coupled;
#[cfg(feature = "fem")]
mod field;
#[cfg(feature = "fem")]
mod fineness;
#[cfg(feature = "fem")]
mod foundation;
mod laminate;
mod plate_contact;
#[cfg(feature = "fem")]
mod profile;
#[cfg(feature = "fem")]
mod refined;
mod ring_plate;
mod rings;
#[cfg(feature = "fem")]
mod section;
#[cfg(feature = "fem")]
mod shaped;
#[cfg(feature = "fem")]
mod submesh;
#[cfg(feature = "fem")]
mod von_mises;

#[cfg(feature = "fem")]
pub use baselines::{Baseline, DATA_SHEET_PCT_FSR_PER_K, baselines};
pub use bead_spring::BeadSpring;
#[cfg(feature = "fem")]
pub use body::{Disc, Facing, Loading, Rings, Strains};
#[cfg(feature = "fem")]
pub use buckled::{TwoCurvatures, buckled, critical_curvature};
#[cfg(feature = "fem")]
pub use contact::{Bond, Carried};
#[cfg(feature = "fem")]
pub use corners::{CornerCoefficients, corner_coefficients};
#[cfg(feature = "fem")]
pub use coupled::{BeadStrain, Beads, Charged, Coupled, CoupledOptions, Press, Whole};
#[cfg(feature = "fem")]
pub use field::Field;
#[cfg(feature = "fem")]
pub use fineness::Fineness;
#[cfg(feature = "fem")]
pub use foundation::{Foundation, Held};
pub use laminate::{Laminate, Sheet};
pub use plate_contact::Pressed;
#[cfg(feature = "fem")]
pub use profile::Profile;
pub use ring_plate::{Bent, RingPlate};
pub use rings::{Gap, Ring};
#[cfg(feature = "fem")]
pub use section::Section;
#[cfg(feature = "fem")]
pub use submesh::Part;
#[cfg(feature = "fem")]
pub use von_mises::von_mises;

#[cfg(feature = "fem")]
pub(crate) use baselines::cylindrical;
#[cfg(feature = "fem")]
pub(crate) use field::{field, gap_capacitance};
#[cfg(feature = "fem")]
pub(crate) use refined::{Refined, refined};
pub(crate) use rings::rings;
#[cfg(feature = "fem")]
pub(crate) use shaped::shaped;
