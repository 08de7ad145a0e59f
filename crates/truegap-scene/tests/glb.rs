//! GLB files read back by the `gltf` crate, an implementation of the format that is not the writer's.

#![allow(clippy::unwrap_used)]

use serde_json::Value;
use truegap_scene::colour::{ColourMap, Rgb};
use truegap_scene::glb::{Field, Provenance, Scene, SceneError, suggested_exaggeration};
use truegap_scene::solid::{Layer, Sweep};

/// A bar of 2 by 1 mm section, 3 to 5 mm from the axis, that moves out by 1 um a mm and up by 5 um a mm.
fn bar(name: &str) -> Layer {
    let points = vec![[3e-3, 0.0], [5e-3, 0.0], [5e-3, 1e-3], [3e-3, 1e-3]];
    Layer {
        name: name.into(),
        colour: Rgb::hex(0xB87333),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        displacement: points.iter().map(|p| [1e-3 * p[0], 5e-3 * p[0]]).collect(),
        fields: vec![points.iter().map(|p| 1e3 * (p[0] + p[1])).collect(), points.iter().map(|p| -p[1]).collect()],
        points,
    }
}

fn scene() -> Scene {
    let mut second = bar("bare metal");
    second.points.iter_mut().for_each(|p| p[1] += 2e-3);
    second.fields[1] = second.points.iter().map(|p| -p[1]).collect();
    second.fields[0].clear();
    Scene {
        title: "bars".into(),
        layers: vec![bar("copper"), second],
        fields: vec![
            Field { name: "temperature".into(), unit: "K".into(), map: ColourMap::Sequential, range: None },
            Field { name: "potential".into(), unit: "V".into(), map: ColourMap::Diverging, range: None },
        ],
        sweep: Sweep::CUT_AWAY,
        exaggeration: Some(20.0),
        provenance: Provenance {
            source: "test".into(),
            command: "cargo test".into(),
            version: "1.2.3".into(),
            notes: vec![("load".into(), "4.5 N".into())],
        },
    }
}

struct Read {
    document: gltf::Document,
    bytes: Vec<u8>,
}

fn read(scene: &Scene) -> Read {
    let bytes = scene.to_glb().expect("a scene");
    let gltf::Gltf { document, blob } = gltf::Gltf::from_slice(&bytes).expect("a glTF file");
    assert_eq!(document.buffers().count(), 1, "one buffer, inside the file");
    Read { document, bytes: blob.expect("the buffer") }
}

impl Read {
    fn mesh(&self, node: &str) -> gltf::Mesh<'_> {
        let node = self.document.nodes().find(|n| n.name() == Some(node)).expect("the node is there");
        node.mesh().expect("it has a mesh")
    }

    fn positions(&self, node: &str) -> Vec<[f32; 3]> {
        let primitive = self.mesh(node).primitives().next().expect("a primitive");
        primitive.reader(|_| Some(self.bytes.as_slice())).read_positions().expect("positions").collect()
    }
}

#[test]
fn every_layer_is_one_named_node_with_one_named_material() {
    let read = read(&scene());
    let root = read.document.scenes().next().expect("a scene").nodes().next().expect("a node");
    let names: Vec<_> = root.children().map(|n| n.name().unwrap_or("").to_owned()).collect();
    assert_eq!(names, ["copper", "bare metal"]);
    for name in names {
        let primitive = read.mesh(&name).primitives().next().expect("a primitive");
        assert_eq!(primitive.material().name(), Some(name.as_str()));
    }
}

#[test]
fn coordinates_are_metres_after_the_root_scale() {
    let read = read(&scene());
    let scale = read.document.scenes().next().expect("a scene").nodes().next().expect("a node").transform().decomposed().2;
    let highest = |of: &dyn Fn(&[f32; 3]) -> f32| read.positions("copper").iter().map(of).fold(0.0, f32::max);
    // Single precision of a few millimetres.
    assert!((highest(&|p| p[0].hypot(p[2]) * scale[0]) - 5e-3).abs() < 1e-8);
    assert!((highest(&|p| p[1] * scale[1]) - 1e-3).abs() < 1e-8);
}

