//! What is wrong with the house, each with the way to mend it.
//!
//! Limits: the texts are for the person whose test has just failed.

use crate::{graph::Arrow, order::ORDER};
use std::{
    collections::BTreeSet,
    fmt::{Display, Formatter, Result},
};

/// Something that breaks the declared order.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Finding {
    /// Files that need one another, and are not allowed to.
    Circle {
        /// files
        files: BTreeSet<String>,
        /// arrows among them
        arrows: Vec<Arrow>,
    },
    /// An allowed circle that is no longer there.
    NoCircle {
        /// files
        files: BTreeSet<String>,
        /// reason that was given
        reason: String,
    },
    /// A file that names something of a room that is not below its own.
    Upward {
        /// the arrow
        arrow: Arrow,
        /// room of the file that names
        from: String,
        /// room of the file that is named
        to: String,
    },
    /// A room that is missing in the declared order of its package.
    UnknownRoom {
        /// package
        package: String,
        /// room
        room: String,
        /// one of its files
        file: String,
    },
    /// A package that is missing in the declared order.
    UnknownPackage {
        /// package
        package: String,
    },
    /// A dependency that the order does not allow.
    Dependency {
        /// package
        package: String,
        /// folder of its manifest
        folder: String,
        /// what it depends on
        on: String,
    },
    /// A package that must not be known, and is reached.
    MustNotKnow {
        /// from the package to the one that it must not know
        way: Vec<String>,
        /// why not
        because: String,
    },
    /// A name with a word that is not to be used.
    PrivateWord {
        /// file and line
        place: String,
        /// the name
        name: String,
        /// the word in it
        word: String,
        /// what to say
        instead: String,
    },
}

impl Display for Finding {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Circle { files, arrows } => circle(f, files, arrows),
            Self::NoCircle { files, reason } => {
                writeln!(f, "allowed circle that is not there: {}", listed(files))?;
                write!(f, "  mend: take it out of {ORDER} (reason given: {reason})")
            }
            Self::Upward { arrow, from, to } => {
                writeln!(f, "arrow upwards: room `{from}` uses room `{to}`, which is not below it\n{}", Line(arrow))?;
                write!(
                    f,
                    "  mend: move what is named into `{from}` or below, or hand it over as an argument; the order of rooms is in {ORDER}"
                )
            }
            Self::UnknownRoom { package, room, file } => {
                writeln!(f, "unknown room: `{room}` of {package} ({file}) is not in the order of its rooms")?;
                write!(f, "  mend: move its files into a room that is there, or give it a storey in {ORDER}, [rooms], {package}")
            }
            Self::UnknownPackage { package } => {
                write!(
                    f,
                    "unknown package: {package}\n  mend: say in {ORDER}, [crates.{package}], what it may depend on, and in docs/ARCHITECTURE.md what it knows"
                )
            }
            Self::Dependency { package, folder, on } => {
                writeln!(f, "dependency that is not allowed: {package} on {on}, in {folder}/Cargo.toml")?;
                write!(f, "  mend: take it out, or change `may-depend-on` in {ORDER} together with docs/ARCHITECTURE.md")
            }
            Self::MustNotKnow { way, because } => {
                write!(
                    f,
                    "package that must not be known: {}\n  because: {because}\n  mend: cut one of these dependencies",
                    way.join(" -> ")
                )
            }
            Self::PrivateWord { place, name, word, instead } => {
                writeln!(f, "private word: `{name}` in {place} says \"{word}\"")?;
                write!(f, "  mend: say {instead}; the words are in {ORDER}, [words], and docs/glossary.md")
            }
        }
    }
}

fn circle(f: &mut Formatter<'_>, files: &BTreeSet<String>, arrows: &[Arrow]) -> Result {
    writeln!(f, "circle of {} files: {}", files.len(), listed(files))?;
    for arrow in arrows {
        writeln!(f, "{}", Line(arrow))?;
    }
    writeln!(f, "  mend: move what two of them need into a file below both, or hand it over as an argument.")?;
    write!(
        f,
        "  Where a trait and its type need one another, add to {ORDER}:\n    [[circle]]\n    files = {:?}\n    reason = \"..\"",
        files.iter().collect::<Vec<_>>()
    )
}

fn listed(files: &BTreeSet<String>) -> String {
    files.iter().map(String::as_str).collect::<Vec<_>>().join(", ")
}

/// An arrow in one line.
struct Line<'a>(&'a Arrow);

impl Display for Line<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let names: Vec<String> = self.0.names.iter().map(|(name, line)| format!("{name} (line {line})")).collect();
        write!(f, "  {} -> {}: {}", self.0.from, self.0.to, names.join(", "))
    }
}
