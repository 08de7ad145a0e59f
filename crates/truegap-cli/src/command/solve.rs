//! `truegap solve`: a finite-element case, its quantities and how far they are to be trusted.
//!
//! Limits: reads, calls, prints.

use super::run::{Outcome, Run};
use super::wait::waiting;
use crate::console::Console;
use crate::table::{digits, table};
use std::path::PathBuf;
use truegap::fem::case::{Case, CaseResult, ErrorsFrom, Method, solve_case};
use truegap::verify::case_file::{open_case, told};

/// Solve a finite-element case: electrostatics or elasticity, axisymmetric or planar
#[derive(Debug, clap::Args)]
pub struct Solve {
    /// TOML of a case
    #[arg(value_name = "CASE.toml")]
    case: PathBuf,
}

impl Run for Solve {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let case = open_case(&self.case)?;
        let working = format!("meshing and solving {}", case.file);
        let result = waiting(console, &working, || solve_case(&case)).map_err(|source| told(&case.file, &source))?;
        if console.json {
            console.print_json(&result)?;
        } else {
            print(console, &result)?;
        }
        Ok(judged(console, &case, &result))
    }
}

/// Something to look at where an estimate is above the target of the case, or is none.
fn judged(console: &Console, case: &Case, result: &CaseResult) -> Outcome {
    let Some(target) = case.mesh.target_error else { return Outcome::Fine };
    let met = |estimate: f64| estimate <= target;
    let mut outcome = Outcome::Fine;
    for (name, quantity) in result.quantities.iter().filter(|(_, q)| !met(q.error_over_scale)) {
        let estimate = digits(quantity.error_over_scale, 2);
        console.note(format!(
            "the error of {name} is estimated at {estimate}, above the target of {target}; refine, or ask for less"
        ));
        outcome = Outcome::LookAt;
    }
    outcome
}

pub(super) fn print(console: &Console, result: &CaseResult) -> anyhow::Result<()> {
    let rows = result.quantities.iter().map(|(name, q)| {
        let [error, relative, scaled] = [q.error_estimate, q.relative_error_estimate, q.error_over_scale].map(|e| digits(e, 2));
        vec![name.clone(), digits(q.value, 9), q.unit.clone(), error, relative, scaled]
    });
    console.print(table(&["quantity", "value", "unit", "error\nestimate", "over\nvalue", "over\nits kind"], rows))?;
    match result.errors {
        ErrorsFrom::Residuals => {}
        ErrorsFrom::Meshes => {
            console.print("\nerror estimates: the change between the last meshes (contact has no estimate from residuals)")?;
        }
        ErrorsFrom::Spaces => {
            console.print("\nerror estimates: the changes between the last spaces, and how fast they shrink")?;
        }
    }
    if !result.pressures.is_empty() {
        console.print("")?;
    }
    for p in &result.pressures {
        let surface = match p.acts {
            "following" => "follows the deformed surface",
            "dead" => "is a dead load: it keeps the undeformed surface and its normals",
            _ => "acts on the undeformed surface: the law is one of small strain",
        };
        console.print(format!("the pressure on {} {surface}", p.boundary))?;
    }
    let [mesh, assemble, solve] = [result.seconds.mesh, result.seconds.assemble, result.seconds.solve].map(|s| digits(s, 2));
    let method = if result.method == Method::Hp { "hp version: " } else { "" };
    console.print(format!(
        "\n{method}{} triangles, {} unknowns; meshing {mesh} s, assembling {assemble} s, solving {solve} s",
        result.mesh.triangles, result.mesh.unknowns
    ))
}
