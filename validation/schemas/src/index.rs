//! Every struct and enum of the workspace by its name.
//!
//! Limits: two types of one name are told apart by the `use` lines of who names them.

use crate::error::SchemaError;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use syn::{Item, ItemEnum, ItemStruct, UseTree};

/// A type as it is written.
pub(crate) enum Shape {
    /// a struct
    Struct(ItemStruct),
    /// an enum
    Enum(ItemEnum),
}

/// A type, and where it stands.
pub(crate) struct Defined {
    /// crate and modules: `truegap_core::units`
    pub path: String,
    /// the item
    pub shape: Shape,
}

/// All types, and what each file calls by which path.
#[derive(Default)]
pub struct Index {
    types: BTreeMap<String, Vec<Defined>>,
    /// module path -> name -> path that it was imported from
    uses: BTreeMap<String, BTreeMap<String, String>>,
}

impl Index {
    /// The sources below `crates` of a workspace.
    ///
    /// # Errors
    /// [`SchemaError`] names the file that cannot be read.
    pub fn of(workspace: &Path) -> Result<Self, SchemaError> {
        let mut index = Self::default();
        for folder in entries(&workspace.join("crates"))? {
            let name = folder.file_name().map(|n| n.to_string_lossy().replace('-', "_")).unwrap_or_default();
            index.read_folder(&folder.join("src"), &name)?;
        }
        // what `truegap prove` writes holds rows of it
        index.read_folder(&workspace.join("validation/blind/generator/src"), "truegap_generator")?;
        Ok(index)
    }

    fn read_folder(&mut self, folder: &Path, module: &str) -> Result<(), SchemaError> {
        for path in entries(folder)? {
            let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
            if path.is_dir() {
                self.read_folder(&path, &format!("{module}::{stem}"))?;
            } else if path.extension().is_some_and(|e| e == "rs") {
                let inside =
                    if ["lib", "main", "mod"].contains(&stem.as_str()) { module.to_owned() } else { format!("{module}::{stem}") };
                self.read_file(&path, &inside)?;
            }
        }
        Ok(())
    }

    fn read_file(&mut self, path: &Path, module: &str) -> Result<(), SchemaError> {
        let text = std::fs::read_to_string(path).map_err(|source| SchemaError::File { file: path.to_owned(), source })?;
        let file = syn::parse_file(&text).map_err(|source| SchemaError::Syntax { file: path.to_owned(), source })?;
        let uses = self.uses.entry(module.to_owned()).or_default();
        for item in file.items {
            let (name, shape) = match item {
                Item::Struct(item) => (item.ident.to_string(), Shape::Struct(item)),
                Item::Enum(item) => (item.ident.to_string(), Shape::Enum(item)),
                Item::Use(item) => {
                    imported(&item.tree, "", uses);
                    continue;
                }
                _ => continue,
            };
            self.types.entry(name).or_default().push(Defined { path: module.to_owned(), shape });
        }
        Ok(())
    }

    /// The type that `name` means in `module`.
    ///
    /// # Errors
    /// [`SchemaError::Type`] where none does, or several do.
    pub(crate) fn find(&self, name: &str, module: &str) -> Result<&Defined, SchemaError> {
        let import = self.uses.get(module).and_then(|uses| uses.get(name)).map(String::as_str);
        // imported under another name
        let name = import.and_then(|path| path.rsplit("::").next()).unwrap_or(name);
        let all = self.types.get(name).map_or(&[][..], Vec::as_slice);
        let near = |defined: &&Defined| nearness(&defined.path, module, import.unwrap_or_default(), name);
        let best = all.iter().map(|d| near(&d)).max().unwrap_or(0);
        let mut nearest = all.iter().filter(|d| near(d) == best);
        match (nearest.next(), nearest.next()) {
            (Some(found), None) => Ok(found),
            _ => {
                let places: Vec<&str> = all.iter().map(|d| d.path.as_str()).collect();
                let found = if places.is_empty() { "no source".to_owned() } else { places.join(" and ") };
                Err(SchemaError::Type { name: name.to_owned(), place: module.to_owned(), found })
            }
        }
    }
}

/// How well a place of definition fits to who names it: same file, then as many words of the import as it shares, then the same crate.
fn nearness(path: &str, module: &str, import: &str, name: &str) -> usize {
    if import.is_empty() && path == module {
        return 1000;
    }
    let words: Vec<&str> = path.split("::").collect();
    let named = import.split("::").filter(|word| *word != name);
    // the facade shows `truegap-model` as `truegap::model`
    let of_facade = |word: &str| words[0].strip_prefix("truegap_") == Some(word);
    let shared =
        named.filter(|word| words.contains(word) || of_facade(word) || (*word == "crate" && words[0] == first(module))).count();
    // a child of the module that re-exports it
    10 * shared + usize::from(words[0] == first(module)) + usize::from(path.starts_with(module))
}

fn first(path: &str) -> &str {
    path.split("::").next().unwrap_or(path)
}

fn imported(tree: &UseTree, path: &str, into: &mut BTreeMap<String, String>) {
    let join = |name: &str| if path.is_empty() { name.to_owned() } else { format!("{path}::{name}") };
    match tree {
        UseTree::Path(inner) => imported(&inner.tree, &join(&inner.ident.to_string()), into),
        UseTree::Name(name) => {
            into.insert(name.ident.to_string(), join(&name.ident.to_string()));
        }
        UseTree::Rename(renamed) => {
            into.insert(renamed.rename.to_string(), join(&renamed.ident.to_string()));
        }
        UseTree::Group(group) => group.items.iter().for_each(|item| imported(item, path, into)),
        UseTree::Glob(_) => {}
    }
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>, SchemaError> {
    let failed = |source| SchemaError::File { file: folder.to_owned(), source };
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let found = std::fs::read_dir(folder).map_err(failed)?.map(|entry| entry.map(|e| e.path()));
    let mut found = found.collect::<Result<Vec<_>, _>>().map_err(failed)?;
    found.sort();
    Ok(found)
}
