//! The elastic cases of `meshes/cases` against numbers that this crate did not make
//! (`validation/verification/references_elasticity.toml`).
//!
//! Each case must meet its own `target_error` (that is the tolerance), and its error estimate must be honest: between
//! half and three times the true error where the reference has the digits to tell.

use serde::Deserialize;
use std::path::Path;
use truegap_fem::case::{read_case, solve_case};

#[derive(Deserialize)]
struct References {
    reference: Vec<Reference>,
}

#[derive(Deserialize)]
struct Reference {
    case: String,
    quantity: String,
    value: f64,
    length: f64,
    trusted: f64,
}

fn check(names: &[&str]) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = std::fs::read_to_string(root.join("validation/verification/references_elasticity.toml")).unwrap();
    let references: References = toml::from_str(&text).unwrap();
    let mut wrong = Vec::new();
    for name in names {
        let text = std::fs::read_to_string(root.join(format!("meshes/cases/{name}.toml"))).unwrap();
        let case = read_case(&text, name).unwrap();
        let target = case.mesh.target_error.unwrap();
        let result = solve_case(&case).unwrap_or_else(|e| panic!("{name}: {e}"));
        let mut seen = 0;
        for r in references.reference.iter().filter(|r| r.case == *name) {
            seen += 1;
            let exact = r.value * r.length;
            let q = result.quantity(&r.quantity).unwrap();
            let error = (q.value / exact - 1.0).abs();
            let effectivity = q.error_estimate / (q.value - exact).abs();
            let honest = error <= 10.0 * r.trusted || (0.5..=3.0).contains(&effectivity);
            let line = format!(
                "{name} {}: {:.9e} against {exact:.9e}, off {error:.1e}, effectivity {effectivity:.2}, {} unknowns, {:.2} s",
                r.quantity, q.value, result.mesh.unknowns, result.seconds.solve
            );
            println!("{line}");
            if !(error <= target + r.trusted && q.error_over_scale <= target && honest) {
                wrong.push(line);
            }
        }
        assert!(seen > 0, "{name} has no reference");
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn rubber_discs_agree_with_converged_values() {
    check(&["rubber_disc_bonded_0_3"]);
}

#[test]
fn nearly_incompressible_discs_agree_with_converged_values() {
    check(&[
        "rubber_disc_bonded_0_49",
        "rubber_disc_bonded_0_4999",
        "rubber_disc_bonded_0_5",
        "rubber_disc_frictionless_0_49",
        "rubber_disc_frictionless_0_4999",
    ]);
}

#[test]
fn thick_walls_agree_with_lame() {
    check(&["thick_cylinder_pressure", "thick_sphere_pressure"]);
}

#[test]
fn le11_agrees_with_the_converged_value() {
    check(&["nafems_le11"]);
}

#[test]
fn the_bimetal_disc_agrees_with_plate_theory() {
    check(&["bimetal_disc_linear"]);
}

#[test]
fn the_bent_bimetal_disc_agrees_with_large_deflection_theory() {
    check(&["bimetal_disc_large"]);
}
