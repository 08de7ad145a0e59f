//! Linear thermoelasticity against exact fields, closed forms and published values.

use super::bodies::*;
use std::f64::consts::{FRAC_PI_6, PI};
use truegap_fem::Symmetry;
use truegap_fem::elasticity::*;
use truegap_fem::mesh::*;

/// Largest error over all nodes against `exact`, with its values prescribed on the rim.
fn rim_error(mut p: Problem, exact: impl Fn(Point) -> [f64; 2]) -> f64 {
    pin_rim(&mut p, &exact);
    let active = match p.order {
        Order::Linear => p.mesh.points.len(),
        Order::Quadratic => usize::MAX,
    };
    let solution = Solver::new(p).unwrap().solve().unwrap();
    let points = &solution.body().nodes.points;
    assert!(solution.body().numbering.free.len() > 50);
    let mut worst: f64 = 0.0;
    for (n, &at) in points.iter().enumerate().take(active) {
        let (u, v) = (solution.nodal(n), exact(at));
        worst = worst.max((u[0] - v[0]).abs()).max((u[1] - v[1]).abs());
    }
    worst
}

// Rounding of patch tests: fields of size one, condition numbers of a few thousand.
const ROUNDING: f64 = 2e-13;

#[test]
fn constant_strain_passes_the_patch_test_with_both_orders_and_formulations() {
    let exact = |p: Point| [0.3 * p[0], -0.7 * p[1] + 0.2];
    for order in [Order::Quadratic, Order::Linear] {
        let p = Problem { order, ..problem(patch(0.15), steel()) };
        assert!(rim_error(p, exact) < ROUNDING);
    }
    let p = problem(patch(0.3), rubber(0.49, Formulation::Mixed));
    assert!(rim_error(p, exact) < ROUNDING);
    // Incompressible: the strain must keep the volume.
    let p = problem(patch(0.3), rubber(0.5, Formulation::Mixed));
    assert!(rim_error(p, |p| [0.3 * p[0], -0.6 * p[1]]) < 1e-12);
}

#[test]
fn shear_and_hoop_that_grow_linearly_pass_the_patch_test() {
    // u = r z, w = r^2: every strain component differs from zero; body force as the equilibrium asks.
    let lame = steel().lame();
    let mut p = problem(patch(0.3), steel());
    let b = -(6.0 * lame.mu + 2.0 * lame.lambda());
    p.body_force = Some(field(move |_| [0.0, b]));
    assert!(rim_error(p, |p| [p[0] * p[1], p[0] * p[0]]) < ROUNDING);
}

#[test]
fn a_harmonic_field_without_load_passes_the_patch_test() {
    // Displacement = gradient of r^2 z - 2 z^3 / 3, a harmonic function: no volume change, no body force.
    let p = problem(patch(0.3), steel());
    assert!(rim_error(p, |p| [2.0 * p[0] * p[1], p[0] * p[0] - 2.0 * p[1] * p[1]]) < ROUNDING);
}

#[test]
fn planar_fields_pass_the_patch_test() {
    let planar = |mesh, material| Problem { symmetry: Symmetry::Planar, ..problem(mesh, material) };
    let linear = |p: Point| [0.3 * p[0] - 0.4 * p[1], 0.1 * p[0] - 0.7 * p[1] + 0.2];
    assert!(rim_error(planar(patch(0.3), steel()), linear) < ROUNDING);
    // u = x y, v = x^2 needs the body force b_y = -(lambda + 3 mu).
    let lame = steel().lame();
    let b = -(lame.lambda() + 3.0 * lame.mu);
    let mut p = planar(patch(0.3), steel());
    p.body_force = Some(field(move |_| [0.0, b]));
    assert!(rim_error(p, |p| [p[0] * p[1], p[0] * p[0]]) < ROUNDING);
}

