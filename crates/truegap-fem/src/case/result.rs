//! What `truegap solve --json` prints.

use super::description::Method;
use crate::goal::Answer;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// A named quantity.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct QuantityValue {
    /// Value in `unit`.
    pub value: f64,
    /// SI unit.
    pub unit: String,
    /// Estimated magnitude of the error, in `unit`.
    pub error_estimate: f64,
    /// The same over the magnitude of the value.
    pub relative_error_estimate: f64,
    /// The same over `scale`: what `target_error` is compared with.
    pub error_over_scale: f64,
    /// Magnitude of the value, or of its kind where the value may vanish (of a stress, the greatest component there), in `unit`.
    pub scale: f64,
}

/// Answers of a solver, by their names.
pub(super) fn quantities(answers: &[Answer]) -> Vec<(String, QuantityValue)> {
    let value = |a: &Answer| QuantityValue {
        value: a.value,
        unit: a.unit.into(),
        error_estimate: a.error_estimate,
        relative_error_estimate: a.relative_error_estimate(),
        error_over_scale: a.error_over_scale(),
        scale: a.scale,
    };
    answers.iter().map(|a| (a.name.clone(), value(a))).collect()
}

/// Size of the last mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct MeshCounts {
    /// Triangles.
    pub triangles: usize,
    /// Free unknowns.
    pub unknowns: usize,
}

/// Wall-clock seconds, all levels together.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SecondsSpent {
    /// Meshing and refining.
    pub mesh: f64,
    /// Assembling.
    pub assemble: f64,
    /// Factorising, solving, estimating.
    pub solve: f64,
}

/// Where the error estimates come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ErrorsFrom {
    /// Local residuals on the last mesh.
    Residuals,
    /// The change of each quantity between the last meshes: contact has no other estimate.
    Meshes,
    /// The changes of each quantity between the last spaces of the hp version, and how fast they shrink.
    Spaces,
}

/// A pressure, and on which surface it acted.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct PressureActs {
    /// Boundary.
    pub boundary: String,
    /// Pressure, positive inwards (Pa).
    pub pressure_pa: f64,
    /// `following` (the deformed surface), `dead` (the undeformed one, as asked for), or `small strain` (a law that
    /// does not tell the two apart).
    pub acts: &'static str,
}

/// The result of a case.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct CaseResult {
    /// How it was solved; left out where quadratic (or linear) elements were refined.
    #[serde(skip_serializing_if = "Method::is_refine")]
    pub method: Method,
    /// Where the error estimates come from.
    pub errors: ErrorsFrom,
    /// Quantities in the order of the outputs.
    #[serde(serialize_with = "as_map")]
    pub quantities: Vec<(String, QuantityValue)>,
    /// Pressures on the body.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pressures: Vec<PressureActs>,
    /// Size.
    pub mesh: MeshCounts,
    /// Time.
    pub seconds: SecondsSpent,
}

impl CaseResult {
    /// The quantity of a name.
    pub fn quantity(&self, name: &str) -> Option<&QuantityValue> {
        self.quantities.iter().find(|q| q.0 == name).map(|q| &q.1)
    }
}

fn as_map<S: Serializer>(quantities: &[(String, QuantityValue)], serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(quantities.len()))?;
    for (name, value) in quantities {
        map.serialize_entry(name, &Wrapped(value))?;
    }
    map.end()
}

struct Wrapped<'a>(&'a QuantityValue);

impl Serialize for Wrapped<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}
