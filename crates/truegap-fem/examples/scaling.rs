//! Time and memory of every step on the disc capacitor (d/a = 0.1), over the number of unknowns, as CSV.
//!
//! `cargo run -p truegap-fem --example scaling [UNKNOWNS...] > validation/verification/scaling.csv`; the plots are made from it by
//! `validation/verification/plots.py`. Seconds are processor seconds of all threads; `whole_s` is a solve with its error estimate.

#[path = "common/clock.rs"]
mod clock;

use clock::Clock;
use std::error::Error;
use truegap_fem::algebra::Pattern;
use truegap_fem::algebra::{Direct, Kind};
use truegap_fem::electrostatics::{VACUUM_PERMITTIVITY, solve_on};
use truegap_fem::problems::{DISC_CAPACITOR, DiscSystem, disc_capacitor_mesh, disc_capacitor_problem};

const SIZES: [usize; 8] = [5_000, 10_000, 20_000, 50_000, 100_000, 200_000, 500_000, 1_000_000];

fn main() -> Result<(), Box<dyn Error>> {
    let asked: Vec<usize> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    println!("unknowns,mesh_s,pattern_s,assemble_s,analyse_s,factorise_s,solve_s,whole_s,solver_mb,relative_error");
    if asked.is_empty() { SIZES.to_vec() } else { asked }.into_iter().try_for_each(row)
}

fn row(size: usize) -> Result<(), Box<dyn Error>> {
    let mut seconds = Vec::new();
    let mesh = timed(&mut seconds, || disc_capacitor_mesh(size))?;
    let system = DiscSystem::new(&mesh);
    let (mut matrix, scatter) = timed(&mut seconds, || Pattern::new(&system.dofs, &system.numbering))?.into_matrix();
    timed(&mut seconds, || scatter.assemble(&mut matrix, |e, out| system.element(e, out)));
    let mut direct = timed(&mut seconds, || Direct::analyse(&matrix, Kind::Llt))?;
    timed(&mut seconds, || direct.factorise(&matrix))?;
    let rhs: Vec<f64> = (0..matrix.ncols()).map(|i| (i % 17) as f64 - 8.0).collect();
    timed(&mut seconds, || direct.solve(&matrix, &rhs))?;
    let megabytes = direct.memory().bytes as f64 / 1e6;
    drop((direct, matrix, scatter, system));
    let (problem, goals) = disc_capacitor_problem();
    let found = timed(&mut seconds, || solve_on(&problem, &goals, &mesh))?;
    let error = found.answers[0].value / VACUUM_PERMITTIVITY / DISC_CAPACITOR - 1.0;
    let seconds: Vec<String> = seconds.iter().map(|s| format!("{s:.4}")).collect();
    println!("{},{},{megabytes:.1},{error:.3e}", found.unknowns, seconds.join(","));
    Ok(())
}

fn timed<T>(seconds: &mut Vec<f64>, work: impl FnOnce() -> T) -> T {
    let clock = Clock::start();
    let out = work();
    seconds.push(clock.seconds());
    out
}
