//! From a type of the sources to a JSON Schema (draft 2020-12).
//!
//! Limits: the shape that `serde` gives it; what a reader checks beyond that (ranges, words) is not in it.

use crate::attributes::{Told, says};
use crate::error::SchemaError;
use crate::index::{Defined, Index, Shape};
use crate::kind::{Kind, kind};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use syn::{Expr, Field, Fields, ItemEnum, ItemStruct, Lit, Type, Variant};

/// Whether the program writes a document, or people do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// JSON that the program writes: what is not known is `null`
    Written,
    /// TOML that is read: what is not known is not there
    Read,
}

/// Collects the schemas of one document.
pub(crate) struct Schemas<'a> {
    index: &'a Index,
    side: Side,
    by_hand: &'a Map<String, Value>,
    /// schemas of types, by the names under `$defs`
    pub defs: Map<String, Value>,
    /// name under `$defs` -> place of the definition
    taken: BTreeMap<String, String>,
}

impl<'a> Schemas<'a> {
    /// None yet.
    pub fn new(index: &'a Index, side: Side, by_hand: &'a Map<String, Value>) -> Self {
        Self { index, side, by_hand, defs: Map::new(), taken: BTreeMap::new() }
    }

    /// A reference to the type `name` as `module` means it.
    pub fn of_name(&mut self, name: &str, module: &str) -> Result<Value, SchemaError> {
        if let Some(given) = self.by_hand.get(name) {
            self.defs.insert(name.to_owned(), given.clone());
            return Ok(reference(name));
        }
        let defined = self.index.find(name, module)?;
        let key = self.key(name, &defined.path);
        if !self.defs.contains_key(&key) {
            self.defs.insert(key.clone(), Value::Null); // a type may hold itself
            let schema = self.defined(defined)?;
            self.defs.insert(key.clone(), schema);
        }
        Ok(reference(&key))
    }

    /// The name of a type under `$defs`; with its module where another type has that name.
    fn key(&mut self, name: &str, path: &str) -> String {
        let place = self.taken.entry(name.to_owned()).or_insert_with(|| path.to_owned());
        if place == path { name.to_owned() } else { format!("{name} of {}", path.rsplit("::").next().unwrap_or(path)) }
    }

    fn defined(&mut self, defined: &Defined) -> Result<Value, SchemaError> {
        match &defined.shape {
            Shape::Struct(item) => self.of_struct(item, &defined.path),
            Shape::Enum(item) => self.of_enum(item, &defined.path),
        }
    }

    fn of_struct(&mut self, item: &ItemStruct, module: &str) -> Result<Value, SchemaError> {
        let told = Told::of(&item.attrs, &format!("{module}::{}", item.ident))?;
        let schema = self.fields(&item.fields, module, told.rename_all.as_deref())?;
        Ok(described(schema, says(&item.attrs)))
    }

    fn fields(&mut self, fields: &Fields, module: &str, case: Option<&str>) -> Result<Value, SchemaError> {
        match fields {
            Fields::Unit => Ok(json!({"type": "null"})),
            Fields::Unnamed(list) if list.unnamed.len() == 1 => self.of_type(&list.unnamed[0].ty, module),
            Fields::Unnamed(list) => {
                let parts = list.unnamed.iter().map(|f| self.of_type(&f.ty, module)).collect::<Result<Vec<_>, _>>()?;
                Ok(tuple(parts))
            }
            Fields::Named(list) => {
                let mut object = Object::default();
                for field in &list.named {
                    self.field(field, module, case, &mut object)?;
                }
                Ok(object.schema())
            }
        }
    }

    fn field(&mut self, field: &Field, module: &str, case: Option<&str>, object: &mut Object) -> Result<(), SchemaError> {
        let ident = field.ident.as_ref().map(ToString::to_string).unwrap_or_default();
        let told = Told::of(&field.attrs, &format!("{module}, field {ident}"))?;
        if told.skip {
            return Ok(());
        }
        if told.flatten {
            return self.flattened(&field.ty, module, object);
        }
        let name = told.name(&ident, case);
        let (inner, optional) = match (self.side, as_option(&field.ty)) {
            (Side::Read, Some(inner)) => (inner, true),
            (Side::Written, Some(inner)) if told.may_be_absent => (inner, true),
            _ => (&field.ty, false),
        };
        let schema = match &told.written_by {
            Some(function) => self.by_function(function, inner, module)?,
            None => self.of_type(inner, module)?,
        };
        let absent = optional || told.may_be_absent || (self.side == Side::Read && told.has_default);
        object.properties.insert(name.clone(), described(schema, says(&field.attrs)));
        if !absent {
            object.required.push(name);
        }
        Ok(())
    }

