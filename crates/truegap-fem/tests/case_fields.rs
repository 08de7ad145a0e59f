//! Fields of a solved case in every triangle, against closed forms.
//!
//! Tolerance: the middle of a triangle is one order less accurate than the goals, which the cases hold to 1e-4 or better;
//! 2 % of the load lies well above that on these meshes and far below any component that is missing or changed for another.

#![allow(clippy::unwrap_used)]

use truegap_fem::case::{InTriangles, SolvedCase, read_case, solve_case_with_fields};
use truegap_fem::elasticity::Components;
use truegap_fem::mesh::Topology;
use truegap_fem::space::Nodes;

fn solved(name: &str, change: impl Fn(String) -> String) -> SolvedCase {
    let file = format!("{}/../../meshes/cases/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = change(std::fs::read_to_string(&file).unwrap());
    solve_case_with_fields(&read_case(&text, &file).unwrap()).unwrap()
}

fn middles(solved: &SolvedCase) -> Vec<[f64; 2]> {
    let nodes = Nodes::new(&solved.mesh, &Topology::new(&solved.mesh));
    (0..solved.mesh.triangles.len()).map(|t| nodes.element(t).map_at([1.0 / 3.0; 2]).at).collect()
}

/// Lame: a sphere from 1 m to 2 m under 1 MPa from inside; the stresses do not depend on the material.
fn sphere([r, z]: [f64; 2]) -> Components {
    let (p, radius) = (1e6, r.hypot(z));
    let (along, around) = (p / 7.0 * (1.0 - 8.0 / radius.powi(3)), p / 7.0 * (1.0 + 4.0 / radius.powi(3)));
    let (s, c) = (r / radius, z / radius);
    Components {
        rr: along * s * s + around * c * c,
        zz: along * c * c + around * s * s,
        tt: around,
        rz: (along - around) * s * c,
    }
}

fn assert_near(found: &Components, expected: &Components, within: f64, at: [f64; 2]) {
    for name in ["rr", "zz", "tt", "rz"] {
        let (a, b) = (found.named(name).unwrap(), expected.named(name).unwrap());
        assert!((a - b).abs() < within, "{name} at {at:?}: {a} for {b}");
    }
}

#[test]
fn stress_in_the_triangles_of_a_sphere_is_that_of_lame_and_strain_follows_from_it() {
    // 0.49 is solved with pressures as unknowns of their own
    for poisson in [0.3, 0.49] {
        let solved = solved("thick_sphere_pressure", |text| text.replace("poisson = 0.3", &format!("poisson = {poisson}")));
        let InTriangles::Elastic { strain, stress } = &solved.in_triangles else { panic!("an elastic case") };
        for ((at, stress), strain) in middles(&solved).into_iter().zip(stress).zip(strain) {
            let s = sphere(at);
            assert_near(stress, &s, 2e4, at);
            let trace = s.rr + s.zz + s.tt;
            let hooke = |own: f64, sum: f64| ((1.0 + poisson) * own - poisson * sum) / 200e9;
            let e = Components { rr: hooke(s.rr, trace), zz: hooke(s.zz, trace), tt: hooke(s.tt, trace), rz: hooke(s.rz, 0.0) };
            assert_near(strain, &e, 2e4 / 200e9, at);
        }
    }
}

#[test]
fn the_field_in_the_triangles_of_a_cable_points_outwards_and_falls_as_one_over_the_radius() {
    let solved = solved("coaxial_cable", |text| text);
    let InTriangles::Electric(field) = &solved.in_triangles else { panic!("an electric case") };
    let core = solved.mesh.region_names.iter().position(|n| n == "core").unwrap();
    for (t, ([x, y], e)) in middles(&solved).into_iter().zip(field).enumerate() {
        if usize::from(solved.mesh.triangle_regions[t]) == core {
            continue; // inside of the conductor
        }
        let square = x * x + y * y;
        let expected = [x, y].map(|c| c / (square * 2f64.ln()));
        let size = expected[0].hypot(expected[1]);
        assert!((e[0] - expected[0]).hypot(e[1] - expected[1]) < 0.02 * size, "{e:?} for {expected:?} at {x} {y}");
    }
}
