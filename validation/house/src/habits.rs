//! How the sources are written: documentation, comments, examples, lengths of functions and files, constants, and the front page.
//!
//! Limits: counts lines as text; what stands below the first `#[cfg(test)]` at the start of a line is not counted.

use crate::{
    source::{closing, without_tests},
    words::{Kind, Token, tokens},
    workspace::Files,
};

/// The front page.
pub(crate) const FRONT: &str = "README.md";

/// The library with the most to review.
pub(crate) const DIAGNOSE: &str = "truegap-diagnose";

/// Lines of a function from which it is counted as long.
const LONG_FUNCTION: usize = 25;

/// Lines of a file from which it is counted as long.
const LONG_FILE: usize = 400;

/// What is counted in the texts, kept from when they were read.
#[derive(Clone, Debug, Default)]
pub(crate) struct Texts {
    pub all: Habits,
    pub diagnose: Habits,
    /// lines of the front page, and numbers typed into its prose
    pub front: Option<[usize; 2]>,
}

impl Texts {
    pub(crate) fn read(files: &Files) -> Self {
        let front = files.get(FRONT).map(|page| [page.lines().count(), numbers_in_prose(page)]);
        Self { all: Habits::of(files, "crates/"), diagnose: Habits::of(files, &format!("crates/{DIAGNOSE}/")), front }
    }
}

/// What was counted in some sources.
#[derive(Clone, Debug, Default)]
pub(crate) struct Habits {
    /// lines with code
    pub code: usize,
    /// lines of documentation
    pub documentation: usize,
    /// lines with a comment that is no documentation
    pub comments: usize,
    /// examples in the documentation that are compiled
    pub examples: usize,
    /// constants that are numbers: in files called `tuning.rs`, and elsewhere
    pub constants: [usize; 2],
    /// places that say where an equation or a method is from
    pub sources: usize,
    functions: Vec<usize>,
    files: Vec<usize>,
}

impl Habits {
    /// Counts in all files of `files` whose path begins with `folder`, which goes through a folder `src`.
    pub(crate) fn of(files: &Files, folder: &str) -> Self {
        let mut habits = Self::default();
        let inside = |path: &str| path.starts_with(folder) && path.contains("/src/") && !path.contains("/tests/");
        for (path, text) in files.iter().filter(|(path, _)| inside(path)) {
            habits.add(path, shipped(text));
            habits.files.push(text.lines().count());
        }
        habits.functions.sort_unstable();
        habits.files.sort_unstable();
        habits
    }

    fn add(&mut self, path: &str, text: &str) {
        let tokens = without_tests(&tokens(text));
        let mut lines: Vec<usize> = tokens.iter().map(|token| token.line).collect();
        lines.dedup();
        self.code += lines.len();
        self.functions.extend(functions(&tokens));
        self.documentation += text.lines().filter_map(documentation).count();
        self.comments += text.lines().filter(|line| has_comment(line)).count();
        self.examples += examples(text);
        self.constants[usize::from(!path.ends_with("/tuning.rs"))] += text.lines().filter(|line| is_number(line)).count();
        let says = |line: &&str| line.contains("**Source:**") || line.trim_start().starts_with("source: \"");
        self.sources += text.lines().filter(says).count();
    }

    /// Lines of documentation for each line of code.
    pub(crate) fn documented(&self) -> String {
        share(self.documentation, self.code, 2)
    }

    /// Comments for each line of code.
    pub(crate) fn commented(&self) -> String {
        share(self.comments, self.code, 3)
    }

    /// Lines of the middle function, and how many functions are long.
    pub(crate) fn functions(&self) -> [usize; 2] {
        lengths(&self.functions, LONG_FUNCTION)
    }

    /// Lines of the middle file, and how many files are long.
    pub(crate) fn files(&self) -> [usize; 2] {
        lengths(&self.files, LONG_FILE)
    }
}

/// Numbers in the prose of a page: not in generated tables, not in code, not in links.
pub(crate) fn numbers_in_prose(page: &str) -> usize {
    let prose: String = page.split("```").step_by(2).collect();
    let typed: String =
        prose.split("<!-- table:").enumerate().map(|(k, part)| if k == 0 { part } else { after_table(part) }).collect();
    let without_links: String =
        typed.split("](").enumerate().map(|(k, part)| if k == 0 { part } else { after_link(part) }).collect();
    without_links.split(|c: char| !c.is_ascii_alphanumeric() && c != '.').filter(|word| begins_with_digit(word)).count()
}

fn after_table(part: &str) -> &str {
    part.split_once("<!-- end -->").map_or("", |(_, rest)| rest)
}

fn after_link(part: &str) -> &str {
    part.split_once(')').map_or("", |(_, rest)| rest)
}

