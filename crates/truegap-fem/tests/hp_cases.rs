//! `method = "hp"` in case files: the answers of the other method and of the references, and a refusal of everything that it does not do.

#![allow(clippy::unwrap_used)]

use serde::Deserialize;
use std::path::Path;
use truegap_fem::FemError;
use truegap_fem::case::{CaseResult, ErrorsFrom, Method, read_case, solve_case, solve_case_with_fields};
use truegap_fem::electrostatics::VACUUM_PERMITTIVITY;

#[derive(Deserialize)]
struct References {
    reference: Vec<Reference>,
}

#[derive(Deserialize)]
struct Reference {
    case: String,
    value: f64,
    eps0: bool,
    length: f64,
}

fn text(path: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)).unwrap()
}

/// A case of the repository, with another text for some parts of it.
fn case(name: &str, changes: &[(&str, &str)]) -> String {
    changes.iter().fold(text(&format!("meshes/cases/{name}.toml")), |text, (from, to)| {
        assert!(text.contains(from), "{name} no longer says `{from}`");
        text.replacen(from, to, 1)
    })
}

const HP: (&str, &str) = ("[mesh]\n", "[mesh]\nmethod = \"hp\"\n");

fn solve(text: &str) -> Result<CaseResult, FemError> {
    solve_case(&read_case(text, "c.toml")?)
}

/// The value that another program or a closed form gives the only output of a case.
fn reference(file: &str, name: &str) -> f64 {
    let all: References = toml::from_str(&text(&format!("validation/verification/references_{file}.toml"))).unwrap();
    let r = all.reference.into_iter().find(|r| r.case == name).unwrap();
    r.value * r.length * if r.eps0 { VACUUM_PERMITTIVITY } else { 1.0 }
}

/// Both methods by the words of a file; each estimate covers its own error, so that together they cover the difference.
fn compare(file: &str, name: &str, output: &str) {
    let exact = reference(file, name);
    let hp = solve(&case(name, &[HP])).unwrap();
    let refined = solve(&case(name, &[])).unwrap();
    assert_eq!((hp.method, hp.errors), (Method::Hp, ErrorsFrom::Spaces));
    assert_eq!((refined.method, refined.errors), (Method::Refine, ErrorsFrom::Residuals));
    let (a, b) = (hp.quantity(output).unwrap(), refined.quantity(output).unwrap());
    println!("{name}: {} and {} unknowns, off {:.1e}", hp.mesh.unknowns, refined.mesh.unknowns, a.value / exact - 1.0);
    assert_eq!(a.unit, b.unit);
    assert!((a.value - b.value).abs() <= a.error_estimate + b.error_estimate, "{name}: {a:?} against {b:?}");
    let target = read_case(&case(name, &[]), name).unwrap().mesh.target_error.unwrap();
    assert!(a.error_over_scale <= target, "{name}: {a:?}");
    assert!((a.value - exact).abs() <= a.error_estimate, "{name}: {a:?} against {exact}");
    assert!(hp.mesh.unknowns > 0 && hp.mesh.unknowns < refined.mesh.unknowns, "{name}: {:?} against {:?}", hp.mesh, refined.mesh);
    assert!([hp.seconds.mesh, hp.seconds.assemble, hp.seconds.solve].iter().all(|s| *s > 0.0), "{:?}", hp.seconds);
}

#[test]
fn disc_capacitors_agree_with_loves_equation_and_with_the_other_method() {
    for name in ["disc_capacitor_1", "disc_capacitor_0_5", "disc_capacitor_0_1", "isolated_disc"] {
        compare("electrostatics", name, "C");
    }
}

#[test]
fn bonded_rubber_agrees_with_another_program_and_with_the_other_method() {
    for name in ["rubber_disc_bonded_0_3", "rubber_disc_bonded_0_49"] {
        compare("elasticity", name, "F");
    }
}

/// The words of a refusal: the file, the key, the place and the remedy.
fn refuses(name: &str, changes: &[(&str, &str)], parts: &[&str]) {
    let changed = case(name, &[&[HP], changes].concat());
    let said = solve(&changed).expect_err(&format!("{name} with {changes:?} was solved")).to_string();
    for part in ["c.toml, mesh, "].iter().chain(parts) {
        assert!(said.contains(part), "{name} with {changes:?}: `{part}` is missing in: {said}");
    }
}

