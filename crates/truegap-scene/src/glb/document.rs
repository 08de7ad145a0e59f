//! The glTF document: a mesh, a material and a node for each layer under a node that scales millimetres to metres.

use super::accessors::Builder;
use super::animation;
use super::error::SceneError;
use super::extras;
use super::field::Legend;
use super::scene::Scene;
use super::view;
use crate::solid::{Layer, Shape, Surface, revolve};
use gltf::binary::{Glb, Header};
use gltf_json as json;
use json::validation::Checked::Valid;
use json::validation::USize64;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Mesh coordinates a metre.
const PER_METRE: f64 = 1000.0;

impl Scene {
    /// The scene as the bytes of a `.glb` file.
    ///
    /// # Errors
    /// Layers that are no solids, share a name or have displacements only in part; fields that do not match the
    /// scene's or have no value anywhere; an exaggeration not above 1; more than 4 GiB.
    pub fn to_glb(&self) -> Result<Vec<u8>, SceneError> {
        self.check()?;
        write(self)
    }
}

/// The bytes of `scene`, which has been checked.
fn write(scene: &Scene) -> Result<Vec<u8>, SceneError> {
    let (factors, legends) = (scene.factors(), scene.legends()?);
    let mut builder = Builder::new();
    let mut nodes = Vec::new();
    let mut bounds = view::Bounds::default();
    for layer in &scene.layers {
        let surface = revolve(layer, &factors, scene.sweep)?;
        surface.shapes.iter().for_each(|shape| bounds.include(&shape.positions));
        nodes.push(add_layer(&mut builder, layer, &surface, &factors, &legends)?);
    }
    animation::add(&mut builder, &nodes, &factors);
    let stack = builder.root.push(json::Node {
        name: Some(scene.title.clone()),
        children: Some(nodes),
        scale: Some([(1.0 / PER_METRE) as f32; 3]),
        ..Default::default()
    });
    let camera = view::add_camera(&mut builder.root, &bounds);
    let top = builder.root.push(json::Scene {
        name: Some(scene.title.clone()),
        nodes: vec![stack, camera],
        extensions: None,
        extras: extras::of_scene(scene, &factors, &legends)?,
    });
    builder.root.scene = Some(top);
    builder.root.asset.generator = Some(format!("truegap-scene {}", env!("CARGO_PKG_VERSION")));
    container(builder)
}

fn container(mut builder: Builder) -> Result<Vec<u8>, SceneError> {
    builder.root.buffers[0].byte_length = USize64(builder.bin.len() as u64);
    let json = builder.root.to_vec()?;
    // Header, two chunk headers, padding of the JSON.
    let bytes = json.len() + builder.bin.len() + 12 + 16 + 4;
    let length = u32::try_from(bytes).map_err(|_| SceneError::TooLarge { bytes })?;
    let header = Header { magic: *b"glTF", version: 2, length };
    Ok(Glb { header, json: Cow::Owned(json), bin: Some(Cow::Owned(builder.bin)) }.to_vec()?)
}

fn add_layer(
    builder: &mut Builder,
    layer: &Layer,
    surface: &Surface,
    factors: &[f64],
    legends: &[Legend],
) -> Result<json::Index<json::Node>, SceneError> {
    let material = builder.root.push(material(layer, layer.field(0).is_some()));
    let primitive = json::mesh::Primitive {
        attributes: attributes(builder, layer, surface, legends),
        indices: Some(builder.triangles(&format!("{}: triangles", layer.name), &surface.triangles)),
        material: Some(material),
        mode: Valid(json::mesh::Mode::Triangles),
        targets: (!factors.is_empty()).then(|| targets(builder, layer, surface)),
        extensions: None,
        extras: None,
    };
    let mesh = builder.root.push(json::Mesh {
        name: Some(layer.name.clone()),
        primitives: vec![primitive],
        weights: (!factors.is_empty()).then(|| vec![0.0; factors.len()]),
        extensions: None,
        extras: extras::of_mesh(factors)?,
    });
    Ok(builder.root.push(json::Node {
        name: Some(layer.name.clone()),
        mesh: Some(mesh),
        extras: extras::of_layer(layer, legends)?,
        ..Default::default()
    }))
}

fn attributes(
    builder: &mut Builder,
    layer: &Layer,
    surface: &Surface,
    legends: &[Legend],
) -> BTreeMap<json::validation::Checked<json::mesh::Semantic>, json::Index<json::Accessor>> {
    use json::mesh::Semantic;
    let name = |what: &str| format!("{}: {what}", layer.name);
    let rest = &surface.shapes[0];
    let mut attributes = BTreeMap::new();
    let positions = builder.vectors(&name("positions"), &millimetres(&rest.positions), true);
    attributes.insert(Valid(Semantic::Positions), positions);
    let normals = builder.vectors(&name("normals"), &single(&rest.normals), false);
    attributes.insert(Valid(Semantic::Normals), normals);
    for legend in legends {
        let Some(values) = layer.field(legend.index) else { continue };
        let values = || surface.source.iter().map(|&point| values[point]);
        if legend.index == 0 {
            let opaque = |[r, g, b]: [f32; 3]| [r, g, b, 1.0];
            let colours: Vec<[f32; 4]> = values().map(|v| opaque(legend.colour(v).linear())).collect();
            attributes.insert(Valid(Semantic::Colors(0)), builder.colours(&name("colours"), &colours));
        }
        let numbers: Vec<f32> = values().map(|v| v as f32).collect();
        let numbers = builder.scalars(&name(&legend.field.name), &numbers);
        attributes.insert(Valid(Semantic::Extras(legend.attribute())), numbers);
    }
    attributes
}

fn targets(builder: &mut Builder, layer: &Layer, surface: &Surface) -> Vec<json::mesh::MorphTarget> {
    let rest = &surface.shapes[0];
    let target = |(n, shape): (usize, &Shape)| {
        let deltas = |moved: &[[f64; 3]], rest: &[[f64; 3]]| -> Vec<[f64; 3]> {
            moved.iter().zip(rest).map(|(a, b)| [a[0] - b[0], a[1] - b[1], a[2] - b[2]]).collect()
        };
        let name = |what: &str| format!("{}: {what} of target {n}", layer.name);
        let positions = millimetres(&deltas(&shape.positions, &rest.positions));
        let normals = single(&deltas(&shape.normals, &rest.normals));
        json::mesh::MorphTarget {
            positions: Some(builder.vectors(&name("position change"), &positions, true)),
            normals: Some(builder.vectors(&name("normal change"), &normals, false)),
            tangents: None,
        }
    };
    surface.shapes[1..].iter().enumerate().map(target).collect()
}

/// Matte; white where vertex colours carry the field (they multiply).
fn material(layer: &Layer, coloured: bool) -> json::Material {
    use json::material::{PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};
    let [r, g, b] = if coloured { [1.0; 3] } else { layer.colour.linear() };
    json::Material {
        name: Some(layer.name.clone()),
        pbr_metallic_roughness: PbrMetallicRoughness {
            base_color_factor: PbrBaseColorFactor([r, g, b, 1.0]),
            metallic_factor: StrengthFactor(0.0),
            roughness_factor: StrengthFactor(0.8),
            ..Default::default()
        },
        ..Default::default()
    }
}

fn millimetres(vectors: &[[f64; 3]]) -> Vec<[f32; 3]> {
    vectors.iter().map(|v| v.map(|x| (x * PER_METRE) as f32)).collect()
}

fn single(vectors: &[[f64; 3]]) -> Vec<[f32; 3]> {
    vectors.iter().map(|v| v.map(|x| x as f32)).collect()
}