#[test]
fn free_expansion_has_no_stress_and_a_held_body_all_of_it() {
    let mut p = problem(patch(0.3), steel());
    p.temperature = Temperature::uniform(50.0);
    p.conditions = vec![Condition::fix("bottom", Second)];
    let strain = 1.2e-5 * 50.0;
    let free = Solver::new(p.clone()).unwrap().solve().unwrap();
    let at = [0.4, 0.6];
    let u = free.displacement_at(at).unwrap();
    assert!((u[0] - strain * at[0]).abs() < 1e-13 && (u[1] - strain * at[1]).abs() < 1e-13);
    // Against the stress of a held body, 200 MPa, rounding of 1e-11.
    assert!(free.stress_at(at).unwrap().rr.abs() < 2e-3);
    assert!((free.strain_at(at).unwrap().tt - strain).abs() < 1e-12);
    assert!(free.energy().abs() < 1e-15);

    p.conditions = vec![Condition::fix("bottom", Second), Condition::fix("top", Second), Condition::fix("outer", First)];
    let held = Solver::new(p).unwrap().solve().unwrap();
    let all = -200e9 * strain / (1.0 - 2.0 * 0.3);
    let stress = held.stress_at(at).unwrap();
    for s in [stress.rr, stress.zz, stress.tt] {
        assert!((s / all - 1.0).abs() < 1e-11, "{s} against {all}");
    }
    let force = held.reaction("top", Second).unwrap();
    assert!((force / (all * PI) - 1.0).abs() < 1e-11);
    // Energy 3/2 * stress * elastic strain, volume pi.
    assert!((held.energy() / (1.5 * all * -strain * PI) - 1.0).abs() < 1e-11);
}

#[test]
fn planar_thermal_stress_out_of_plane_is_that_of_plane_strain() {
    let mut p = problem(patch(0.3), steel());
    p.symmetry = Symmetry::Planar;
    p.temperature = Temperature::uniform(10.0);
    p.conditions = vec![Condition::fix("bottom", Second), Condition::fix("inner", First)];
    let s = Solver::new(p).unwrap().solve().unwrap();
    let stress = s.stress_at([0.5, 0.5]).unwrap();
    // Free in the plane, held across it: sigma = -E a T, in-plane strain (1 + nu) a T.
    assert!((stress.tt / (-200e9 * 1.2e-4) - 1.0).abs() < 1e-11);
    assert!(stress.rr.abs() < 1e-2 && stress.rz.abs() < 1e-2);
    assert!((s.strain_at([0.5, 0.5]).unwrap().zz / (1.3 * 1.2e-4) - 1.0).abs() < 1e-11);
}

/// Free expansion is linear in both directions, so every fit has it exactly, however few elements lie across the body.
#[test]
fn a_body_one_or_two_elements_wide_expands_as_much_across_as_along() {
    let strain = 1.3 * 1.2e-5 * 10.0; // plane strain: (1 + nu) a T
    for (order, columns) in [
        (Order::Quadratic, &[0.0, 0.1][..]),
        (Order::Quadratic, &[0.0, 0.05, 0.1]),
        (Order::Linear, &[0.0, 0.1]),
        (Order::Linear, &[0.0, 0.05, 0.1]),
    ] {
        let layer = Layer { name: "body".into(), thickness: 1.0, rows: 12 };
        let mut p = problem(layered_grid(columns, 0.0, &[layer]).unwrap(), steel());
        (p.symmetry, p.order, p.temperature) = (Symmetry::Planar, order, Temperature::uniform(10.0));
        p.conditions = vec![Condition::fix("bottom", Second), Condition::fix("left", First)];
        let (at, told) = ([0.047, 0.52], format!("{order:?}, {} columns", columns.len()));
        let found = Solver::new(p.clone()).unwrap().solve().unwrap().strain_at(at).unwrap();
        assert!((found.rr / strain - 1.0).abs() < 1e-9 && (found.zz / strain - 1.0).abs() < 1e-9, "{told}: {found:?}");
        if order == Order::Linear {
            continue; // errors of goals are estimated above quadratic elements
        }
        let goal = Goal::Strain { at, component: "xx".into() };
        let answer = &solve_goals(&p, &[Quantity { name: "xx".into(), goal }]).unwrap().answers[0];
        assert!((answer.value / strain - 1.0).abs() < 1e-9 && answer.error_estimate < 1e-9 * strain, "{told}: {answer:?}");
    }
}

fn cylinder(edge: f64) -> Problem {
    let mut p = problem(rectangle([1.0, 0.0], [2.0, 0.3], SizeField::uniform(edge)), steel());
    p.conditions = vec![Condition::fix("bottom", Second), Condition::fix("top", Second)];
    p
}

