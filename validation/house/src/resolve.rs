//! From a path in the code to the module that defines what it names, through re-exports and across crates.
//!
//! Limits: a variant or an associated function counts as its type; an item that a macro makes counts as its module.

use crate::{import::Brings, modules::Modules};

/// What a path leads to.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Found {
    Module(usize),
    /// an item and the module that defines it
    Item(usize, String),
}

impl Found {
    /// The module, or the one that defines the item.
    pub(crate) fn module(&self) -> usize {
        match self {
            Found::Module(module) | Found::Item(module, _) => *module,
        }
    }
}

/// What `path` in the module `from` leads to; `None` where it leaves the workspace.
pub(crate) fn resolve(modules: &Modules, from: usize, path: &[String]) -> Option<Found> {
    Walk { modules, seen: Vec::new() }.path(from, path, false)
}

/// What `name` is in `module`, seen from outside of it.
pub(crate) fn look_up(modules: &Modules, module: usize, name: &str) -> Option<Found> {
    Walk { modules, seen: Vec::new() }.look_up(module, name, false)
}

struct Walk<'a> {
    modules: &'a Modules,
    /// names that are being looked for, since re-exports by glob may name each other
    seen: Vec<(usize, String, bool)>,
}

impl Walk<'_> {
    /// `more`: names follow, so a module comes before a function of the same name.
    fn path(&mut self, from: usize, path: &[String], more: bool) -> Option<Found> {
        let (first, rest) = path.split_first()?;
        let mut found = self.first(from, first, more || !rest.is_empty())?;
        for (k, name) in rest.iter().enumerate() {
            let Found::Module(module) = found else { return Some(found) };
            found = match name.as_str() {
                "super" => Found::Module(self.modules.all[module].parent?),
                "self" => Found::Module(module),
                // what a macro makes is nowhere in the text
                _ => self.look_up(module, name, more || k + 1 < rest.len()).unwrap_or_else(|| Found::Item(module, name.clone())),
            };
        }
        Some(found)
    }

    fn first(&mut self, from: usize, name: &str, more: bool) -> Option<Found> {
        match name {
            "crate" => Some(Found::Module(self.modules.root(from))),
            "self" => Some(Found::Module(from)),
            "super" => self.modules.all[from].parent.map(Found::Module),
            _ => self.look_up(from, name, more).or_else(|| self.modules.libraries.get(name).map(|root| Found::Module(*root))),
        }
    }

    /// `more` as in [`Walk::path`].
    fn look_up(&mut self, module: usize, name: &str, more: bool) -> Option<Found> {
        let asked = (module, name.to_owned(), more);
        if self.seen.contains(&asked) {
            return None;
        }
        self.seen.push(asked);
        let child = self.modules.all[module].children.get(name).map(|child| Found::Module(*child));
        let item = self.modules.all[module].source.items.contains_key(name).then(|| Found::Item(module, name.to_owned()));
        let found = if more { child.or(item) } else { item.or_else(|| self.imported(module, name, more)).or(child) };
        let found = found.or_else(|| self.imported(module, name, more)).or_else(|| self.by_glob(module, name, more));
        self.seen.pop();
        found
    }

    fn imported(&mut self, module: usize, name: &str, more: bool) -> Option<Found> {
        let imports = &self.modules.all[module].source.imports;
        imports.iter().filter(|i| i.brings == Brings::Name(name.to_owned())).find_map(|i| self.path(module, &i.path, more))
    }

    fn by_glob(&mut self, module: usize, name: &str, more: bool) -> Option<Found> {
        let imports = &self.modules.all[module].source.imports;
        let globs = imports.iter().filter(|i| i.brings == Brings::Everything);
        globs.into_iter().find_map(|i| match self.path(module, &i.path, true)? {
            Found::Module(other) if other != module => self.look_up(other, name, more),
            _ => None,
        })
    }
}
