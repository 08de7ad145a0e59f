//! Writes the tables of the pages from the result files; exit code 0 (done), 1 (`check` found a difference) or 2 (could not be done).

use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};
use truegap_tables::{REAL, TablesError, collect, pages};

const HELP: &str = "truegap-tables [check | collect DIR]

Writes the tables between `<!-- table: NAME -->` and `<!-- end -->` in README.md, docs/*.md and docs/guide/*.md from the result files of this repository.
  check        writes nothing; names the pages that differ, exit code 1 if any does
  collect DIR  writes validation/recordings/real.json from DIR/*/diagnosis.json, then the tables; a folder is named as its recording, `foam-insole--hold`";

fn main() -> ExitCode {
    let root = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words.as_slice() {
        [] => write(&root),
        ["check"] => check(&root),
        ["collect", dir] => gather(&root, Path::new(dir)).and_then(|()| write(&root)),
        other => {
            println!("{HELP}");
            return ExitCode::from(if matches!(other, ["-h" | "--help"]) { 0 } else { 2 });
        }
    };
    done.unwrap_or_else(|error| {
        eprintln!("error: {error}");
        ExitCode::from(2)
    })
}

fn gather(root: &Path, dir: &Path) -> Result<(), TablesError> {
    let real = collect(dir)?;
    real.write(root)?;
    println!("{REAL}: {} recordings", real.recordings.len());
    Ok(())
}

fn write(root: &Path) -> Result<ExitCode, TablesError> {
    for page in pages(root)?.iter().filter(|page| page.differs()) {
        page.write()?;
        println!("{} written", name(root, &page.path));
    }
    Ok(ExitCode::SUCCESS)
}

fn check(root: &Path) -> Result<ExitCode, TablesError> {
    let pages = pages(root)?;
    let differing: Vec<_> = pages.iter().filter(|page| page.differs()).collect();
    differing.iter().for_each(|page| println!("{} differs; write it again: cargo run -p truegap-tables", name(root, &page.path)));
    Ok(ExitCode::from(u8::from(!differing.is_empty())))
}

/// A page as a reader calls it.
fn name(root: &Path, page: &Path) -> String {
    page.strip_prefix(root).unwrap_or(page).display().to_string()
}
