//! Files that hold a frame: Parquet and Arrow (Feather), known by their first bytes, whatever they are called.
//!
//! Limits: read where the feature `columnar` is built in; numbers, truth values, dates (as text, too) and durations, other columns are left out; none on standard input.

#[cfg(feature = "columnar")]
mod arrow;
pub(in crate::recording) mod kind;
mod of_file;

#[cfg(feature = "columnar")]
use self::arrow::of_kind;
use self::kind::Kind;
pub(super) use self::of_file::Frame;
use super::{
    error::RecordingError,
    frame::FrameColumn,
    manifest::Manifest,
    packed::{is_standard_input, unread},
};
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

/// The columns of a Parquet or Arrow file: numbers as they stand, dates as seconds since the first.
///
/// # Errors
/// [`RecordingError`] where the file cannot be read or is of another kind.
pub fn read_columns(path: &Path) -> Result<Vec<FrameColumn<'static>>, RecordingError> {
    let says = || "it begins as neither".to_owned();
    match read(path)? {
        Some(mut frame) => {
            frame.read_dates(path, &Manifest::default())?;
            Ok(frame.columns)
        }
        None => Err(RecordingError::Columnar { file: path.to_owned(), kind: "a Parquet or Arrow", says: says() }),
    }
}

/// The frame in a file; `None` where it is a file of another kind.
pub(super) fn read(path: &Path) -> Result<Option<Frame>, RecordingError> {
    if is_standard_input(path) {
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
    Ok(Kind::of(&first))
}

#[cfg(not(feature = "columnar"))]
fn of_kind(path: &Path, _: File, kind: Kind) -> Result<Frame, RecordingError> {
    Err(RecordingError::NoColumnar { file: path.to_owned(), kind: kind.told() })
}
