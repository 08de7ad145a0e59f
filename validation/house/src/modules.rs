//! The modules of every package as one list: who is whose child, and in which file.
//!
//! Limits: `#[path = ..]` is not followed; files of tests, examples and benches are modules of their own without children.

use crate::{
    HouseError,
    source::Source,
    workspace::{Files, Package},
};
use std::collections::BTreeMap;

/// What a file belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Part {
    /// `src/lib.rs` and its modules
    Library,
    /// `src/main.rs` and its modules
    Program,
    /// a test, an example, a bench
    Outside,
}

/// A module.
#[derive(Clone, Debug)]
pub(crate) struct Module {
    /// index of its package
    pub package: usize,
    pub part: Part,
    /// path of its file
    pub file: String,
    /// names from the root of its crate
    pub path: Vec<String>,
    pub parent: Option<usize>,
    pub children: BTreeMap<String, usize>,
    pub source: Source,
}

/// All modules, and the root of every library by its name in code.
#[derive(Debug, Default)]
pub(crate) struct Modules {
    pub all: Vec<Module>,
    pub libraries: BTreeMap<String, usize>,
}

impl Modules {
    /// Reads the modules of `packages`.
    ///
    /// # Errors
    /// [`HouseError::NoModule`] where a `mod` line has no file.
    pub(crate) fn read(files: &Files, packages: &[Package]) -> Result<Self, HouseError> {
        let mut modules = Self::default();
        for (k, package) in packages.iter().enumerate() {
            modules.crates(files, k, package)?;
        }
        Ok(modules)
    }

    /// The root module of the crate of `module`.
    pub(crate) fn root(&self, mut module: usize) -> usize {
        while let Some(parent) = self.all[module].parent {
            module = parent;
        }
        module
    }

    fn crates(&mut self, files: &Files, package: usize, about: &Package) -> Result<(), HouseError> {
        for (file, part) in [("src/lib.rs", Part::Library), ("src/main.rs", Part::Program)] {
            let path = format!("{}/{file}", about.folder);
            if let Some(text) = files.get(&path) {
                let root =
                    self.module(files, Place { package, part, file: path, path: Vec::new(), parent: None }, Source::read(text))?;
                if part == Part::Library {
                    self.libraries.insert(about.identifier(), root);
                }
            }
        }
        let inside = |path: &str| ["tests/", "examples/", "benches/"].iter().any(|part| path.starts_with(part));
        for (path, text) in files {
            if path.strip_prefix(&about.folder).and_then(|rest| rest.strip_prefix('/')).is_some_and(inside) {
                let mut source = Source::read(text);
                source.children.clear();
                self.module(
                    files,
                    Place { package, part: Part::Outside, file: path.clone(), path: Vec::new(), parent: None },
                    source,
                )?;
            }
        }
        Ok(())
    }

    fn module(&mut self, files: &Files, place: Place, source: Source) -> Result<usize, HouseError> {
        let here = self.all.len();
        let declared = source.children.clone();
        let Place { package, part, file, path, parent } = place;
        self.all.push(Module {
            package,
            part,
            file: file.clone(),
            path: path.clone(),
            parent,
            children: BTreeMap::new(),
            source,
        });
        for (name, child) in declared {
            let mut path = path.clone();
            path.push(name.clone());
            let place = |file| Place { package, part, file, path: path.clone(), parent: Some(here) };
            let index = match child.body {
                Some(body) => self.module(files, place(file.clone()), body)?,
                None => {
                    let (file, text) = file_of(files, &root_folder(&self.all[self.root(here)].file), &path, &file)?;
                    self.module(files, place(file), Source::read(text))?
                }
            };
            self.all[here].children.insert(name, index);
        }
        Ok(here)
    }
}

/// Where a module stands.
struct Place {
    package: usize,
    part: Part,
    file: String,
    path: Vec<String>,
    parent: Option<usize>,
}

fn root_folder(file: &str) -> String {
    file.rsplit_once('/').map_or(String::new(), |(folder, _)| folder.to_owned())
}

/// File and text of the module `path` of a crate whose root is in `folder`; `named_in` is where its `mod` line stands.
fn file_of<'a>(files: &'a Files, folder: &str, path: &[String], named_in: &str) -> Result<(String, &'a str), HouseError> {
    let stem = format!("{folder}/{}", path.join("/"));
    let places = [format!("{stem}.rs"), format!("{stem}/mod.rs")];
    let found = places.iter().find_map(|file| Some((file.clone(), files.get(file)?.as_str())));
    found.ok_or_else(|| HouseError::NoModule {
        file: named_in.to_owned(),
        name: path.last().cloned().unwrap_or_default(),
        looked_for: places.join(" and "),
    })
}
