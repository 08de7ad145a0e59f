//! The analytic model of a capacitive tactile sensor, one function per equation.
