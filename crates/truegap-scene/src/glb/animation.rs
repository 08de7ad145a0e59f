//! One animation for each morph target: from rest to deformed and back.

use super::accessors::Builder;
use super::extras::target_name;
use gltf_json as json;
use json::animation::{Channel, Interpolation, Property, Sampler, Target};
use json::validation::Checked::Valid;

/// Seconds at which the stack is at rest, deformed, held, at rest again.
const TIMES: [f32; 4] = [0.0, 2.0, 3.0, 5.0];
const WEIGHTS: [f32; 4] = [0.0, 1.0, 1.0, 0.0];

/// Adds the animations of `nodes`, whose meshes have a target for each of `factors`.
pub(super) fn add(builder: &mut Builder, nodes: &[json::Index<json::Node>], factors: &[f64]) {
    if factors.is_empty() {
        return;
    }
    let input = builder.keyframes("animation times", &TIMES, true);
    for (target, &factor) in factors.iter().enumerate() {
        let weight_of = |w: f32| (0..factors.len()).map(move |n| if n == target { w } else { 0.0 });
        let weights: Vec<f32> = WEIGHTS.into_iter().flat_map(weight_of).collect();
        let output = builder.keyframes(&format!("animation weights {target}"), &weights, false);
        let sampler = Sampler { input, interpolation: Valid(Interpolation::Linear), output, extensions: None, extras: None };
        let channel = |&node: &json::Index<json::Node>| Channel {
            sampler: json::Index::new(0),
            target: Target { node, path: Valid(Property::MorphTargetWeights), extensions: None, extras: None },
            extensions: None,
            extras: None,
        };
        builder.root.push(json::Animation {
            name: Some(format!("rest to {}", target_name(factor))),
            channels: nodes.iter().map(channel).collect(),
            samplers: vec![sampler],
            extensions: None,
            extras: None,
        });
    }
}
