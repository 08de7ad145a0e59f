//! The pages name nothing that does not exist, and can be read from their first lines.
#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};

/// Lines within which a page says what it is about.
const SUMMARY: usize = 12;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// README, CONTRIBUTING and the pages of `docs/` and its guide, with their texts.
fn pages() -> Vec<(PathBuf, String)> {
    let folder = |name: &str| std::fs::read_dir(root().join(name)).unwrap().map(|entry| entry.unwrap().path());
    let docs = folder("docs").chain(folder("docs/guide"));
    let pages = docs.chain(["README.md", "CONTRIBUTING.md"].map(|name| root().join(name)));
    let pages = pages.filter(|path| path.extension().is_some_and(|end| end == "md"));
    pages.map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect()
}

/// What stands between `open` and `close`, each time.
fn between<'a>(text: &'a str, open: &str, close: char) -> Vec<&'a str> {
    text.split(open).skip(1).filter_map(|rest| rest.split_once(close)).map(|(inside, _)| inside).collect()
}

#[test]
fn every_link_leads_to_a_file() {
    for (path, text) in pages() {
        for link in between(&text, "](", ')') {
            let file = link.split('#').next().unwrap_or_default();
            let elsewhere = link.contains("://") || file.is_empty();
            assert!(elsewhere || path.with_file_name(file).exists(), "{}: there is no {link}", path.display());
        }
    }
}

/// Files and folders of the repository, without what a build makes.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        found.push(path.clone());
        if path.is_dir() && !["target", ".git"].contains(&name.as_str()) {
            files(&path, found);
        }
    }
}

#[test]
fn the_pages_for_contributors_name_only_files_that_exist() {
    let mut there = Vec::new();
    files(&root(), &mut there);
    for page in ["docs/ARCHITECTURE.md", "CONTRIBUTING.md"] {
        let text = std::fs::read_to_string(root().join(page)).unwrap();
        let prose: String = text.split("```").step_by(2).collect();
        let named: Vec<&str> = prose.split('`').skip(1).step_by(2).filter(|name| is_path(name)).collect();
        assert!(named.len() > 10, "{page} names {} files", named.len());
        for name in named {
            assert!(there.iter().any(|path| path.ends_with(name.trim_end_matches('/'))), "{page}: there is no `{name}`");
        }
    }
}

/// Whether a name in backticks is one of a file or a folder: `noise/rest.rs`, `effects/`, `order.toml`; not a schema, nor a file that a reader is to write.
fn is_path(name: &str) -> bool {
    let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || "_-./".contains(c));
    let other = name.starts_with("truegap.") || name.contains("my_");
    let ending = [".rs", ".toml", ".md", ".csv", ".json"].iter().any(|end| name.ends_with(end));
    plain && !other && (name.contains('/') || ending)
}

#[test]
fn every_page_has_one_title_and_a_short_summary() {
    // the contents of the guide have a heading for each of its parts
    for (path, text) in pages().into_iter().filter(|(path, _)| !path.ends_with("SUMMARY.md")) {
        let prose: String = text.split("```").step_by(2).collect();
        assert_eq!(prose.lines().filter(|line| line.starts_with("# ")).count(), 1, "{}", path.display());
        let first_heading = prose.lines().position(|line| line.starts_with("## ")).unwrap_or(usize::MAX);
        assert!(first_heading <= 2 * SUMMARY, "{}: the first section begins in line {first_heading}", path.display());
    }
}

#[test]
fn the_readme_is_short() {
    let lines = std::fs::read_to_string(root().join("README.md")).unwrap().lines().count();
    assert!(lines <= 70, "README.md has {lines} lines");
}
