//! What a sweep leaves on disk: `sweep.json` and `cases/HASH.json`.
//!
//! Limits: a file is there whole or not at all, by writing beside it and renaming; a killed process leaves `*.part` files, which nobody reads.

use crate::error::SweepError;
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use serde_json::Value;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

pub(crate) const SWEEP: &str = "sweep.json";
pub(crate) const SCHEMA: &str = "truegap.sweep/1";

/// `sweep.json`.
#[derive(Clone, Debug, Deserialize)]
pub struct Described {
    schema: String,
    /// what computes a case
    pub study: String,
    /// name of the sweep: SHA-256 of the names of its cases
    pub name: String,
    /// number of cases
    pub cases: usize,
    /// what all cases share
    pub context: Value,
}

/// What sweep a folder holds.
///
/// # Errors
/// [`SweepError::NoSweep`] where it holds none.
pub fn describe(folder: &Path) -> Result<Described, SweepError> {
    let file = folder.join(SWEEP);
    let refused = |reason: String| SweepError::NoSweep { file: file.clone(), reason };
    let text = fs::read_to_string(&file).map_err(|source| refused(source.to_string()))?;
    let described: Described = serde_json::from_str(&text).map_err(|source| refused(source.to_string()))?;
    if described.schema == SCHEMA {
        Ok(described)
    } else {
        Err(refused(format!("its schema is `{}`, not `{SCHEMA}`", described.schema)))
    }
}

/// A case's file.
#[derive(Serialize, Deserialize)]
pub(crate) struct Record<C, R> {
    pub hash: String,
    pub case: C,
    pub result: R,
}

pub(crate) fn case_file(folder: &Path, hash: &str) -> PathBuf {
    folder.join("cases").join(format!("{hash}.json"))
}

/// The result in a case's file; `None` where there is no file.
pub(crate) fn read_case<R: DeserializeOwned>(folder: &Path, hash: &str) -> Result<Option<R>, SweepError> {
    let file = case_file(folder, hash);
    let text = match fs::read_to_string(&file) {
        Ok(text) => text,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(source) => return Err(SweepError::Disk { path: file, what: "cannot be read", source }),
    };
    let record: Record<serde::de::IgnoredAny, R> =
        serde_json::from_str(&text).map_err(|source| SweepError::Damaged { file: file.clone(), reason: source.to_string() })?;
    if record.hash == hash {
        Ok(Some(record.result))
    } else {
        Err(SweepError::Damaged { file, reason: format!("it names case {}", record.hash) })
    }
}

/// Writes a file so that a reader finds it whole or not at all, whatever happens to the writer; its folder is made where it is missing.
///
/// # Errors
/// [`SweepError::Disk`].
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), SweepError> {
    put(path, bytes, |part| fs::rename(part, path))
}

/// The same, and never in the place of a file that is there.
///
/// # Errors
/// [`SweepError::Disk`]; of the kind `AlreadyExists` where there is a file.
pub fn write_once(path: &Path, bytes: &[u8]) -> Result<(), SweepError> {
    if path.exists() {
        let source = io::ErrorKind::AlreadyExists.into();
        return Err(SweepError::Disk { path: path.to_owned(), what: "cannot be written", source });
    }
    put(path, bytes, |part| match fs::hard_link(part, path) {
        // a second name is refused where there is a file, which a new name is not; some disks know no second names
        Err(error) if !matches!(error.kind(), io::ErrorKind::AlreadyExists | io::ErrorKind::StorageFull) => {
            fs::rename(part, path)
        }
        linked => linked.and_then(|()| fs::remove_file(part)),
    })
}

/// Writes a part beside a file; `place` makes it the file.
fn put(path: &Path, bytes: &[u8], place: impl FnOnce(&Path) -> io::Result<()>) -> Result<(), SweepError> {
    let failed = |path: &Path, what| {
        let path = path.to_owned();
        move |source| SweepError::Disk { path, what, source }
    };
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(failed(folder, "cannot be made"))?;
    let (part, mut file) = part_file(path).map_err(failed(path, "no file can be made beside it"))?;
    let written = file.write_all(bytes).and_then(|()| file.sync_all()).and_then(|()| place(&part));
    written.map_err(|source| {
        let _ = fs::remove_file(&part); // the first error is the one to tell
        SweepError::Disk { path: path.to_owned(), what: "cannot be written", source }
    })
}

/// A new file beside `path` that no other process writes to, on this machine or another.
fn part_file(path: &Path) -> io::Result<(PathBuf, File)> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let mut number = 0;
    loop {
        let part = path.with_file_name(format!("{name}.{}-{number}.part", std::process::id()));
        match OpenOptions::new().write(true).create_new(true).open(&part) {
            Ok(file) => return Ok((part, file)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => number += 1,
            Err(error) => return Err(error),
        }
    }
}
