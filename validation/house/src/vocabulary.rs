//! Names with a word that is not to be used, since the glossary has another one for the same thing.
//!
//! Limits: looks at names in code, those of tests included; not at comments, strings and pages.

use crate::{
    finding::Finding,
    order::{Order, Private},
    words::tokens,
    workspace::{Files, Package},
};
use std::collections::BTreeSet;

/// A name that says what it should not.
#[derive(Clone, Debug)]
pub(crate) struct Said {
    file: String,
    line: usize,
    name: String,
    word: String,
    instead: String,
}

impl From<&Said> for Finding {
    fn from(said: &Said) -> Self {
        let Said { file, line, name, word, instead } = said.clone();
        Self::PrivateWord { place: format!("{file}, line {line}"), name, word, instead }
    }
}

/// The first use of each such name in each file, that of the file included.
pub(crate) fn said(files: &Files, packages: &[Package], order: &Order) -> Vec<Said> {
    let sources = files.iter().filter(|(file, _)| file.ends_with(".rs"));
    let in_file = |(file, text): (&String, &String)| {
        let package = packages.iter().find(|package| file.starts_with(&format!("{}/", package.folder)));
        let looked_for = |word: &&Private| word.within.is_empty() || package.is_some_and(|p| word.within.contains(&p.name));
        in_file(file, text, &order.words.iter().filter(looked_for).collect::<Vec<_>>())
    };
    sources.flat_map(in_file).collect()
}

fn in_file(file: &str, text: &str, words: &[&Private]) -> Vec<Said> {
    let stem = file.rsplit('/').next().and_then(|name| name.strip_suffix(".rs")).map(|stem| (stem.to_owned(), 1));
    let names = tokens(text).into_iter().filter_map(|token| Some((token.word()?.to_owned(), token.line)));
    let mut seen = BTreeSet::new();
    let new = stem.into_iter().chain(names).filter(|(name, _)| seen.insert(name.clone()));
    let said = |(name, line): (String, usize)| {
        let parts = parts(&name);
        let found = words.iter().find(|word| parts.contains(&word.word) && !word.except.contains(&name))?;
        Some(Said { file: file.to_owned(), line, name, word: found.word.clone(), instead: found.instead.clone() })
    };
    new.filter_map(said).collect()
}

/// The words of a name, in small letters: of `the_gate`, `TheGate` and `THE_GATE` alike.
fn parts(name: &str) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut before = '_';
    for c in name.chars() {
        if c == '_' || (c.is_uppercase() && before.is_lowercase()) {
            parts.push(String::new());
        }
        if c != '_' {
            parts.last_mut().into_iter().for_each(|part| part.extend(c.to_lowercase()));
        }
        before = c;
    }
    parts
}
