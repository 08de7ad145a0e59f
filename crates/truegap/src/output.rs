//! Folders of results that are there whole or not at all.
//!
//! Limits: files are written beside the target as `NAME.PID.part` and renamed at the end, so target and its parent must be on one disk; a process that
//! is killed leaves the `.part` folder behind, never a target.

mod earlier;

use earlier::holds_a_result;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Why a folder of results cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum OutputError {
    /// Something else has that name.
    #[error("{folder}: there is a file of this name; give -o a folder that is new or holds an earlier result")]
    NotAFolder { folder: PathBuf },
    /// The folder holds what is not a result of this kind.
    #[error(
        "{folder}: holds `{entry}`, which would be lost; give -o a folder that is new or holds an earlier result, or move `{entry}`"
    )]
    Foreign { folder: PathBuf, entry: String },
    /// The folder holds what is called as a result is, and no document says that this program wrote it.
    #[error(
        "{folder}: holds `{entry}`, which would be lost and is not known to be a result of truegap: no document of it, as diagnosis.json is one, stands in the \
         folder; give -o a folder that is new or holds an earlier result, or move `{entry}`"
    )]
    NotAResult { folder: PathBuf, entry: String },
    /// A file that is read stands where one is to be written.
    #[error("{file}: is read here, and a result would take its place; give -o another folder")]
    OverInput { file: PathBuf },
    /// The disk says no.
    #[error("{path}: cannot be written: {source}; check that its parent is there and may be written to")]
    Write { path: PathBuf, source: io::Error },
}

/// A folder being filled; dropped without [`OutputFolder::publish`] it leaves nothing.
#[derive(Debug)]
pub struct OutputFolder {
    target: PathBuf,
    part: PathBuf,
    /// names that an earlier result may hold and this one not
    replaced: Vec<String>,
    published: bool,
}

impl OutputFolder {
    /// Begins a folder that will be `target`; its parents are made where they are missing.
    ///
    /// # Errors
    /// [`OutputError`] where `target` is a file, or the disk refuses.
    pub fn begin(target: impl Into<PathBuf>) -> Result<Self, OutputError> {
        let target = behind_link(target.into());
        if (target.exists() || target.is_symlink()) && !target.is_dir() {
            return Err(OutputError::NotAFolder { folder: target });
        }
        let part = beside(&target, "part");
        let made = Self { target, part, replaced: Vec::new(), published: false };
        remove(&made.part).and_then(|()| fs::create_dir_all(&made.part)).map_err(|source| made.failed(&made.part, source))?;
        Ok(made)
    }

    /// The same folder; files of these names are of an earlier result and go with it, whether this one writes them or not.
    #[must_use]
    pub fn replacing(mut self, files: &[&str]) -> Self {
        self.replaced.extend(files.iter().map(|file| (*file).to_owned()));
        self
    }

    /// Whether `target` could be written now and hold `files` at its top, without leaving anything behind: asked before the work begins.
    ///
    /// # Errors
    /// As [`OutputFolder::begin`] and [`OutputFolder::publish`].
    pub fn check(target: impl AsRef<Path>, files: &[&str]) -> Result<(), OutputError> {
        let target = &behind_link(target.as_ref().to_owned());
        let failed = |path: &Path, source| OutputError::Write { path: path.to_owned(), source };
        if (target.exists() || target.is_symlink()) && !target.is_dir() {
            return Err(OutputError::NotAFolder { folder: target.to_owned() });
        }
        if target.is_dir() {
            let there = entries(target).map_err(|source| failed(target, source))?;
            replaceable(target, &there, |entry| files.iter().any(|file| entry == file))?;
        }
        // the part folder is made beside the target, in the nearest parent that is there
        let parents =
            target.ancestors().skip(1).map(|parent| if parent.as_os_str().is_empty() { Path::new(".") } else { parent });
        let Some(parent) = parents.into_iter().find(|parent| parent.exists()) else { return Ok(()) };
        if !parent.is_dir() {
            return Err(OutputError::NotAFolder { folder: parent.to_owned() });
        }
        let trial = beside(&parent.join("out"), "trial.part");
        fs::create_dir(&trial).and_then(|()| fs::remove_dir(&trial)).map_err(|source| failed(target, source))
    }

    /// Whether none of `read`, files that are read, stands in `target` under one of the names `files`, also by way of a link.
    ///
    /// # Errors
    /// [`OutputError::OverInput`] names the first that would be lost.
    pub fn check_spares(target: &Path, files: &[&str], read: &[PathBuf]) -> Result<(), OutputError> {
        let written: Vec<PathBuf> = files.iter().filter_map(|file| target.join(file).canonicalize().ok()).collect();
        match read.iter().find(|file| file.canonicalize().is_ok_and(|file| written.contains(&file))) {
            Some(file) => Err(OutputError::OverInput { file: file.clone() }),
            None => Ok(()),
        }
    }

