//! Temperature fields of case files: walls under steady heat flow against closed forms, and what is refused.

#![allow(clippy::unwrap_used)]

use std::path::Path;
use truegap_fem::FemError;
use truegap_fem::case::{CaseResult, read_case, solve_case};

fn text(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../meshes/cases/{name}.toml"))).unwrap()
}

fn solve(text: &str) -> Result<CaseResult, FemError> {
    read_case(text, "case.toml").map_err(FemError::from).and_then(|c| solve_case(&c))
}

/// Relative error of a displacement, which its case asks for to 1e-4.
fn off(result: &CaseResult, name: &str, exact: f64) -> f64 {
    (result.quantity(name).unwrap().value / exact - 1.0).abs()
}

#[test]
fn walls_under_steady_heat_flow_agree_with_closed_forms() {
    // Timoshenko and Goodier: a = 1, b = 2, 100 K to 0 K, nu = 0.3, 12 ppm/K.
    let sphere = solve(&text("thick_sphere_heat")).unwrap();
    assert!(off(&sphere, "u_inside", 2.4e-3 / 7.0) < 1e-4 && off(&sphere, "u_outside", 4.8e-3 / 7.0) < 1e-4);
    // The time of an elastic case is split: assembling and solving both take some.
    assert!(sphere.seconds.assemble > 0.0 && sphere.seconds.solve > 0.0);
    let cylinder = solve(&text("thick_cylinder_heat")).unwrap();
    assert!(off(&cylinder, "u_inside", 6.053021318934e-4) < 1e-4 && off(&cylinder, "u_outside", 1.210604263787e-3) < 1e-4);
}

#[test]
fn a_logarithm_in_the_plane_counts_from_the_origin() {
    // A quarter of the same cylinder in Cartesian coordinates: plane strain, so the same displacements.
    let planar = text("ring_in_plane")
        .replace("pressure = \"1 MPa\"\n", "")
        .replace("poisson = 0.3", "poisson = 0.3\nexpansion = \"12 ppm/K\"")
        .replace(
            "[mesh]",
            "[temperature]\nbase = \"100 K\"\nlogarithm = { amplitude = \"-144.26950408889634 K\", radius = \"1 m\" }\n\n[mesh]",
        );
    assert!(off(&solve(&planar).unwrap(), "u_inside", 6.053021318934e-4) < 1e-4);
}

#[test]
fn a_radius_only_shifts_the_zero_of_the_logarithm() {
    let at_two =
        text("thick_cylinder_heat").replace("base = \"100 K\"", "base = \"0 K\"").replace("radius = \"1 m\"", "radius = \"2 m\"");
    assert!(off(&solve(&at_two).unwrap(), "u_inside", 6.053021318934e-4) < 1e-4);
}

#[test]
fn temperatures_that_cannot_be_are_refused_with_their_place() {
    let refuse = |from: &str, to: &str, says: &str| {
        let changed = text("thick_sphere_heat").replace(from, to);
        assert_ne!(changed, text("thick_sphere_heat"), "{from} is not in the file");
        let message = solve(&changed).unwrap_err().to_string();
        assert!(message.contains(says), "{from} -> {to}: {message}");
    };
    refuse("amplitude = \"200 K\"", "amplitude = 200", "temperature, inverse, amplitude");
    refuse("radius = \"1 m\"", "radius = \"-1 m\"", "temperature, inverse, radius: must be positive");
    refuse("radius = \"1 m\"", "length = \"1 m\"", "length");
    // The wall reaches the axis, where a logarithm is infinite.
    refuse("inverse = {", "logarithm = {", "temperature: is infinite at [0.0,");
    let planar = text("ring_in_plane") + "\n[temperature]\ninverse = { amplitude = \"1 K\", radius = \"1 m\" }\n";
    assert!(solve(&planar).unwrap_err().to_string().contains("`logarithm`"));
}
