//! Contact with rigid planes: against prescribed displacements where all of a face touches, and against Hertz.

use super::bodies::*;
use truegap_fem::elasticity::*;
use truegap_fem::mesh::*;

fn plane(boundary: &str, position: f64, travel: f64, side: Side) -> Condition {
    Condition::Obstacle { boundary: boundary.into(), component: Second, position, travel, side }
}

#[test]
fn a_plane_that_presses_a_whole_face_acts_as_a_prescribed_displacement() {
    let (h, press) = (198e-6, -0.05 * 198e-6);
    for law in [LawKind::Linear, LawKind::NeoHookean] {
        let material = Material { law, ..rubber(0.45, Formulation::Mixed) };
        let force = |condition| {
            let mut p = problem(rubber_disc(40e-6, 20e-6), material);
            p.conditions = vec![Condition::fix("bottom", First), Condition::fix("bottom", Second), condition];
            Solver::new(p).unwrap().solve().unwrap().reaction("top", Second).unwrap()
        };
        let pushed = force(plane("top", h, press, Side::Below));
        let displaced = force(Condition::displace("top", Second, press));
        // Multipliers leave 1e-8 of the displacement.
        assert!((pushed / displaced - 1.0).abs() < 1e-6, "{pushed} {displaced}");
        assert!(displaced < -1e-4);
    }
}

#[test]
fn a_plane_that_is_out_of_reach_does_nothing() {
    let mut p = problem(rubber_disc(40e-6, 20e-6), rubber(0.45, Formulation::Mixed));
    p.conditions =
        vec![Condition::fix("bottom", First), Condition::fix("bottom", Second), plane("top", 198e-6, 1e-6, Side::Below)];
    let s = Solver::new(p).unwrap().solve().unwrap();
    assert_eq!(s.reaction("top", Second).unwrap(), 0.0);
}

/// Lower half of a sphere of radius 1 whose pole touches the plane z = -1, with edges of `edge` at a contact of radius `reach`.
fn half_sphere(edge: f64, reach: f64) -> Mesh {
    let s = std::f64::consts::FRAC_1_SQRT_2;
    let outline = Outline { start: [0.0, -1.0], steps: vec![Step::Arc { via: [s, -s], to: [1.0, 0.0] }, Step::Line([0.0, 0.0])] };
    let mut drawing = Geometry::default().region("ball", outline).boundary("equator", &[[0.0, 0.0], [1.0, 0.0]]);
    let skin = Outline { start: [0.0, -1.0], steps: vec![Step::Arc { via: [s, -s], to: [1.0, 0.0] }] };
    drawing.boundaries.push(Boundary { name: "skin".into(), path: BoundaryPath::Path(skin) });
    let rim = [reach, -(1.0 - reach * reach).sqrt()];
    let sources = [[0.0, -1.0], rim].map(|at| SizeSource { at, size: edge }).to_vec();
    let size = SizeField { max_edge: 0.15, growth: 0.25, sources };
    mesh_geometry(&drawing, &MeshOptions { size, arc_step_degrees: 5.0, ..Default::default() }).unwrap()
}

#[test]
fn a_sphere_on_a_plane_follows_hertz() {
    let press: f64 = 1e-3;
    let mut p = problem(half_sphere(1.5e-3, 0.0316), Material { young: 1.0, ..steel() });
    p.conditions = vec![Condition::fix("equator", Second), plane("skin", -1.0, press, Side::Above)];
    let solution = Solver::new(p).unwrap().solve().unwrap();
    let force = solution.reaction("skin", Second).unwrap();
    let reduced = 1.0 / (1.0 - 0.3 * 0.3);
    let hertz = 4.0 / 3.0 * reduced * press.powf(1.5);
    println!("Hertz: force {force:e} against {hertz:e}");
    // Hertz takes the sphere for a half-space: that misplaces its middle by up to 0.5 F / (E R), 2 % of the way.
    assert!((force / hertz - 1.0).abs() < 0.02, "{force} against {hertz}");
    // Contact radius from the force alone; the last touching node is known to one edge.
    let radius = (0.75 * force / reduced).cbrt();
    let body = solution.body();
    let level = -1.0 + press;
    let touching = body.boundary_nodes("skin").unwrap().into_iter().map(|n| n as usize).filter(|&n| {
        let z = body.nodes.points[n][1] + solution.nodal(n)[1];
        assert!(z > level - 1e-10, "node {n} has passed the plane");
        z < level + 1e-9
    });
    let reach = touching.map(|n| body.nodes.points[n][0]).fold(0.0, f64::max);
    println!("Hertz: radius {reach} against {radius}");
    assert!((reach - radius).abs() < 2e-3, "{reach} against {radius}");
}

