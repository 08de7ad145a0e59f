//! Solves every case that has a reference and prints the comparison as a Markdown table.
//!
//! `cargo run --release -p truegap-fem --example verification [NAME]` (NAME: only cases whose name contains it)

use serde::Deserialize;
use std::path::{Path, PathBuf};
use truegap_fem::case::{read_case, solve_case};

#[derive(Deserialize)]
struct References {
    reference: Vec<Reference>,
}

#[derive(Deserialize)]
struct Reference {
    case: String,
    quantity: String,
    value: f64,
    #[serde(default)]
    eps0: bool,
    length: f64,
    source: String,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let filter = std::env::args().nth(1).unwrap_or_default();
    println!(
        "| case | quantity | reference | computed | relative error | estimate | effectivity | unknowns | seconds | source of the reference |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for file in reference_files(&root.join("validation/verification"))? {
        let references: References = toml::from_str(&std::fs::read_to_string(file)?)?;
        let mut names: Vec<&str> = references.reference.iter().map(|r| r.case.as_str()).collect();
        names.dedup();
        for name in names.into_iter().filter(|n| n.contains(&filter)) {
            print_case(&root, name, references.reference.iter().filter(|r| r.case == name))?;
        }
    }
    println!(
        "\nMade by `cargo run --release -p truegap-fem --example verification`; one row by `truegap solve meshes/cases/CASE.toml --json`."
    );
    Ok(())
}

fn reference_files(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)?.filter_map(|e| Some(e.ok()?.path())).collect();
    files.retain(|p| p.file_name().is_some_and(|n| n.to_string_lossy().starts_with("references")));
    files.sort();
    Ok(files)
}

fn print_case<'a>(
    root: &Path,
    name: &str,
    references: impl Iterator<Item = &'a Reference>,
) -> Result<(), Box<dyn std::error::Error>> {
    let path = root.join("meshes/cases").join(format!("{name}.toml"));
    let case = read_case(&std::fs::read_to_string(&path)?, &format!("meshes/cases/{name}.toml"))?;
    let result = solve_case(&case)?;
    let seconds = result.seconds.mesh + result.seconds.assemble + result.seconds.solve;
    for r in references {
        let exact = r.value * r.length * if r.eps0 { truegap_fem::physics::electrostatics::VACUUM_PERMITTIVITY } else { 1.0 };
        let q = result.quantity(&r.quantity).ok_or_else(|| format!("{name} has no output {}", r.quantity))?;
        let error = q.value / exact - 1.0;
        // Below this the reference and rounding decide, not the mesh.
        let effectivity =
            if error.abs() > 1e-11 { format!("{:.2}", q.error_estimate / (q.value - exact).abs()) } else { "-".into() };
        println!(
            "| {name} | {} ({}) | {exact:.10e} | {:.10e} | {error:.1e} | {:.1e} | {effectivity} | {} | {seconds:.2} | {} |",
            r.quantity,
            q.unit,
            q.value,
            q.error_estimate / exact.abs(),
            result.mesh.unknowns,
            r.source
        );
    }
    Ok(())
}
