//! Error over unknowns and time, as CSV: uniform, graded and adaptive meshes, linear and quadratic elements.
//!
//! `cargo run -p truegap-fem --example convergence > validation/verification/convergence.csv`; the plots are made from it by
//! `validation/verification/plots.py`. Two problems with a singular rim and a reference that truegap did not make: the disc capacitor
//! in open space (Love's equation) and the bonded rubber disc (hp finite elements of another program). Seconds are processor seconds of
//! all threads.

#[path = "common/clock.rs"]
mod clock;

use clock::Clock;
use std::error::Error;
use truegap_fem::elasticity::{self, Formulation, solve_goals, solve_goals_adaptive};
use truegap_fem::electrostatics::{self, Order, VACUUM_PERMITTIVITY, solve_adaptive, solve_on_with};
use truegap_fem::mesh::{Geometry, Mesh, MeshOptions, SizeField, mesh_geometry};
use truegap_fem::problems::{
    DISC_CAPACITOR, RUBBER_DISC, RUBBER_SIZE, disc_capacitor_geometry, disc_capacitor_mesh, disc_capacitor_problem,
    rubber_disc_geometry, rubber_disc_mesh, rubber_disc_problem,
};

const SIZES: [usize; 5] = [2_000, 8_000, 30_000, 120_000, 480_000];
const TARGETS: [f64; 6] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7];

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    println!("problem,elements,mesh,unknowns,seconds,relative_error,relative_estimate");
    for order in [Order::Linear, Order::Quadratic] {
        for size in SIZES {
            disc(order, "uniform", &uniform(&disc_capacitor_geometry(), 50.0, triangles(order, size))?)?;
            if order == Order::Quadratic {
                disc(order, "graded", &disc_capacitor_mesh(size)?)?;
            }
        }
        let reachable = if order == Order::Linear { 3 } else { 6 };
        TARGETS[..reachable].iter().try_for_each(|&target| adaptive_disc(order, target))?;
    }
    for size in SIZES {
        rubber("uniform", uniform(&rubber_disc_geometry(), RUBBER_SIZE[0] * RUBBER_SIZE[1], size / 4)?)?;
        rubber("graded", rubber_disc_mesh(size)?)?;
    }
    TARGETS[..5].iter().try_for_each(|&target| adaptive_rubber(target))
}

/// Triangles of one size on a body of a given area (m^2).
fn uniform(geometry: &Geometry, area: f64, triangles: usize) -> Outcome<Mesh> {
    let edge = (area / (0.433 * triangles as f64)).sqrt();
    Ok(mesh_geometry(geometry, &MeshOptions { size: SizeField::uniform(edge), ..MeshOptions::default() })?)
}

/// Triangles of a mesh with `unknowns` nodes: a corner has two triangles, a quadratic node half of one.
fn triangles(order: Order, unknowns: usize) -> usize {
    match order {
        Order::Linear => 2 * unknowns,
        Order::Quadratic => unknowns / 2,
    }
}

fn print(what: [&str; 3], unknowns: usize, clock: &Clock, error: f64, estimate: f64) {
    let seconds = clock.seconds();
    println!("{},{unknowns},{seconds:.4},{:.3e},{estimate:.3e}", what.join(","), error.abs());
}

fn name(order: Order) -> &'static str {
    match order {
        Order::Linear => "linear",
        Order::Quadratic => "quadratic",
    }
}

fn disc(order: Order, kind: &str, mesh: &Mesh) -> Outcome<()> {
    let (problem, goals) = disc_capacitor_problem();
    let clock = Clock::start();
    let found = solve_on_with(&problem, &goals, mesh, order)?;
    print_disc(order, kind, &clock, &found);
    Ok(())
}

fn adaptive_disc(order: Order, target: f64) -> Outcome<()> {
    let (problem, goals) = disc_capacitor_problem();
    let clock = Clock::start();
    let mut mesh = mesh_geometry(&disc_capacitor_geometry(), &MeshOptions::default())?;
    let accuracy = electrostatics::Accuracy { target, order, ..Default::default() };
    print_disc(order, "adaptive", &clock, &solve_adaptive(&problem, &goals, &mut mesh, &accuracy)?);
    Ok(())
}

fn print_disc(order: Order, kind: &str, clock: &Clock, found: &electrostatics::Outcome) {
    let answer = &found.answers[0];
    let error = answer.value / VACUUM_PERMITTIVITY / DISC_CAPACITOR - 1.0;
    print(["disc capacitor", name(order), kind], found.unknowns, clock, error, answer.relative_error_estimate());
}

fn rubber(kind: &str, mesh: Mesh) -> Outcome<()> {
    let clock = Clock::start();
    let (problem, goals) = rubber_disc_problem(mesh, Formulation::suited(0.49));
    print_rubber(kind, &clock, &solve_goals(&problem, &goals)?);
    Ok(())
}

fn adaptive_rubber(target: f64) -> Outcome<()> {
    let clock = Clock::start();
    let mesh = mesh_geometry(&rubber_disc_geometry(), &MeshOptions::default())?;
    let (mut problem, goals) = rubber_disc_problem(mesh, Formulation::suited(0.49));
    let accuracy = elasticity::Accuracy { target, ..Default::default() };
    print_rubber("adaptive", &clock, &solve_goals_adaptive(&mut problem, &goals, &accuracy)?);
    Ok(())
}

fn print_rubber(kind: &str, clock: &Clock, found: &elasticity::Outcome) {
    let answer = &found.answers[0];
    let exact = -RUBBER_DISC * std::f64::consts::PI * RUBBER_SIZE[0] * RUBBER_SIZE[0] * 1e-3 * 1e6;
    let unknowns = found.solution.body().numbering.free.len();
    let error = answer.value / exact - 1.0;
    print(["rubber disc", "quadratic mixed", kind], unknowns, clock, error, answer.relative_error_estimate());
}
