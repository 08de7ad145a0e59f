//! What the committed tables give, their ranges and their measured accuracy, as a Markdown table.
//!
//! `cargo run -p truegap-audit --example corrections_table`

use truegap_audit::corrections::{Axis, library};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let all = library()?;
    println!("| table | gives | range | largest relative error between nodes |\n|---|---|---|---|");
    for table in [&all.bead_load, &all.held_expansion, &all.cell_field, &all.heated_field, &all.rim_field, &all.tail_edge] {
        let range = |axis: &Axis| format!("{} {} to {}", axis.name, axis.low, axis.high);
        let ranges: Vec<String> = table.axes.iter().map(range).collect();
        println!(
            "| `{}` | {} | {} | {:.1e} at {} points |",
            table.id,
            table.says,
            ranges.join("; "),
            table.accuracy,
            table.checked_at
        );
    }
    Ok(())
}
