//! The file as it is written, before any check.

use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawCase {
    pub schema: String,
    pub physics: String,
    pub symmetry: String,
    pub length_unit: Option<String>,
    #[serde(default)]
    pub material: BTreeMap<String, RawMaterial>,
    #[serde(default)]
    pub region: Vec<RawRegion>,
    #[serde(default)]
    pub boundary: Vec<RawBoundary>,
    pub temperature: Option<RawTemperature>,
    #[serde(default)]
    pub mesh: RawMesh,
    #[serde(default)]
    pub output: Vec<RawOutput>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawMaterial {
    pub relative_permittivity: Option<f64>,
    pub young: Option<toml::Value>,
    pub poisson: Option<f64>,
    pub expansion: Option<toml::Value>,
    pub law: Option<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawRegion {
    pub name: String,
    pub material: Option<String>,
    #[serde(default)]
    pub polygon: Vec<RawStep>,
}

/// A point, or an arc from the point before it.
#[derive(Debug, Deserialize)]
#[serde(
    untagged,
    expecting = "write a point [first, second] or an arc { via = [first, second], to = [first, second] }, without further keys"
)]
pub(super) enum RawStep {
    Point([f64; 2]),
    Arc(RawArc),
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawArc {
    pub via: [f64; 2],
    pub to: [f64; 2],
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawBoundary {
    pub name: String,
    pub path: Option<Vec<RawStep>>,
    pub region: Option<String>,
    pub potential: Option<toml::Value>,
    #[serde(default)]
    pub open: bool,
    #[serde(default)]
    pub fix: Vec<String>,
    #[serde(default)]
    pub displace: BTreeMap<String, toml::Value>,
    pub pressure: Option<toml::Value>,
    pub pressure_load: Option<String>,
    pub plate: Option<RawPlate>,
}

/// A rigid plate: the coordinate at which it stands, and how far it moves or how strongly it presses.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawPlate {
    pub x: Option<toml::Value>,
    pub y: Option<toml::Value>,
    pub z: Option<toml::Value>,
    pub travel: Option<toml::Value>,
    pub force: Option<toml::Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawTemperature {
    pub base: Option<toml::Value>,
    #[serde(default)]
    pub gradient: BTreeMap<String, toml::Value>,
    pub logarithm: Option<RawRadial>,
    pub inverse: Option<RawRadial>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawRadial {
    pub amplitude: toml::Value,
    pub radius: toml::Value,
}

#[derive(Debug, Deserialize, Default)]
#[serde(deny_unknown_fields)]
pub(super) struct RawMesh {
    pub target_error: Option<f64>,
    pub max_edge: Option<toml::Value>,
    pub order: Option<u8>,
    pub method: Option<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawOutput {
    pub name: String,
    pub kind: String,
    pub boundary: Option<String>,
    pub at: Option<[f64; 2]>,
    pub component: Option<String>,
}
