//! The general plate sensor: (1) and (2).
//!
//! Limits: parallel plates, no field outside of them.

/// A pressure and the Young's modulus that answers it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compression {
    /// pressure, positive in compression, Pa
    pub pressure: f64,
    /// Young's modulus, Pa
    pub young: f64,
}

impl Compression {
    /// Compressive strain of a linear solid.
    pub fn strain(self) -> f64 {
        self.pressure / self.young
    }
}

/// Capacitance of two parallel plates.
///
/// $$ C = \frac{\epsilon A}{d} $$
///
/// | symbol | argument       | unit |
/// |--------|----------------|------|
/// | ε      | `permittivity` | F/m  |
/// | A      | `area`         | m²   |
/// | d      | `gap`          | m    |
///
/// **Source:** \[hampson2023\] (1). **Assumes:** `NO-FRINGING`. **Accuracy:** two roundings.
pub fn plate_capacitance(permittivity: f64, area: f64, gap: f64) -> f64 {
    permittivity * area / gap
}

/// Capacitance of two parallel plates on a linear spring that fills the gap.
///
/// $$ C = \frac{\epsilon A}{d_0 (1 - p / E)} $$
///
/// | symbol | argument               | unit |
/// |--------|------------------------|------|
/// | ε      | `permittivity`         | F/m  |
/// | A      | `area`                 | m²   |
/// | d0     | `unloaded_gap`         | m    |
/// | p      | `compression.pressure` | Pa   |
/// | E      | `compression.young`    | Pa   |
///
/// **Source:** \[hampson2023\] (2), with p = -sigma. **Assumes:** `NO-FRINGING`, `LINEAR-SOLID`. **Accuracy:** a few roundings, as long as p is not close to E.
pub fn spring_plate_capacitance(permittivity: f64, area: f64, unloaded_gap: f64, compression: Compression) -> f64 {
    plate_capacitance(permittivity, area, unloaded_gap * (1.0 - compression.strain()))
}
