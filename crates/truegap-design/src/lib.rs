//! Sensitivity, optimisation and tolerance of sensor designs.
