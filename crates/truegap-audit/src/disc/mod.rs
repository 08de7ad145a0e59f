//! The whole disc: a stack of layers on beads, heated and pressed, as finite elements and as the closed forms it is checked against.
//!
//! Axisymmetric: beads become rings of equal area fraction. What has no axis (a cylinder after buckling) is in [`buckled`], by energy.

mod banded;
pub mod baselines;
pub mod bead_spring;
pub mod body;
pub mod buckled;
pub mod columns;
pub mod contact;
pub mod corners;
pub mod coupled;
pub mod field;
pub mod foundation;
pub mod laminate;
pub mod plate_contact;
pub mod profile;
pub mod refined;
pub mod ring_plate;
pub mod section;
pub mod shaped;
pub mod submesh;
pub mod von_mises;

pub use baselines::{Baseline, baselines};
pub use bead_spring::BeadSpring;
pub use body::{Disc, Facing, Fineness, Loading, Rings, Strains};
pub use corners::{CornerCoefficients, corner_coefficients};
pub use coupled::{BeadStrain, Beads, Charged, Coupled, CoupledOptions, Press, Whole};
pub use laminate::{Laminate, Sheet};
pub use profile::Profile;
pub use refined::{Refined, refined};
pub use ring_plate::{Bent, RingPlate};
pub use section::{Gap, Section};
pub use shaped::shaped;
