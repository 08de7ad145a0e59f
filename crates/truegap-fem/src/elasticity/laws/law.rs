//! What a law has to say at a displacement gradient.

use nalgebra::Matrix3;

/// A tensor in the orthonormal directions (r, z, theta), or (x, y, out of plane).
pub type Tensor = Matrix3<f64>;

/// A law evaluated at a displacement gradient `H = F - I`, where `H[(i, j)]` is the derivative of `u_i` along `x_j`.
///
/// All parts are dimensionless: the moduli multiply them outside.
pub trait Law: Sized {
    /// Degree to which the integrand should be integrated exactly, with quadratic shapes.
    const QUADRATURE_DEGREE: usize;
    /// Prepares the evaluation at `h`.
    fn at(h: &Tensor) -> Self;
    /// Shear energy `s` (NaN where the state is not admissible).
    fn shear_energy(&self) -> f64;
    /// Derivative of `s` by `H`.
    fn shear_stress(&self) -> Tensor;
    /// Second derivative of `s` by `H`, applied to `dh`.
    fn shear_tangent(&self, dh: &Tensor) -> Tensor;
    /// Volume measure `g`, zero in the stress-free state.
    fn volume(&self) -> f64;
    /// Derivative of `g` by `H`.
    fn volume_slope(&self) -> Tensor;
    /// Second derivative of `g` by `H`, applied to `dh`.
    fn volume_curvature(&self, dh: &Tensor) -> Tensor;
}
