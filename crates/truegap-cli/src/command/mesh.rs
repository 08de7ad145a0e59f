//! `truegap mesh`: the mesh of a finite-element case as a file.
//!
//! Limits: reads, calls, prints.

use super::run::{Outcome, Run};
use super::solve;
use super::wait::waiting;
use crate::console::Console;
use crate::table::digits;
use serde::Serialize;
use std::path::PathBuf;
use truegap::verify::case_file::{MeshFormat, first_mesh, open_case, solved_mesh};

/// Mesh a finite-element case and write it as .msh or .vtu
#[derive(Debug, clap::Args)]
pub struct Mesh {
    /// TOML of a case
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
    /// File to write: .msh (gmsh 4.1) or .vtu (VTK)
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    /// Solve the case first: the refined mesh, in a .vtu with potential and field, or displacement, strain and stress
    #[arg(long)]
    solved: bool,
}

#[derive(Serialize)]
struct Answer {
    file: String,
    triangles: usize,
    corners: usize,
    least_angle_degrees: f64,
    shortest_edge_m: f64,
    longest_edge_m: f64,
}

impl Run for Mesh {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        MeshFormat::of(&self.output)?; // before the work
        let case = open_case(&self.case)?;
        let mesh = || if self.solved { solved_mesh(&case) } else { first_mesh(&case) };
        let meshed = waiting(console, &format!("meshing {}", case.file), mesh)?;
        meshed.write(&self.output)?;
        let quality = meshed.mesh.quality();
        let answer = Answer {
            file: self.output.display().to_string(),
            triangles: meshed.mesh.triangles.len(),
            corners: meshed.mesh.points.len(),
            least_angle_degrees: quality.least_angle_degrees,
            shortest_edge_m: quality.shortest_edge,
            longest_edge_m: quality.longest_edge,
        };
        if console.json {
            console.print_json(&answer)?;
            return Ok(Outcome::Fine);
        }
        if let Some(result) = &meshed.result {
            solve::print(console, result)?;
        }
        let [least, shortest, longest] =
            [quality.least_angle_degrees, quality.shortest_edge, quality.longest_edge].map(|v| digits(v, 3));
        console.print(format!(
            "{}: {} triangles, {} corners, least angle {least} degrees, edges from {shortest} m to {longest} m",
            answer.file, answer.triangles, answer.corners
        ))?;
        Ok(Outcome::Fine)
    }
}
