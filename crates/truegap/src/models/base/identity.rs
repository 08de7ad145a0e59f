//! What a program is, by content: the same answers may be expected of it as long as nothing of this has changed.
//!
//! Counted are the words of its command, the names of its parameters, the file of the program, every file that the command names, and the files beside such a one that end as it does, as
//! modules of a script do.
//!
//! Limits: what else a program reads is not seen, a licence, a table, a package that is installed. A command that names no file of its own folder, as `python3 -m sim` does, has no identity.

use super::process::program;
use sha2::{Digest, Sha256};
use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};

/// SHA-256 of all that is counted, hexadecimal; `None` where that is not enough to know the program again.
pub(super) fn identity(run: &[String], folder: &Path, names: &[String]) -> Option<String> {
    let (first, rest) = run.split_first()?;
    let named: Vec<PathBuf> = rest.iter().map(|word| folder.join(word)).filter(|path| path.is_file()).collect();
    let started = program(first, folder);
    let own = started.components().count() > 1 && started.is_file();
    if named.is_empty() && !own {
        return None;
    }
    let mut hash = Sha256::new();
    hash.update(format!("truegap.answers/1 {run:?} {names:?}"));
    let started = if own { Some(started) } else { on_path(first) };
    for file in started.into_iter().chain(named.iter().flat_map(|file| with_alike(file))) {
        count(&mut hash, &file).ok()?;
    }
    Some(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}

/// Where the system finds a program that is called by its name alone.
fn on_path(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).map(|folder| folder.join(name)).find(|file| file.is_file())
}

/// A file and those beside it that end as it does, in the order of their names.
fn with_alike(file: &Path) -> Vec<PathBuf> {
    let ending = file.extension().map(OsStr::to_owned);
    let beside = file.parent().and_then(|folder| std::fs::read_dir(folder).ok()).into_iter().flatten();
    let alike = beside.filter_map(|entry| entry.ok().map(|entry| entry.path()));
    let alike = alike.filter(|path| path != file && ending.is_some() && path.extension() == ending.as_deref() && path.is_file());
    let mut files: Vec<PathBuf> = alike.chain([file.to_owned()]).collect();
    files.sort();
    files
}

fn count(hash: &mut Sha256, file: &Path) -> io::Result<()> {
    let mut content = Sha256::new();
    io::copy(&mut std::fs::File::open(file)?, &mut Counted(&mut content))?;
    hash.update(file.file_name().unwrap_or_default().as_encoded_bytes());
    hash.update([0]);
    hash.update(content.finalize());
    Ok(())
}

/// A hash that is written to.
struct Counted<'a>(&'a mut Sha256);

impl io::Write for Counted<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_another_one_where_a_file_of_it_has_changed() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
        let id = |run: &[&str]| {
            let run: Vec<String> = run.iter().map(|word| (*word).to_owned()).collect();
            identity(&run, folder.path(), &["k".to_owned()])
        };
        assert_eq!((id(&["python3", "sim.py"]), id(&["python3", "-m", "sim"])), (None, None));
        write("sim.py", "1");
        let first = id(&["python3", "sim.py"]).unwrap();
        assert_eq!(id(&["python3", "sim.py"]).unwrap(), first);
        assert_ne!(id(&["python3", "sim.py", "--fine"]).unwrap(), first);
        write("notes.txt", "of no matter");
        assert_eq!(id(&["python3", "sim.py"]).unwrap(), first);
        write("helper.py", "2");
        let second = id(&["python3", "sim.py"]).unwrap();
        write("sim.py", "3");
        let third = id(&["python3", "sim.py"]).unwrap();
        assert!(second != first && third != second && third != first);
        write("sim", "binary");
        assert!(id(&["./sim"]).is_some());
    }
}
