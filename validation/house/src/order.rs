//! The declared order: who may depend on whom, which room stands above which, which circles are allowed.
//!
//! Limits: it is read from [`ORDER`], and says nothing about a crate that is not in it.

use crate::{
    HouseError,
    workspace::{Files, parse},
};
use std::collections::{BTreeMap, BTreeSet};
use toml::{Table, Value};

/// File of the order, from the root of the workspace.
pub const ORDER: &str = "validation/house/order.toml";

/// What is declared about a package.
#[derive(Clone, Debug, Default)]
pub(crate) struct Declared {
    pub may_depend_on: BTreeSet<String>,
    /// packages that it must not reach through others either
    pub must_not_know: BTreeSet<String>,
    /// from the table of `docs/ARCHITECTURE.md`
    pub because: String,
}

/// A circle of files that is allowed.
#[derive(Clone, Debug)]
pub(crate) struct Allowed {
    pub files: BTreeSet<String>,
    pub reason: String,
}

/// A word that names are not to hold.
#[derive(Clone, Debug)]
pub(crate) struct Private {
    /// in small letters
    pub word: String,
    /// what to say
    pub instead: String,
    /// packages whose names are looked through; all where this is empty
    pub within: BTreeSet<String>,
    /// names that keep the word, since files have them
    pub except: BTreeSet<String>,
}

/// The declared order.
#[derive(Clone, Debug, Default)]
pub(crate) struct Order {
    pub crates: BTreeMap<String, Declared>,
    /// storeys by package, the top one first; each with its rooms
    pub rooms: BTreeMap<String, Vec<BTreeSet<String>>>,
    pub circles: Vec<Allowed>,
    pub words: Vec<Private>,
}

impl Order {
    /// Reads the order among `files`; nothing is declared where there is none.
    ///
    /// # Errors
    /// [`HouseError::Toml`], [`HouseError::Order`].
    pub(crate) fn read(files: &Files) -> Result<Self, HouseError> {
        let table = parse(ORDER, files.get(ORDER).map_or("", String::as_str))?;
        let mut order = Self::default();
        for (name, about) in tables(&table, "crates")? {
            let about = about.as_table().ok_or_else(|| wrong(name, "a table"))?;
            order.crates.insert(name.clone(), declared(about)?);
        }
        for (name, storeys) in tables(&table, "rooms")? {
            let storeys = storeys.as_array().ok_or_else(|| wrong(name, "a list of storeys"))?;
            order.rooms.insert(name.clone(), storeys.iter().map(|s| storey(name, s)).collect::<Result<_, _>>()?);
        }
        let circles = table.get("circle").map_or(Some(&[][..]), |c| c.as_array().map(Vec::as_slice));
        for circle in circles.ok_or_else(|| wrong("circle", "a list of tables, each under `[[circle]]`"))? {
            order.circles.push(allowed(circle)?);
        }
        for (word, about) in tables(&table, "words")? {
            order.words.push(private(word, about)?);
        }
        Ok(order)
    }

    /// Storey of a room, 0 at the top; `None` where the package is in no order or the room is not in it.
    pub(crate) fn storey(&self, package: &str, room: &str) -> Option<usize> {
        self.rooms.get(package)?.iter().position(|storey| storey.contains(room))
    }
}

fn wrong(key: &str, expected: &'static str) -> HouseError {
    HouseError::Order { path: ORDER.to_owned(), key: key.to_owned(), expected }
}

fn tables<'a>(table: &'a Table, key: &str) -> Result<Vec<(&'a String, &'a Value)>, HouseError> {
    match table.get(key) {
        None => Ok(Vec::new()),
        Some(value) => Ok(value.as_table().ok_or_else(|| wrong(key, "a table"))?.iter().collect()),
    }
}

fn words(table: &Table, key: &str) -> Result<BTreeSet<String>, HouseError> {
    let Some(value) = table.get(key) else { return Ok(BTreeSet::new()) };
    let list = value.as_array().ok_or_else(|| wrong(key, "a list of names"))?;
    list.iter().map(|v| v.as_str().map(str::to_owned).ok_or_else(|| wrong(key, "a list of names"))).collect()
}

fn text(table: &Table, key: &str) -> String {
    table.get(key).and_then(Value::as_str).unwrap_or_default().to_owned()
}

fn declared(about: &Table) -> Result<Declared, HouseError> {
    Ok(Declared {
        may_depend_on: words(about, "may-depend-on")?,
        must_not_know: words(about, "must-not-know")?,
        because: text(about, "because"),
    })
}

fn storey(name: &str, value: &Value) -> Result<BTreeSet<String>, HouseError> {
    match value {
        Value::String(room) => Ok(BTreeSet::from([room.clone()])),
        Value::Array(rooms) => {
            let room = |v: &Value| v.as_str().map(str::to_owned).ok_or_else(|| wrong(name, "a list of rooms"));
            rooms.iter().map(room).collect()
        }
        _ => Err(wrong(name, "a list of rooms, each a name or a list of names")),
    }
}

fn allowed(circle: &Value) -> Result<Allowed, HouseError> {
    let circle = circle.as_table().ok_or_else(|| wrong("circle", "a table under `[[circle]]`"))?;
    let (files, reason) = (words(circle, "files")?, text(circle, "reason"));
    match (files.len() > 1, reason.is_empty()) {
        (true, false) => Ok(Allowed { files, reason }),
        (false, _) => Err(wrong("circle.files", "a list of at least two files, from the root of the workspace")),
        (_, true) => Err(wrong("circle.reason", "why the files need one another")),
    }
}

fn private(word: &str, about: &Value) -> Result<Private, HouseError> {
    let about = about.as_table().ok_or_else(|| wrong(word, "a table, `{ instead = \"..\" }`"))?;
    match text(about, "instead") {
        instead if instead.is_empty() => Err(wrong(word, "a table that says what stands `instead`")),
        instead => Ok(Private { word: word.to_owned(), instead, within: words(about, "in")?, except: words(about, "except")? }),
    }
}
