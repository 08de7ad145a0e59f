//! The public face of a package: what can be named from outside of it, and what is.
//!
//! Limits: items (functions, types, traits, constants), not methods or fields; an item that other crates only get as a result is not named.

use crate::{
    graph::taken,
    house::House,
    import::{Brings, Seen},
    modules::{Modules, Part},
    resolve::{Found, resolve},
};
use std::collections::BTreeSet;

type Item = (usize, String);

/// Numbers of public things of one library.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Face {
    /// `pub mod` lines in the root
    pub modules: usize,
    /// items that can be named from outside
    pub items: usize,
    /// of these, those that no other package names, its tests included
    pub named_by_no_other: usize,
    /// of these, those that the package's own tests, examples and benches do not name either
    pub named_by_nobody: usize,
}

impl House {
    /// The public face of the package with index `package`.
    pub(crate) fn face(&self, package: usize) -> Face {
        let Some(&root) = self.modules.libraries.get(&self.packages[package].identifier()) else { return Face::default() };
        let items = public(&self.modules, root);
        let named = |who: &dyn Fn(usize, Part) -> bool| self.named(who);
        let others = named(&|k, _| k != package);
        let outside = named(&|k, part| k != package || part != Part::Library);
        let modules = &self.modules.all[root].source.children;
        Face {
            modules: modules.values().filter(|child| child.seen == Seen::Everywhere).count(),
            items: items.len(),
            named_by_no_other: items.difference(&others).count(),
            named_by_nobody: items.difference(&outside).count(),
        }
    }

    /// Public items of the package named `package` that no other package names: the file that defines each, and its name.
    pub(crate) fn unnamed(&self, package: usize) -> Vec<(String, String)> {
        let Some(&root) = self.modules.libraries.get(&self.packages[package].identifier()) else { return Vec::new() };
        let others = self.named(&|k, _| k != package);
        public(&self.modules, root)
            .difference(&others)
            .map(|(at, name)| (self.modules.all[*at].file.clone(), name.clone()))
            .collect()
    }

    /// Items that the modules chosen by `who` name, wherever they are defined.
    fn named(&self, who: &dyn Fn(usize, Part) -> bool) -> BTreeSet<Item> {
        let all = self.modules.all.iter().enumerate().filter(|(_, m)| who(m.package, m.part));
        let taken = all.flat_map(|(k, _)| taken(&self.modules, k));
        taken.filter_map(|(found, _)| item(found)).collect()
    }
}

fn item(found: Found) -> Option<Item> {
    match found {
        Found::Item(module, name) => Some((module, name)),
        Found::Module(_) => None,
    }
}

/// Items of the package of `root` that a path of public names leads to.
fn public(modules: &Modules, root: usize) -> BTreeSet<Item> {
    let package = modules.all[root].package;
    let (mut items, mut visited, mut open) = (BTreeSet::new(), BTreeSet::new(), vec![root]);
    while let Some(k) = open.pop() {
        let module = &modules.all[k];
        if module.package != package || !visited.insert(k) {
            continue;
        }
        let source = &module.source;
        items.extend(source.items.iter().filter(|(_, seen)| **seen == Seen::Everywhere).map(|(name, _)| (k, name.clone())));
        let shown = |name: &&String| source.children[*name].seen == Seen::Everywhere;
        open.extend(module.children.keys().filter(shown).map(|name| module.children[name]));
        for import in source.imports.iter().filter(|i| i.seen == Seen::Everywhere) {
            match resolve(modules, k, &import.path) {
                Some(Found::Item(at, name)) if modules.all[at].package == package && import.brings != Brings::Everything => {
                    items.insert((at, name));
                }
                Some(Found::Module(at)) => open.push(at),
                _ => {}
            }
        }
    }
    items
}
