//! Outputs and their estimates on meshes given by hand, and outputs that do not exist.

use super::bodies::*;
use truegap_fem::FemError;
use truegap_fem::elasticity::*;
use truegap_fem::mesh::*;

fn pressed(law: LawKind, part: f64) -> Problem {
    let mesh = rectangle([0.0, 0.0], [291.5e-6, 198e-6], SizeField::uniform(60e-6));
    let mut p = problem(mesh, Material { law, ..rubber(0.45, Formulation::Mixed) });
    p.conditions = vec![
        Condition::fix("bottom", First),
        Condition::fix("bottom", Second),
        Condition::fix("top", First),
        Condition::displace("top", Second, -part * 198e-6),
    ];
    p
}

fn force(name: &str, boundary: &str) -> Quantity {
    Quantity { name: name.into(), goal: Goal::Reaction { boundary: boundary.into(), component: Second } }
}

#[test]
fn the_error_of_a_force_at_large_strain_is_estimated_on_every_mesh() {
    let quantities = [force("F", "top"), Quantity { name: "W".into(), goal: Goal::Energy }];
    let solve = |edge: f64| {
        let mut p = pressed(LawKind::NeoHookean, 0.1);
        p.mesh = rectangle([0.0, 0.0], [291.5e-6, 198e-6], SizeField::uniform(edge));
        solve_goals(&p, &quantities).unwrap().answers
    };
    // The reference is this crate's own, on a mesh graded into the rims; its error is a tenth of those below.
    let mut p = pressed(LawKind::NeoHookean, 0.1);
    p.mesh = rubber_disc(12e-6, 2e-6);
    let best = solve_goals(&p, &quantities).unwrap().answers;
    for edge in [60e-6, 30e-6] {
        for (a, b) in solve(edge).iter().zip(&best) {
            let effectivity = a.error_estimate / (a.value - b.value).abs();
            println!("edge {edge} {}: {:.6e}, best {:.6e}, effectivity {effectivity:.2}", a.name, a.value, b.value);
            assert!((0.5..3.0).contains(&effectivity), "edge {edge} {}: {effectivity}", a.name);
        }
    }
}

#[test]
fn refinement_reaches_its_target_and_says_where_it_cannot() {
    let mut p = pressed(LawKind::Linear, 1e-3);
    let accuracy = Accuracy { target: 1e-3, ..Accuracy::default() };
    let out = solve_goals_adaptive(&mut p, &[force("F", "top")], &accuracy).unwrap();
    assert!(out.levels > 2 && out.answers[0].relative_error_estimate() <= 1e-3);
    assert!(out.answers[0].relative_error_estimate() > 1e-5);
    let few = Accuracy { target: 1e-6, max_unknowns: 500, ..accuracy };
    let err = solve_goals_adaptive(&mut pressed(LawKind::Linear, 1e-3), &[force("F", "top")], &few).unwrap_err();
    assert!(matches!(err, FemError::Elasticity(ElasticityError::NotReached { .. })), "{err}");
}

#[test]
fn outputs_that_do_not_exist_are_refused() {
    let mut p = pressed(LawKind::Linear, 1e-3);
    p.conditions = vec![Condition::pin([0.0, 0.0], Second)];
    let err = |goal| solve_goals(&p, &[Quantity { name: "q".into(), goal }]).unwrap_err().to_string();
    assert!(err(Goal::Reaction { boundary: "outer".into(), component: Second }).contains("nothing holds it"));
    assert!(err(Goal::Reaction { boundary: "lid".into(), component: Second }).contains("lid"));
    assert!(err(Goal::Stress { at: [1e-4, 1e-4], component: "rt".into() }).contains("`rt`"));
    assert!(err(Goal::Strain { at: [1.0, 1e-4], component: "rr".into() }).contains("outside"));
}

/// There is no estimate above linear elements: an error, where an index beyond the end of a list was the answer.
#[test]
fn linear_elements_have_no_estimate() {
    let mut p = pressed(LawKind::Linear, 1e-3);
    p.order = Order::Linear;
    p.materials[0].formulation = Formulation::Displacement;
    let quantities = [force("F", "top")];
    let wanted = |e: FemError| matches!(e, FemError::Elasticity(ElasticityError::EstimateNeedsQuadratic));
    assert!(wanted(solve_goals(&p, &quantities).unwrap_err()));
    assert!(wanted(solve_goals_adaptive(&mut p, &quantities, &Accuracy::default()).unwrap_err()));
}