#[test]
fn thick_cylinder_under_pressure_follows_lame() {
    let mut p = cylinder(0.05);
    p.conditions.push(Condition::pressure("inner", 1e6));
    let s = Solver::new(p).unwrap().solve().unwrap();
    for (r, exact) in [(1.0, 9.533333333333e-6), (2.0, 6.066666666667e-6)] {
        let u = s.displacement_at([r, 0.15]).unwrap()[0];
        // Quadratic elements of edge 0.05: (h / r)^4 with a factor of order one.
        assert!((u / exact - 1.0).abs() < 3e-6, "{u} against {exact}");
    }
    for r in [1.0, 1.3, 2.0] {
        let stress = s.stress_at([r, 0.15]).unwrap();
        let (radial, hoop) = (1e6 / 3.0 * (1.0 - 4.0 / (r * r)), 1e6 / 3.0 * (1.0 + 4.0 / (r * r)));
        // Recovered stresses converge with h^3.
        assert!((stress.rr - radial).abs() < 600.0, "rr {} {radial}", stress.rr);
        assert!((stress.tt - hoop).abs() < 600.0, "tt {} {hoop}", stress.tt);
    }
}

#[test]
fn heated_thick_cylinder_follows_timoshenko() {
    let mut p = cylinder(0.05);
    // Steady conduction from 100 K at r = 1 to 0 at r = 2.
    p.temperature = Temperature::Field(field(|p: Point| 100.0 * (1.0 - p[0].ln() / 2f64.ln())));
    let s = Solver::new(p).unwrap().solve().unwrap();
    for (r, exact) in [(1.0, 6.053021318934e-4), (2.0, 1.210604263787e-3)] {
        let u = s.displacement_at([r, 0.15]).unwrap()[0];
        assert!((u / exact - 1.0).abs() < 1e-5, "{u} against {exact}");
    }
    let stress = s.stress_at([1.0, 0.15]).unwrap();
    assert!((stress.tt / -2.09823707e8 - 1.0).abs() < 1e-3, "{stress:?}");
    assert!((stress.zz / -3.02947112e8 - 1.0).abs() < 1e-3, "{stress:?}");
}

#[test]
fn thick_sphere_under_pressure_and_heat_follows_the_closed_forms() {
    let body = || {
        let mut p = problem(thick_sphere(0.04), steel());
        p.conditions = vec![Condition::fix("equator", Second)];
        p
    };
    let mut p = body();
    p.conditions.push(Condition::pressure("inside", 1e6));
    let s = Solver::new(p).unwrap().solve().unwrap();
    for (r, exact) in [(1.0, 4e-6), (2.0, 1.5e-6)] {
        for at in [[r, 0.0], [0.0, r]] {
            let u = s.displacement_at(at).unwrap();
            // Quadratic elements on an unstructured mesh: about 0.2 h^3.
            assert!((u[0].hypot(u[1]) / exact - 1.0).abs() < 2e-5, "{u:?} against {exact}");
        }
    }
    let mut p = body();
    p.temperature = Temperature::Field(field(|p: Point| -100.0 + 200.0 / p[0].hypot(p[1])));
    let s = Solver::new(p).unwrap().solve().unwrap();
    for (r, exact) in [(1.0, 2.4e-3 / 7.0), (1.5, 7.442176870748e-4), (2.0, 4.8e-3 / 7.0)] {
        for at in [[r, 0.0], [0.0, r]] {
            let u = s.displacement_at(at).unwrap();
            let u = u[0].hypot(u[1]);
            assert!((u / exact - 1.0).abs() < 5e-5, "{u} against {exact}");
        }
    }
    let stress = s.stress_at([2.0, 0.0]).unwrap();
    assert!((stress.tt / 9.7959183673e7 - 1.0).abs() < 1e-3, "{stress:?}");
    assert!((stress.zz / 9.7959183673e7 - 1.0).abs() < 1e-3, "{stress:?}");
}

