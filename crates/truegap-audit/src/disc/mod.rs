//! The whole disc: a stack of layers on beads, heated and pressed, as finite elements and as the closed forms it is checked against.
//!
//! Axisymmetric: beads become rings of equal area fraction. What has no axis (a cylinder after buckling) is in [`buckled()`], by energy.

mod banded;
mod baselines;
mod bead_spring;
mod body;
mod buckled;
mod columns;
mod contact;
mod corners;
mod coupled;
mod field;
mod fineness;
mod foundation;
mod laminate;
mod plate_contact;
mod profile;
mod refined;
mod ring_plate;
mod section;
mod shaped;
mod submesh;
mod von_mises;

pub use baselines::{Baseline, DATA_SHEET_PCT_FSR_PER_K, baselines};
pub use bead_spring::BeadSpring;
pub use body::{Disc, Facing, Loading, Rings, Strains};
pub use buckled::{TwoCurvatures, buckled, critical_curvature};
pub use contact::{Bond, Carried};
pub use corners::{CornerCoefficients, corner_coefficients};
pub use coupled::{BeadStrain, Beads, Charged, Coupled, CoupledOptions, Press, Whole};
pub use field::Field;
pub use fineness::Fineness;
pub use foundation::{Foundation, Held};
pub use laminate::{Laminate, Sheet};
pub use plate_contact::Pressed;
pub use profile::Profile;
pub use ring_plate::{Bent, RingPlate};
pub use section::{Gap, Ring, Section};
pub use submesh::Part;
pub use von_mises::von_mises;

pub(crate) use baselines::cylindrical;
pub(crate) use field::{field, gap_capacitance};
pub(crate) use refined::{Refined, refined};
pub(crate) use section::rings;
pub(crate) use shaped::shaped;
