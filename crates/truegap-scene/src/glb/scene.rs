//! What a caller describes.

use super::error::SceneError;
use super::field::{Field, Legend};
use crate::solid::{Layer, Sweep};

/// Where a scene comes from; written into the file as given.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Provenance {
    /// What was computed, for instance a sensor name or a case file.
    pub source: String,
    /// The command that made it.
    pub command: String,
    /// Version of the program.
    pub version: String,
    /// Further facts by name: load, temperature, mesh size.
    pub notes: Vec<(String, String)>,
}

/// A stack of axisymmetric layers to be shown in 3D.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Title, shown by viewers.
    pub title: String,
    /// The layers; either all of them have displacements or none.
    pub layers: Vec<Layer>,
    /// The fields that the layers' values are of, in their order. The first one colours the file, the viewer offers all;
    /// without any the parts have their material colours.
    pub fields: Vec<Field>,
    /// Full turn or cut away.
    pub sweep: Sweep,
    /// Factor of a second, exaggerated deformation beside the true one; `None`: true scale only.
    pub exaggeration: Option<f64>,
    /// Where it comes from.
    pub provenance: Provenance,
}

impl Scene {
    /// Displacement factors of the morph targets: none, true scale, or true scale and the exaggeration.
    pub(super) fn factors(&self) -> Vec<f64> {
        if self.layers.iter().all(|l| l.displacement.is_empty()) {
            return Vec::new();
        }
        [1.0].into_iter().chain(self.exaggeration).collect()
    }

    pub(super) fn legends(&self) -> Result<Vec<Legend<'_>>, SceneError> {
        let legend = |(index, field)| Legend::new(index, field, &self.layers);
        self.fields.iter().enumerate().map(legend).collect()
    }

    pub(super) fn check(&self) -> Result<(), SceneError> {
        if self.layers.is_empty() {
            return Err(SceneError::NoLayer { title: self.title.clone() });
        }
        for (i, layer) in self.layers.iter().enumerate() {
            if self.layers[..i].iter().any(|other| other.name == layer.name) {
                return Err(SceneError::SameName { name: layer.name.clone() });
            }
            let (found, wanted) = (layer.fields.len(), self.fields.len());
            if found != 0 && found != wanted {
                return Err(SceneError::FieldCount { layer: layer.name.clone(), found, wanted });
            }
            if layer.displacement.is_empty() && !self.factors().is_empty() {
                return Err(SceneError::SomeRest { layer: layer.name.clone() });
            }
        }
        match self.exaggeration {
            Some(factor) if !(factor > 1.0 && factor.is_finite()) => Err(SceneError::Exaggeration { factor }),
            _ => Ok(()),
        }
    }
}

/// The largest factor of 1, 2 or 5 times a power of ten that keeps the largest displacement within a tenth of the stack's
/// size and leaves every triangle of the sections at least a fifth of its area; `None` where no factor above 1 does.
///
/// It looks only at layers: plates that approach each other may pass through one another where the gap is no layer.
pub fn suggested_exaggeration(layers: &[Layer]) -> Option<f64> {
    let moved = layers.iter().map(Layer::largest_displacement_m).fold(0.0, f64::max);
    let extent = |axis: usize| {
        let all = || layers.iter().flat_map(|l| &l.points).map(|p| p[axis]);
        all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min)
    };
    if layers.is_empty() || moved <= 0.0 || !moved.is_finite() {
        return None;
    }
    let wanted = 0.1 * extent(0).max(extent(1)) / moved;
    let powers = (0..=wanted.log10().ceil().max(0.0) as i32).rev().map(|k| 10f64.powi(k));
    let factors = powers.flat_map(|power| [5.0, 2.0, 1.0].map(|m| m * power));
    factors.filter(|f| *f > 1.0 && *f <= wanted).find(|&f| layers.iter().all(|layer| keeps_its_shape(layer, f)))
}

/// Whether all triangles of the section keep their sense and a fifth of their area, and no point crosses the axis.
fn keeps_its_shape(layer: &Layer, factor: f64) -> bool {
    let moved = layer.displaced(factor);
    let area = |points: &[[f64; 2]], [a, b, c]: [usize; 3]| -> Option<f64> {
        let (a, b, c) = (points.get(a)?, points.get(b)?, points.get(c)?);
        Some((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    };
    let sound = |&t: &[usize; 3]| area(&moved, t).zip(area(&layer.points, t)).is_some_and(|(now, rest)| now / rest > 0.2);
    layer.triangles.iter().all(sound) && moved.iter().all(|p| p[0] >= -1e-12)
}
