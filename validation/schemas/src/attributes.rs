//! What `serde` is told of a type, a field or a variant, and what a reader is told of it.
//!
//! Limits: the words that the workspace uses; any other is an error, so that no schema is wrong in silence.

use crate::error::SchemaError;
use syn::{Attribute, Expr, Lit, Meta};

/// What `serde` is told.
#[derive(Debug, Default)]
pub(crate) struct Told {
    pub rename: Option<String>,
    pub rename_all: Option<String>,
    pub tag: Option<String>,
    pub untagged: bool,
    pub flatten: bool,
    /// never written nor read
    pub skip: bool,
    /// sometimes not written
    pub may_be_absent: bool,
    /// need not be there to be read
    pub has_default: bool,
    /// written by a function of its own
    pub written_by: Option<String>,
}

impl Told {
    /// What the attributes of `place` say.
    pub fn of(attributes: &[Attribute], place: &str) -> Result<Self, SchemaError> {
        let mut told = Self::default();
        for attribute in attributes.iter().filter(|a| a.path().is_ident("serde")) {
            let unread = |error: syn::Error| SchemaError::Unknown { place: place.to_owned(), what: error.to_string() };
            attribute.parse_nested_meta(|meta| told.take(&meta)).map_err(unread)?;
        }
        Ok(told)
    }

    fn take(&mut self, meta: &syn::meta::ParseNestedMeta<'_>) -> syn::Result<()> {
        let word = meta.path.get_ident().map(ToString::to_string).unwrap_or_default();
        let value = if meta.input.peek(syn::Token![=]) { Some(meta.value()?.parse::<syn::LitStr>()?.value()) } else { None };
        match word.as_str() {
            "rename" => self.rename = value,
            "rename_all" => self.rename_all = value,
            "tag" => self.tag = value,
            "untagged" => self.untagged = true,
            "flatten" => self.flatten = true,
            "skip" | "skip_serializing" => self.skip = true,
            "skip_serializing_if" => self.may_be_absent = true,
            "default" => self.has_default = true,
            "serialize_with" => self.written_by = value,
            "deny_unknown_fields" | "expecting" | "transparent" => {}
            _ => return Err(meta.error(format!("`serde({word})`"))),
        }
        Ok(())
    }

    /// The name of a variant or a field as it is written.
    pub fn name(&self, ident: &str, of_all: Option<&str>) -> String {
        self.rename.clone().unwrap_or_else(|| cased(ident.trim_start_matches("r#"), of_all))
    }
}

/// `ThermalPath` as `thermal_path` or `thermal-path`.
fn cased(ident: &str, case: Option<&str>) -> String {
    let separator = match case {
        Some("snake_case") => "_",
        Some("kebab-case") => "-",
        Some("lowercase") => "",
        _ => return ident.to_owned(),
    };
    let mut out = String::new();
    for (index, letter) in ident.chars().enumerate() {
        if letter.is_uppercase() && index > 0 {
            out += separator;
        }
        out.extend(letter.to_lowercase());
    }
    out
}

/// The doc comment as one line, without the marks of links to items.
pub(crate) fn says(attributes: &[Attribute]) -> Option<String> {
    let line = |attribute: &Attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Str(text) => Some(text.value()),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    };
    let lines: Vec<String> = attributes.iter().filter_map(line).collect();
    let text = lines.join(" ").split_whitespace().collect::<Vec<_>>().join(" ");
    let text = text.replace("[`", "`").replace("`]", "`");
    (!text.is_empty()).then_some(text)
}

#[cfg(test)]
mod tests {
    use super::cased;

    #[test]
    fn variants_are_written_as_serde_writes_them() {
        assert_eq!(cased("ThermalPath", Some("snake_case")), "thermal_path");
        assert_eq!(cased("ThermalPath", Some("kebab-case")), "thermal-path");
        assert_eq!(cased("ThermalPath", None), "ThermalPath");
    }
}
