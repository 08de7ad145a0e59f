//! The workspace, read: packages, modules, arrows, and the order they should keep.
//!
//! Limits: see the modules that read the parts.

use crate::{
    HouseError,
    graph::{Arrow, arrows, circles},
    habits::{FRONT, Texts},
    modules::{Modules, Part},
    order::{ORDER, Order},
    vocabulary::{Said, said},
    workspace::{Files, Package, packages, read_files},
};
use std::{
    collections::{BTreeMap, BTreeSet},
    path::Path,
};

/// The workspace as a graph.
#[derive(Debug)]
pub struct House {
    pub(crate) packages: Vec<Package>,
    pub(crate) modules: Modules,
    pub(crate) order: Order,
    /// by package
    pub(crate) arrows: Vec<Vec<Arrow>>,
    /// room of every file inside of a package
    pub(crate) rooms: BTreeMap<String, String>,
    pub(crate) texts: Texts,
    /// names that hold a word which is not to be used
    pub(crate) said: Vec<Said>,
}

impl House {
    /// Reads the workspace whose `Cargo.toml` is in `root`.
    ///
    /// # Errors
    /// [`HouseError`] where a file cannot be read or is no TOML, where the order is wrong, where a `mod` line has no file.
    pub fn open(root: &Path) -> Result<Self, HouseError> {
        let mut files = read_files(root, &[ORDER])?;
        if let Ok(page) = std::fs::read_to_string(root.join(FRONT)) {
            files.insert(FRONT.to_owned(), page);
        }
        Self::of(&files)
    }

    /// The same from sources that need not exist as files.
    ///
    /// # Errors
    /// As [`House::open`].
    pub fn of(files: &Files) -> Result<Self, HouseError> {
        let packages = packages(files)?;
        let modules = Modules::read(files, &packages)?;
        let order = Order::read(files)?;
        let arrows = (0..packages.len()).map(|package| arrows(&modules, package)).collect();
        let rooms = rooms(&modules);
        let (texts, said) = (Texts::read(files), said(files, &packages, &order));
        Ok(Self { packages, modules, order, arrows, rooms, texts, said })
    }

    /// The arrows from file to file inside of a package.
    pub fn arrows(&self, package: &str) -> &[Arrow] {
        self.packages.iter().position(|p| p.name == package).map_or(&[], |k| &self.arrows[k])
    }

    /// Files of the package with index `package`, by room.
    pub(crate) fn files_by_room(&self, package: usize) -> BTreeMap<&str, Vec<&str>> {
        let mut by_room: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        let inside = self.modules.all.iter().filter(|m| m.package == package && m.part != Part::Outside);
        for file in inside.map(|m| m.file.as_str()).collect::<BTreeSet<_>>() {
            by_room.entry(self.room(file)).or_default().push(file);
        }
        by_room
    }

    /// Room of a file.
    pub(crate) fn room(&self, file: &str) -> &str {
        self.rooms.get(file).map_or("", String::as_str)
    }

    /// Pairs of rooms between which there is an arrow, and how many files' arrows that are.
    pub(crate) fn room_arrows(&self, package: usize) -> BTreeMap<(&str, &str), usize> {
        let mut pairs = BTreeMap::new();
        for arrow in &self.arrows[package] {
            let pair = (self.room(&arrow.from), self.room(&arrow.to));
            if pair.0 != pair.1 {
                *pairs.entry(pair).or_default() += 1;
            }
        }
        pairs
    }

    /// Circles of files of a package.
    pub(crate) fn circles(&self, package: usize) -> Vec<BTreeSet<String>> {
        circles(&self.arrows[package].iter().map(|a| (a.from.clone(), a.to.clone())).collect())
    }

    /// Circles of rooms of a package.
    pub(crate) fn room_circles(&self, package: usize) -> Vec<BTreeSet<&str>> {
        circles(&self.room_arrows(package).into_keys().collect())
    }

    /// Arrows to a room that is not below, with the rooms.
    pub(crate) fn upward(&self, package: usize) -> Vec<(&Arrow, &str, &str)> {
        let name = &self.packages[package].name;
        if !self.order.rooms.contains_key(name) {
            return Vec::new();
        }
        // the root of a crate stands above all rooms
        let storey = |room| if is_root(room) { Some(0) } else { self.order.storey(name, room).map(|s| s + 1) };
        let with_rooms = self.arrows[package].iter().map(|a| (a, self.room(&a.from), self.room(&a.to)));
        let up = |from, to| matches!((storey(from), storey(to)), (Some(from), Some(to)) if from >= to);
        with_rooms.filter(|(_, from, to)| from != to && up(from, to)).collect()
    }
}

/// Whether a room is the root of a crate, `lib` or `main`.
pub(crate) fn is_root(room: &str) -> bool {
    matches!(room, "lib.rs" | "main.rs")
}

fn rooms(modules: &Modules) -> BTreeMap<String, String> {
    let mut rooms = BTreeMap::new();
    for module in modules.all.iter().filter(|m| m.part != Part::Outside) {
        let root = if module.part == Part::Library { "lib.rs" } else { "main.rs" };
        let room = module.path.first().map_or(root, String::as_str);
        // the first module of a file is the file's own; those inside of it come later
        rooms.entry(module.file.clone()).or_insert_with(|| room.to_owned());
    }
    rooms
}
