//! Descriptions that are refused before anything is solved, with the place and the remedy.

use super::bodies::*;
use truegap_fem::Symmetry;
use truegap_fem::elasticity::*;

#[test]
fn a_body_that_can_move_is_refused_before_anything_is_solved() {
    let free = problem(patch(0.4), steel());
    assert!(matches!(Solver::new(free).err(), Some(ElasticityError::RigidMotion { .. })));
    let planar = |conditions| Problem { symmetry: Symmetry::Planar, conditions, ..problem(patch(0.4), steel()) };
    let err = |conditions| Solver::new(planar(conditions)).err().map(|e| e.to_string()).unwrap_or_default();
    assert!(err(vec![Condition::fix("bottom", Second)]).contains("along x"));
    assert!(err(vec![Condition::fix("inner", First)]).contains("along y"));
    let hinge = vec![Condition::pin([0.0, 0.0], First), Condition::pin([0.0, 0.0], Second)];
    assert!(err(hinge).contains("turning"));
    assert_eq!(err(vec![Condition::fix("bottom", Second), Condition::pin([0.0, 0.0], First)]), "");
}

#[test]
fn wrong_descriptions_are_refused_with_the_place_and_the_remedy() {
    let held = |material| {
        let mut p = problem(patch(0.4), material);
        p.conditions = vec![Condition::fix("bottom", Second)];
        p
    };
    let text = |p: Problem| Solver::new(p).err().map(|e| e.to_string()).unwrap_or_default();
    let half = text(held(rubber(0.5, Formulation::Displacement)));
    assert!(half.contains("`body`") && half.contains("mixed"), "{half}");
    assert!(text(held(rubber(0.51, Formulation::Mixed))).contains("0.51"));
    assert!(text(held(Material { young: -1.0, ..steel() })).contains("Young"));
    assert!(text(held(Material { expansion: f64::NAN, ..steel() })).contains("expansion"));
    let mut p = held(steel());
    p.materials.clear();
    assert!(text(p).contains("body"));
    let mut p = held(steel());
    p.conditions.push(Condition::displace("bottom", Second, 1e-3));
    assert!(text(p).contains("two conditions"));
    let mut p = held(steel());
    p.conditions.push(Condition::fix("lid", Second));
    assert!(text(p).contains("lid"));
    let mut p = held(steel());
    p.conditions.push(Condition::pressure("top", f64::NAN));
    assert!(text(p).contains("top"));
    let mut p = held(steel());
    p.conditions.push(Condition::pin([0.123, 0.456], Second));
    assert!(text(p).contains("no node"));
    let mut p = held(rubber(0.49, Formulation::Mixed));
    p.order = Order::Linear;
    assert!(text(p).contains("quadratic"));
    let mut p = held(steel());
    p.mesh.triangles[3].swap(0, 1);
    assert!(text(p).contains("inverted"));
    let s = Solver::new(held(steel())).unwrap().solve().unwrap();
    assert!(matches!(s.stress_at([2.0, 0.5]), Err(ElasticityError::Outside { .. })));
    assert_eq!(text(held(steel())), "");
}
