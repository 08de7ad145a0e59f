//! Commitments: the hash of every answer and of every recording is published before any answer is opened.
//!
//! Limits: a study can be made again from its seed, so whoever knows the seed knows the answers; take a seed that cannot be guessed.

use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The file that holds the commitments of a study.
pub const COMMITMENTS: &str = "commitments.txt";

/// SHA-256 of `bytes`, lower-case hexadecimal.
pub fn sha256(bytes: impl AsRef<[u8]>) -> String {
    Sha256::digest(bytes).iter().fold(String::new(), |mut hex, byte| {
        // Writing to a string cannot fail.
        let _ = write!(hex, "{byte:02x}");
        hex
    })
}

/// One line of `commitments.txt`, in the format of `sha256sum`.
pub fn line(file: &str, bytes: impl AsRef<[u8]>) -> String {
    format!("{}  {file}\n", sha256(bytes))
}

/// Why a study is not what was committed to.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CommitmentError {
    /// A file is not the one that was committed to.
    #[error(
        "{file}: its SHA-256 is {found}, {list} has {committed}; it was altered after {list} was written: put it back as it was"
    )]
    Altered {
        /// File.
        file: String,
        /// File of the hashes.
        list: &'static str,
        /// Hash found.
        found: String,
        /// Hash committed to.
        committed: String,
    },
    /// Nothing was committed to for this file.
    #[error("{list}: no line for {file}; put {list} back as it was written")]
    Missing {
        /// File.
        file: String,
        /// File of the hashes.
        list: &'static str,
    },
    /// A line that does not belong there.
    #[error(
        "{list}, line {line}: `{text}` is not `SHA-256  FILE`, or its file has a line already; put {list} back as it was written"
    )]
    Line {
        /// File of the hashes.
        list: &'static str,
        /// Its line, from 1.
        line: usize,
        /// What stands there.
        text: String,
    },
}

/// Hashes by file: `commitments.txt`, or another list of this format.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sums {
    list: &'static str,
    of: BTreeMap<String, String>,
}

impl Sums {
    /// None yet, for the file `list`.
    pub fn none(list: &'static str) -> Self {
        Self { list, of: BTreeMap::new() }
    }

    /// Reads the text of the file `list`.
    ///
    /// # Errors
    /// [`CommitmentError::Line`]: a list that was cut inside a line or has a file twice is no list.
    pub fn parse(list: &'static str, text: &str) -> Result<Self, CommitmentError> {
        let mut of = BTreeMap::new();
        for (index, whole) in text.lines().enumerate() {
            let failed = || CommitmentError::Line { list, line: index + 1, text: whole.to_owned() };
            let (hash, file) = whole.split_once("  ").ok_or_else(failed)?;
            let is_hash = hash.len() == 64 && hash.bytes().all(|b| b.is_ascii_hexdigit());
            if !is_hash || file.is_empty() || of.insert(file.to_owned(), hash.to_owned()).is_some() {
                return Err(failed());
            }
        }
        Ok(Self { list, of })
    }

    /// The files, in the order of their names.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.of.keys().map(String::as_str)
    }

    /// Whether `file` has a line.
    pub fn has(&self, file: &str) -> bool {
        self.of.contains_key(file)
    }

    /// The hash committed to.
    ///
    /// # Errors
    /// [`CommitmentError::Missing`].
    pub fn get(&self, file: &str) -> Result<&str, CommitmentError> {
        let missing = || CommitmentError::Missing { file: file.to_owned(), list: self.list };
        self.of.get(file).map(String::as_str).ok_or_else(missing)
    }

    /// Commits to a file.
    pub fn insert(&mut self, file: &str, bytes: impl AsRef<[u8]>) {
        self.of.insert(file.to_owned(), sha256(bytes));
    }

    /// Checks that `bytes` are the file that was committed to.
    ///
    /// # Errors
    /// [`CommitmentError`].
    pub fn check(&self, file: &str, bytes: impl AsRef<[u8]>) -> Result<(), CommitmentError> {
        let (committed, found) = (self.get(file)?, sha256(bytes));
        if found == committed {
            return Ok(());
        }
        Err(CommitmentError::Altered { file: file.to_owned(), list: self.list, found, committed: committed.to_owned() })
    }

    /// The text of the list.
    pub fn text(&self) -> String {
        self.of.iter().fold(String::new(), |text, (file, hash)| text + &format!("{hash}  {file}\n"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// FIPS 180-2, appendix B.1.
    #[test]
    fn the_hash_is_sha256() {
        assert_eq!(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }

    #[test]
    fn an_altered_answer_does_not_open() {
        let published = Sums::parse(COMMITMENTS, &line("case-001.json", "{\"effects\": []}")).unwrap();
        assert_eq!(published.check("case-001.json", "{\"effects\": []}"), Ok(()));
        assert!(matches!(published.check("case-001.json", "{\"effects\": [1]}"), Err(CommitmentError::Altered { .. })));
        assert!(matches!(published.check("case-002.json", ""), Err(CommitmentError::Missing { .. })));
    }

    #[test]
    fn a_list_cut_inside_a_line_or_with_a_file_twice_is_none() {
        let text = line("a", "1") + &line("b", "2");
        let read = Sums::parse(COMMITMENTS, &text).unwrap();
        assert_eq!((read.text(), read.files().count()), (text.clone(), 2));
        let cut = &text[..text.len() - 3];
        assert!(matches!(Sums::parse(COMMITMENTS, cut), Err(CommitmentError::Line { line: 2, .. })));
        assert!(matches!(Sums::parse(COMMITMENTS, &(text.clone() + &text)), Err(CommitmentError::Line { line: 3, .. })));
    }
}
