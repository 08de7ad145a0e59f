//! The field: capacitance of a plate over an uneven gap, by quadrature over the disc.
//!
//! Limits: parallel-plate field at every point (no fringing); Gauss-Legendre in rho^2 (12 points) and, for a tilted plate, the
//! trapezium in the angle (16 points over half a turn, which converges geometrically for a periodic integrand).

use super::{gauss, warp};

/// Shape of the gap under one electrode, all lengths in m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Gap {
    /// Mean gap.
    pub mean: f64,
    /// Thermal curvature of the plate, 1/m.
    pub curvature: f64,
    /// Rise of one side of the rim over the middle (wedge).
    pub tilt: f64,
    /// Bending under load: the middle comes closer by this much against the rim of a uniformly loaded, simply supported plate.
    pub bow: f64,
    /// Air that never closes, times the permittivity of the bead layer (its equivalent thickness there).
    pub dead: f64,
}

/// Quadrature over a disc.
#[derive(Debug, Clone)]
pub struct Disc {
    points: Vec<gauss::Point>,
    cosines: Vec<f64>,
}

impl Disc {
    /// 12 rings, 16 angles.
    pub fn new() -> Self {
        let angles = 16;
        let cosines = (0..angles).map(|i| (std::f64::consts::PI * (f64::from(i) + 0.5) / f64::from(angles)).cos()).collect();
        Self { points: gauss::rule(12), cosines }
    }

    /// Mean of 1/gap over a disc of `radius` (m), 1/m; `None` where the plates touch.
    pub fn mean_inverse(&self, gap: &Gap, radius: f64) -> Option<f64> {
        let sags = self.points.iter().map(|p| warp::sag(gap.curvature, radius * p.x.sqrt()));
        let mean_sag: f64 = self.points.iter().zip(sags.clone()).map(|(p, s)| p.weight * s).sum();
        let mut sum = 0.0;
        for (p, sag) in self.points.iter().zip(sags) {
            let ring = gap.mean + gap.dead + sag - mean_sag - gap.bow * (plate(p.x) - PLATE_MEAN);
            sum += p.weight * self.around(ring, gap.tilt * p.x.sqrt())?;
        }
        Some(sum)
    }

    /// Mean of 1/(ring + tilt cos) around a ring.
    fn around(&self, ring: f64, tilt: f64) -> Option<f64> {
        if ring <= tilt.abs() {
            return None;
        }
        if tilt == 0.0 {
            return Some(1.0 / ring);
        }
        let sum: f64 = self.cosines.iter().map(|c| 1.0 / (ring + tilt * c)).sum();
        Some(sum / self.cosines.len() as f64)
    }
}

impl Default for Disc {
    fn default() -> Self {
        Self::new()
    }
}

/// Poisson's ratio of the electrode in the bending shape.
const PLATE_POISSON: f64 = 0.34;
/// Mean of [`plate`] over the disc: integral of (1 - u)(q - u)/q over u in (0, 1), q = (5 + nu)/(1 + nu).
const PLATE_MEAN: f64 = 0.5 - (1.0 / 6.0) * (1.0 + PLATE_POISSON) / (5.0 + PLATE_POISSON);

/// Deflection of a simply supported, uniformly loaded plate at rho^2/r^2 = `u`, over that at its middle.
///
/// **Source:** Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, 16, eq. (67).
fn plate(u: f64) -> f64 {
    let q = (5.0 + PLATE_POISSON) / (1.0 + PLATE_POISSON);
    (1.0 - u) * (q - u) / q
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wedge alone has the mean 2 (1 - sqrt(1 - q^2)) / (q^2 g), q = tilt / gap; the rule converges geometrically.
    #[test]
    fn a_tilted_plate_has_the_capacitance_of_the_wedge() {
        let gap = Gap { mean: 160e-6, tilt: 40e-6, ..Gap::default() };
        let q: f64 = 0.25;
        let exact = 2.0 * (1.0 - (1.0 - q * q).sqrt()) / (q * q * gap.mean);
        let found = Disc::new().mean_inverse(&gap, 7.5e-3).expect("open gap");
        assert!((found / exact - 1.0).abs() < 1e-12, "{found} against {exact}");
    }

    /// The shape's mean is known in closed form; the rule is exact for it.
    #[test]
    fn bending_leaves_the_mean_gap_alone() {
        let mean: f64 = gauss::rule(12).iter().map(|p| p.weight * plate(p.x)).sum();
        assert!((mean - PLATE_MEAN).abs() < 1e-14);
    }
}
