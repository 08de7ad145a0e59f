//! truegap's part in the comparison with other programs (`validation/peers/fem.py`): meshes for all of them, and its own times.
//!
//! `cargo run -p truegap-fem --example beside_peers mesh disc|rubber graded|uniform UNKNOWNS FILE.msh` writes a mesh;
//! `... solve disc|rubber FILE.msh` solves on it, walls without field, displacements only, as the others do;
//! `... adapt disc|rubber TARGET` refines for itself, open space and mixed rubber, from the drawing to the answer;
//! `... hp disc|rubber TARGET` does the same by the hp version, rubber by displacements alone.
//! The last three print a line of JSON: seconds of processor time (`seconds`) and of wall clock, the largest memory of the process.

#[path = "common/clock.rs"]
mod clock;

use clock::Clock;
use std::error::Error;
use std::fs;
use std::io::BufWriter;
use truegap_fem::elasticity::{self, Component, Formulation, Solver};
use truegap_fem::electrostatics::{self, Solved, VACUUM_PERMITTIVITY};
use truegap_fem::io::{read_msh, write_msh};
use truegap_fem::mesh::{Geometry, Mesh, MeshOptions, SizeField, mesh_geometry};
use truegap_fem::problems::{
    RUBBER_SIZE, disc_capacitor_geometry, disc_capacitor_mesh, disc_capacitor_problem, rubber_disc_geometry, rubber_disc_mesh,
    rubber_disc_problem,
};

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["mesh", problem, kind, unknowns, file] => {
            let mesh = mesh(problem, kind, unknowns.parse()?)?;
            Ok(write_msh(&mut BufWriter::new(fs::File::create(file)?), &mesh)?)
        }
        ["solve", problem, file] => {
            let mesh = read_msh(&fs::read_to_string(file)?, file)?;
            match *problem {
                "disc" => solve_disc(&mesh),
                _ => solve_rubber(mesh),
            }
        }
        ["adapt", "disc", target] => adapt_disc(target.parse()?),
        ["adapt", _, target] => adapt_rubber(target.parse()?),
        ["hp", "disc", target] => hp_disc(target.parse()?),
        ["hp", _, target] => hp_rubber(target.parse()?),
        _ => Err("usage: mesh PROBLEM graded|uniform UNKNOWNS FILE | solve PROBLEM FILE | adapt|hp PROBLEM TARGET".into()),
    }
}

fn mesh(problem: &str, kind: &str, unknowns: usize) -> Outcome<Mesh> {
    Ok(match (problem, kind) {
        ("disc", "graded") => disc_capacitor_mesh(unknowns)?,
        ("disc", _) => uniform(&disc_capacitor_geometry(), 50.0, unknowns / 2)?,
        (_, "graded") => rubber_disc_mesh(unknowns)?,
        _ => uniform(&rubber_disc_geometry(), RUBBER_SIZE[0] * RUBBER_SIZE[1], unknowns / 4)?,
    })
}

/// Triangles of one size on a body of a given area (m^2).
fn uniform(geometry: &Geometry, area: f64, triangles: usize) -> Outcome<Mesh> {
    let edge = (area / (0.433 * triangles as f64)).sqrt();
    Ok(mesh_geometry(geometry, &MeshOptions { size: SizeField::uniform(edge), ..MeshOptions::default() })?)
}

fn solve_disc(mesh: &Mesh) -> Outcome<()> {
    let (mut problem, _) = disc_capacitor_problem();
    problem.open.clear();
    let clock = Clock::start();
    let solved = Solved::new(&problem, mesh)?;
    let value = 2.0 * solved.energy() / VACUUM_PERMITTIVITY;
    report(&clock, solved.unknowns(), 1, value);
    Ok(())
}

fn solve_rubber(mesh: Mesh) -> Outcome<()> {
    let (problem, _) = rubber_disc_problem(mesh, Formulation::Displacement);
    let clock = Clock::start();
    let mut solver = Solver::new(problem)?;
    let solution = solver.solve()?;
    let value = apparent(solution.reaction("top", Component::Second)?);
    report(&clock, solver.body().numbering.free.len(), 1, value);
    Ok(())
}

/// Apparent over true modulus for a force on the plate (N).
fn apparent(force: f64) -> f64 {
    let [radius, _] = RUBBER_SIZE;
    -force / (std::f64::consts::PI * radius * radius * 1e-3 * 1e6)
}

fn adapt_disc(target: f64) -> Outcome<()> {
    let (problem, goals) = disc_capacitor_problem();
    let clock = Clock::start();
    let mut mesh = mesh_geometry(&disc_capacitor_geometry(), &MeshOptions::default())?;
    let accuracy = electrostatics::Accuracy { target, ..Default::default() };
    let outcome = electrostatics::solve_adaptive(&problem, &goals, &mut mesh, &accuracy)?;
    report(&clock, outcome.unknowns, outcome.levels, outcome.answers[0].value / VACUUM_PERMITTIVITY);
    Ok(())
}

fn adapt_rubber(target: f64) -> Outcome<()> {
    let clock = Clock::start();
    let mesh = mesh_geometry(&rubber_disc_geometry(), &MeshOptions::default())?;
    let (mut problem, goals) = rubber_disc_problem(mesh, Formulation::suited(0.49));
    let accuracy = elasticity::Accuracy { target, ..Default::default() };
    let outcome = elasticity::solve_goals_adaptive(&mut problem, &goals, &accuracy)?;
    let unknowns = outcome.solution.body().numbering.free.len();
    report(&clock, unknowns, outcome.levels, apparent(outcome.answers[0].value));
    Ok(())
}

fn hp_disc(target: f64) -> Outcome<()> {
    let (problem, goals) = disc_capacitor_problem();
    let clock = Clock::start();
    let mesh = mesh_geometry(&disc_capacitor_geometry(), &MeshOptions::default())?;
    let found = electrostatics::solve_hp(&problem, &goals, &mesh, target)?;
    report(&clock, found.unknowns, found.levels, found.answers[0].value / VACUUM_PERMITTIVITY);
    Ok(())
}

fn hp_rubber(target: f64) -> Outcome<()> {
    let clock = Clock::start();
    let mesh = mesh_geometry(&rubber_disc_geometry(), &MeshOptions::default())?;
    let (problem, goals) = rubber_disc_problem(mesh, Formulation::suited(0.49));
    let found = elasticity::solve_hp(&problem, &goals, target)?;
    report(&clock, found.unknowns, found.levels, apparent(found.answers[0].value));
    Ok(())
}

/// Prints the line of a finished run.
fn report(clock: &Clock, unknowns: usize, levels: usize, value: f64) {
    let (seconds, wall) = (clock.seconds(), clock.wall());
    println!(
        "{{\"unknowns\": {unknowns}, \"value\": {value:?}, \"seconds\": {seconds:.4}, \"wall\": {wall:.4}, \"levels\": {levels}, \"peak_mb\": {}}}",
        peak_mb()
    );
}

/// Largest resident memory of this process so far (MB), 0 where the system does not tell.
fn peak_mb() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    line.and_then(|l| l.trim().trim_end_matches(" kB").parse::<u64>().ok()).unwrap_or(0) / 1000
}
