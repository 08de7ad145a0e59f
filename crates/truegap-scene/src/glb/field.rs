//! The fields that colour a scene, and their legends.

use super::error::SceneError;
use crate::colour::{ColourMap, Rgb};
use crate::solid::Layer;

/// What the nodal values of the layers are, and how they become colours.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// For instance `von Mises stress`.
    pub name: String,
    /// Unit of the values.
    pub unit: String,
    /// Colour map.
    pub map: ColourMap,
    /// Values at the ends of the map; `None`: the extent of the data (symmetric about zero for a diverging map).
    pub range: Option<(f64, f64)>,
}

/// A field with its range settled.
#[derive(Debug, Clone)]
pub(super) struct Legend<'a> {
    /// Number of the field.
    pub index: usize,
    pub field: &'a Field,
    /// Ends of the colour map.
    pub range: (f64, f64),
    /// Extent of the data.
    pub data: (f64, f64),
}

impl<'a> Legend<'a> {
    pub fn new(index: usize, field: &'a Field, layers: &[Layer]) -> Result<Self, SceneError> {
        let data = layers
            .iter()
            .flat_map(|l| l.field(index).unwrap_or(&[]).iter().copied())
            .fold(None, |range, v| Some(range.map_or((v, v), |(low, high): (f64, f64)| (low.min(v), high.max(v)))))
            .ok_or_else(|| SceneError::NoValues { field: field.name.clone() })?;
        let (low, high) = field.range.unwrap_or(field.map.span(data.0, data.1));
        if !(low < high && low.is_finite() && high.is_finite()) {
            return Err(SceneError::Range { field: field.name.clone(), low, high });
        }
        Ok(Self { index, field, range: (low, high), data })
    }

    /// Name of the vertex attribute that holds the values, without its underscore.
    pub fn attribute(&self) -> String {
        format!("FIELD_{}", self.index)
    }

    /// Colour of a value.
    pub fn colour(&self, value: f64) -> Rgb {
        self.field.map.at((value - self.range.0) / (self.range.1 - self.range.0))
    }
}
