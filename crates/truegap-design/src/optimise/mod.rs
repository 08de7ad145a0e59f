//! Designs with smaller temperature coefficients: a mixed space, constraints that keep a sensor useful, fronts and the minimisation vector.
//!
//! Limits: the search sees a unit cube; levels and whole numbers are steps in it. L1 of the paper's Table 2 enters no equation and is no axis.

mod constraint;
mod design;
mod directions;
mod front;
mod hypervolume;
mod latin;
mod pareto;
mod problem;
mod space;
mod union;
mod vector;

pub use constraint::{CONSTRAINTS, Constraint, Useful};
pub use design::Design;
pub use front::{Evaluation, Front, FrontPoint, SearchOptions, front};
pub use hypervolume::{hypervolume_2d, hypervolume_3d};
pub use latin::latin_hypercube;
pub use problem::{Candidate, DesignProblem, Exclusion, OBJECTIVES};
pub use space::{Axis, Choice, Space};
pub use union::{Searched, search, thin, unite};
pub use vector::descend;
