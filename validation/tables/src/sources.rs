//! Tables of the architecture, read from the sources: the crates with their public modules, and the stages of the diagnosis with their files.
//!
//! Limits: reads the first line of a module's documentation and `pub mod` lines as text.

use crate::{error::TablesError, markdown::Markdown};
use std::path::{Path, PathBuf};

/// Stages of `truegap-diagnose`, the last one first: a stage may use those below it.
const STAGES: [&str; 17] = [
    "compensation",
    "pipeline",
    "answer",
    "explain",
    "validation",
    "discovery",
    "selection",
    "adequacy",
    "quality",
    "noise",
    "fit",
    "whitening",
    "effects",
    "data",
    "seeds",
    "stats",
    "text",
];

const DIAGNOSE: &str = "crates/truegap-diagnose/src";

/// Files of a folder that are named; more are counted.
const NAMED: usize = 16;

/// One row a crate: what it is, and its public modules.
pub(crate) fn crates(root: &Path) -> Result<Markdown, TablesError> {
    let mut table = Markdown::new(&["crate", "what", "public modules"]);
    for folder in inside(&root.join("crates"))? {
        let lib = folder.join("src/lib.rs");
        if lib.exists() {
            let text = read(&lib)?;
            let modules: Vec<String> = text.lines().filter_map(public_module).map(|name| format!("`{name}`")).collect();
            let shown = if modules.is_empty() { "none: all names are at the root".to_owned() } else { modules.join(", ") };
            table.rows.push(vec![format!("`{}`", stem(&folder)), summary(&text), shown]);
        }
    }
    Ok(table)
}

/// One row a stage of the diagnosis, in the order of the work: what it does, and its files.
///
/// # Errors
/// [`TablesError::NoRow`] where a stage of the list has no file, or a file stands in no stage.
pub(crate) fn stages(root: &Path) -> Result<Markdown, TablesError> {
    let src = root.join(DIAGNOSE);
    let unknown = |path: &PathBuf| !["lib", "tests"].contains(&stem(path).as_str()) && !STAGES.contains(&stem(path).as_str());
    if let Some(path) = inside(&src)?.iter().find(|path| unknown(path)) {
        return Err(TablesError::NoRow { path: PathBuf::from(file!()), row: stem(path) });
    }
    let mut table = Markdown::new(&["stage", "what", "files"]);
    for stage in STAGES.iter().rev() {
        let folder = src.join(stage);
        let (text, files) = match folder.is_dir() {
            true => (read(&folder.join("mod.rs"))?, files(&folder)?),
            false => (read(&src.join(format!("{stage}.rs")))?, String::new()),
        };
        table.rows.push(vec![format!("`{stage}`"), summary(&text), files]);
    }
    Ok(table)
}

/// Names of the files and folders of a stage, without `mod.rs`.
fn files(folder: &Path) -> Result<String, TablesError> {
    let name = |path: PathBuf| if path.is_dir() { format!("`{}/`", stem(&path)) } else { format!("`{}.rs`", stem(&path)) };
    let names: Vec<String> = inside(folder)?.into_iter().filter(|path| stem(path) != "mod").map(name).collect();
    Ok(if names.len() > NAMED { format!("{} files", names.len()) } else { names.join(", ") })
}

/// The first sentence of a module's documentation, links as plain names.
fn summary(text: &str) -> String {
    let lines = text.lines().skip_while(|line| !line.starts_with("//! "));
    let paragraph: Vec<&str> = lines.map_while(|line| line.strip_prefix("//! ")).collect();
    let sentence = paragraph.join(" ").replace("[`", "`").replace("`]", "`").replace("crate::", "");
    let end = sentence.find(". ").unwrap_or(sentence.len());
    sentence[..end].trim_end_matches('.').to_owned()
}

/// The name in a `pub mod` line of the root.
fn public_module(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("pub mod ")?;
    rest.split([';', ' ']).next()
}

fn inside(folder: &Path) -> Result<Vec<PathBuf>, TablesError> {
    let entries = std::fs::read_dir(folder).map_err(TablesError::at(folder))?;
    let mut paths: Vec<PathBuf> =
        entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<_, _>>().map_err(TablesError::at(folder))?;
    paths.sort();
    Ok(paths)
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

fn read(path: &Path) -> Result<String, TablesError> {
    std::fs::read_to_string(path).map_err(TablesError::at(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_summary_is_the_first_sentence_without_links() {
        let text = "//! One file an effect, in [`library`]. Nothing more.\n//!\n//! Limits: none.\n";
        assert_eq!(summary(text), "One file an effect, in `library`");
        assert_eq!(summary("//! Two lines\n//! of one sentence.\n//!\n//! Limits.\n"), "Two lines of one sentence");
    }

    #[test]
    fn private_modules_are_not_listed() {
        let names: Vec<_> =
            ["pub mod a;", "mod b;", "pub mod c {", "pub(crate) mod d;"].into_iter().filter_map(public_module).collect();
        assert_eq!(names, ["a", "c"]);
    }
}
