//! The parts of a sensor: layers, materials, tolerances. SI inside.
//!
//! Limits: a circular electrode; one compressible dielectric; at most two metals in the warping electrode.

use crate::units::Measure;

/// Linear elastic, thermal and dielectric constants of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// name
    pub name: String,
    /// Young's modulus at the reference temperature, Pa
    pub young: Measure,
    /// change of Young's modulus with temperature, Pa/K
    pub softening: Measure,
    /// Poisson's ratio
    pub poisson: f64,
    /// coefficient of linear thermal expansion, 1/K
    pub expansion: f64,
    /// relative permittivity; 1 for a conductor, where it means nothing
    pub permittivity: f64,
}

/// A layer: material and thickness.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// material
    pub material: Material,
    /// thickness, m
    pub thickness: Measure,
}

/// What fills the gap beside air.
#[derive(Clone, Debug, PartialEq)]
pub enum Filling {
    /// cylindrical beads
    Beads {
        /// number of beads
        count: u32,
        /// diameter of one bead, m
        diameter: Measure,
    },
    /// a solid (or foam) that covers this share of the electrode and cannot spread sideways freely
    Solid {
        /// covered share of the electrode, 0 to 1
        coverage: f64,
    },
}

/// The compressible dielectric.
#[derive(Clone, Debug, PartialEq)]
pub struct CompressibleDielectric {
    /// material and height
    pub layer: Layer,
    /// how it fills the gap
    pub filling: Filling,
    /// relative permittivity of what is between
    pub surrounding_permittivity: f64,
}

/// How the capacitances add up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// self capacitance to grounded shields: main + backing + tail, as the paper's (23)
    Shielded,
    /// mutual capacitance between the plates: only the main gap counts
    Mutual,
}

/// A sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// name
    pub name: String,
    /// what it is and where its numbers come from
    pub description: String,
    /// which capacitances are read
    pub layout: Layout,
    /// load at full scale, N
    pub full_scale: f64,
    /// temperature at which dimensions are given, degrees Celsius
    pub reference_c: f64,
    /// diameter of the electrodes, m
    pub diameter: Measure,
    /// the conductor of the centre electrode (material 2 of the paper's (9))
    pub conductor: Layer,
    /// the plating of the centre electrode (material 1); without it nothing warps
    pub plating: Option<Layer>,
    /// insulator on the electrode and behind it
    pub insulator: Layer,
    /// what is compressed
    pub dielectric: CompressibleDielectric,
    /// tail trace: length and width, m
    pub tail: (f64, f64),
    /// capacitance beside the sensor, F
    pub stray: Measure,
}
