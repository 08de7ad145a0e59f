//! A Rust source as words and marks: comments and literals are gone, every word knows its line.
//!
//! Limits: it reads sources that the compiler has accepted; numbers, strings, characters and lifetimes leave nothing but a [`Kind::Literal`].

use std::{iter::Peekable, str::Chars};

/// What a token is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// a keyword or a name
    Word(String),
    /// `::`
    Path,
    /// any other character
    Mark(char),
    /// number, string, character or lifetime
    Literal,
}

/// One token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Token {
    pub kind: Kind,
    /// from 1
    pub line: usize,
}

impl Token {
    /// The word, where it is one.
    pub(crate) fn word(&self) -> Option<&str> {
        match &self.kind {
            Kind::Word(word) => Some(word),
            _ => None,
        }
    }

    /// Whether this is the character `mark`.
    pub(crate) fn is(&self, mark: char) -> bool {
        self.kind == Kind::Mark(mark)
    }
}

/// The tokens of a source.
pub(crate) fn tokens(text: &str) -> Vec<Token> {
    let mut reader = Reader { rest: text.chars().peekable(), line: 1 };
    let mut all = Vec::new();
    while let Some(first) = reader.next() {
        let line = reader.line;
        if let Some(kind) = reader.token(first) {
            all.push(Token { kind, line });
        }
    }
    all
}

struct Reader<'a> {
    rest: Peekable<Chars<'a>>,
    line: usize,
}

impl Reader<'_> {
    fn next(&mut self) -> Option<char> {
        let c = self.rest.next()?;
        self.line += usize::from(c == '\n');
        Some(c)
    }

    fn skip(&mut self) {
        self.next();
    }

    /// The character `ahead` places on, without taking it.
    fn peek(&self, ahead: usize) -> Option<char> {
        self.rest.clone().nth(ahead)
    }

    fn token(&mut self, first: char) -> Option<Kind> {
        match (first, self.peek(0)) {
            (c, _) if c.is_whitespace() => None,
            ('/', Some('/')) => self.line_comment(),
            ('/', Some('*')) => self.block_comment(),
            (':', Some(':')) => self.next().map(|_| Kind::Path),
            ('"', _) => Some(self.string()),
            ('\'', _) => Some(self.quoted()),
            (c, _) if c.is_ascii_digit() => Some(self.number()),
            (c, _) if c.is_alphabetic() || c == '_' => Some(self.word(c)),
            (c, _) => Some(Kind::Mark(c)),
        }
    }

    fn line_comment(&mut self) -> Option<Kind> {
        while self.next().is_some_and(|c| c != '\n') {}
        None
    }

    /// Block comments nest.
    fn block_comment(&mut self) -> Option<Kind> {
        self.next();
        let mut depth = 1;
        while depth > 0 {
            match (self.next()?, self.peek(0)) {
                ('/', Some('*')) => depth += 1,
                ('*', Some('/')) => depth -= 1,
                _ => continue,
            }
            self.next();
        }
        None
    }

    fn string(&mut self) -> Kind {
        while let Some(c) = self.next() {
            match c {
                '\\' => self.skip(),
                '"' => break,
                _ => {}
            }
        }
        Kind::Literal
    }

    /// A raw string after its `r`: as many `#` at the end as at the start.
    fn raw_string(&mut self) -> Kind {
        let mut fence = 0;
        while self.next() == Some('#') {
            fence += 1;
        }
        while let Some(c) = self.next() {
            if c == '"' && (0..fence).all(|k| self.peek(k) == Some('#')) {
                (0..fence).for_each(|_| self.skip());
                break;
            }
        }
        Kind::Literal
    }

    /// A character such as `'a'` or `'\n'`, or a lifetime such as `'a`.
    fn quoted(&mut self) -> Kind {
        if self.peek(0) == Some('\\') {
            self.next();
            self.next();
            while self.next().is_some_and(|c| c != '\'') {}
        } else if self.peek(1) == Some('\'') {
            self.next();
            self.next();
        } else {
            self.letters();
        }
        Kind::Literal
    }

    fn letters(&mut self) -> String {
        let mut word = String::new();
        while let Some(c) = self.rest.next_if(|c| c.is_alphanumeric() || *c == '_') {
            word.push(c);
        }
        word
    }

    /// `1.5e-3` is read as `1.5e`, a mark and `3`: nobody looks at numbers.
    fn number(&mut self) -> Kind {
        self.letters();
        if self.peek(0) == Some('.') && self.peek(1).is_some_and(|c| c.is_ascii_digit()) {
            self.next();
            self.letters();
        }
        Kind::Literal
    }

    fn word(&mut self, first: char) -> Kind {
        let word = format!("{first}{}", self.letters());
        match (word.as_str(), self.peek(0), self.peek(1)) {
            ("r" | "br" | "cr", Some('"'), _) | ("r" | "br" | "cr", Some('#'), Some('"' | '#')) => self.raw_string(),
            ("b" | "c", Some('"'), _) => {
                self.next();
                self.string()
            }
            ("b", Some('\''), _) => {
                self.next();
                self.quoted()
            }
            ("r", Some('#'), _) => {
                self.next();
                Kind::Word(self.letters())
            }
            _ => Kind::Word(word),
        }
    }
}