fn begins_with_digit(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_digit())
}

/// The text of a source above its tests.
fn shipped(text: &str) -> &str {
    text.split("\n#[cfg(test)]\nmod tests {").next().unwrap_or(text)
}

/// What a line of documentation says.
fn documentation(line: &str) -> Option<&str> {
    let line = line.trim_start();
    line.strip_prefix("///").or_else(|| line.strip_prefix("//!"))
}

fn has_comment(line: &str) -> bool {
    let begins = |at: usize| at == 0 || line[..at].ends_with(char::is_whitespace);
    documentation(line).is_none() && line.match_indices("//").any(|(at, _)| begins(at))
}

/// Code blocks in the documentation that `cargo test` compiles: the fence says nothing, or `rust`, `no_run`, `should_panic`.
fn examples(text: &str) -> usize {
    let fences = text.lines().filter_map(documentation).filter_map(|line| line.trim().strip_prefix("```"));
    let compiled =
        |fence: &&str| fence.is_empty() || ["rust", "no_run", "should_panic"].iter().any(|word| fence.starts_with(word));
    fences.step_by(2).filter(compiled).count()
}

/// `const NAME: f64 = ..`, or another type of number.
fn is_number(line: &str) -> bool {
    let declared =
        line.trim_start().trim_start_matches("pub ").trim_start_matches("pub(crate) ").trim_start_matches("pub(super) ");
    let kind = declared.strip_prefix("const ").and_then(|rest| rest.split_once(": "));
    kind.is_some_and(|(_, kind)| {
        ["f64 ", "f32 ", "usize ", "u32 ", "u64 ", "i32 ", "i64 "].iter().any(|number| kind.starts_with(number))
    })
}

/// Lines of every function with a body.
fn functions(tokens: &[Token]) -> Vec<usize> {
    let begins = |at: usize| tokens[at].word() == Some("fn") && tokens.get(at + 1).and_then(Token::word).is_some();
    (0..tokens.len())
        .filter(|&at| begins(at))
        .filter_map(|at| Some(tokens[body_end(tokens, at)?].line + 1 - tokens[at].line))
        .collect()
}

/// The bracket that ends the function at `at`; `None` where it has no body.
fn body_end(tokens: &[Token], mut at: usize) -> Option<usize> {
    loop {
        match tokens.get(at)?.kind {
            Kind::Mark(';') => return None,
            Kind::Mark('{') => return Some(closing(tokens, at)),
            Kind::Mark('(' | '[') => at = closing(tokens, at) + 1,
            _ => at += 1,
        }
    }
}

/// The middle of sorted numbers, and how many are above `long`.
fn lengths(sorted: &[usize], long: usize) -> [usize; 2] {
    [sorted.get(sorted.len() / 2).copied().unwrap_or(0), sorted.iter().filter(|&&lines| lines > long).count()]
}

fn share(part: usize, whole: usize, digits: usize) -> String {
    format!("{:.digits$}", part as f64 / whole.max(1) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "//! A page.\n//!\n//! ```\n//! let x = 1;\n//! ```\n//!\n//! ```text\n//! a drawing\n//! ```\n
/// Twice. **Source:** arithmetic.
pub fn twice(x: f64) -> f64 {
    // because two is twice one
    2.0 * x // \"https://nowhere\" is no comment
}
pub(crate) const HALF: f64 = 0.5;
const NAME: &str = \"a // b\";
trait T { fn none(&self); }
#[cfg(test)]
mod tests {
    // not counted
    fn neither() {}
}
";

    fn habits(path: &str) -> Habits {
        Habits::of(&Files::from([(path.to_owned(), SOURCE.to_owned())]), "a/")
    }

    #[test]
    fn lines_examples_functions_and_constants_are_counted() {
        let found = habits("a/src/tuning.rs");
        // code: fn, its value, its bracket, two constants, the trait
        assert_eq!((found.code, found.documentation, found.comments), (6, 10, 3));
        assert_eq!((found.examples, found.sources, found.constants), (1, 1, [1, 0]));
        assert_eq!((found.functions(), found.files()), ([4, 0], [23, 0]));
        assert_eq!(habits("a/src/other.rs").constants, [0, 1]);
        assert_eq!(habits("a/tests/t.rs").code, 0);
    }

    #[test]
    fn only_numbers_that_were_typed_into_the_prose_count() {
        let page =
            "Three, 4 and 0.5 [5 links](docs/7.md).\n```sh\nrun 9\n```\n<!-- table: x -->\n| 1 |\n<!-- end -->\nS15 and 12 %\n";
        assert_eq!(numbers_in_prose(page), 4);
    }
}