#[test]
fn force_and_radius_of_a_pressed_sphere_converge_with_the_mesh() {
    // Contact radius 1 / 31.6 of the sphere, on edges of a quarter to a sixteenth of it.
    let reduced = 1.0 / (1.0 - 0.3 * 0.3);
    let solve = |edge: f64| {
        let mut p = problem(half_sphere(edge, 0.0316), Material { young: 1.0, ..steel() });
        p.conditions = vec![Condition::fix("equator", Second), plane("skin", -1.0, 1e-3, Side::Above)];
        let named = |name: &str, goal| ContactQuantity { name: name.into(), goal };
        let goals = [("F", ContactGoal::Force(1)), ("a", ContactGoal::Radius(1)), ("p", ContactGoal::PeakPressure(1))];
        let goals = goals.map(|(name, goal)| named(name, goal));
        // The printed errors are those of the halved mesh.
        let out = solve_contact(&mut p, None, &goals, None).unwrap();
        out.answers
    };
    let all: Vec<_> = [8e-3, 4e-3, 2e-3].map(solve).into_iter().collect();
    let best = all[2][0].value;
    for (answers, edge) in all.iter().zip([4e-3, 2e-3, 1e-3]) {
        let [force, radius, peak] = [0, 1, 2].map(|i| &answers[i]);
        let (a, p0) = ((0.75 * best / reduced).cbrt(), (6.0 * best * reduced * reduced).cbrt() / std::f64::consts::PI);
        println!(
            "edge {edge}: F {:.6e} +- {:.1e} ({:.1e}), a {:.5e} +- {:.1e} ({:.1e}), p {:.5e} +- {:.1e} ({:.1e})",
            force.value,
            force.error_estimate,
            force.value - best,
            radius.value,
            radius.error_estimate,
            radius.value - a,
            peak.value,
            peak.error_estimate,
            peak.value - p0
        );
        // The end of the contact is known to a node; edges carry a middle node.
        assert!((radius.value - a).abs() < 0.5 * edge + 1e-3 * a, "{} {a}", radius.value);
        assert!((force.value - best).abs() <= force.error_estimate, "{} {best}", force.value);
    }
    // Squares of a / R are what Hertz leaves out: 1e-3.
    let p0 = (6.0 * best * reduced * reduced).cbrt() / std::f64::consts::PI;
    assert!((all[2][2].value / p0 - 1.0).abs() < 0.01, "{} {p0}", all[2][2].value);
    let off = |i: usize| (all[i][0].value - best).abs();
    assert!(off(1) < off(0) / 2.0 && off(1) < 1e-3 * best, "{} {}", off(0), off(1));
}

/// Bonded rubber disc of height 198 um, pressed by the load factor in per cent; its side may be stopped by the plates.
fn bulging(rim: f64, stopped: bool) -> Solver {
    let h = 198e-6;
    let material = Material { law: LawKind::NeoHookean, ..rubber(0.49, Formulation::Mixed) };
    let mut p = problem(rubber_disc(25e-6, rim), material);
    let press = -0.01 * h;
    p.conditions = ["bottom", "top"].map(|b| Condition::fix(b, First)).to_vec();
    p.conditions.extend([Condition::fix("bottom", Second), Condition::displace("top", Second, press)]);
    if stopped {
        p.conditions.extend([plane("outer", 0.0, 0.0, Side::Above), plane("outer", h, press, Side::Below)]);
    }
    Solver::new(p).unwrap()
}

#[test]
fn the_side_of_a_bonded_disc_rolls_onto_the_plates() {
    // Without the plates the side folds through them, and soon there is no equilibrium.
    let free = bulging(4e-6, false).advance(25.0, &NewtonOptions { least_step: 0.05, ..Default::default() });
    assert!(matches!(free, Err(ElasticityError::NotConverged { .. })));

    let mut solver = bulging(4e-6, true);
    let mut energy = |part: f64| solver.advance(part, &NewtonOptions::default()).unwrap().energy();
    let d = 0.05;
    let (low, high) = (energy(25.0 - d), energy(25.0 + d));
    let s = solver.advance(25.0, &NewtonOptions::default()).unwrap();
    let (below, above) = (solver.obstacle_force(4), solver.obstacle_force(5));
    assert!(below > 0.0 && above < 0.0);
    let top = s.reaction("top", Second).unwrap() + above;
    let bottom = s.reaction("bottom", Second).unwrap() + below;
    assert!((top / bottom + 1.0).abs() < 1e-6, "{top} {bottom}");
    // The whole force of the plate is the slope of the energy; 1e-3: nodes touch one after another.
    let slope = (high - low) / (2.0 * d * -0.01 * 198e-6);
    println!("25 %: plate {top:e} N, of which the side {above:e} N; slope of the energy {slope:e} N");
    assert!((top / slope - 1.0).abs() < 1e-3, "{top} {slope}");
    // The mesh at the rim matters little.
    let mut coarse = bulging(10e-6, true);
    let other =
        coarse.advance(25.0, &NewtonOptions::default()).unwrap().reaction("top", Second).unwrap() + coarse.obstacle_force(5);
    assert!((other / top - 1.0).abs() < 0.03, "{other} {top}");
}
