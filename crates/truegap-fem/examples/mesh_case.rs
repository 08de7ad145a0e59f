//! Meshes and solves a case: writes the last mesh as `.msh` and the field as `.vtu`.
//!
//! `cargo run --release -p truegap-fem --example mesh_case CASE.toml OUT` writes `OUT.msh` and `OUT.vtu`;
//! with a third argument `first`, the mesh before any refinement.

use std::fs::File;
use std::io::BufWriter;
use truegap_fem::case::{mesh_case, read_case, solve_case_with_fields};
use truegap_fem::io::{Field, write_msh, write_vtu};
use truegap_fem::mesh::Topology;
use truegap_fem::space::Nodes;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [case_file, out, ..] = arguments.as_slice() else {
        return Err("usage: mesh_case CASE.toml OUT [first]".into());
    };
    let case = read_case(&std::fs::read_to_string(case_file)?, case_file)?;
    let (mesh, potential) = if arguments.get(2).is_some_and(|a| a == "first") {
        (mesh_case(&case)?, Vec::new())
    } else {
        let solved = solve_case_with_fields(&case)?;
        for (name, q) in &solved.result.quantities {
            println!("{name} = {:.9e} {} +/- {:.1e}", q.value, q.unit, q.error_estimate);
        }
        (solved.mesh, solved.at_nodes)
    };
    write_msh(&mut BufWriter::new(File::create(format!("{out}.msh"))?), &mesh)?;
    let nodes = Nodes::new(&mesh, &Topology::new(&mesh));
    let fields = [Field { name: "potential (V)", components: 1, values: &potential }];
    write_vtu(
        &mut BufWriter::new(File::create(format!("{out}.vtu"))?),
        &nodes,
        if potential.is_empty() { &[] } else { &fields },
        &[],
    )?;
    let q = mesh.quality();
    println!(
        "{} triangles, least angle {:.1} degrees, edges {:.3e} to {:.3e} m",
        mesh.triangles.len(),
        q.least_angle_degrees,
        q.shortest_edge,
        q.longest_edge
    );
    Ok(())
}
