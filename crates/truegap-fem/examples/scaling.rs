//! Time and memory of every step on the disc capacitor (d/a = 0.1), over the number of unknowns, as a Markdown table.
//!
//! `cargo run --release -p truegap-fem --example scaling [UNKNOWNS...]`

use std::time::Instant;
use truegap_fem::physics::electrostatics::{Accuracy, Solved, VACUUM_PERMITTIVITY, estimate_pairs, solve_adaptive};
use truegap_fem::problems::{DISC_CAPACITOR, disc_capacitor_geometry, disc_capacitor_mesh, disc_capacitor_problem};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let asked: Vec<usize> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let sizes = if asked.is_empty() { vec![50_000, 200_000, 1_000_000] } else { asked };
    let (problem, goals) = disc_capacitor_problem();
    println!("| unknowns | mesh s | assemble s | factorise, solve s | estimate s | factor MB | relative error |");
    println!("|---|---|---|---|---|---|---|");
    for size in sizes {
        let begin = Instant::now();
        let mesh = disc_capacitor_mesh(size)?;
        let meshing = begin.elapsed().as_secs_f64();
        let solved = Solved::new(&problem, &mesh)?;
        let c = solved.capacitance_matrix();
        let value = 0.5 * (c[0][0] - c[0][1]) / VACUUM_PERMITTIVITY;
        let begin = Instant::now();
        estimate_pairs(&solved, &[&solved.units[0], &solved.potential], &[(0, 1)]);
        let estimate = begin.elapsed().as_secs_f64();
        println!(
            "| {} | {meshing:.3} | {:.3} | {:.3} | {estimate:.3} | {} | {:.2e} |",
            solved.unknowns(),
            solved.seconds.assemble,
            solved.seconds.solve,
            solved.memory().bytes / 1_000_000,
            value / DISC_CAPACITOR - 1.0
        );
    }
    println!("\n| target | unknowns | levels | seconds | relative error |\n|---|---|---|---|---|");
    for target in [1e-3, 1e-4, 1e-5, 1e-6] {
        let begin = Instant::now();
        let mut mesh = truegap_fem::mesh::mesh_geometry(&disc_capacitor_geometry(), &Default::default())?;
        let outcome = solve_adaptive(&problem, &goals, &mut mesh, &Accuracy { target, ..Accuracy::default() })?;
        let error = outcome.answers[0].value / VACUUM_PERMITTIVITY / DISC_CAPACITOR - 1.0;
        println!(
            "| {target:.0e} | {} | {} | {:.3} | {error:.2e} |",
            outcome.unknowns,
            outcome.levels,
            begin.elapsed().as_secs_f64()
        );
    }
    Ok(())
}
