//! Folders of results that are there whole or not at all.
//!
//! Limits: files are written beside the target as `NAME.PID.part` and renamed at the end, so target and its parent must be on one disk; a process that
//! is killed leaves the `.part` folder behind, never a target.

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
            if let Some(entry) = there.into_iter().find(|entry| files.iter().all(|file| entry != file)) {
                return Err(OutputError::Foreign { folder: target.to_owned(), entry: entry.to_string_lossy().into_owned() });
            }
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
        let earlier = |entry: &std::ffi::OsString| self.replaced.iter().any(|file| *entry == **file);
        match old.into_iter().find(|entry| !new.contains(entry) && !earlier(entry)) {
            Some(entry) => Err(OutputError::Foreign { folder: self.target.clone(), entry: entry.to_string_lossy().into_owned() }),
            None => Ok(()),
        }
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
mod tests {
    use super::*;

    fn place(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("truegap-output-{}-{name}", std::process::id()));
        remove(&path).unwrap();
        fs::create_dir_all(&path).unwrap();
        path
    }

    #[test]
    fn a_folder_appears_whole() {
        let place = place("whole");
        let target = place.join("deep/er/out");
        let folder = OutputFolder::begin(&target).unwrap();
        folder.write("meshes/a.glb", "1").unwrap();
        assert!(!target.exists());
        folder.publish().unwrap();
        assert_eq!(fs::read_to_string(target.join("meshes/a.glb")).unwrap(), "1");
        assert_eq!(entries(target.parent().unwrap()).unwrap(), ["out"]);
        remove(&place).unwrap();
    }

    #[test]
    fn what_is_given_up_leaves_nothing() {
        let place = place("dropped");
        let folder = OutputFolder::begin(place.join("out")).unwrap();
        folder.write("a", "1").unwrap();
        drop(folder);
        assert!(entries(&place).unwrap().is_empty());
        remove(&place).unwrap();
    }

    #[test]
    fn an_earlier_result_is_replaced_and_anything_else_is_not() {
        let place = place("again");
        let target = place.join("out");
        for round in ["1", "2"] {
            let folder = OutputFolder::begin(&target).unwrap();
            folder.write("a", round).unwrap();
            folder.publish().unwrap();
        }
        assert_eq!(fs::read_to_string(target.join("a")).unwrap(), "2");
        fs::write(target.join("thesis.tex"), "mine").unwrap();
        let folder = OutputFolder::begin(&target).unwrap();
        folder.write("a", "3").unwrap();
        assert!(matches!(folder.publish(), Err(OutputError::Foreign { entry, .. }) if entry == "thesis.tex"));
        assert_eq!(fs::read_to_string(target.join("a")).unwrap(), "2");
        assert_eq!(entries(&place).unwrap(), ["out"]);
        remove(&place).unwrap();
    }

    #[test]
    fn a_place_is_checked_without_a_trace() {
        let place = place("checked");
        let files = ["a.json"];
        OutputFolder::check(place.join("new/deep"), &files).unwrap();
        assert!(entries(&place).unwrap().is_empty());
        fs::write(place.join("file"), "x").unwrap();
        assert!(matches!(OutputFolder::check(place.join("file"), &files), Err(OutputError::NotAFolder { .. })));
        assert!(matches!(OutputFolder::check(place.join("file/out"), &files), Err(OutputError::NotAFolder { .. })));
        fs::create_dir(place.join("old")).unwrap();
        fs::write(place.join("old/a.json"), "x").unwrap();
        OutputFolder::check(place.join("old"), &files).unwrap();
        fs::write(place.join("old/thesis.tex"), "x").unwrap();
        assert!(
            matches!(OutputFolder::check(place.join("old"), &files), Err(OutputError::Foreign { entry, .. }) if entry == "thesis.tex")
        );
        remove(&place).unwrap();
    }

    /// A second result with fewer files than the first: found by running a diagnosis twice into one folder, once with a mechanism and once without.
    #[test]
    fn a_result_with_fewer_files_replaces_an_earlier_one() {
        let place = place("fewer");
        let write = |files: &[&str]| {
            let folder = OutputFolder::begin(place.join("out")).unwrap().replacing(&["a", "b"]);
            files.iter().for_each(|file| folder.write(file, "x").unwrap());
            folder.publish()
        };
        write(&["a", "b"]).unwrap();
        write(&["a"]).unwrap();
        assert_eq!(entries(&place.join("out")).unwrap(), ["a"]);
        fs::write(place.join("out/thesis.tex"), "x").unwrap();
        assert!(matches!(write(&["a"]), Err(OutputError::Foreign { entry, .. }) if entry == "thesis.tex"));
        remove(&place).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link() {
        let place = place("link");
        fs::create_dir(place.join("real")).unwrap();
        std::os::unix::fs::symlink("real", place.join("out")).unwrap();
        std::os::unix::fs::symlink("nowhere", place.join("lost")).unwrap();
        for round in ["1", "2"] {
            OutputFolder::check(place.join("out"), &["a"]).unwrap();
            let folder = OutputFolder::begin(place.join("out")).unwrap();
            folder.write("a", round).unwrap();
            folder.publish().unwrap();
            assert!(place.join("out").is_symlink());
            assert_eq!(fs::read_to_string(place.join("real/a")).unwrap(), round);
        }
        assert!(matches!(OutputFolder::check(place.join("lost"), &["a"]), Err(OutputError::NotAFolder { .. })));
        assert_eq!(entries(&place).unwrap().len(), 3);
        remove(&place).unwrap();
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn there_is_a_folder_at_every_moment_of_a_replacement() {
        let place = place("exchange");
        for (name, text) in [("part", "new"), ("target", "old")] {
            fs::create_dir(place.join(name)).unwrap();
            fs::write(place.join(name).join("a"), text).unwrap();
        }
        assert!(exchange(&place.join("part"), &place.join("target")));
        let read = |name: &str| fs::read_to_string(place.join(name).join("a")).unwrap();
        assert_eq!((read("target").as_str(), read("part").as_str()), ("new", "old"));
        remove(&place).unwrap();
    }

    #[test]
    fn a_file_is_not_a_folder() {
        let place = place("file");
        fs::write(place.join("out"), "x").unwrap();
        assert!(matches!(OutputFolder::begin(place.join("out")), Err(OutputError::NotAFolder { .. })));
        remove(&place).unwrap();
    }
}
