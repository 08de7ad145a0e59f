//! Commitments: the hash of every answer is published before any is opened.
//!
//! Limits: a study can be made again from its seed, so whoever knows the seed knows the answers; take a seed that cannot be guessed.

use sha2::{Digest, Sha256};
use std::fmt::Write;

/// SHA-256 of `text`, lower-case hexadecimal.
pub fn sha256(text: &str) -> String {
    Sha256::digest(text.as_bytes()).iter().fold(String::new(), |mut hex, byte| {
        // Writing to a string cannot fail.
        let _ = write!(hex, "{byte:02x}");
        hex
    })
}

/// One line of `commitments.txt`, in the format of `sha256sum`.
pub fn line(case: &str, text: &str) -> String {
    format!("{}  {case}.json\n", sha256(text))
}

/// Why a key does not open a study.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CommitmentError {
    /// The answer is not the one that was committed to.
    #[error(
        "{case}: the answer's SHA-256 is {found}, committed was {committed}; the key was altered after the study was published"
    )]
    Altered {
        /// Case.
        case: String,
        /// Hash of the answer found.
        found: String,
        /// Hash published.
        committed: String,
    },
    /// No commitment for this case.
    #[error("{case}: no line in commitments.txt; take the key that belongs to this study")]
    Missing {
        /// Case.
        case: String,
    },
}

/// Checks that `text` is the answer of `case` that `commitments` (the text of `commitments.txt`) binds to.
pub fn verify(commitments: &str, case: &str, text: &str) -> Result<(), CommitmentError> {
    let name = format!("{case}.json");
    let committed = commitments
        .lines()
        .filter_map(|line| line.split_once("  "))
        .find(|(_, file)| *file == name)
        .ok_or_else(|| CommitmentError::Missing { case: case.to_owned() })?
        .0;
    let found = sha256(text);
    if found == committed {
        return Ok(());
    }
    Err(CommitmentError::Altered { case: case.to_owned(), found, committed: committed.to_owned() })
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
        let published = line("case-001", "{\"effects\": []}");
        assert_eq!(verify(&published, "case-001", "{\"effects\": []}"), Ok(()));
        assert!(matches!(verify(&published, "case-001", "{\"effects\": [1]}"), Err(CommitmentError::Altered { .. })));
        assert!(matches!(verify(&published, "case-002", ""), Err(CommitmentError::Missing { .. })));
    }
}
