//! Finite elements: meshing, bisecting, pattern, assembly, analysis, factorisation, re-factorisation, solve and the whole, over the unknowns.
//!
//! Run: `cargo bench -p truegap-benches --bench fem`. The problem is the disc capacitor of `truegap_fem::problems`; sizes
//! are 50 k, 200 k and 1 M unknowns (`TRUEGAP_BENCH_UNKNOWNS=50000` for one of them).

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use truegap_fem::FemError;
use truegap_fem::algebra::Pattern;
use truegap_fem::algebra::{Direct, Kind};
use truegap_fem::electrostatics::{Accuracy, solve_adaptive, solve_on};
use truegap_fem::mesh::bisect;
use truegap_fem::mesh::{MeshOptions, SizeField, Topology, mesh_geometry};
use truegap_fem::problems::{DiscSystem, disc_capacitor_geometry, disc_capacitor_mesh, disc_capacitor_problem};

fn sizes() -> Vec<usize> {
    let asked = std::env::var("TRUEGAP_BENCH_UNKNOWNS").ok().and_then(|n| n.parse().ok());
    asked.map_or_else(|| vec![50_000, 200_000, 1_000_000], |n| vec![n])
}

fn meshing(c: &mut Criterion) {
    let mut group = c.benchmark_group("meshing");
    group.sample_size(10);
    for unknowns in sizes() {
        // An area of 50 m^2 in equilateral triangles of two unknowns each.
        let edge = (50.0 / (0.433 * unknowns as f64 / 2.0)).sqrt();
        let options = MeshOptions { size: SizeField::uniform(edge), ..MeshOptions::default() };
        group.bench_function(BenchmarkId::new("triangulate by size", unknowns), |b| {
            b.iter(|| mesh_geometry(&disc_capacitor_geometry(), black_box(&options)))
        });
    }
    group.finish();
}

fn steps(c: &mut Criterion) {
    for unknowns in sizes() {
        if let Err(e) = steps_at(c, unknowns) {
            eprintln!("{unknowns} unknowns: {e}");
        }
    }
}

fn steps_at(c: &mut Criterion, unknowns: usize) -> Result<(), FemError> {
    let mut group = c.benchmark_group("steps");
    group.sample_size(10);
    let mesh = disc_capacitor_mesh(unknowns)?;
    let topology = Topology::new(&mesh);
    let every_fifth: Vec<bool> = (0..mesh.triangles.len()).map(|t| t % 5 == 0).collect();
    group.bench_function(BenchmarkId::new("bisect a fifth", unknowns), |b| {
        b.iter(|| bisect(&mesh, &topology, black_box(&every_fifth)))
    });
    let system = DiscSystem::new(&mesh);
    group.bench_function(BenchmarkId::new("pattern", unknowns), |b| b.iter(|| Pattern::new(&system.dofs, &system.numbering)));
    let pattern = Pattern::new(&system.dofs, &system.numbering)?;
    let mut matrix = pattern.matrix();
    group.bench_function(BenchmarkId::new("assemble", unknowns), |b| {
        b.iter(|| pattern.assemble(&mut matrix, |e, out| system.element(e, out)))
    });
    group.bench_function(BenchmarkId::new("analyse and factorise", unknowns), |b| b.iter(|| Direct::new(&matrix, Kind::Llt)));
    let mut direct = Direct::new(&matrix, Kind::Llt)?;
    group.bench_function(BenchmarkId::new("factorise again", unknowns), |b| b.iter(|| direct.factorise(&matrix)));
    let rhs: Vec<f64> = (0..pattern.size()).map(|i| (i % 17) as f64 - 8.0).collect();
    group.bench_function(BenchmarkId::new("solve", unknowns), |b| b.iter(|| direct.solve(&matrix, black_box(&rhs))));
    let (problem, goals) = disc_capacitor_problem();
    group.bench_function(BenchmarkId::new("whole solve with estimate", unknowns), |b| {
        b.iter(|| solve_on(&problem, &goals, &mesh))
    });
    group.finish();
    Ok(())
}

fn adaptive(c: &mut Criterion) {
    let mut group = c.benchmark_group("adaptive");
    group.sample_size(10);
    let (problem, goals) = disc_capacitor_problem();
    for target in [1e-4, 1e-6] {
        group.bench_function(BenchmarkId::new("disc capacitor to", format!("{target:.0e}")), |b| {
            b.iter(|| {
                let mut mesh = mesh_geometry(&disc_capacitor_geometry(), &MeshOptions::default())?;
                solve_adaptive(&problem, &goals, &mut mesh, &Accuracy { target, ..Accuracy::default() })
            })
        });
    }
    group.finish();
}

criterion_group!(benches, meshing, steps, adaptive);
criterion_main!(benches);
