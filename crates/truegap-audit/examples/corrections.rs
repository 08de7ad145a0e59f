//! Computes the tables of corrections and writes them to `tables/`, with the accuracy measured between their nodes.
//!
//! `cargo run -p truegap-audit --example corrections [NAME...]` (minutes; all tables where none is named)

use std::path::Path;
use std::time::Instant;
use truegap_audit::corrections::MAKERS;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    println!("| table | coefficients | largest relative error between nodes | points checked | seconds |\n|---|---|---|---|---|");
    for (name, compute) in MAKERS.into_iter().filter(|(name, _)| wanted.is_empty() || wanted.iter().any(|w| w == name)) {
        let begin = Instant::now();
        let mut table = compute()?;
        table.command = format!("cargo run -p truegap-audit --example corrections {name}");
        // nine digits are more than the finite elements have
        table.coefficients.iter_mut().for_each(|c| *c = format!("{c:.9e}").parse().unwrap_or(*c));
        table.accuracy = format!("{:.1e}", table.accuracy).parse()?;
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tables").join(format!("{name}.toml"));
        std::fs::write(file, toml::to_string(&table)?)?;
        let seconds = begin.elapsed().as_secs_f64();
        println!("| {name} | {} | {:.1e} | {} | {seconds:.0} |", table.coefficients.len(), table.accuracy, table.checked_at);
    }
    Ok(())
}