#[test]
fn morph_targets_move_true_to_scale_and_exaggerated_with_unit_normals() {
    let read = read(&scene());
    let mesh = read.mesh("copper");
    let primitive = mesh.primitives().next().expect("a primitive");
    let reader = primitive.reader(|_| Some(read.bytes.as_slice()));
    let rest: Vec<_> = reader.read_positions().expect("positions").collect();
    let normals: Vec<_> = reader.read_normals().expect("normals").collect();
    let targets: Vec<_> = reader.read_morph_targets().collect();
    assert_eq!((targets.len(), mesh.weights()), (2, Some(&[0.0, 0.0][..])));
    for ((moved, turned, _), factor) in targets.into_iter().zip([1.0, 20.0]) {
        for (rest, delta) in rest.iter().zip(moved.expect("positions")) {
            let radius = rest[0].hypot(rest[2]);
            let outward = (delta[0] * rest[0] + delta[2] * rest[2]) / radius;
            // Single precision of the deltas: 1e-7 of them.
            assert!((outward - factor * 1e-3 * radius).abs() < 1e-6 * factor * radius);
            assert!((delta[1] - factor * 5e-3 * radius).abs() < 1e-6 * factor * radius);
        }
        let mut largest_turn = 0.0f32;
        for (normal, delta) in normals.iter().zip(turned.expect("normals")) {
            let n = [normal[0] + delta[0], normal[1] + delta[1], normal[2] + delta[2]];
            assert!((n[0].hypot(n[1]).hypot(n[2]) - 1.0).abs() < 1e-6);
            largest_turn = largest_turn.max(delta[0].hypot(delta[1]).hypot(delta[2]));
        }
        // The upper side tilts by the slope du_z/dr over the stretch (1 + du_r/dr).
        let tilt = (5e-3 * factor / (1.0 + 1e-3 * factor)).atan();
        assert!((largest_turn - 2.0 * (tilt / 2.0).sin()).abs() < 1e-6, "{largest_turn} {tilt}");
    }
}

#[test]
fn animations_lead_from_rest_to_each_target_and_back() {
    let read = read(&scene());
    let names: Vec<_> = read.document.animations().map(|a| a.name().unwrap_or("").to_owned()).collect();
    assert_eq!(names, ["rest to deformed, true scale", "rest to deformed, exaggerated x20"]);
    for (target, animation) in read.document.animations().enumerate() {
        assert_eq!(animation.channels().count(), 2);
        for channel in animation.channels() {
            let reader = channel.reader(|_| Some(read.bytes.as_slice()));
            let Some(gltf::animation::util::ReadOutputs::MorphTargetWeights(weights)) = reader.read_outputs() else {
                panic!("weights expected");
            };
            let weights: Vec<f32> = weights.into_f32().collect();
            let of_target: Vec<f32> = weights.chunks(2).map(|w| w[target]).collect();
            assert_eq!((of_target, weights.chunks(2).all(|w| w[1 - target] == 0.0)), (vec![0.0, 1.0, 1.0, 0.0], true));
        }
    }
}

#[test]
fn vertex_colours_are_linear_light_of_the_map_and_carry_their_values() {
    let read = read(&scene());
    let primitive = read.mesh("copper").primitives().next().expect("a primitive");
    let reader = primitive.reader(|_| Some(read.bytes.as_slice()));
    let colours: Vec<[f32; 4]> = reader.read_colors(0).expect("colours").into_rgba_f32().collect();
    let positions = read.positions("copper");
    // The field is r + z in mm, 3 to 6; ends of the map: dark violet 440154 and yellow FDE725, decoded by hand.
    let at = |value: f32| {
        let index = positions.iter().position(|p| (p[0].hypot(p[2]) + p[1] - value).abs() < 1e-4).expect("a vertex");
        colours[index]
    };
    let close = |a: [f32; 4], b: [f32; 4]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 2e-3);
    assert!(close(at(3.0), [0.0578, 0.0003, 0.0887, 1.0]) && close(at(6.0), [0.9823, 0.7991, 0.0185, 1.0]));
    let bare = read.mesh("bare metal").primitives().next().expect("a primitive");
    assert!(bare.reader(|_| Some(read.bytes.as_slice())).read_colors(0).is_none());
    let factor = bare.material().pbr_metallic_roughness().base_color_factor();
    assert!(close(factor, [0.4793, 0.1714, 0.0331, 1.0]));
    let values = primitive.attributes().find(|(s, _)| s.to_string() == "_FIELD_0").expect("values").1;
    assert_eq!((values.min().map(|v| v[0].as_f64()), values.max().map(|v| v[0].as_f64())), (Some(Some(3.0)), Some(Some(6.0))));
}