#[test]
fn electrostatics_that_it_does_not_know_is_refused() {
    let out = "method out: quadratic elements are refined then";
    refuses("coaxial_cable", &[], &["region `", "curved edge at (", " m, ", out]);
    refuses("guard_ring", &[], &["`disc`", "touch at (", "one name", out]);
    let at_a_point = ("kind = \"capacitance\"\nboundary = \"upper\"", "kind = \"potential\"\nat = [0.5, 1.0]");
    refuses("disc_capacitor_1", &[at_a_point], &["output `C`", "capacitance", out]);
    let field = ("kind = \"capacitance\"\nboundary = \"upper\"", "kind = \"field\"\nat = [0.5, 1.0]\ncomponent = \"z\"");
    refuses("disc_capacitor_1", &[field], &["output `C`", out]);
    refuses("disc_capacitor_1", &[("target_error = 1e-05", "max_edge = \"1 mm\"")], &["max_edge alone", "target_error = 1e-4"]);
    let fine = ("target_error = 1e-05", "target_error = 1e-5\nmax_edge = \"0.1 mm\"");
    refuses("disc_capacitor_1", &[fine], &["triangles", "3000", "raise max_edge", out]);
    refuses("disc_capacitor_1", &[("target_error", "order = 2\ntarget_error")], &["order", "remove one"]);
    refuses(
        "square_cable",
        &[("1e-5", "1e-12")],
        &["estimated relative error", "unknowns", "1.0e-12", "raise target_error", out],
    );
    refuses("disc_capacitor_1", &[("\"hp\"", "\"p\"")], &["`p`", "refine, hp"]);
}

#[test]
fn elasticity_that_it_does_not_know_is_refused() {
    let (bar, out) = ("rubber_disc_bonded_0_3", "leave method out: quadratic elements are refined then");
    refuses("thick_sphere_pressure", &[], &["curved edge", "region `wall`", out]);
    refuses("hertz_sphere", &[], &["has a plate", "displacements", out]);
    refuses("rubber_disc_bonded_0_4999", &[], &["region `disc`", "0.4999", "0.499", out]);
    refuses(bar, &[("poisson = 0.3", "poisson = 0.3\nlaw = \"neo-hookean\"")], &["region `disc`", "large strain", out]);
    refuses(bar, &[("poisson = 0.3", "poisson = 0.3\nlaw = \"svk\"")], &["region `disc`", "large strain", out]);
    let warm = ("[mesh]", "[temperature]\nbase = \"1 K\"\n[mesh]");
    let expands = ("poisson = 0.3", "poisson = 0.3\nexpansion = \"200 ppm/K\"");
    refuses(bar, &[expands, warm], &["region `disc`", "expands", out]);
    refuses(bar, &[("fix = [\"r\"]\n", "pressure = \"1 kPa\"\n")], &["boundary `top`", "pressure", out]);
    let pin = ("[mesh]", "[[boundary]]\nname = \"pin\"\npath = [[0, 0]]\nfix = [\"z\"]\n[mesh]");
    refuses(bar, &[pin], &["the point (0, 0) m", "a pin", out]);
    for kind in ["displacement", "stress", "strain"] {
        let component = if kind == "displacement" { "r" } else { "rz" };
        let to = format!("kind = \"{kind}\"\nat = [100, 100]\ncomponent = \"{component}\"");
        let from = "kind = \"reaction\"\nboundary = \"top\"\ncomponent = \"z\"";
        refuses(bar, &[(from, &to)], &["output `F`", "reaction", out]);
    }
    let side = ("[mesh]", "[[boundary]]\nname = \"side\"\npath = [[291.5, 0], [291.5, 100]]\nfix = [\"z\"]\n[mesh]");
    let of_bottom = ("kind = \"reaction\"\nboundary = \"top\"", "kind = \"reaction\"\nboundary = \"bottom\"");
    refuses(bar, &[side, of_bottom], &["output `F`", "boundary `bottom`", "touches boundary `side`", out]);
    refuses(bar, &[("component = \"z\"", "component = \"r\"")], &["meets the axis", out]);
    refuses("rubber_disc_frictionless_0_49", &[("component = \"z\"", "component = \"r\"")], &["no displacement", out]);
}

/// A body that expands and is not warm has no thermal strain.
#[test]
fn a_material_that_could_expand_is_taken_where_nothing_is_warm() {
    let expands = ("poisson = 0.3", "poisson = 0.3\nexpansion = \"200 ppm/K\"");
    let [plain, cold] = [&[HP][..], &[HP, expands]].map(|c| solve(&case("rubber_disc_bonded_0_3", c)).unwrap());
    assert_eq!(plain.quantities, cold.quantities);
}

#[test]
fn fields_are_refused_before_the_work() {
    let text = case("disc_capacitor_1", &[HP]);
    let said = solve_case_with_fields(&read_case(&text, "c.toml").unwrap()).unwrap_err().to_string();
    for part in ["c.toml, mesh, method = \"hp\"", "field", "leave method out", "truegap solve"] {
        assert!(said.contains(part), "`{part}` is missing in: {said}");
    }
}
