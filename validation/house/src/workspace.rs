//! The packages of a workspace and their sources, as text.
//!
//! Limits: members are folders or `folder/*`; a library starts at `src/lib.rs`, a program at `src/main.rs`.

use crate::HouseError;
use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};
use toml::{Table, Value};

/// Files by their path from the root of the workspace, with `/` between folders.
pub type Files = BTreeMap<String, String>;

/// One package.
#[derive(Clone, Debug)]
pub(crate) struct Package {
    pub name: String,
    /// folder from the root of the workspace
    pub folder: String,
    /// packages of every table of dependencies, tests and build scripts included
    pub depends_on: BTreeSet<String>,
}

impl Package {
    /// Name in code.
    pub(crate) fn identifier(&self) -> String {
        self.name.replace('-', "_")
    }
}

/// Manifests and Rust sources of the workspace at `root`, and the files `more`.
///
/// # Errors
/// [`HouseError::Read`] where a file cannot be read, [`HouseError::Toml`] where a manifest is no TOML.
pub(crate) fn read_files(root: &Path, more: &[&str]) -> Result<Files, HouseError> {
    let mut files = Files::new();
    for path in ["Cargo.toml"].iter().chain(more) {
        add(root, path, &mut files)?;
    }
    for member in members(&files)? {
        for folder in folders(root, &member)? {
            add(root, &format!("{folder}/Cargo.toml"), &mut files)?;
            for part in ["src", "tests", "examples", "benches"] {
                add_sources(root, &format!("{folder}/{part}"), &mut files)?;
            }
        }
    }
    Ok(files)
}

/// The packages whose manifests are among `files`, by folder.
///
/// # Errors
/// [`HouseError::Toml`] where a manifest is no TOML.
pub(crate) fn packages(files: &Files) -> Result<Vec<Package>, HouseError> {
    let manifests = files.iter().filter_map(|(path, text)| Some((path.strip_suffix("/Cargo.toml")?, text)));
    manifests.map(|(folder, text)| package(folder, text)).collect()
}

fn package(folder: &str, text: &str) -> Result<Package, HouseError> {
    let table = parse(&format!("{folder}/Cargo.toml"), text)?;
    let name = table.get("package").and_then(|p| p.get("name")).and_then(Value::as_str).unwrap_or(folder).to_owned();
    let kinds = ["dependencies", "dev-dependencies", "build-dependencies"];
    let tables = kinds.iter().filter_map(|kind| table.get(*kind)?.as_table());
    Ok(Package { name, folder: folder.to_owned(), depends_on: tables.flat_map(|t| t.keys().cloned()).collect() })
}

/// TOML in the file `path`.
pub(crate) fn parse(path: &str, text: &str) -> Result<Table, HouseError> {
    text.parse().map_err(|reason| HouseError::Toml { path: path.to_owned(), reason: Box::new(reason) })
}

fn members(files: &Files) -> Result<Vec<String>, HouseError> {
    let root = parse("Cargo.toml", files.get("Cargo.toml").map_or("", String::as_str))?;
    let members = root.get("workspace").and_then(|w| w.get("members")).and_then(Value::as_array);
    Ok(members.into_iter().flatten().filter_map(Value::as_str).map(str::to_owned).collect())
}

/// The packages' folders that a member stands for.
fn folders(root: &Path, member: &str) -> Result<Vec<String>, HouseError> {
    let Some(above) = member.strip_suffix("/*") else { return Ok(vec![member.to_owned()]) };
    let names = names(&root.join(above))?;
    let folders = names.into_iter().map(|name| format!("{above}/{name}"));
    Ok(folders.filter(|folder| root.join(folder).join("Cargo.toml").is_file()).collect())
}

fn names(folder: &Path) -> Result<Vec<String>, HouseError> {
    let failed = |reason| HouseError::Read { path: folder.display().to_string(), reason };
    let entries: Vec<_> = fs::read_dir(folder).and_then(Iterator::collect).map_err(failed)?;
    let mut names: Vec<String> = entries.iter().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    Ok(names)
}

fn add(root: &Path, path: &str, files: &mut Files) -> Result<(), HouseError> {
    let failed = |reason| HouseError::Read { path: path.to_owned(), reason };
    files.insert(path.to_owned(), fs::read_to_string(root.join(path)).map_err(failed)?);
    Ok(())
}

fn add_sources(root: &Path, folder: &str, files: &mut Files) -> Result<(), HouseError> {
    let here = root.join(folder);
    if !here.is_dir() {
        return Ok(());
    }
    for name in names(&here)? {
        let path = format!("{folder}/{name}");
        if here.join(&name).is_dir() {
            add_sources(root, &path, files)?;
        } else if name.ends_with(".rs") {
            add(root, &path, files)?;
        }
    }
    Ok(())
}
