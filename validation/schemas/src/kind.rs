//! Types of the standard library and their like, as JSON has them.
//!
//! Limits: a number that is not finite is written as `null` by `serde_json`; the schemas promise numbers, and tests hold real outputs against them.

use serde_json::{Value, json};
use syn::{GenericArgument, PathArguments, PathSegment, Type};

/// What a type of the standard library is.
pub(crate) enum Kind<'a> {
    /// a value without parts of ours
    Plain(Value),
    /// what it holds, and nothing more
    Same(&'a Type),
    /// it or nothing
    Maybe(&'a Type),
    /// a list
    List(&'a Type),
    /// keys and values
    Map(&'a Type, &'a Type),
}

/// The kind of a path's last segment; none where it is a type of ours.
pub(crate) fn kind(segment: &PathSegment) -> Option<Kind<'_>> {
    let inner = inner(segment);
    let number =
        |low: Option<u64>| low.map_or_else(|| json!({"type": "integer"}), |low| json!({"type": "integer", "minimum": low}));
    Some(match (segment.ident.to_string().as_str(), inner.as_slice()) {
        ("String" | "str" | "PathBuf" | "Path" | "EffectId", []) => Kind::Plain(json!({"type": "string"})),
        ("bool", []) => Kind::Plain(json!({"type": "boolean"})),
        ("f64" | "f32", []) => Kind::Plain(json!({"type": "number"})),
        ("usize" | "u64" | "u32" | "u16" | "u8", []) => Kind::Plain(number(Some(0))),
        ("isize" | "i64" | "i32" | "i16" | "i8", []) => Kind::Plain(number(None)),
        ("Value", []) => Kind::Plain(json!({})),
        ("Box" | "Arc" | "Rc" | "Spanned" | "Cow", [inner]) => Kind::Same(inner),
        ("Option", [inner]) => Kind::Maybe(inner),
        ("Vec" | "BTreeSet", [inner]) => Kind::List(inner),
        ("BTreeMap" | "HashMap", [key, value]) => Kind::Map(key, value),
        _ => return None,
    })
}

fn inner(segment: &PathSegment) -> Vec<&Type> {
    let PathArguments::AngleBracketed(arguments) = &segment.arguments else { return Vec::new() };
    let types = arguments.args.iter().map(|argument| match argument {
        GenericArgument::Type(inner) => Some(inner),
        _ => None,
    });
    types.flatten().collect()
}
