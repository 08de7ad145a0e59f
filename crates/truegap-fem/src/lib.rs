//! Axisymmetric and planar finite elements: thermoelasticity and electrostatics.
