//! One layer of a stack: its section, and what it does.

use super::error::SolidError;
use crate::colour::Rgb;

/// A named part with a triangulated section. All lengths are metres; arrays run over the points.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Unique name, for instance `upper copper`.
    pub name: String,
    /// Material colour, shown where there is no field.
    pub colour: Rgb,
    /// Points (r, z) of the section, m; r not negative.
    pub points: Vec<[f64; 2]>,
    /// Corner indices; either orientation.
    pub triangles: Vec<[usize; 3]>,
    /// Displacement (u_r, u_z) of every point, m; empty if the layer does not move.
    pub displacement: Vec<[f64; 2]>,
    /// Values of each field at every point, in the field's unit; an empty list where the layer does not have that field.
    pub fields: Vec<Vec<f64>>,
}

impl Layer {
    /// The points moved by `factor` times their displacement.
    pub(crate) fn displaced(&self, factor: f64) -> Vec<[f64; 2]> {
        if self.displacement.is_empty() {
            return self.points.clone();
        }
        let moved = |(p, u): (&[f64; 2], &[f64; 2])| [p[0] + factor * u[0], p[1] + factor * u[1]];
        self.points.iter().zip(&self.displacement).map(moved).collect()
    }

    /// Values of field number `index`, if the layer has it.
    pub fn field(&self, index: usize) -> Option<&[f64]> {
        self.fields.get(index).map(Vec::as_slice).filter(|values| !values.is_empty())
    }

    /// Largest displacement, m; zero for a layer that does not move.
    pub(crate) fn largest_displacement_m(&self) -> f64 {
        self.displacement.iter().map(|u| u[0].hypot(u[1])).fold(0.0, f64::max)
    }

    /// Checks the arrays; `factor` is the largest exaggeration that will be shown.
    pub(super) fn check(&self, factor: f64) -> Result<(), SolidError> {
        let layer = || self.name.clone();
        if self.triangles.is_empty() {
            return Err(SolidError::EmptyLayer { layer: layer() });
        }
        let points = self.points.len();
        let fields = self.fields.iter().map(|values| ("field", values.len()));
        for (what, found) in fields.chain([("displacement", self.displacement.len())]) {
            if found != 0 && found != points {
                return Err(SolidError::Lengths { layer: layer(), what, found, points });
            }
        }
        for (triangle, corners) in self.triangles.iter().enumerate() {
            if let Some(&point) = corners.iter().find(|&&p| p >= points) {
                return Err(SolidError::NoSuchPoint { layer: layer(), triangle, point, points });
            }
        }
        let not_finite = |what, point| SolidError::NotFinite { layer: layer(), what, point };
        let bad = |pairs: &[[f64; 2]]| pairs.iter().position(|p| !(p[0].is_finite() && p[1].is_finite()));
        bad(&self.points).map_or(Ok(()), |p| Err(not_finite("position", p)))?;
        bad(&self.displacement).map_or(Ok(()), |p| Err(not_finite("displacement", p)))?;
        let mut no_value = self.fields.iter().filter_map(|f| f.iter().position(|v| !v.is_finite()));
        no_value.next().map_or(Ok(()), |p| Err(not_finite("field", p)))?;
        self.check_radii(&self.points, "at rest")?;
        self.check_radii(&self.displaced(1.0), "deformed")?;
        self.check_radii(&self.displaced(factor), "deformed")
    }

    fn check_radii(&self, points: &[[f64; 2]], state: &'static str) -> Result<(), SolidError> {
        // Solvers leave points on the axis within rounding of it.
        let slack = -1e-9 * points.iter().map(|p| p[0].abs()).fold(0.0, f64::max);
        match points.iter().position(|p| p[0] < slack) {
            Some(point) => {
                let (layer, radius_m) = (self.name.clone(), points[point][0]);
                Err(SolidError::BehindAxis { layer, point, radius_m, state })
            }
            None => Ok(()),
        }
    }
}