    /// A list of pairs that is written as a map is the one function that the workspace has for this.
    fn by_function(&mut self, function: &str, of: &Type, module: &str) -> Result<Value, SchemaError> {
        let unknown = || SchemaError::Unknown { place: module.to_owned(), what: format!("`serialize_with = {function}`") };
        let pair = match of {
            Type::Path(path) => path.path.segments.last().and_then(kind),
            _ => None,
        };
        match (function, pair) {
            ("as_map", Some(Kind::List(Type::Tuple(pair)))) if pair.elems.len() == 2 => {
                let value = self.of_type(&pair.elems[1], module)?;
                Ok(json!({"type": "object", "additionalProperties": value}))
            }
            _ => Err(unknown()),
        }
    }

    fn flattened(&mut self, inner: &Type, module: &str, object: &mut Object) -> Result<(), SchemaError> {
        let unknown = |what: String| SchemaError::Unknown { place: module.to_owned(), what };
        let Type::Path(path) = inner else { return Err(unknown("a flattened type without a name".into())) };
        let Some(segment) = path.path.segments.last() else { return Err(unknown("a flattened type without a name".into())) };
        let name = segment.ident.to_string();
        if name == "Table" || matches!(kind(segment), Some(Kind::Map(..))) {
            object.open = true;
            return Ok(());
        }
        let defined = self.index.find(&name, module)?;
        match &defined.shape {
            Shape::Struct(item) => {
                let Fields::Named(list) = &item.fields else { return Err(unknown(format!("the flattened tuple `{name}`"))) };
                list.named.iter().try_for_each(|field| self.field(field, &defined.path, None, object))
            }
            Shape::Enum(_) => Err(unknown(format!("the flattened enum `{name}`"))),
        }
    }

    fn of_enum(&mut self, item: &ItemEnum, module: &str) -> Result<Value, SchemaError> {
        let told = Told::of(&item.attrs, &format!("{module}::{}", item.ident))?;
        let case = told.rename_all.as_deref();
        if told.tag.is_none() && !told.untagged && item.variants.iter().all(|v| matches!(v.fields, Fields::Unit)) {
            let names = item.variants.iter().map(|v| variant_name(v, module, case)).collect::<Result<Vec<_>, _>>()?;
            return Ok(described(json!({"enum": names}), says(&item.attrs)));
        }
        let each = item.variants.iter().map(|variant| self.variant(variant, module, &told, case));
        let each = each.collect::<Result<Vec<_>, _>>()?;
        Ok(described(json!({"anyOf": each}), says(&item.attrs)))
    }

    fn variant(&mut self, variant: &Variant, module: &str, of: &Told, case: Option<&str>) -> Result<Value, SchemaError> {
        let name = variant_name(variant, module, case)?;
        let inner_case = Told::of(&variant.attrs, module)?.rename_all;
        let schema = match (&variant.fields, &of.tag) {
            (fields, None) if of.untagged => self.fields(fields, module, inner_case.as_deref())?,
            (Fields::Unit, None) => json!({"const": name}),
            (fields, None) => {
                let inner = self.fields(fields, module, inner_case.as_deref())?;
                json!({"type": "object", "properties": {&name: inner}, "required": [name], "additionalProperties": false})
            }
            (fields, Some(tag)) => {
                let mut object = Object::default();
                object.properties.insert(tag.clone(), json!({"const": name}));
                object.required.push(tag.clone());
                match fields {
                    Fields::Named(list) => {
                        list.named.iter().try_for_each(|f| self.field(f, module, inner_case.as_deref(), &mut object))?;
                    }
                    Fields::Unit => {}
                    Fields::Unnamed(list) => self.flattened(&list.unnamed[0].ty, module, &mut object)?,
                }
                object.schema()
            }
        };
        Ok(described(schema, says(&variant.attrs)))
    }

