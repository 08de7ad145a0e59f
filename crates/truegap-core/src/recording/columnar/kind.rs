//! Kinds of files that hold a frame, known by their first bytes, whatever they are called.
//!
//! Limits: Parquet and Arrow (Feather version 2).

/// A kind, each with its first bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::recording) enum Kind {
    Parquet,
    Arrow,
}

impl Kind {
    /// The kind of what begins so.
    pub fn of(first: &[u8]) -> Option<Self> {
        match first {
            _ if first.starts_with(b"ARROW1") => Some(Self::Arrow),
            _ if first.starts_with(b"PAR1") => Some(Self::Parquet),
            _ => None,
        }
    }

    /// In the words of a message.
    pub fn told(self) -> &'static str {
        match self {
            Self::Parquet => "a Parquet",
            Self::Arrow => "an Arrow",
        }
    }
}
