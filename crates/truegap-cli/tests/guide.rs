//! The pages of the guide: their commands run, and print what the pages show. The Python code of them is run by the tests of the package.
//!
//! Blocks of a page: `toml file=NAME` is written to NAME; `csv file=NAME rows=N` is a header and one row of formulas in t (s), written out; `sh` is run, line by
//! line, with what `with=FROM:TO` copies from docs; each line of a `text` block behind it must be in what was printed.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use std::path::{Path, PathBuf};

const DOCS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs");

struct Block {
    info: String,
    text: String,
}

fn blocks(page: &str) -> Vec<Block> {
    let fenced = page.split("```").skip(1).step_by(2);
    fenced
        .map(|b| b.split_once('\n').unwrap())
        .map(|(info, text)| Block { info: info.to_owned(), text: text.to_owned() })
        .collect()
}

impl Block {
    fn kind(&self) -> &str {
        self.info.split(' ').next().unwrap()
    }

    fn named(&self, key: &str) -> Option<&str> {
        self.info.split(' ').find_map(|word| word.strip_prefix(key)?.strip_prefix('='))
    }
}

/// A cell as the pages write it: a sum of products of numbers, t, `sin(...)`, parentheses and `noise`, which is different in each row.
struct Formula<'a> {
    rest: &'a [u8],
    t: f64,
}

impl Formula<'_> {
    fn sum(&mut self) -> f64 {
        let mut value = self.product();
        loop {
            match self.next() {
                Some(b'+') => value += self.taken().product(),
                Some(b'-') => value -= self.taken().product(),
                _ => return value,
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut value = self.factor();
        loop {
            match self.next() {
                Some(b'*') => value *= self.taken().factor(),
                Some(b'/') => value /= self.taken().factor(),
                // two factors beside one another
                Some(b's' | b'n' | b'(') => value *= self.factor(),
                _ => return value,
            }
        }
    }

    fn factor(&mut self) -> f64 {
        let word = |text: &[u8], name: &str| text.starts_with(name.as_bytes());
        if self.next() == Some(b'(') {
            let value = self.taken().sum();
            assert_eq!(self.next(), Some(b')'));
            self.rest = &self.rest[1..];
            return value;
        }
        if word(self.rest, "sin") {
            self.rest = &self.rest[3..];
            return self.factor().sin();
        }
        if word(self.rest, "noise") {
            self.rest = &self.rest[5..];
            // a uniform number of unit variance, from the digits of a sine
            let uniform = ((self.t + 1.0) * 12.9898).sin() * 43758.5453;
            return (uniform - uniform.floor() - 0.5) * 12f64.sqrt();
        }
        if word(self.rest, "t") {
            self.rest = &self.rest[1..];
            return self.t;
        }
        let end = self.rest.iter().position(|b| !(b.is_ascii_digit() || *b == b'.')).unwrap_or(self.rest.len());
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest;
        std::str::from_utf8(number).unwrap().parse().unwrap()
    }

    fn next(&mut self) -> Option<u8> {
        self.rest = self.rest.trim_ascii_start();
        self.rest.first().copied()
    }

    fn taken(&mut self) -> &mut Self {
        self.rest = self.rest[1..].trim_ascii_start();
        self
    }
}

fn written_out(block: &Block) -> String {
    let (header, row) = block.text.trim_end().split_once('\n').unwrap();
    let rows: u32 = block.named("rows").unwrap().parse().unwrap();
    let cell = |text: &str, t: f64| Formula { rest: text.trim_matches(['{', '}']).as_bytes(), t }.sum().to_string();
    let line = |k: u32| row.split(',').map(|c| cell(c, f64::from(k))).collect::<Vec<_>>().join(",");
    std::iter::once(header.to_owned()).chain((0..rows).map(line)).collect::<Vec<_>>().join("\n") + "\n"
}

/// Writes the files of a page, runs its commands in their order, and compares what they print with what the page shows.
fn follow(page: &str) -> usize {
    let bench = Bench::new();
    let blocks = blocks(page);
    for block in blocks.iter() {
        match (block.kind(), block.named("file")) {
            ("toml", Some(file)) => bench.file(file, &block.text),
            ("csv", Some(file)) => bench.file(file, &written_out(block)),
            _ => &bench,
        };
        if let Some((from, to)) = block.named("with").and_then(|with| with.split_once(':')) {
            bench.file(to, &std::fs::read_to_string(Path::new(DOCS).join(from)).unwrap());
        }
    }
    let mut count = 0;
    let mut printed = String::new();
    for block in &blocks {
        match block.kind() {
            "sh" => {
                printed.clear();
                for line in block.text.lines() {
                    let may_fail = line.ends_with(" || true");
                    let words: Vec<&str> = line.trim_end_matches(" || true").split(' ').collect();
                    assert_eq!(words[0], "truegap", "{line}");
                    let said = bench.run(&words[1..]);
                    assert!(said.code < 2 || may_fail, "{line}: {}", said.err);
                    printed += &said.out;
                    count += 1;
                }
            }
            "text" => block.text.lines().for_each(|line| assert!(printed.contains(line), "`{line}` is not in: {printed}")),
            _ => {}
        }
    }
    count
}

fn pages() -> Vec<PathBuf> {
    let mut pages: Vec<PathBuf> = std::fs::read_dir(format!("{DOCS}/guide")).unwrap().map(|e| e.unwrap().path()).collect();
    pages.sort();
    pages
}

#[test]
fn the_commands_of_the_guide_run_and_print_what_it_shows() {
    let followed: Vec<usize> = pages().iter().map(|page| follow(&std::fs::read_to_string(page).unwrap())).collect();
    assert!(followed.iter().sum::<usize>() >= 9, "{followed:?}");
}

#[test]
fn the_formulas_of_the_pages_are_computed() {
    let at = |text: &str| Formula { rest: text.as_bytes(), t: 3.0 }.sum();
    assert_eq!(at("1 + 0.5 * (5 + 4 sin((t - 3) / 9))"), 3.5);
    assert_eq!(at("2 - t / 6 + 2"), 3.5);
}

#[test]
fn the_summary_of_the_site_lists_every_page_once() {
    let summary = std::fs::read_to_string(format!("{DOCS}/SUMMARY.md")).unwrap();
    let listed: Vec<&str> = summary.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(file, _)| file).collect();
    let mut files: Vec<String> = ["", "guide/"]
        .iter()
        .flat_map(|folder| {
            let entries = std::fs::read_dir(format!("{DOCS}/{folder}")).unwrap();
            entries.map(move |e| format!("{folder}{}", e.unwrap().file_name().to_str().unwrap()))
        })
        .filter(|file| file.ends_with(".md") && file != "SUMMARY.md")
        .collect();
    files.sort();
    let mut sorted = listed.clone();
    sorted.sort_unstable();
    assert_eq!(sorted, files);
}
