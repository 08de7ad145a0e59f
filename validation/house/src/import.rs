//! `use` trees as a flat list: nested braces, globs, renames.
//!
//! Limits: what a path leads to is found in `resolve`.

use crate::words::{Kind, Token};

/// Who may see an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Seen {
    /// `pub`
    Everywhere,
    /// `pub(crate)`, `pub(super)`, `pub(in ..)` or nothing
    Within,
}

/// What one leaf of a `use` tree brings in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Brings {
    /// one name, as it is called here
    Name(String),
    /// `as _`: a trait for its methods
    Unnamed,
    /// `*`
    Everything,
}

/// One leaf of a `use` tree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Import {
    pub path: Vec<String>,
    pub brings: Brings,
    pub seen: Seen,
    pub line: usize,
}

/// The leaves of the tree in `tokens`, without `use` and `;`.
pub(crate) fn imports(tokens: &[Token], seen: Seen) -> Vec<Import> {
    let mut tree = Tree { tokens, at: 0, seen, leaves: Vec::new() };
    tree.branch(&[]);
    tree.leaves
}

struct Tree<'a> {
    tokens: &'a [Token],
    at: usize,
    seen: Seen,
    leaves: Vec<Import>,
}

impl Tree<'_> {
    fn branch(&mut self, above: &[String]) {
        let mut path = above.to_vec();
        while let Some(token) = self.tokens.get(self.at) {
            match &token.kind {
                Kind::Word(word) if word == "as" => return self.renamed(path),
                Kind::Word(word) => path.push(word.clone()),
                Kind::Mark('*') => {
                    self.at += 1;
                    return self.leaf(path, Brings::Everything);
                }
                Kind::Mark('{') => return self.braces(&path),
                Kind::Path => {}
                _ => break,
            }
            self.at += 1;
        }
        self.named(path);
    }

    fn braces(&mut self, path: &[String]) {
        self.at += 1;
        while self.tokens.get(self.at).is_some_and(|t| !t.is('}')) {
            self.branch(path);
            self.at += usize::from(self.tokens.get(self.at).is_some_and(|t| t.is(',')));
        }
        self.at += 1;
    }

    fn renamed(&mut self, path: Vec<String>) {
        let name = self.tokens.get(self.at + 1).and_then(Token::word).unwrap_or("_").to_owned();
        self.at += 2;
        let brings = if name == "_" { Brings::Unnamed } else { Brings::Name(name) };
        self.leaf(path, brings);
    }

    fn named(&mut self, path: Vec<String>) {
        let name = path.iter().rev().find(|word| *word != "self").cloned();
        if let Some(name) = name {
            self.leaf(path, Brings::Name(name));
        }
    }

    /// `a::b::{self}` is `a::b`; `self` at the start of a path stays.
    fn leaf(&mut self, mut path: Vec<String>, brings: Brings) {
        if path.len() > 1 && path.last().is_some_and(|word| word == "self") {
            path.pop();
        }
        let line = self.tokens.get(self.at.min(self.tokens.len()).saturating_sub(1)).map_or(0, |t| t.line);
        self.leaves.push(Import { path, brings, seen: self.seen, line });
    }
}