#[test]
#[allow(clippy::approx_constant, reason = "NAFEMS prints five digits")]
fn nafems_le11_gives_the_converged_stress_and_not_only_the_target() {
    let (c, s) = (FRAC_PI_6.cos(), FRAC_PI_6.sin());
    let (c15, s15) = ((0.5 * FRAC_PI_6).cos(), (0.5 * FRAC_PI_6).sin());
    let (i, o, d) = (22.5f64.to_radians(), 1.0, 0.70711);
    let outline = Outline {
        start: [1.0, 0.0],
        steps: vec![
            Step::Line([1.4, 0.0]),
            Step::Arc { via: [1.4 * c15, 1.4 * s15], to: [1.4 * c, 1.4 * s] },
            Step::Line([o, 1.39]),
            Step::Line([o, 1.79]),
            Step::Line([d, 1.79]),
            Step::Line([d, d]),
            Step::Arc { via: [i.cos(), i.sin()], to: [1.0, 0.0] },
        ],
    };
    let drawing = Geometry::default()
        .region("body", outline)
        .boundary("bottom", &[[1.0, 0.0], [1.4, 0.0]])
        .boundary("top", &[[1.0, 1.79], [d, 1.79]]);
    let size = SizeField { max_edge: 0.06, growth: 0.2, sources: vec![SizeSource { at: [1.0, 0.0], size: 0.004 }] };
    let mesh = mesh_geometry(&drawing, &MeshOptions { size, arc_step_degrees: 4.0, ..Default::default() }).unwrap();
    let mut p = problem(mesh, Material { young: 210e9, expansion: 2.3e-4, ..steel() });
    p.temperature = Temperature::Linear { base: 0.0, gradient: [1.0, 1.0] };
    p.conditions = vec![Condition::fix("bottom", Second), Condition::fix("top", Second)];
    let solution = Solver::new(p).unwrap().solve().unwrap();
    let stress = solution.stress_at([1.0, 0.0]).unwrap().zz;
    let u = solution.displacement_at([1.0, 0.0]).unwrap()[0];
    println!("LE11: {stress} Pa, {u} m, {} unknowns", solution.body().numbering.free.len());
    // hp-converged values; NAFEMS' own target of -105 MPa is 0.6 % off them.
    assert!((stress / -105.669e6 - 1.0).abs() < 3e-4, "{stress}");
    assert!((u / 0.64623932e-3 - 1.0).abs() < 2e-5, "{u}");
}

#[test]
fn bonded_rubber_disc_is_as_stiff_as_the_converged_values_say() {
    for (nu, bonded, exact) in [(0.3, true, 1.17057048), (0.49, true, 1.96621337), (0.49, false, 1.31212227)] {
        let mesh = rubber_disc(12e-6, 0.08e-6);
        let e = apparent_modulus(mesh, rubber(nu, Formulation::Displacement), Order::Quadratic, bonded);
        println!("disc nu {nu} bonded {bonded}: {e} error {:.2e}", e / exact - 1.0);
        assert!((e / exact - 1.0).abs() < 1e-4, "nu {nu}: {e} against {exact}");
    }
    let free = {
        let mut p = problem(rubber_disc(40e-6, 10e-6), rubber(0.49, Formulation::Displacement));
        p.conditions = vec![Condition::fix("bottom", Second), Condition::displace("top", Second, -1e-6)];
        Solver::new(p).unwrap().solve().unwrap().reaction("top", Second).unwrap()
    };
    // Frictionless on both faces: uniaxial, exactly E A / h.
    assert!((free / (-1e6 * PI * 291.5e-6f64.powi(2) * 1e-6 / 198e-6) - 1.0).abs() < 1e-11);
}

/// u = r sin(z), w = r^2 cos(z): all strain components, and not in the space.
fn manufactured(edge: f64, symmetry: Symmetry, material: Material) -> (f64, f64) {
    let lame = material.lame();
    let (mu, la) = (lame.mu, lame.lambda());
    let mut p = problem(patch(edge), material);
    p.symmetry = symmetry;
    p.body_force = Some(match symmetry {
        // Stresses by hand: e_rr = e_tt = sin z, e_zz = -r^2 sin z, 2 e_rz = 3 r cos z.
        Symmetry::Axisymmetric => field(move |p: Point| {
            let (r, s, c) = (p[0], p[1].sin(), p[1].cos());
            [2.0 * la * r * s + 3.0 * mu * r * s, -(la * (2.0 * c - r * r * c) - 2.0 * mu * r * r * c + 6.0 * mu * c)]
        }),
        // Planar, same field in (x, y): e_xx = sin y, e_yy = -x^2 sin y, 2 e_xy = 3 x cos y.
        Symmetry::Planar => field(move |p: Point| {
            let (x, s, c) = (p[0], p[1].sin(), p[1].cos());
            [2.0 * la * x * s + 3.0 * mu * x * s, -(la * (c - x * x * c) - 2.0 * mu * x * x * c + 3.0 * mu * c)]
        }),
    });
    let exact = |p: Point| [p[0] * p[1].sin(), p[0] * p[0] * p[1].cos()];
    pin_rim(&mut p, exact);
    let s = Solver::new(p).unwrap().solve().unwrap();
    let probe = [0.43, 0.57];
    let nodes = &s.body().nodes.points;
    let square: f64 = nodes
        .iter()
        .enumerate()
        .map(|(n, &at)| {
            let (u, v) = (s.nodal(n), exact(at));
            (u[0] - v[0]).powi(2) + (u[1] - v[1]).powi(2)
        })
        .sum();
    let shear = s.strain_at(probe).unwrap().rz - 1.5 * probe[0] * probe[1].cos();
    ((square / nodes.len() as f64).sqrt(), shear.abs())
}

