//! One source file as a module: what it defines, what it imports, which paths it names.
//!
//! Limits: macros are not expanded (the paths in their text count); items inside of functions and `impl`s are not items of the module.

use crate::{
    import::{Import, Seen, imports},
    words::{Kind, Token, tokens},
};
use std::collections::{BTreeMap, BTreeSet};

/// A `mod` line, or a module with its body in place.
#[derive(Clone, Debug)]
pub(crate) struct Child {
    pub seen: Seen,
    pub body: Option<Source>,
}

/// A path in code, such as `crate::fit::Model` or `fit::Model`; at least two names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Mention {
    pub path: Vec<String>,
    pub line: usize,
}

/// What the text of a module says.
#[derive(Clone, Debug, Default)]
pub(crate) struct Source {
    pub items: BTreeMap<String, Seen>,
    pub children: BTreeMap<String, Child>,
    pub imports: Vec<Import>,
    pub mentions: Vec<Mention>,
    /// every name in the code, for what comes in by a glob
    pub names: BTreeSet<String>,
}

impl Source {
    /// Reads a file.
    pub(crate) fn read(text: &str) -> Self {
        Self::of(&without_tests(&tokens(text)))
    }

    fn of(tokens: &[Token]) -> Self {
        let mut source = Self::default();
        let (mut at, mut depth, mut seen) = (0, 0usize, Seen::Within);
        while let Some(token) = tokens.get(at) {
            let step = match &token.kind {
                Kind::Word(word) => {
                    let step = source.word(word, &tokens[at..], depth, seen, at.checked_sub(1).map(|k| &tokens[k].kind));
                    seen = step.seen;
                    step.length
                }
                Kind::Mark(mark) => {
                    depth = match mark {
                        '{' | '(' | '[' => depth + 1,
                        '}' | ')' | ']' => depth.saturating_sub(1),
                        _ => depth,
                    };
                    seen = Seen::Within;
                    1
                }
                _ => 1,
            };
            at += step;
        }
        source
    }

    fn word(&mut self, word: &str, rest: &[Token], depth: usize, seen: Seen, before: Option<&Kind>) -> Step {
        let next = rest.get(1);
        let named = next.and_then(Token::word);
        match word {
            "pub" => return Step::visibility(rest),
            "use" if !next.is_some_and(|t| t.is('<')) => {
                let end = rest.iter().position(|t| t.is(';')).unwrap_or(rest.len());
                self.imports.extend(imports(&rest[1..end], seen));
                return Step { length: end + 1, seen: Seen::Within };
            }
            "mod" if depth == 0 && named.is_some() => return self.module(rest, seen),
            "macro_rules" if depth == 0 => drop(rest.get(2).and_then(Token::word).map(|name| self.item(name, seen))),
            "fn" | "struct" | "enum" | "trait" | "type" | "union" | "static" | "const" if depth == 0 => {
                let generic = matches!(before, Some(Kind::Mark('<' | ',')));
                if let (Some(name), false) = (named, generic || is_modifier(named)) {
                    self.item(name, seen);
                    return Step { length: 2, seen: Seen::Within };
                }
                // `const fn`: the name comes later, and keeps the visibility
                return Step { length: 1, seen };
            }
            "unsafe" | "async" | "extern" => return Step { length: 1, seen },
            _ => return self.path(rest, before),
        }
        Step { length: 1, seen: Seen::Within }
    }

    fn item(&mut self, name: &str, seen: Seen) {
        self.items.insert(name.to_owned(), seen);
    }

    fn module(&mut self, rest: &[Token], seen: Seen) -> Step {
        let name = rest[1].word().unwrap_or_default().to_owned();
        let inline = rest.get(2).is_some_and(|t| t.is('{'));
        let end = if inline { closing(rest, 2) } else { 2 };
        let body = inline.then(|| Self::of(&rest[3..end]));
        self.children.insert(name, Child { seen, body });
        Step { length: end + 1, seen: Seen::Within }
    }

    /// A path of names, or one name.
    fn path(&mut self, rest: &[Token], before: Option<&Kind>) -> Step {
        let mut path = Vec::new();
        let mut at = 0;
        while let Some(word) = rest.get(at).and_then(Token::word) {
            path.push(word.to_owned());
            if rest.get(at + 1).is_none_or(|t| t.kind != Kind::Path) {
                break;
            }
            at += 2;
        }
        let length = 2 * path.len() - 1;
        // `<T as Trait>::name` belongs to a type
        if before != Some(&Kind::Path) {
            if before != Some(&Kind::Mark('.')) {
                self.names.insert(path[0].clone());
            }
            if path.len() > 1 {
                self.mentions.push(Mention { path, line: rest[0].line });
            }
        }
        Step { length, seen: Seen::Within }
    }
}

/// How many tokens were read, and what the next item is seen by.
struct Step {
    length: usize,
    seen: Seen,
}

impl Step {
    fn visibility(rest: &[Token]) -> Self {
        match rest.get(1).is_some_and(|t| t.is('(')) {
            true => Self { length: closing(rest, 1) + 1, seen: Seen::Within },
            false => Self { length: 1, seen: Seen::Everywhere },
        }
    }
}

fn is_modifier(word: Option<&str>) -> bool {
    matches!(word, Some("fn" | "unsafe" | "async" | "extern" | "mut"))
}

/// Index of the bracket that closes the one at `open`.
pub(crate) fn closing(tokens: &[Token], open: usize) -> usize {
    let mut depth = 0usize;
    for (k, token) in tokens.iter().enumerate().skip(open) {
        match token.kind {
            Kind::Mark('{' | '(' | '[') => depth += 1,
            Kind::Mark('}' | ')' | ']') => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return k;
        }
    }
    tokens.len().saturating_sub(1)
}

/// The tokens without attributes and without items that exist in tests only.
pub(crate) fn without_tests(tokens: &[Token]) -> Vec<Token> {
    let mut kept = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let inner = usize::from(tokens.get(at + 1).is_some_and(|t| t.is('!')));
        if !(token.is('#') && tokens.get(at + 1 + inner).is_some_and(|t| t.is('['))) {
            kept.push(token.clone());
            at += 1;
            continue;
        }
        let end = closing(tokens, at + 1 + inner);
        let attribute = &tokens[at + 2 + inner..end];
        at = end + 1;
        if is_test(attribute) {
            at = if inner == 1 { tokens.len() } else { after_item(tokens, at) };
        }
    }
    kept
}

/// `cfg(test)`, `cfg(all(test, ..))`, not `cfg(not(test))`.
fn is_test(attribute: &[Token]) -> bool {
    let has = |word| attribute.iter().any(|t| t.word() == Some(word));
    attribute.first().is_some_and(|t| t.word() == Some("cfg")) && has("test") && !has("not")
}

/// Where the item that starts at `at` has ended.
fn after_item(tokens: &[Token], mut at: usize) -> usize {
    while let Some(token) = tokens.get(at) {
        match token.kind {
            Kind::Mark(';') => return at + 1,
            Kind::Mark('{') => return closing(tokens, at) + 1,
            Kind::Mark('(' | '[') => at = closing(tokens, at) + 1,
            _ => at += 1,
        }
    }
    at
}