    /// Whether files of these names, and figures, may be put into `folder` beside whatever else stands there: none stands there already, or a document says
    /// that it is an earlier result. Asked before the work begins, where a folder is filled file by file.
    ///
    /// # Errors
    /// [`OutputError::NotAResult`] names what would be lost.
    pub fn check_beside(folder: &Path, files: &[&str]) -> Result<(), OutputError> {
        if !folder.is_dir() {
            return Ok(());
        }
        let there = entries(folder).map_err(|source| OutputError::Write { path: folder.to_owned(), source })?;
        let is_figure = |entry: &OsString| Path::new(entry).extension().is_some_and(|ending| ending == "svg");
        let lost = there.into_iter().find(|entry| is_figure(entry) || files.iter().any(|file| entry == file));
        match lost.filter(|_| !holds_a_result(folder)) {
            Some(entry) => Err(OutputError::NotAResult { folder: folder.to_owned(), entry: shown(&entry) }),
            None => Ok(()),
        }
    }

    /// Where files are to be written meanwhile.
    pub fn path(&self) -> &Path {
        &self.part
    }

    /// Writes a file; `name` may hold folders, which are made.
    ///
    /// # Errors
    /// [`OutputError::Write`] where the disk refuses.
    pub fn write(&self, name: impl AsRef<Path>, bytes: impl AsRef<[u8]>) -> Result<(), OutputError> {
        let path = self.part.join(name);
        let parent = path.parent().unwrap_or(&self.part);
        fs::create_dir_all(parent).and_then(|()| fs::write(&path, bytes)).map_err(|source| self.failed(&path, source))
    }

    /// Puts the folder in its place; an earlier result that holds nothing else is replaced.
    ///
    /// # Errors
    /// [`OutputError::Foreign`] where the place holds anything that this folder does not, [`OutputError::Write`] where the disk refuses.
    pub fn publish(mut self) -> Result<PathBuf, OutputError> {
        let old = beside(&self.target, "old.part");
        let replaces = self.target.is_dir();
        if replaces {
            self.check_replaceable()?;
            if exchange(&self.part, &self.target) {
                self.published = true;
                remove(&self.part).map_err(|source| self.failed(&self.part, source))?;
                return Ok(self.target.clone());
            }
            fs::rename(&self.target, &old).map_err(|source| self.failed(&self.target, source))?;
        }
        if let Err(source) = fs::rename(&self.part, &self.target) {
            if replaces {
                fs::rename(&old, &self.target).map_err(|source| self.failed(&old, source))?;
            }
            return Err(self.failed(&self.target, source));
        }
        self.published = true;
        remove(&old).map_err(|source| self.failed(&old, source))?;
        Ok(self.target.clone())
    }

    /// Nothing may be lost but what is written again.
    fn check_replaceable(&self) -> Result<(), OutputError> {
        let new = entries(&self.part).map_err(|source| self.failed(&self.part, source))?;
        let old = entries(&self.target).map_err(|source| self.failed(&self.target, source))?;
        let earlier = |entry: &OsString| self.replaced.iter().any(|file| *entry == **file);
        replaceable(&self.target, &old, |entry| new.contains(entry) || earlier(entry))
    }

    fn failed(&self, path: &Path, source: io::Error) -> OutputError {
        OutputError::Write { path: path.to_owned(), source }
    }
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        if !self.published {
            let _ = remove(&self.part); // nothing more can be done where even removing fails
        }
    }
}

/// Whether a folder with these entries may be replaced: each is one that `is_written` here, and a document says that they were written by this program.
fn replaceable(folder: &Path, entries: &[OsString], is_written: impl Fn(&OsString) -> bool) -> Result<(), OutputError> {
    if let Some(entry) = entries.iter().find(|entry| !is_written(entry)) {
        return Err(OutputError::Foreign { folder: folder.to_owned(), entry: shown(entry) });
    }
    match entries.iter().min().filter(|_| !holds_a_result(folder)) {
        Some(entry) => Err(OutputError::NotAResult { folder: folder.to_owned(), entry: shown(entry) }),
        None => Ok(()),
    }
}

fn shown(entry: &OsString) -> String {
    entry.to_string_lossy().into_owned()
}

/// What a link points at: a link to a folder stays one, and the folder behind it is filled.
fn behind_link(target: PathBuf) -> PathBuf {
    if target.is_symlink() { fs::canonicalize(&target).unwrap_or(target) } else { target }
}

/// Puts `part` in the place of the folder `target` and leaves the old one at `part`, in one step, so that there is never no folder; false where the system
/// cannot.
#[cfg(target_os = "linux")]
fn exchange(part: &Path, target: &Path) -> bool {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    renameat_with(CWD, part, CWD, target, RenameFlags::EXCHANGE).is_ok()
}

#[cfg(not(target_os = "linux"))]
fn exchange(_: &Path, _: &Path) -> bool {
    false
}

fn beside(target: &Path, ending: &str) -> PathBuf {
    let mut name = target.file_name().map_or_else(|| OsString::from("out"), OsString::from);
    name.push(format!(".{}.{ending}", std::process::id()));
    target.with_file_name(name)
}

fn remove(folder: &Path) -> io::Result<()> {
    if folder.exists() { fs::remove_dir_all(folder) } else { Ok(()) }
}

fn entries(folder: &Path) -> io::Result<Vec<OsString>> {
    fs::read_dir(folder)?.map(|entry| entry.map(|e| e.file_name())).collect()
}

#[cfg(test)]
mod tests;
