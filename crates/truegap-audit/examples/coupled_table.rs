//! Baseline, span and drift of the coupled disc beside those of the analytic model, as a Markdown table.
//!
//! `cargo run -p truegap-audit --example coupled_table` (some minutes)

use truegap_audit::disc::{Beads, CornerCoefficients, CoupledOptions, Whole, corner_coefficients};
use truegap_audit::{AuditError, Options, Study, Swap, Watch};
use truegap_core::Sensor;
use truegap_core::sensor::builtin_sensor;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("| sensor | route | baseline, pF | span, pF | K_baseline, %FSR/K | K_sensitivity, %/K |");
    println!("|---|---|---|---|---|---|");
    for name in ["singletact-s15-4.5n", "singletact-s15-4.5n-stiffening", "singletact-s8-optimised"] {
        let sensor = builtin_sensor(name).ok_or("no such sensor")??;
        let bare = Sensor { plating: None, ..sensor.clone() };
        analytic(name, "analytic model", &sensor)?;
        analytic(name, "analytic model without warp", &bare)?;
        coupled(name, "coupled, beads that spread and expand freely", &sensor, false)?;
        coupled(name, "coupled, the same without plating: no warp", &bare, false)?;
        coupled(name, "coupled, beads bonded to both plates", &sensor, true)?;
    }
    Ok(())
}

fn analytic(name: &str, route: &str, sensor: &Sensor) -> Result<(), AuditError> {
    let watch = Watch::default();
    let study = Study::new(sensor, Options::default(), &watch)?;
    let chain = study.chain(Swap::none());
    print(name, route, &corner_coefficients(&|force, celsius| chain.capacitance_pf(force, celsius), study.corners())?);
    Ok(())
}

fn coupled(name: &str, route: &str, sensor: &Sensor, bonded: bool) -> Result<(), AuditError> {
    let watch = Watch::default();
    let study = Study::new(sensor, Options::default(), &watch)?;
    let beads = if bonded { Beads::bonded(&study)? } else { Beads::free(sensor, &study.device) };
    let whole = Whole::new(sensor, &study.device, beads, CoupledOptions::default())?;
    print(name, route, &whole.coefficients(&study)?);
    Ok(())
}

fn print(name: &str, route: &str, c: &CornerCoefficients) {
    let [b, s, kb, ks] = [c.baseline_pf, c.span_pf, c.k_baseline_pct_fsr_per_k, c.k_sensitivity_pct_per_k];
    println!("| {name} | {route} | {b:.4} | {s:.4} | {kb:.4} | {ks:.4} |");
}
