//! Finite-element cases typed: quantities against closed forms, mesh files, and what is wrong with a case.

#![allow(clippy::unwrap_used)]

mod common;

use common::{Bench, Said};
use serde_json::Value;
use std::f64::consts::PI;

const VACUUM_PERMITTIVITY: f64 = 8.854_187_812_8e-12;

fn case(name: &str) -> String {
    format!("{}/../../meshes/cases/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

fn read(said: &Said) -> Value {
    assert_eq!(said.code, 0, "{}{}", said.out, said.err);
    serde_json::from_str(&said.out).unwrap()
}

/// Compared with the tolerance that the case asks for itself; the estimate must be honest about it.
fn assert_quantity(answer: &Value, name: &str, unit: &str, expected: f64, target: f64) {
    let quantity = &answer["quantities"][name];
    let value = quantity["value"].as_f64().unwrap();
    assert_eq!(quantity["unit"], unit);
    approx::assert_relative_eq!(value, expected, max_relative = target);
    let estimate = quantity["error_estimate"].as_f64().unwrap();
    assert!(estimate > 0.0 && estimate <= target * expected, "{quantity}");
}

#[test]
fn a_coaxial_cable_has_its_capacitance_per_metre() {
    let answer = read(&Bench::new().run(&["solve", &case("coaxial_cable"), "--json"]));
    assert_quantity(&answer, "C", "F/m", 2.0 * PI * VACUUM_PERMITTIVITY / 2f64.ln(), 1e-5);
    for count in ["triangles", "unknowns"] {
        assert!(answer["mesh"][count].as_u64().unwrap() > 10);
    }
    for step in ["mesh", "assemble", "solve"] {
        assert!(answer["seconds"][step].as_f64().unwrap() >= 0.0);
    }
}

/// Love's value; what is refused is in the tests of truegap-fem.
#[test]
fn the_hp_version_is_asked_for_in_the_file_and_named_in_the_answer() {
    let bench = Bench::new();
    let plain = std::fs::read_to_string(case("disc_capacitor_1")).unwrap();
    bench.file("plain.toml", &plain);
    bench.file("hp.toml", &plain.replace("[mesh]", "[mesh]\nmethod = \"hp\""));
    let [hp, refined] = ["hp.toml", "plain.toml"].map(|file| read(&bench.run(&["solve", file, "--json"])));
    for answer in [&hp, &refined] {
        assert_quantity(answer, "C", "F", 7.283_139_931_33e-3 * VACUUM_PERMITTIVITY, 1e-5);
    }
    assert_eq!((&hp["method"], &hp["errors"]), (&"hp".into(), &"spaces".into()));
    assert_eq!((refined.get("method"), &refined["errors"]), (None, &"residuals".into()));
    assert!(hp["mesh"]["unknowns"].as_u64() < refined["mesh"]["unknowns"].as_u64(), "{hp} against {refined}");
    let said = bench.run(&["solve", "hp.toml"]);
    assert!(
        said.code == 0 && said.out.contains("\nhp version: ") && said.out.contains("between the last spaces"),
        "{}",
        said.out
    );
    let fields = &["hp.toml, mesh, method = \"hp\"", "field", "leave method out"];
    bench.refuses(&["mesh", "hp.toml", "-o", "hp.vtu", "--solved"], fields);
    read(&bench.run(&["mesh", "hp.toml", "-o", "hp.msh", "--json"]));
    let curved = std::fs::read_to_string(case("coaxial_cable")).unwrap().replace("[mesh]", "[mesh]\nmethod = \"hp\"");
    bench.file("curved.toml", &curved);
    bench.refuses(&["solve", "curved.toml"], &["curved.toml, mesh, method", "curved edge", "leave method out"]);
}

#[test]
fn a_table_of_a_sphere_under_pressure_names_every_output() {
    let said = Bench::new().run(&["solve", &case("thick_sphere_pressure")]);
    assert_eq!(said.code, 0, "{}{}", said.out, said.err);
    for word in ["quantity", "u_inside", "u_outside", "W", "m", "J", "triangles", "unknowns"] {
        assert!(said.out.contains(word), "`{word}` is missing in: {}", said.out);
    }
}

#[test]
fn a_mesh_is_written_whole_in_both_formats() {
    let bench = Bench::new();
    let first = read(&bench.run(&["mesh", &case("coaxial_cable"), "-o", "first.msh", "--json"]));
    let text = std::fs::read_to_string(bench.path("first.msh")).unwrap();
    let mesh = truegap::fem::io::read_msh(&text, "first.msh").unwrap();
    assert_eq!(first["triangles"].as_u64().unwrap() as usize, mesh.triangles.len());
    let mut names = mesh.boundary_names.clone();
    names.sort();
    assert_eq!(names, ["inner", "outer"]);
    let solved = read(&bench.run(&["mesh", &case("coaxial_cable"), "-o", "solved.vtu", "--solved", "--json"]));
    assert!(solved["triangles"].as_u64() > first["triangles"].as_u64(), "{solved} after {first}");
    let text = std::fs::read_to_string(bench.path("solved.vtu")).unwrap();
    let cells = format!("NumberOfCells=\"{}\"", solved["triangles"]);
    assert!(text.contains(&cells) && text.contains("potential (V)"));
    assert!(text.contains("electric field (V/m)") && text.contains("Name=\"region: core\""));
    assert_eq!(bench.names(), ["first.msh", "solved.vtu"]);
}

/// A picture of a solved body is asked for its stresses first, and needs to know which part is which.
#[test]
fn a_solved_body_is_written_with_strain_stress_and_regions() {
    let bench = Bench::new();
    read(&bench.run(&["mesh", &case("thick_sphere_pressure"), "-o", "solved.vtu", "--solved", "--json"]));
    let text = std::fs::read_to_string(bench.path("solved.vtu")).unwrap();
    for name in ["displacement (m)", "strain (1)", "stress (Pa)", "von Mises stress (Pa)", "region", "region: wall"] {
        assert!(text.contains(&format!("Name=\"{name}\"")), "{name}");
    }
    assert!(!text.contains("String"), "meshio reads no text arrays");
}

#[test]
fn what_is_wrong_with_a_case_is_named() {
    let bench = Bench::new();
    let good = std::fs::read_to_string(case("coaxial_cable")).unwrap();
    let changes: [(&str, &str, &[&str]); 6] = [
        ("truegap.case/1", "truegap.recording/1", &["c.toml", "`truegap.recording/1`", "truegap.case/1"]),
        ("potential = \"1 V\"", "potential = \"1 N\"", &["c.toml", "`1 N`", "V"]),
        ("physics = \"electrostatics\"", "physics = \"magnetics\"", &["c.toml", "`magnetics`", "electrostatics"]),
        ("kind = \"capacitance\"", "kind = \"inductance\"", &["c.toml", "`inductance`", "capacitance"]),
        ("region = \"core\"", "region = \"kern\"", &["c.toml", "`kern`", "core"]),
        ("symmetry = ", "symetry = ", &["c.toml", "line 4", "symetry"]),
    ];
    for (from, to, parts) in changes {
        assert!(good.contains(from), "the case no longer says `{from}`");
        bench.file("c.toml", &good.replace(from, to));
        bench.refuses(&["solve", "c.toml"], parts);
        bench.refuses(&["mesh", "c.toml", "-o", "c.msh", "--solved"], parts);
    }
    bench.refuses(&["solve", "nowhere.toml"], &["nowhere.toml", "cannot be read", "truegap.case/1"]);
    bench.refuses(&["mesh", &case("coaxial_cable"), "-o", "c.stl"], &["c.stl", "`stl`", ".msh", ".vtu"]);
    bench.refuses(&["mesh", &case("coaxial_cable"), "-o", "no/such/c.msh"], &["no/such/c.msh", "cannot be written", "folder"]);
}
