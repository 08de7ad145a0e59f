//! The graph of files: which file names what of which other file, and the circles among them.
//!
//! Limits: inside of one package; a `mod` line is no arrow, nor is a `pub use` in `lib.rs`.

use crate::{
    import::{Brings, Import, Seen},
    modules::{Module, Modules, Part},
    resolve::{Found, look_up, resolve},
};
use std::collections::{BTreeMap, BTreeSet};

/// An arrow from a file to the file that it names something of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Arrow {
    /// file that names
    pub from: String,
    /// file that is named
    pub to: String,
    /// what is named, with the first line of each
    pub names: BTreeMap<String, usize>,
}

/// The names that `module` takes from elsewhere: what each leads to, and its line.
pub(crate) fn taken(modules: &Modules, module: usize) -> Vec<(Found, usize)> {
    let here = &modules.all[module];
    let mut taken = Vec::new();
    for import in &here.source.imports {
        if is_facade(modules, module, import) {
            continue;
        }
        let found = resolve(modules, module, &import.path);
        match (&import.brings, found) {
            (Brings::Everything, Some(Found::Module(other))) => {
                taken.extend(by_glob(modules, module, other).map(|f| (f, import.line)))
            }
            // `use crate::mesh;` is told by the `mesh::..` that follow it
            (Brings::Name(name), Some(Found::Module(_))) if here.source.mentions.iter().any(|m| m.path[0] == *name) => {}
            (_, Some(found)) => taken.push((found, import.line)),
            (_, None) => {}
        }
    }
    let mentions = here.source.mentions.iter();
    taken.extend(mentions.filter_map(|m| Some((resolve(modules, module, &m.path)?, m.line))));
    taken
}

/// A `pub use` in `lib.rs`, be it in a module in place, shows what is inside and needs nothing of it.
fn is_facade(modules: &Modules, module: usize, import: &Import) -> bool {
    let here = &modules.all[module];
    here.part == Part::Library && import.seen == Seen::Everywhere && here.file == modules.all[modules.root(module)].file
}

fn by_glob(modules: &Modules, module: usize, other: usize) -> impl Iterator<Item = Found> {
    let source = &modules.all[module].source;
    let own = |name: &&String| !source.items.contains_key(*name);
    source.names.iter().filter(own).filter_map(move |name| look_up(modules, other, name))
}

/// The arrows inside of the package with index `package`.
pub(crate) fn arrows(modules: &Modules, package: usize) -> Vec<Arrow> {
    let mut ties: BTreeMap<(&str, &str), BTreeMap<String, usize>> = BTreeMap::new();
    let inside = |module: &Module| module.package == package && module.part != Part::Outside;
    for (k, here) in modules.all.iter().enumerate().filter(|(_, m)| inside(m)) {
        for (found, line) in taken(modules, k) {
            let there = &modules.all[found.module()];
            if inside(there) && there.file != here.file {
                let names = ties.entry((&here.file, &there.file)).or_default();
                names.entry(name(modules, &found)).and_modify(|first| *first = line.min(*first)).or_insert(line);
            }
        }
    }
    ties.into_iter().map(|((from, to), names)| Arrow { from: from.to_owned(), to: to.to_owned(), names }).collect()
}

fn name(modules: &Modules, found: &Found) -> String {
    match found {
        Found::Item(_, name) => name.clone(),
        Found::Module(module) => modules.all[*module].path.last().map_or_else(|| "crate".to_owned(), |name| format!("{name}::")),
    }
}

/// Sets of at least two nodes each of which leads to every other one, in the order of their first node.
pub(crate) fn circles<T: Ord + Clone>(arrows: &BTreeSet<(T, T)>) -> Vec<BTreeSet<T>> {
    let mut next: BTreeMap<&T, Vec<&T>> = BTreeMap::new();
    let mut back: BTreeMap<&T, Vec<&T>> = BTreeMap::new();
    for (from, to) in arrows {
        next.entry(from).or_default().push(to);
        back.entry(to).or_default().push(from);
    }
    let mut done = BTreeSet::new();
    let mut circles = Vec::new();
    for &node in next.keys() {
        if done.contains(node) {
            continue;
        }
        let circle: BTreeSet<&T> = reached(node, &next).intersection(&reached(node, &back)).copied().collect();
        done.extend(circle.iter().copied());
        if circle.len() > 1 {
            circles.push(circle.into_iter().cloned().collect());
        }
    }
    circles
}

/// All nodes that `start` leads to, itself included.
fn reached<'a, T: Ord>(start: &'a T, next: &BTreeMap<&'a T, Vec<&'a T>>) -> BTreeSet<&'a T> {
    let mut reached = BTreeSet::from([start]);
    let mut open = vec![start];
    while let Some(node) = open.pop() {
        for &to in next.get(node).into_iter().flatten() {
            if reached.insert(to) {
                open.push(to);
            }
        }
    }
    reached
}
