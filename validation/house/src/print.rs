//! The graph as text, as a table in Markdown, and for Graphviz.
//!
//! Limits: colours and layout are left to whoever draws.

use crate::{face::Face, house::House};
use std::{
    collections::BTreeSet,
    fmt::{Display, Formatter, Result},
};

/// Rooms of every package, the rooms each one uses, and the circles.
#[derive(Debug)]
pub struct Plan<'a>(pub &'a House);

/// One row a package, in Markdown.
#[derive(Debug)]
pub struct Numbers<'a>(pub &'a House);

/// Packages as clusters of rooms, in the language of Graphviz; arrows upwards and inside of circles are red.
#[derive(Debug)]
pub struct Dot<'a>(pub &'a House);

impl Display for Plan<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        for package in 0..self.0.packages.len() {
            plan(self.0, package, f)?;
        }
        Ok(())
    }
}

fn plan(house: &House, package: usize, f: &mut Formatter<'_>) -> Result {
    let names: BTreeSet<&str> = house.packages.iter().map(|p| p.name.as_str()).collect();
    let about = &house.packages[package];
    let on: Vec<&str> = about.depends_on.iter().map(String::as_str).filter(|on| names.contains(on)).collect();
    writeln!(f, "{} -> {}", about.name, or_nothing(&on))?;
    let arrows = house.room_arrows(package);
    for (room, files) in rows(house, package) {
        let uses: Vec<String> =
            arrows.iter().filter(|((from, _), _)| *from == room).map(|((_, to), n)| format!("{to} {n}")).collect();
        let uses = or_nothing(&uses.iter().map(String::as_str).collect::<Vec<_>>());
        writeln!(f, "  {room} ({}): {uses}", counted(files, "file"))?;
    }
    for circle in house.room_circles(package) {
        writeln!(f, "  circle of rooms: {}", circle.into_iter().collect::<Vec<_>>().join(", "))?;
    }
    for circle in house.circles(package) {
        writeln!(f, "  circle of files: {}", circle.into_iter().collect::<Vec<_>>().join(", "))?;
    }
    for (arrow, from, to) in house.upward(package) {
        writeln!(f, "  upwards, {from} to {to}: {} -> {}", arrow.from, arrow.to)?;
    }
    writeln!(f)
}

/// Rooms with their number of files, from the top down where there is an order.
fn rows(house: &House, package: usize) -> Vec<(&str, usize)> {
    let by_room = house.files_by_room(package);
    let mut rows: Vec<(&str, usize)> = by_room.into_iter().map(|(room, files)| (room, files.len())).collect();
    rows.sort_by_key(|(room, _)| house.order.storey(&house.packages[package].name, room));
    rows
}

fn or_nothing(words: &[&str]) -> String {
    if words.is_empty() { "-".to_owned() } else { words.join(", ") }
}

fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

impl Display for Numbers<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let heads = [
            "package",
            "rooms",
            "files",
            "arrows of files",
            "arrows of rooms",
            "circles of rooms",
            "circles of files",
            "files in circles",
            "arrows upwards",
            "root `pub mod`s",
            "public items",
            "named by no other package",
            "nor by own tests",
        ];
        writeln!(f, "| {} |\n|---{}|", heads.join(" | "), "|--:".repeat(heads.len() - 1))?;
        for package in 0..self.0.packages.len() {
            let cells = cells(self.0, package);
            let cells: Vec<String> = cells.iter().map(|n| n.map_or("-".to_owned(), |n| n.to_string())).collect();
            writeln!(f, "| `{}` | {} |", self.0.packages[package].name, cells.join(" | "))?;
        }
        Ok(())
    }
}

fn cells(house: &House, package: usize) -> [Option<usize>; 12] {
    let by_room = house.files_by_room(package);
    let circles = house.circles(package);
    let Face { modules, items, named_by_no_other, named_by_nobody } = house.face(package);
    let ordered = house.order.rooms.contains_key(&house.packages[package].name);
    [
        Some(by_room.len()),
        Some(by_room.values().map(Vec::len).sum()),
        Some(house.arrows[package].len()),
        Some(house.room_arrows(package).len()),
        Some(house.room_circles(package).len()),
        Some(circles.len()),
        Some(circles.iter().map(BTreeSet::len).sum()),
        ordered.then(|| house.upward(package).len()),
        Some(modules),
        Some(items),
        Some(named_by_no_other),
        Some(named_by_nobody),
    ]
}

/// The numbers of the review as CSV.
#[derive(Debug)]
pub struct Reviewed<'a>(pub &'a House);

impl Display for Reviewed<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "what,value")?;
        self.0.review().iter().try_for_each(|row| writeln!(f, "\"{}\",\"{}\"", row.what, row.value))
    }
}

impl Display for Dot<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let house = self.0;
        writeln!(f, "digraph house {{\n  compound = true; node [shape = box];")?;
        for (k, package) in house.packages.iter().enumerate() {
            let name = &package.name;
            writeln!(f, "  subgraph \"cluster_{name}\" {{ label = \"{name}\"; \"{name}\" [shape = point];")?;
            for (room, files) in rows(house, k) {
                writeln!(f, "    \"{name}/{room}\" [label = \"{room}\\n{}\"];", counted(files, "file"))?;
            }
            let up: BTreeSet<(&str, &str)> = house.upward(k).into_iter().map(|(_, from, to)| (from, to)).collect();
            let circles = house.room_circles(k);
            for (from, to) in house.room_arrows(k).into_keys() {
                let bad = up.contains(&(from, to)) || circles.iter().any(|c| c.contains(from) && c.contains(to));
                let colour = if bad { " [color = red]" } else { "" };
                writeln!(f, "    \"{name}/{from}\" -> \"{name}/{to}\"{colour};")?;
            }
            writeln!(f, "  }}")?;
        }
        for package in &house.packages {
            for on in house.packages.iter().filter(|p| package.depends_on.contains(&p.name)) {
                writeln!(f, "  \"{0}\" -> \"{1}\" [ltail = \"cluster_{0}\", lhead = \"cluster_{1}\"];", package.name, on.name)?;
            }
        }
        writeln!(f, "}}")
    }
}

/// Public items that no other package names, one a line: `file: name`.
#[derive(Debug)]
pub struct Unnamed<'a>(pub &'a House);

impl Display for Unnamed<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let items = (0..self.0.packages.len()).flat_map(|package| self.0.unnamed(package));
        for (file, name) in items {
            writeln!(f, "{file}: {name}")?;
        }
        Ok(())
    }
}
