//! What makes a scene impossible to write.

use crate::solid::SolidError;

/// A scene that cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// No layer.
    #[error("scene `{title}` has no layer; there is nothing to export")]
    NoLayer {
        /// Title of the scene.
        title: String,
    },
    /// Two layers with one name.
    #[error("two layers are called `{name}`; names tell parts apart in viewers, make them unique")]
    SameName {
        /// The name.
        name: String,
    },
    /// Displacements for some layers only.
    #[error("layer `{layer}` has no displacement but others have; give every layer one (zeros where it rests)")]
    SomeRest {
        /// Name of the layer.
        layer: String,
    },
    /// Fields of a layer that do not match the fields of the scene.
    #[error(
        "layer `{layer}` carries {found} fields, the scene names {wanted}; give one list of values for each (an empty one where the layer does not have the field), or none at all"
    )]
    FieldCount {
        /// Name of the layer.
        layer: String,
        /// Fields of the layer.
        found: usize,
        /// Fields of the scene.
        wanted: usize,
    },
    /// A field is named but no layer carries values.
    #[error("the scene shows `{field}` but no layer carries values of it")]
    NoValues {
        /// Name of the field.
        field: String,
    },
    /// A colour range that is empty or not finite.
    #[error("field `{field}`: the colour range {low} to {high} is empty or not finite")]
    Range {
        /// Name of the field.
        field: String,
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// An exaggeration that is none.
    #[error("an exaggeration of {factor} is none; use a finite factor above 1, or leave it out for true scale only")]
    Exaggeration {
        /// The factor.
        factor: f64,
    },
    /// More bytes than a GLB can hold.
    #[error("the scene takes {bytes} bytes, a GLB holds at most 4294967295; use fewer segments or a coarser section")]
    TooLarge {
        /// Bytes needed.
        bytes: usize,
    },
    /// A layer that is no solid.
    #[error(transparent)]
    Solid(#[from] SolidError),
    /// The JSON part could not be written.
    #[error("the glTF document could not be written: {0}")]
    Json(#[from] serde_json::Error),
    /// The container could not be written.
    #[error("the GLB container could not be written: {0}")]
    Container(#[from] gltf::Error),
}