#[test]
fn the_metadata_says_units_legend_and_origin() {
    let read = read(&scene());
    let extras = read.document.scenes().next().expect("a scene").extras().clone().expect("extras");
    let extras: Value = serde_json::from_str(extras.get()).expect("JSON");
    assert_eq!(extras["units"]["length"], "m");
    assert_eq!((&extras["fields"][0]["name"], &extras["fields"][0]["unit"]), (&"temperature".into(), &"K".into()));
    assert_eq!((extras["fields"][0]["min"].as_f64(), extras["fields"][0]["max"].as_f64()), (Some(3.0), Some(6.0)));
    assert_eq!(extras["fields"][0]["stops"][0]["srgb"], "#440154");
    assert_eq!(extras["coloured_by"], "temperature");
    // The second part reaches 3 mm up; its map is symmetric about zero.
    let potential = &extras["fields"][1];
    assert_eq!((potential["min"].as_f64(), potential["max"].as_f64()), (Some(-3e-3), Some(3e-3)));
    assert_eq!((potential["data_max"].as_f64(), &potential["attribute"]), (Some(0.0), &"_FIELD_1".into()));
    assert_eq!(extras["provenance"]["version"], "1.2.3");
    assert_eq!(extras["provenance"]["notes"]["load"], "4.5 N");
    assert_eq!(extras["deformation"]["targets"][1]["factor"], 20.0);
}

#[test]
fn the_camera_looks_at_the_middle_from_outside() {
    let read = read(&scene());
    let node = read.document.nodes().find(|n| n.camera().is_some()).expect("a camera");
    let camera = node.camera().expect("camera");
    let gltf::camera::Projection::Perspective(lens) = camera.projection() else {
        panic!("perspective expected");
    };
    let matrix = node.transform().matrix();
    let (backward, position) = (matrix[2], matrix[3]);
    // The ray from the camera against its backward axis passes the middle of the bars (0, y, 0).
    let along = position[2] / backward[2];
    assert!((position[0] - along * backward[0]).abs() < 1e-5 * along);
    let height = position[1] - along * backward[1];
    assert!((0.0..0.02).contains(&height) && along > lens.znear() && along < lens.zfar().expect("far plane"));
}

#[test]
fn a_stack_at_rest_has_neither_targets_nor_animation() {
    let mut still = scene();
    still.layers.iter_mut().for_each(|l| l.displacement.clear());
    let read = read(&still);
    assert_eq!(read.document.animations().count(), 0);
    assert_eq!(read.mesh("copper").primitives().next().expect("a primitive").morph_targets().count(), 0);
}

#[test]
fn the_suggested_exaggeration_shows_a_tenth_of_the_size() {
    // Largest displacement sqrt(26) * 5 um; largest dimension 3 mm high; a tenth of it is 11.8 times as much.
    assert_eq!(suggested_exaggeration(&scene().layers), Some(10.0));
    let mut large = scene().layers;
    large.iter_mut().flat_map(|l| &mut l.displacement).for_each(|u| u[1] *= 100.0);
    assert_eq!(suggested_exaggeration(&large), None);
    // A tenth of compression times five leaves half the height, times ten nothing.
    let mut squeezed = vec![bar("squeezed")];
    squeezed[0].displacement = squeezed[0].points.iter().map(|p| [0.0, -0.1 * p[1]]).collect();
    squeezed[0].points.iter_mut().for_each(|p| p[0] *= 10.0);
    assert_eq!(suggested_exaggeration(&squeezed), Some(5.0));
}

#[test]
fn scenes_that_contradict_themselves_are_typed_errors() {
    let broken = |change: &dyn Fn(&mut Scene)| {
        let mut scene = scene();
        change(&mut scene);
        scene.to_glb().expect_err("a contradiction")
    };
    assert!(matches!(broken(&|s| s.layers.clear()), SceneError::NoLayer { .. }));
    assert!(matches!(broken(&|s| s.layers[1].name = "copper".into()), SceneError::SameName { .. }));
    assert!(matches!(broken(&|s| s.layers[1].displacement.clear()), SceneError::SomeRest { .. }));
    assert!(matches!(broken(&|s| s.fields.truncate(1)), SceneError::FieldCount { found: 2, wanted: 1, .. }));
    assert!(matches!(broken(&|s| s.layers[0].fields[0].clear()), SceneError::NoValues { .. }));
    assert!(matches!(broken(&|s| s.exaggeration = Some(0.5)), SceneError::Exaggeration { .. }));
    assert!(matches!(broken(&|s| s.layers[0].points[0][0] = -1.0), SceneError::Solid(_)));
    let range = broken(&|s| s.fields[0].range = Some((2.0, 1.0)));
    assert!(matches!(range, SceneError::Range { .. }));
}
