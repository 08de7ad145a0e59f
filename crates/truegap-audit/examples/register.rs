//! The register for the three sensors of the paper, as the Markdown table of `docs/audit.md`: verdict, how far off, effect on K_baseline and K_sensitivity.
//!
//! `cargo run -p truegap-audit --example register` (half a minute)

use truegap_audit::{Audit, Cache, Finding, Options, Watch, register, run};
use truegap_core::sensor::builtin_sensors;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut audits: Vec<Audit> = Vec::new();
    for built_in in builtin_sensors().iter().take(3) {
        audits.push(run(&built_in.sensor()?, &register(), Options::default(), &Cache::none(), &Watch::default())?);
    }
    let names: Vec<&str> = audits.iter().map(|a| a.sensor.as_str()).collect();
    println!("| assumption | {} |", names.join(" | "));
    println!("|---|{}", "---|".repeat(names.len()));
    for assumption in register() {
        let cells: Vec<String> =
            audits.iter().map(|audit| cell(audit.assumptions.iter().find(|f| f.id == assumption.id()))).collect();
        println!("| `{}` | {} |", assumption.id(), cells.join(" | "));
    }
    Ok(())
}

fn cell(finding: Option<&Finding>) -> String {
    let Some(f) = finding else { return "-".into() };
    let [_, span, k_baseline, k_sensitivity, _] =
        f.effect_on.values().map(|v| v.map_or_else(|| "-".to_owned(), |v| format!("{v:+.1}")));
    let verdict = format!("{:?}", f.verdict).to_lowercase();
    format!("{verdict}: {:.4} against {:.4} {}; {span}, {k_baseline}, {k_sensitivity}", f.analytic.value, f.fem.value, f.fem.unit)
}
