//! The shape of an electrode's face, and what it makes of the gap.
//!
//! Straight between the nodes of the mesh; no field outside of the plates.

use crate::error::AuditError;
use std::f64::consts::TAU;
use truegap_fem::elasticity::Solution;
use truegap_model::equations::warp::{Dome, sag};

/// Heights of a face over its radius.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// `(share of the rim's radius, height in m)`, from the axis to the rim
    pub points: Vec<[f64; 2]>,
}

impl Profile {
    /// The face `face` of a solved disc: axial displacements over deformed radii.
    ///
    /// # Errors
    /// A body without that boundary.
    pub(crate) fn of_face(solution: &Solution) -> Result<Self, AuditError> {
        let body = solution.body();
        let nodes = body.boundary_nodes("face").map_err(AuditError::fem("face of the electrode"))?;
        let mut points: Vec<[f64; 2]> = nodes
            .iter()
            .map(|&n| {
                let [u, w] = solution.nodal(n as usize);
                [body.nodes.points[n as usize][0] + u, w]
            })
            .collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let rim = points.last().map_or(1.0, |p| p[0]);
        points.iter_mut().for_each(|p| p[0] /= rim);
        Ok(Self { points })
    }

    /// A shape given by a formula over the share of the radius, at `count` + 1 even points.
    pub fn from_fn(count: usize, height: impl Fn(f64) -> f64) -> Self {
        let at = |i: usize| i as f64 / count as f64;
        Self { points: (0..=count).map(|i| [at(i), height(at(i))]).collect() }
    }

    /// Rim above centre, m.
    pub fn sag(&self) -> f64 {
        match (self.points.first(), self.points.last()) {
            (Some(centre), Some(rim)) => rim[1] - centre[1],
            _ => 0.0,
        }
    }

    /// Mean height over the disc, m.
    pub fn mean(&self) -> f64 {
        self.integral(|_, height| height) / std::f64::consts::PI
    }

    /// Height at a share of the radius, m.
    pub fn height(&self, share: f64) -> f64 {
        let after = self.points.partition_point(|p| p[0] < share).clamp(1, self.points.len() - 1);
        let ([a, za], [b, zb]) = (self.points[after - 1], self.points[after]);
        if b > a { za + (zb - za) * (share - a) / (b - a) } else { za }
    }

    /// Lowest height, m.
    pub(crate) fn lowest(&self) -> f64 {
        self.points.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min)
    }

    /// Largest distance from the mean height, m.
    pub(crate) fn largest_deviation(&self) -> f64 {
        let mean = self.mean();
        self.points.iter().map(|p| (p[1] - mean).abs()).fold(0.0, f64::max)
    }

    /// The shape a share `t` of the way to another one.
    #[must_use]
    pub(crate) fn towards(&self, other: &Self, t: f64) -> Self {
        let at = |p: &[f64; 2]| [p[0], (1.0 - t) * p[1] + t * other.height(p[0])];
        Self { points: self.points.iter().map(at).collect() }
    }

    /// The shape times a factor.
    #[must_use]
    pub(crate) fn times(&self, factor: f64) -> Self {
        Self { points: self.points.iter().map(|p| [p[0], factor * p[1]]).collect() }
    }

    /// The sum of two shapes, at the points of this one.
    #[must_use]
    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self { points: self.points.iter().map(|p| [p[0], p[1] + other.height(p[0])]).collect() }
    }

    /// The cap of (18) over a radius (m).
    pub(crate) fn sphere(curvature: f64, radius: f64) -> Self {
        Self::from_fn(200, |share| sag(Dome { curvature, radius }, share * radius))
    }

    /// Mean of mean gap over local gap: the factor on the capacitance of flat plates; `None` where the plates touch.
    ///
    /// $$ f = \frac{1}{A} \int \frac{g}{g + w - \bar w}\,dA $$
    pub(crate) fn gain(&self, mean_gap: f64) -> Option<f64> {
        let mean = self.mean();
        let open = self.points.iter().all(|p| mean_gap + p[1] - mean > 0.0);
        open.then(|| self.integral(|_, height| mean_gap / (mean_gap + height - mean)) / std::f64::consts::PI)
    }

    /// Integral of a function of share and height over the unit disc, three Gauss points between nodes.
    pub fn integral(&self, f: impl Fn(f64, f64) -> f64) -> f64 {
        const GAUSS: [(f64, f64); 3] = [(0.112_701_665_379_258_3, 5.0), (0.5, 8.0), (0.887_298_334_620_741_7, 5.0)];
        let part = |p: &[[f64; 2]]| {
            let ([a, za], [b, zb]) = (p[0], p[1]);
            let at = |(t, w): (f64, f64)| w / 18.0 * (a + t * (b - a)) * f(a + t * (b - a), za + t * (zb - za));
            (b - a) * GAUSS.iter().map(|&g| at(g)).sum::<f64>()
        };
        TAU * self.points.windows(2).map(part).sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_model::equations::{
        integral::BentPlates,
        warp::{Dome, mean_sag, rim_sag, sag},
    };

    #[test]
    fn a_spherical_profile_has_the_closed_forms_of_the_model() {
        let dome = Dome { curvature: 2.0, radius: 7.5e-3 };
        let p = Profile::from_fn(400, |t| sag(dome, t * dome.radius));
        assert!((p.mean() / mean_sag(dome) - 1.0).abs() < 1e-4);
        assert!((p.sag() / rim_sag(dome) - 1.0).abs() < 1e-12);
        let gap = 160e-6;
        let exact = BentPlates::settled(gap, dome).integral() * gap / (std::f64::consts::PI * dome.radius * dome.radius);
        // Straight pieces: (1 / 400)^2 of the curvature's part.
        assert!((p.gain(gap).unwrap() - exact).abs() < 1e-5, "{:?} {exact}", p.gain(gap));
        // Sag over gap 0.35: a twelfth of its square.
        assert!(exact > 1.01);
        assert_eq!(p.gain(20e-6), None);
    }
}
