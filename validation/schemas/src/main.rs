//! Writes docs/schemas: `cargo run -p truegap-schemas`.

use std::path::Path;
use std::process::ExitCode;
use truegap_schemas::{Index, SchemaError, written};

fn main() -> ExitCode {
    match write() {
        Ok(count) => {
            println!("{count} schemas written to docs/schemas");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn write() -> Result<usize, SchemaError> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let all = written(&Index::of(&workspace)?, &workspace)?;
    for (name, text) in &all {
        let file = workspace.join("docs/schemas").join(format!("{name}.json"));
        std::fs::write(&file, text).map_err(|source| SchemaError::File { file, source })?;
    }
    Ok(all.len())
}