    fn of_type(&mut self, ty: &Type, module: &str) -> Result<Value, SchemaError> {
        let unknown = |what: &str| SchemaError::Unknown { place: module.to_owned(), what: what.to_owned() };
        match ty {
            Type::Reference(inner) => self.of_type(&inner.elem, module),
            Type::Paren(inner) => self.of_type(&inner.elem, module),
            Type::Slice(inner) => Ok(list(self.of_type(&inner.elem, module)?)),
            Type::Array(inner) => {
                let mut schema = list(self.of_type(&inner.elem, module)?);
                if let Expr::Lit(length) = &inner.len
                    && let Lit::Int(length) = &length.lit
                {
                    let length: u64 = length.base10_parse().map_err(|_| unknown("the length of an array"))?;
                    schema["minItems"] = length.into();
                    schema["maxItems"] = length.into();
                }
                Ok(schema)
            }
            Type::Tuple(inner) => Ok(tuple(inner.elems.iter().map(|t| self.of_type(t, module)).collect::<Result<Vec<_>, _>>()?)),
            Type::Path(path) => {
                let segment = path.path.segments.last().ok_or_else(|| unknown("a type without a name"))?;
                match kind(segment) {
                    Some(kind) => self.of_kind(kind, module),
                    None => self.of_name(&segment.ident.to_string(), module),
                }
            }
            _ => Err(unknown("a type that is neither path, array nor tuple")),
        }
    }

    fn of_kind(&mut self, kind: Kind<'_>, module: &str) -> Result<Value, SchemaError> {
        Ok(match kind {
            Kind::Plain(schema) => schema,
            Kind::Same(inner) => self.of_type(inner, module)?,
            Kind::Maybe(inner) => {
                let inner = self.of_type(inner, module)?;
                json!({"anyOf": [inner, {"type": "null"}]})
            }
            Kind::List(inner) => list(self.of_type(inner, module)?),
            Kind::Map(key, value) => {
                let (key, value) = (self.of_type(key, module)?, self.of_type(value, module)?);
                let mut schema = json!({"type": "object", "additionalProperties": value});
                if key != json!({"type": "string"}) {
                    schema["propertyNames"] = key;
                }
                schema
            }
        })
    }
}

fn variant_name(variant: &Variant, module: &str, case: Option<&str>) -> Result<String, SchemaError> {
    Ok(Told::of(&variant.attrs, module)?.name(&variant.ident.to_string(), case))
}

/// An object while its keys are collected.
#[derive(Default)]
struct Object {
    properties: Map<String, Value>,
    required: Vec<String>,
    /// whether other keys may stand in it
    open: bool,
}

impl Object {
    fn schema(self) -> Value {
        let mut schema = json!({"type": "object", "properties": self.properties});
        if !self.required.is_empty() {
            schema["required"] = self.required.into();
        }
        schema["additionalProperties"] = self.open.into();
        schema
    }
}

fn as_option(ty: &Type) -> Option<&Type> {
    let Type::Path(path) = ty else { return None };
    match kind(path.path.segments.last()?) {
        Some(Kind::Maybe(inner)) => Some(inner),
        _ => None,
    }
}

fn reference(name: &str) -> Value {
    json!({"$ref": format!("#/$defs/{}", name.replace(' ', "%20"))})
}

fn list(items: Value) -> Value {
    json!({"type": "array", "items": items})
}

fn tuple(parts: Vec<Value>) -> Value {
    let length = parts.len();
    json!({"type": "array", "prefixItems": parts, "minItems": length, "maxItems": length})
}

fn described(schema: Value, says: Option<String>) -> Value {
    let (Some(says), Value::Object(inner)) = (says, &schema) else { return schema };
    // what stands nearest to the reader comes first
    let mut out = Map::new();
    out.insert("description".into(), says.into());
    out.extend(inner.iter().filter(|(key, _)| *key != "description").map(|(key, value)| (key.clone(), value.clone())));
    Value::Object(out)
}
