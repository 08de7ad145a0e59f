//! Time and memory of every step on the disc capacitor (d/a = 0.1), over the number of unknowns, as CSV.
//!
//! `cargo run -p truegap-fem --example scaling [UNKNOWNS...] > validation/verification/scaling.csv`; the plots are made from it by
//! `validation/verification/plots.py`. Seconds are wall-clock.

use std::time::Instant;
use truegap_fem::physics::electrostatics::{Solved, VACUUM_PERMITTIVITY, estimate_pairs};
use truegap_fem::problems::{DISC_CAPACITOR, disc_capacitor_mesh, disc_capacitor_problem};

const SIZES: [usize; 8] = [5_000, 10_000, 20_000, 50_000, 100_000, 200_000, 500_000, 1_000_000];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let asked: Vec<usize> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let sizes = if asked.is_empty() { SIZES.to_vec() } else { asked };
    let (problem, _) = disc_capacitor_problem();
    println!("unknowns,mesh_s,assemble_s,solve_s,estimate_s,factor_mb,relative_error");
    for size in sizes {
        let begin = Instant::now();
        let mesh = disc_capacitor_mesh(size)?;
        let meshing = begin.elapsed().as_secs_f64();
        let solved = Solved::new(&problem, &mesh)?;
        let c = solved.capacitance_matrix();
        let error = 0.5 * (c[0][0] - c[0][1]) / VACUUM_PERMITTIVITY / DISC_CAPACITOR - 1.0;
        let begin = Instant::now();
        estimate_pairs(&solved, &[&solved.units[0], &solved.potential], &[(0, 1)]);
        let estimate = begin.elapsed().as_secs_f64();
        let (s, megabytes) = (solved.seconds, solved.memory().bytes as f64 / 1e6);
        let unknowns = solved.unknowns();
        println!("{unknowns},{meshing:.4},{:.4},{:.4},{estimate:.4},{megabytes:.1},{error:.3e}", s.assemble, s.solve);
    }
    Ok(())
}
