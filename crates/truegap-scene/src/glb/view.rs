//! A camera that sees the whole stack: viewers' default cameras are made for things of a metre.

use gltf_json as json;
use json::validation::Checked::Valid;

/// Vertical opening of the camera, radians.
const OPENING: f64 = 0.6;
/// Turn to the right of +Z and lift above the horizon, radians.
const AZIMUTH: f64 = 0.35;
const ELEVATION: f64 = 0.5;

/// Cylinder about the axis around everything shown, metres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    radius: f64,
    low: f64,
    high: f64,
}

impl Default for Bounds {
    fn default() -> Self {
        Self { radius: 0.0, low: f64::INFINITY, high: f64::NEG_INFINITY }
    }
}

impl Bounds {
    pub fn include(&mut self, positions: &[[f64; 3]]) {
        for [x, y, z] in positions {
            self.radius = self.radius.max(x.hypot(*z));
            self.low = self.low.min(*y);
            self.high = self.high.max(*y);
        }
    }
}

/// Adds a camera and returns its node, which belongs at the top of the scene (metres).
pub(super) fn add_camera(root: &mut json::Root, bounds: &Bounds) -> json::Index<json::Node> {
    let radius = bounds.radius.hypot(0.5 * (bounds.high - bounds.low));
    let distance = radius / (0.5 * OPENING).sin();
    let camera = root.push(json::Camera {
        name: Some("whole stack".into()),
        orthographic: None,
        perspective: Some(json::camera::Perspective {
            aspect_ratio: None,
            yfov: OPENING as f32,
            zfar: Some((distance + 4.0 * radius) as f32),
            znear: (0.05 * distance) as f32,
            extensions: None,
            extras: None,
        }),
        type_: Valid(json::camera::Type::Perspective),
        extensions: None,
        extras: None,
    });
    let ((sa, ca), (se, ce)) = (AZIMUTH.sin_cos(), ELEVATION.sin_cos());
    let from = [distance * ce * sa, 0.5 * (bounds.low + bounds.high) + distance * se, distance * ce * ca];
    // A turn about Y after a turn about X that looks down.
    let ((sy, cy), (sx, cx)) = ((0.5 * AZIMUTH).sin_cos(), (-0.5 * ELEVATION).sin_cos());
    let turn = [cy * sx, sy * cx, -sy * sx, cy * cx];
    root.push(json::Node {
        name: Some("camera".into()),
        camera: Some(camera),
        translation: Some(from.map(|x| x as f32)),
        rotation: Some(json::scene::UnitQuaternion(turn.map(|x| x as f32))),
        ..Default::default()
    })
}
