//! Binary data of a document: aligned, with the bounds that readers and validators expect.

use gltf_json as json;
use json::accessor::{ComponentType, GenericComponentType, Type};
use json::buffer::Target;
use json::validation::Checked::Valid;
use json::validation::USize64;

/// A document under construction with its binary chunk.
pub(super) struct Builder {
    pub root: json::Root,
    pub bin: Vec<u8>,
}

type Accessor = json::Index<json::Accessor>;

impl Builder {
    pub fn new() -> Self {
        let mut root = json::Root::default();
        // The length is set when the chunk is complete.
        root.push(json::Buffer { byte_length: USize64(0), name: None, uri: None, extensions: None, extras: None });
        Self { root, bin: Vec::new() }
    }

    /// Vectors of three with bounds (positions and their deltas).
    pub fn vectors(&mut self, name: &str, values: &[[f32; 3]], bounds: bool) -> Accessor {
        let flat = values.as_flattened();
        let bounds = bounds.then(|| limits(flat, 3));
        self.floats(name, flat, Type::Vec3, bounds, Some(Target::ArrayBuffer))
    }

    /// Colours with opacity, linear light.
    pub fn colours(&mut self, name: &str, values: &[[f32; 4]]) -> Accessor {
        self.floats(name, values.as_flattened(), Type::Vec4, None, Some(Target::ArrayBuffer))
    }

    /// One number a vertex.
    pub fn scalars(&mut self, name: &str, values: &[f32]) -> Accessor {
        let bounds = limits(values, 1);
        self.floats(name, values, Type::Scalar, Some(bounds), Some(Target::ArrayBuffer))
    }

    /// Numbers for animations, which live outside of vertex buffers.
    pub fn keyframes(&mut self, name: &str, values: &[f32], bounds: bool) -> Accessor {
        self.floats(name, values, Type::Scalar, bounds.then(|| limits(values, 1)), None)
    }

    /// Triangle corners.
    pub fn triangles(&mut self, name: &str, values: &[[u32; 3]]) -> Accessor {
        let flat = values.as_flattened();
        let bytes: Vec<u8> = flat.iter().flat_map(|v| v.to_le_bytes()).collect();
        let view = self.view(name, &bytes, Some(Target::ElementArrayBuffer));
        self.accessor(name, view, flat.len(), (ComponentType::U32, Type::Scalar), None)
    }

    fn floats(
        &mut self,
        name: &str,
        flat: &[f32],
        type_: Type,
        bounds: Option<(json::Value, json::Value)>,
        target: Option<Target>,
    ) -> Accessor {
        let bytes: Vec<u8> = flat.iter().flat_map(|v| v.to_le_bytes()).collect();
        let view = self.view(name, &bytes, target);
        self.accessor(name, view, flat.len() / type_.multiplicity(), (ComponentType::F32, type_), bounds)
    }

    fn view(&mut self, name: &str, bytes: &[u8], target: Option<Target>) -> json::Index<json::buffer::View> {
        debug_assert_eq!(bytes.len() % 4, 0);
        let byte_offset = Some(USize64(self.bin.len() as u64));
        self.bin.extend_from_slice(bytes);
        self.root.push(json::buffer::View {
            buffer: json::Index::new(0),
            byte_length: USize64(bytes.len() as u64),
            byte_offset,
            byte_stride: None,
            name: Some(name.into()),
            target: target.map(Valid),
            extensions: None,
            extras: None,
        })
    }

    fn accessor(
        &mut self,
        name: &str,
        view: json::Index<json::buffer::View>,
        count: usize,
        (component, type_): (ComponentType, Type),
        bounds: Option<(json::Value, json::Value)>,
    ) -> Accessor {
        let (min, max) = bounds.unzip();
        self.root.push(json::Accessor {
            buffer_view: Some(view),
            byte_offset: None,
            count: USize64(count as u64),
            component_type: Valid(GenericComponentType(component)),
            extensions: None,
            extras: None,
            type_: Valid(type_),
            min,
            max,
            name: Some(name.into()),
            normalized: false,
            sparse: None,
        })
    }
}

/// Smallest and largest of every component, exactly as stored.
fn limits(flat: &[f32], components: usize) -> (json::Value, json::Value) {
    let of = |pick: fn(f32, f32) -> f32| {
        let one = |c: usize| flat.iter().skip(c).step_by(components).copied().reduce(pick).unwrap_or(0.0);
        json::Value::from((0..components).map(|c| f64::from(one(c))).collect::<Vec<_>>())
    };
    (of(f32::min), of(f32::max))
}
