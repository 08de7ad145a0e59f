//! Files that hold a frame: Parquet and Arrow (Feather), known by their first bytes, whatever they are called.
//!
//! Limits: read where the feature `columnar` is built in; numbers, truth values, dates and durations, other columns are left out; none on standard input.

#[cfg(feature = "columnar")]
mod arrow;

#[cfg(feature = "columnar")]
use self::arrow::of_kind;
use super::{error::RecordingError, frame::FrameColumn, manifest::Manifest, packed::unread};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

/// Kinds of files, each with its first bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Parquet,
    Arrow,
}

impl Kind {
    /// In the words of a message.
    fn told(self) -> &'static str {
        match self {
            Self::Parquet => "a Parquet",
            Self::Arrow => "an Arrow",
        }
    }
}

/// The columns of a file.
pub(super) struct Frame {
    pub columns: Vec<FrameColumn<'static>>,
    /// names of what is neither numbers nor times, and what it is
    pub left_out: Vec<(String, String)>,
    pub sha256: String,
}

impl Frame {
    /// Refuses a file whose columns of text are named for numbers.
    ///
    /// # Errors
    /// [`RecordingError::NoNumbersInColumn`].
    pub fn holds_numbers(&self, file: &Path, manifest: &Manifest) -> Result<(), RecordingError> {
        let roles = manifest.columns.values().map(|named| &named.text);
        let mut wanted = roles.chain(manifest.drivers.iter().map(|driver| &driver.column));
        match wanted.find_map(|name| self.left_out.iter().find(|(column, _)| column == name)) {
            None => Ok(()),
            Some((column, holds)) => {
                let (file, column, holds) = (file.to_owned(), column.clone(), holds.clone());
                Err(RecordingError::NoNumbersInColumn { file, column, holds })
            }
        }
    }
}

/// The columns of a Parquet or Arrow file: numbers as they stand, dates as seconds since the first.
///
/// # Errors
/// [`RecordingError`] where the file cannot be read or is of another kind.
pub fn read_columns(path: &Path) -> Result<Vec<FrameColumn<'static>>, RecordingError> {
    let says = || "it begins as neither".to_owned();
    match read(path)? {
        Some(frame) => Ok(frame.columns),
        None => Err(RecordingError::Columnar { file: path.to_owned(), kind: "a Parquet or Arrow", says: says() }),
    }
}

/// The frame in a file; `None` where it is a file of another kind.
pub(super) fn read(path: &Path) -> Result<Option<Frame>, RecordingError> {
    if path == Path::new("-") {
        return Ok(None);
    }
    let mut file = truegap_limits::open(path).map_err(|source| unread(path, source))?;
    let kind = kind(&mut file).map_err(|source| unread(path, source))?;
    kind.map(|kind| of_kind(path, file, kind)).transpose()
}

fn kind(file: &mut File) -> io::Result<Option<Kind>> {
    let mut first = Vec::new();
    file.by_ref().take(6).read_to_end(&mut first)?;
    file.seek(SeekFrom::Start(0))?;
    Ok(match first.as_slice() {
        b"ARROW1" => Some(Kind::Arrow),
        [b'P', b'A', b'R', b'1', ..] => Some(Kind::Parquet),
        _ => None,
    })
}

#[cfg(not(feature = "columnar"))]
fn of_kind(path: &Path, _: File, kind: Kind) -> Result<Frame, RecordingError> {
    Err(RecordingError::NoColumnar { file: path.to_owned(), kind: kind.told() })
}
