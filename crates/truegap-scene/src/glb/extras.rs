//! Metadata: units, legend, provenance, names of the morph targets.

use super::field::Legend;
use super::scene::Scene;
use crate::colour::ColourMap;
use crate::solid::Layer;
use gltf_json::extras::{Extras, RawValue};
use serde_json::{Value, json};

/// `deformed, true scale` or `deformed, exaggerated x50`.
pub(super) fn target_name(factor: f64) -> String {
    if factor == 1.0 { "deformed, true scale".into() } else { format!("deformed, exaggerated x{factor}") }
}

/// Of the scene: everything a reader needs to take numbers from the picture.
pub(super) fn of_scene(scene: &Scene, factors: &[f64], legends: &[Legend]) -> Result<Extras, serde_json::Error> {
    let notes: serde_json::Map<String, Value> =
        scene.provenance.notes.iter().map(|(name, value)| (name.clone(), json!(value))).collect();
    let largest = scene.layers.iter().map(Layer::largest_displacement_m).fold(0.0, f64::max);
    raw(&json!({
        "schema": "truegap.scene/1",
        "title": scene.title,
        "units": {"length": "m", "mesh_coordinates": "mm", "root_node_scale": 0.001, "axis": "+Y"},
        "sweep_degrees": scene.sweep.degrees,
        "deformation": {
            "targets": factors.iter().map(|&f| json!({"name": target_name(f), "factor": f})).collect::<Vec<_>>(),
            "largest_displacement_m": largest,
        },
        "coloured_by": legends.first().map(|l| &l.field.name),
        "fields": legends.iter().map(of_legend).collect::<Vec<_>>(),
        "provenance": {
            "source": scene.provenance.source,
            "command": scene.provenance.command,
            "version": scene.provenance.version,
            "notes": notes,
        },
    }))
}

/// Of a layer's node.
pub(super) fn of_layer(layer: &Layer, legends: &[Legend]) -> Result<Extras, serde_json::Error> {
    let range = |l: &Legend| {
        let values = layer.field(l.index)?;
        let (least, most) = (values.iter().copied().reduce(f64::min), values.iter().copied().reduce(f64::max));
        Some(json!({"name": l.field.name, "unit": l.field.unit, "min": least, "max": most}))
    };
    raw(&json!({
        "layer": layer.name,
        "material_colour": layer.colour.css(),
        "section": {"points": layer.points.len(), "triangles": layer.triangles.len()},
        "largest_displacement_m": layer.largest_displacement_m(),
        "fields": legends.iter().filter_map(range).collect::<Vec<_>>(),
    }))
}

/// Of a mesh: `targetNames`, which three.js and Blender show.
pub(super) fn of_mesh(factors: &[f64]) -> Result<Extras, serde_json::Error> {
    if factors.is_empty() {
        return Ok(None);
    }
    raw(&json!({"targetNames": factors.iter().map(|&f| target_name(f)).collect::<Vec<_>>()}))
}

fn of_legend(legend: &Legend) -> Value {
    let (low, high) = legend.range;
    let stops = legend.field.map.stops();
    let last = (stops.len() - 1) as f64;
    let stop =
        |(i, colour): (usize, &crate::colour::Rgb)| json!({"value": low + (high - low) * i as f64 / last, "srgb": colour.css()});
    json!({
        "name": legend.field.name,
        "unit": legend.field.unit,
        "min": low,
        "max": high,
        "data_min": legend.data.0,
        "data_max": legend.data.1,
        "map": match legend.field.map { ColourMap::Sequential => "sequential", ColourMap::Diverging => "diverging" },
        "interpolation": "linear in sRGB between stops; end colours beyond",
        "attribute": format!("_{}", legend.attribute()),
        "state": "deformed",
        "stops": stops.iter().enumerate().map(stop).collect::<Vec<_>>(),
    })
}

fn raw(value: &Value) -> Result<Extras, serde_json::Error> {
    RawValue::from_string(value.to_string()).map(Some)
}
