//! The section of the disc with its fields, for ParaView.
//!
//! Limits: at rest, with the displacement to warp by; quadratic triangles.

use truegap_audit::disc::{Coupled, von_mises};
use truegap_scene::vtu::{Cells, Data, Grid};

/// The grid: displacement, temperature, potential (unknown in metals), von Mises stress and field strength by cell.
pub(super) fn section(coupled: &Coupled, temperature_c: f64) -> Grid {
    let solution = &coupled.carried.solution;
    let body = solution.body();
    let nodes = &body.nodes;
    let cells = nodes.triangles.iter().map(|t| t.map(|n| n as usize)).collect();
    let mesh = &body.problem.mesh;
    let air = mesh.region_names.iter().position(|n| n == "air");
    let stress = |t: usize| if Some(mesh.triangle_regions[t] as usize) == air { f64::NAN } else { mean(von_mises(solution, t)) };
    let (potential, strength) = electric(coupled);
    Grid::new(nodes.points.clone(), Cells::QuadraticTriangles(cells))
        .on_points("displacement (m)", Data::Vector((0..nodes.points.len()).map(|n| solution.nodal(n)).collect()))
        .on_points("temperature (degC)", Data::Scalar(vec![temperature_c; nodes.points.len()]))
        .on_points("potential (V)", Data::Scalar(potential))
        .on_cells("von Mises stress (Pa)", Data::Scalar((0..mesh.triangles.len()).map(stress).collect()))
        .on_cells("field strength (V/m)", Data::Scalar(strength))
        .on_cells("region", Data::Label(mesh.triangle_regions.iter().map(|&r| i32::from(r)).collect()))
        .legend("region", &mesh.region_names)
}

/// Potential at the nodes (1 V in metals) and field strength of the cells (0 in metals).
fn electric(coupled: &Coupled) -> (Vec<f64>, Vec<f64>) {
    let body = coupled.carried.solution.body();
    let mut potential = vec![1.0; body.nodes.points.len()];
    let mut strength = vec![0.0; body.nodes.triangles.len()];
    let field = &coupled.field;
    let place: std::collections::BTreeMap<[u32; 3], usize> =
        coupled.deformed.triangles.iter().enumerate().map(|(t, corners)| (*corners, t)).collect();
    for t in 0..field.part.mesh.triangles.len() {
        let corners = field.part.mesh.triangles[t].map(|p| field.part.origin[p as usize]);
        let Some(&whole) = place.get(&corners) else { continue };
        for (from, to) in field.nodes.triangles[t].iter().zip(body.nodes.triangles[whole]) {
            potential[to as usize] = field.potential[*from as usize];
        }
        strength[whole] = mean(field.strength(t));
    }
    (potential, strength)
}

fn mean(values: [f64; 3]) -> f64 {
    values.iter().sum::<f64>() / 3.0
}
