//! Case files: what is read, and what is refused with its place and a remedy.

#![allow(clippy::unwrap_used)]

use truegap_fem::FemError;
use truegap_fem::case::{CaseError, read_case, solve_case};

const GOOD: &str = r#"
schema = "truegap.case/1"
physics = "electrostatics"
symmetry = "planar"
length_unit = "mm"

[material.air]
relative_permittivity = 1.0

[[region]]
name = "gap"; material = "air"; polygon = [[0, 0], [4, 0], [4, 2], [0, 2]]

[[boundary]]
name = "top"
path = [[0, 2], [4, 2]]
potential = "3 V"

[[boundary]]
name = "bottom"
path = [[0, 0], [4, 0]]
potential = "-1 V"

[mesh]
max_edge = "0.5 mm"

[[output]]
name = "C"
kind = "capacitance"
boundary = "top"

[[output]]
name = "middle"
kind = "potential"
at = [1, 1]
"#;

fn good() -> String {
    GOOD.replace("name = \"gap\"; material = \"air\"; polygon", "name = \"gap\"\nmaterial = \"air\"\npolygon")
}

#[test]
fn a_plate_capacitor_per_metre_comes_out_in_its_units() {
    let result = solve_case(&read_case(&good(), "good.toml").unwrap()).unwrap();
    let c = result.quantity("C").unwrap();
    // eps0 w / d per metre; exact for a uniform field but for rounding.
    assert!((c.value / (8.8541878128e-12 * 2.0) - 1.0).abs() < 1e-12 && c.unit == "F/m");
    let v = result.quantity("middle").unwrap();
    assert!((v.value - 1.0).abs() < 1e-12 && v.unit == "V");
    assert!(result.mesh.triangles > 32 && result.mesh.unknowns > 64);
}

#[test]
fn wrong_files_are_refused_with_their_place() {
    let refuse = |from: &str, to: &str, says: &str| {
        let text = good().replacen(from, to, 1);
        assert_ne!(text, good(), "{from} is not in the file");
        let error = read_case(&text, "bad.toml").map_err(FemError::from).and_then(|c| solve_case(&c)).unwrap_err();
        let message = error.to_string();
        assert!(message.contains(says), "{from} -> {to}: {message}");
        message
    };
    refuse("truegap.case/1", "truegap.case/2", "truegap.case/1");
    refuse("electrostatics", "magnetics", "electrostatics, elasticity");
    refuse("\"3 V\"", "3", "1 V");
    refuse("\"3 V\"", "\"3 kPa\"", "boundary `top`, potential");
    refuse("material = \"air\"", "material = \"oil\"", "region `gap`");
    refuse("material = \"air\"\n", "", "its material");
    refuse("relative_permittivity = 1.0", "relative_permittivity = -1.0", "positive");
    refuse("relative_permittivity = 1.0", "young = \"1 GPa\"", "relative_permittivity is missing");
    refuse("potential = \"3 V\"\n", "", "boundary `top`: its potential is missing");
    refuse("[[0, 2], [4, 2]]", "[[0, 7], [4, 7]]", "lies on nothing");
    refuse("[[0, 0], [4, 0], [4, 2], [0, 2]]", "[[0, 0], [4, 2], [4, 0], [0, 2]]", "crosses itself");
    refuse("[[0, 0], [4, 0], [4, 2], [0, 2]]", "[[0, 0], [4, 0], [5, 0]]", "encloses no area");
    refuse("boundary = \"top\"", "boundary = \"side\"", "no potential");
    refuse("at = [1, 1]", "at = [9, 1]", "outside the mesh");
    refuse("at = [1, 1]\n", "", "its point");
    refuse("kind = \"potential\"", "kind = \"stress\"", "electrostatic case");
    refuse("max_edge = \"0.5 mm\"", "max_edge = \"0 mm\"", "positive");
    refuse("max_edge = \"0.5 mm\"", "target_error = 3.0", "relative");
    refuse("max_edge = \"0.5 mm\"", "size = 3", "size");
    refuse("name = \"middle\"", "name = \"C\"", "used twice");
}

#[test]
fn a_syntax_error_names_its_line() {
    let error = read_case(&good().replace("potential = \"3 V\"", "potential = 3 V"), "bad.toml").unwrap_err();
    assert!(matches!(&error, CaseError::Syntax { message, .. } if message.contains("line")), "{error}");
}