#[test]
fn manufactured_solutions_converge_with_their_order_and_along_their_curve() {
    // The curve error = c h^3 with c measured once: mixed bodies are pushed lambda / mu times harder.
    for (symmetry, material, c) in [
        (Symmetry::Axisymmetric, steel(), 4.3e-3),
        (Symmetry::Planar, steel(), 4.2e-3),
        (Symmetry::Axisymmetric, rubber(0.49, Formulation::Mixed), 0.1),
        (Symmetry::Planar, rubber(0.49, Formulation::Mixed), 0.1),
    ] {
        let errors: Vec<(f64, f64)> = [0.2, 0.1, 0.05].iter().map(|&h| manufactured(h, symmetry, material)).collect();
        println!("{symmetry:?} {:?}: {errors:?}", material.formulation);
        for (k, h) in [0.2f64, 0.1, 0.05].into_iter().enumerate() {
            let scaled = errors[k].0 / h.powi(3);
            assert!(scaled < 1.5 * c && scaled > 0.5 * c, "h {h}: {scaled} against {c}");
        }
        let order = (errors[0].0 / errors[2].0).log2() / 2.0;
        assert!(order > 2.8 && order < 4.2, "order {order}");
        assert!(errors[2].1 < 1e-4, "recovered shear strain: {errors:?}");
    }
}

#[test]
fn work_of_the_loads_is_twice_the_energy_and_forces_balance() {
    let mut p = problem(patch(0.2), steel());
    p.conditions =
        vec![Condition::fix("bottom", Second), Condition::fix("bottom", First), Condition::displace("top", Second, 1e-3)];
    let s = Solver::new(p).unwrap().solve().unwrap();
    let top = s.reaction("top", Second).unwrap();
    assert!((0.5 * top * 1e-3 / s.energy() - 1.0).abs() < 1e-10);
    assert!((s.reaction("bottom", Second).unwrap() / top + 1.0).abs() < 1e-10);
}

#[test]
fn points_of_the_axis_stay_on_it_in_every_state() {
    // A disc bonded below and bent by pressure from above: nothing but the axis condition holds u_r at r = 0.
    let mesh = drawn(&[("below", &[[0.0, 0.0], [1.0, 0.0]]), ("above", &[[0.0, 0.5], [1.0, 0.5]])]);
    let mut p = problem(mesh, steel());
    p.conditions = vec![Condition::fix("below", First), Condition::fix("below", Second), Condition::pressure("above", 1e6)];
    let solution = Solver::new(p).unwrap().solve().unwrap();
    let points = &solution.body().nodes.points;
    let on_axis: Vec<usize> = (0..points.len()).filter(|&n| points[n][0] == 0.0).collect();
    assert!(on_axis.len() > 5);
    assert!(on_axis.iter().all(|&n| solution.nodal(n)[0] == 0.0));
    assert!(on_axis.iter().any(|&n| solution.nodal(n)[1] < 0.0));
}

/// A disc of radius 1 and height 0.5 with named lines.
fn drawn(lines: &[(&str, &[Point])]) -> Mesh {
    let body = Geometry::default().region("body", Outline::rectangle([0.0, 0.0], [1.0, 0.5]));
    let drawing = lines.iter().fold(body, |g, (name, path)| g.boundary(name, path));
    mesh_geometry(&drawing, &MeshOptions { size: SizeField::uniform(0.15), ..Default::default() }).unwrap()
}
