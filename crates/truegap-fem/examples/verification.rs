//! Solves every case that has a reference and prints the comparison as a Markdown page.
//!
//! `cargo run -p truegap-fem --example verification [NAME]` (NAME: only cases whose name contains it); the page is
//! `validation/verification/finite_elements.md`.

use serde::Deserialize;
use std::error::Error;
use std::path::Path;
use truegap_fem::case::{QuantityValue, read_case, solve_case};
use truegap_fem::electrostatics::VACUUM_PERMITTIVITY;

/// Files of references in `validation/verification` and their titles.
const FILES: [(&str, &str); 3] = [
    ("references_electrostatics", "Electrostatics"),
    ("references_elasticity", "Elasticity"),
    ("references_independent", "Cases on which the estimates were never tuned"),
];

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
    trusted: f64,
    source: String,
}

/// What the rows of a section have in common.
#[derive(Default)]
struct Tally {
    rows: usize,
    judged: usize,
    outside: Vec<String>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let filter = std::env::args().nth(1).unwrap_or_default();
    println!("# Finite elements against references that they did not make\n");
    println!(
        "Effectivity is the estimated over the true error; 0.5 to 3 is asked. There is a dash where the reference has not the"
    );
    println!("digits to tell, or where rounding decides. Seconds are wall-clock, all adaptive levels together.");
    for (file, title) in FILES {
        let text = std::fs::read_to_string(root.join(format!("validation/verification/{file}.toml")))?;
        let references: References = toml::from_str(&text)?;
        section(&root, title, &references, &filter)?;
    }
    println!(
        "\nMade by `cargo run -p truegap-fem --example verification`; one row by `truegap solve meshes/cases/CASE.toml --json`."
    );
    Ok(())
}

fn section(root: &Path, title: &str, references: &References, filter: &str) -> Result<(), Box<dyn Error>> {
    println!("\n## {title}\n");
    println!(
        "| case | quantity | reference | computed | relative error | estimate | effectivity | unknowns | seconds | source of the reference |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    let mut names: Vec<&str> = references.reference.iter().map(|r| r.case.as_str()).collect();
    names.dedup();
    let mut tally = Tally::default();
    for name in names.into_iter().filter(|n| n.contains(filter)) {
        print_case(root, name, references.reference.iter().filter(|r| r.case == name), &mut tally)?;
    }
    let inside = tally.judged - tally.outside.len();
    println!("\n{} quantities, {} with an effectivity, {inside} of them from 0.5 to 3.", tally.rows, tally.judged);
    if !tally.outside.is_empty() {
        println!("Outside: {}.", tally.outside.join("; "));
    }
    Ok(())
}

fn print_case<'a>(
    root: &Path,
    name: &str,
    references: impl Iterator<Item = &'a Reference>,
    tally: &mut Tally,
) -> Result<(), Box<dyn Error>> {
    let path = root.join("meshes/cases").join(format!("{name}.toml"));
    let case = read_case(&std::fs::read_to_string(&path)?, &format!("meshes/cases/{name}.toml"))?;
    let result = solve_case(&case)?;
    let seconds = result.seconds.mesh + result.seconds.assemble + result.seconds.solve;
    for r in references {
        let exact = r.value * r.length * if r.eps0 { VACUUM_PERMITTIVITY } else { 1.0 };
        let q = result.quantity(&r.quantity).ok_or_else(|| format!("{name} has no output {}", r.quantity))?;
        println!(
            "| {name} | {} ({}) | {exact:.10e} | {:.10e} | {:.1e} | {:.1e} | {} | {} | {seconds:.2} | {} |",
            r.quantity,
            q.unit,
            q.value,
            q.value / exact - 1.0,
            q.error_estimate / exact.abs(),
            effectivity(name, r, q, exact, tally),
            result.mesh.unknowns,
            r.source
        );
    }
    Ok(())
}

/// Effectivity as text, counted in the tally.
fn effectivity(name: &str, r: &Reference, q: &QuantityValue, exact: f64, tally: &mut Tally) -> String {
    tally.rows += 1;
    let error = (q.value - exact).abs();
    if error / exact.abs() <= (10.0 * r.trusted).max(1e-11) {
        return "-".into();
    }
    tally.judged += 1;
    let effectivity = q.error_estimate / error;
    if !(0.5..=3.0).contains(&effectivity) {
        tally.outside.push(format!("{name}, {}: {effectivity:.2}", r.quantity));
    }
    format!("{effectivity:.2}")
}
