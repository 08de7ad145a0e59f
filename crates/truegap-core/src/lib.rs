//! Quantities at the edges, sensors, recordings and the simulator contract.
