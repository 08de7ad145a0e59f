//! Pages and the marked places in them.
//!
//! Limits: a mark is a line of its own; tables are not nested.

use crate::{error::TablesError, table::table};
use std::path::{Path, PathBuf};

const START: &str = "<!-- table: ";
const STOP: &str = " -->";
const END: &str = "<!-- end -->";

/// A page as it stands and as it should stand.
pub struct Page {
    /// the file
    pub path: PathBuf,
    /// its text now
    pub stands: String,
    /// its text with every table written from the result files
    pub wanted: String,
}

impl Page {
    /// Whether a table differs from its result file.
    pub fn differs(&self) -> bool {
        self.stands != self.wanted
    }

    /// Writes the page as it should stand.
    ///
    /// # Errors
    /// [`TablesError::File`] where it cannot be written.
    pub fn write(&self) -> Result<(), TablesError> {
        std::fs::write(&self.path, &self.wanted).map_err(TablesError::at(&self.path))
    }
}

/// README.md and the pages of `docs/` and its guide of the repository in `root`, in order of their names.
///
/// # Errors
/// [`TablesError`] where a page, a mark in it or a result file is not as it should be.
pub fn pages(root: &Path) -> Result<Vec<Page>, TablesError> {
    let mut paths = vec![root.join("README.md")];
    for folder in ["docs", "docs/guide"].map(|folder| root.join(folder)) {
        for entry in std::fs::read_dir(&folder).map_err(TablesError::at(&folder))? {
            paths.push(entry.map_err(TablesError::at(&folder))?.path());
        }
    }
    paths.retain(|path| path.extension().is_some_and(|end| end == "md"));
    paths.sort();
    paths.into_iter().map(|path| page(root, path)).collect()
}

fn page(root: &Path, path: PathBuf) -> Result<Page, TablesError> {
    let stands = std::fs::read_to_string(&path).map_err(TablesError::at(&path))?;
    match rewritten(&stands, |name, line| table(root, name, line)) {
        Ok(wanted) => Ok(Page { path, stands, wanted }),
        Err(source) => Err(TablesError::Page { page: path, source: Box::new(source) }),
    }
}

/// The text with `table(name, line)` between each mark and its end.
///
/// # Errors
/// [`TablesError::NoEnd`] where a mark has no end, and those of `table`.
pub fn rewritten(text: &str, table: impl Fn(&str, usize) -> Result<String, TablesError>) -> Result<String, TablesError> {
    let mut out = String::with_capacity(text.len());
    let mut open: Option<(&str, usize)> = None;
    for (index, line) in text.lines().enumerate() {
        match open {
            Some(_) if line == END => open = None,
            Some((name, at)) if marked(line).is_some() => return Err(TablesError::NoEnd { line: at, name: name.to_owned() }),
            Some(_) => continue,
            None => {}
        }
        out.push_str(line);
        out.push('\n');
        if let Some(name) = marked(line) {
            open = Some((name, index + 1));
            out.push_str(&table(name, index + 1)?);
        }
    }
    match open {
        Some((name, line)) => Err(TablesError::NoEnd { line, name: name.to_owned() }),
        None => Ok(out),
    }
}

/// The name in a mark.
fn marked(line: &str) -> Option<&str> {
    line.strip_prefix(START)?.strip_suffix(STOP)
}
