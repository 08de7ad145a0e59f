//! Predict, verify and explain a capacitive tactile sensor.
