//! K_baseline with every way of treating the warp, for every built-in sensor that warps, as a Markdown table.
//!
//! `cargo run -p truegap-audit --example warp_table`

use truegap_audit::disc::{Baseline, DATA_SHEET_PCT_FSR_PER_K, baselines};
use truegap_audit::{AuditError, Options, Study, Watch};
use truegap_core::Sensor;
use truegap_core::sensor::builtin_sensors;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "| sensor | electrode | rim above centre at 50 degC, um | K_baseline, %FSR/K | against {DATA_SHEET_PCT_FSR_PER_K} | K_sensitivity, %/K |"
    );
    println!("|---|---|---|---|---|---|");
    for built_in in builtin_sensors() {
        let sensor = built_in.sensor()?;
        if sensor.plating.is_none() {
            continue;
        }
        match rows(&sensor) {
            Ok(rows) => rows.iter().for_each(|row| print(built_in.name, row)),
            Err(error) => println!("| {} | {error} | | | | |", built_in.name),
        }
    }
    Ok(())
}

fn rows(sensor: &Sensor) -> Result<Vec<Baseline>, AuditError> {
    let watch = Watch::default();
    baselines(&Study::new(sensor, Options::default(), &watch)?)
}

fn print(sensor: &str, row: &Baseline) {
    let [a, b] = row.sag_um;
    let sag = if a == b { format!("{a:.2}") } else { format!("{a:.2} and {b:.2}") };
    let k = row.coefficients.k_baseline_pct_fsr_per_k;
    // The data sheet's value is that of the 15 mm part.
    let off = 100.0 * (k / DATA_SHEET_PCT_FSR_PER_K - 1.0);
    let off = if sensor.starts_with("singletact-s15") { format!("{off:+.0} %") } else { "-".into() };
    println!("| {sensor} | {} | {sag} | {k:.4} | {off} | {:.4} |", row.says, row.coefficients.k_sensitivity_pct_per_k);
}
