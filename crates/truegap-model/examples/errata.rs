//! Prints the paper's printed equations against the corrected ones: `cargo run -p truegap-model --example errata`.

fn main() -> Result<(), truegap_core::SimulationError> {
    print!("{}", truegap_model::errata_table()?);
    Ok(())
}
