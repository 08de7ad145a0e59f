//! Thermoelasticity of axisymmetric and planar bodies.
