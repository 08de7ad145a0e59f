//! The workspace in one column of numbers: what a review of it asked, so that two versions can be set side by side.
//!
//! Limits: see [`crate::habits`] and [`crate::face`] for what is counted.

use crate::{
    habits::{DIAGNOSE, Texts},
    house::House,
};
use std::collections::BTreeSet;

/// One number, or a few of a kind, with what it counts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// what is counted
    pub what: String,
    /// how many
    pub value: String,
}

impl House {
    /// The numbers of the review, in its order.
    pub fn review(&self) -> Vec<Row> {
        let mut rows = self.modules_row();
        rows.extend(self.graph());
        rows.extend(self.written());
        rows
    }

    fn modules_row(&self) -> Vec<Row> {
        let names = [DIAGNOSE, "truegap-audit", "truegap-core", "truegap-fem"];
        let faces = names.map(|name| self.index(name).map(|package| self.face(package)));
        let modules = faces.map(|face| face.map_or("-".to_owned(), |face| face.modules.to_string()));
        let items = faces[0].unwrap_or_default();
        vec![
            row("root `pub mod`s: diagnose, audit, core, fem", modules.join(", ")),
            row("`pub` items of diagnose", items.items),
            row("of these, named by no other crate", items.named_by_no_other),
            row("of these, not named by its own tests and examples either", items.named_by_nobody),
        ]
    }

    fn graph(&self) -> Vec<Row> {
        let circles: Vec<BTreeSet<String>> = (0..self.packages.len()).flat_map(|package| self.circles(package)).collect();
        let upward = self.index(DIAGNOSE).filter(|_| self.order.rooms.contains_key(DIAGNOSE));
        vec![
            row("circles of files, all crates", circles.len()),
            row("files in the largest circle", circles.iter().map(BTreeSet::len).max().unwrap_or(0)),
            row(
                "arrows upwards between stages of diagnose",
                upward.map_or("-".into(), |package| self.upward(package).len().to_string()),
            ),
        ]
    }

    fn written(&self) -> Vec<Row> {
        let Texts { all, diagnose, front } = &self.texts;
        let ([line, long], [file, large]) = (all.functions(), all.files());
        let [tuned, elsewhere] = diagnose.constants;
        let [lines, numbers] = front.map_or(["-".into(), "-".into()], |counts| counts.map(|n| n.to_string()));
        vec![
            row("doc lines per line of code, all crates (diagnose)", format!("{} ({})", all.documented(), diagnose.documented())),
            row("comments per line of code", all.commented()),
            row("examples in docs that compile", all.examples),
            row("places that say their source, all crates (diagnose)", format!("{} ({})", all.sources, diagnose.sources)),
            row("lines of the median function; functions over 25 lines", format!("{line}; {long}")),
            row("lines of the median file; files over 400 lines", format!("{file}; {large}")),
            row("constants of diagnose in tuning files; elsewhere", format!("{tuned}; {elsewhere}")),
            row("lines of README; numbers typed into its prose", format!("{lines}; {numbers}")),
        ]
    }

    fn index(&self, name: &str) -> Option<usize> {
        self.packages.iter().position(|package| package.name == name)
    }
}

fn row(what: &str, value: impl ToString) -> Row {
    Row { what: what.to_owned(), value: value.to_string() }
}
