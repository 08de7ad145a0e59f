use super::*;

fn explained() -> Decision {
    Decision { verdict: Verdict::Explained, model: 3, sets: vec![vec![7]], ..Decision::nothing(Verdict::Explained, 0) }
}

/// An effect that takes 30 units of a recording with a burst of 360 is a small part of what is there; one that takes 3000 is not.
#[test]
fn interference_unseats_an_effect_that_explains_less_of_the_recording() {
    let small = explained().with_interference(0, 30.0, 360.0);
    assert_eq!((small.verdict, small.model, small.sets.len()), (Verdict::Unexplained, 0, 0));
    let large = explained().with_interference(0, 3000.0, 360.0);
    assert_eq!((large.verdict, large.model), (Verdict::Explained, 3));
    assert_eq!(Decision::nothing(Verdict::Agrees, 0).with_interference(0, 0.0, 1.0).verdict, Verdict::Unexplained);
    assert_eq!(Decision::nothing(Verdict::Undecided, 0).with_interference(0, 0.0, 99.0).verdict, Verdict::Undecided);
}

/// A curve stands for 93 or 99.5 % of what is removed, and beside it a lag with a rival is carried: nothing is open, and whether the curve explains all that counts is its share's matter.
#[test]
fn what_is_carried_leaves_nothing_open() {
    let both = || Decision { verdict: Verdict::Ambiguous, sets: vec![vec![7], vec![1, 2]], removed: 0.999, ..explained() };
    let of = |share| both().carrying((vec![1], share, false), &[7, 1], &left(0.0));
    assert_eq!((of(0.93).verdict, of(0.995).verdict), (Verdict::WrongForm, Verdict::Explained));
    assert_eq!((of(0.93).carried, of(0.93).claimed), (vec![1], 0.93));
    // tests see nothing in what is left of the model, and the curve leaves next to that: nothing is wrong with its form that one would see
    assert_eq!(both().carrying((vec![1], 0.93, true), &[7, 1], &left(0.0)).verdict, Verdict::Explained);
    let rivals = both().carrying((vec![7], 0.995, false), &[7, 1], &left(0.0));
    assert_eq!(rivals.verdict, Verdict::Ambiguous);
    assert_eq!(both().carrying((Vec::new(), 1.0, true), &[7, 1], &left(0.0)).verdict, Verdict::Ambiguous);
}

#[test]
fn rivals_are_told_each_with_the_effect_in_whose_place_it_stands() {
    let three = Decision { verdict: Verdict::Ambiguous, sets: vec![vec![7], vec![1, 2, 5]], ..explained() };
    assert_eq!(three.rivals().collect::<Vec<_>>(), [(1, 2), (1, 5)]);
    // what is told under another verdict leaves none open
    assert_eq!(Decision { verdict: Verdict::WrongForm, ..three }.rivals().count(), 0);
}

#[test]
fn a_rival_joins_the_set_of_its_effect() {
    let two = explained().with_rival((7, 2));
    assert_eq!((two.verdict, &two.sets), (Verdict::Ambiguous, &vec![vec![7, 2]]));
    assert_eq!(two.with_rival((7, 2)).sets, [[7, 2]]);
    assert_eq!(explained().with_rival((5, 2)).verdict, Verdict::Explained);
}

use crate::{
    fit::score_test::JointTest,
    selection::{candidates::Tried, model_space::EvidenceCheck},
};

/// What is left over of a model: nothing, or `excess` above twelve degrees of freedom.
fn left(excess: f64) -> Adequacy {
    let smooth = JointTest { statistic: 12.0 + excess, freedom: 12, p_value: if excess > 0.0 { 1e-9 } else { 0.5 } };
    Adequacy {
        smooth,
        stretches: JointTest { statistic: 0.0, freedom: 0, p_value: 1.0 },
        line_p_value: 1.0,
        line_at: (0, 0.0),
        left_over_noise: 1.0,
    }
}

/// Models with their effects and probabilities; each effect takes 1000 units of a misfit of `misfit`.
fn selection(misfit: f64, models: &[(&[usize], f64)]) -> Selection {
    let tried = |effects: &[usize]| {
        let left: f64 = (misfit - 1000.0 * effects.len() as f64).max(0.0);
        Tried::leaving(vec![left.sqrt()], effects)
    };
    let of = |effect: usize| models.iter().filter(|(e, _)| e.contains(&effect)).map(|(_, p)| p).sum();
    Selection {
        models: models.iter().map(|(effects, _)| tried(effects)).collect(),
        probability: models.iter().map(|(_, p)| *p).collect(),
        effect_probability: (0..5).map(of).collect(),
        temper: 1.0,
        base: models.iter().position(|(e, _)| e.is_empty()).unwrap(),
        check: EvidenceCheck::default(),
        unmodelled: Vec::new(),
    }
}

fn decided(models: &[(&[usize], f64)], before: f64, after: f64) -> Decision {
    decide(&selection(2000.0, models), &left(before), &left(after), |_| false)
}

#[test]
fn what_is_not_detected_is_not_named() {
    assert_eq!(decided(&[(&[], 0.7), (&[0], 0.3)], 0.0, 0.0).verdict, Verdict::Agrees);
    // as likely as not
    assert_eq!(decided(&[(&[], 0.5), (&[0], 0.5)], 0.0, 0.0).verdict, Verdict::Undecided);
    assert_eq!(decided(&[(&[0], 0.8), (&[], 0.2)], 0.0, 0.0).verdict, Verdict::Undecided);
    assert_eq!(decided(&[(&[0], 0.8), (&[], 0.2)], 90.0, 0.0).verdict, Verdict::Unexplained);
    assert_eq!(decided(&[(&[0], 0.97), (&[], 0.03)], 0.0, 0.0).verdict, Verdict::Explained);
}

#[test]
fn a_rival_within_twenty_makes_it_ambiguous() {
    let near = decided(&[(&[0], 0.92), (&[1], 0.07), (&[], 0.01)], 0.0, 0.0);
    assert_eq!((near.verdict, near.sets), (Verdict::Ambiguous, vec![vec![0, 1]]));
    let far = decided(&[(&[0], 0.96), (&[1], 0.03), (&[], 0.01)], 0.0, 0.0);
    assert_eq!((far.verdict, far.sets), (Verdict::Explained, vec![vec![0]]));
}

/// One effect takes 1000 of 2000 units; what the tests find beside it is a share of 1 %, 23 % or 33 % of that and it.
#[test]
fn what_is_left_decides_on_the_form() {
    let one: &[(&[usize], f64)] = &[(&[0], 0.99), (&[], 0.01)];
    assert_eq!(decided(one, 0.0, 5.0).verdict, Verdict::Explained);
    let wrong = decided(one, 0.0, 300.0);
    assert_eq!(wrong.verdict, Verdict::WrongForm);
    approx::assert_relative_eq!(wrong.removed, 1000.0 / 1300.0, max_relative = 1e-12);
    assert_eq!(decided(one, 0.0, 500.0).verdict, Verdict::Unexplained);
}

/// A slow response, or a drift with a relaxation: what is missing is one or the other two.
#[test]
fn two_effects_together_may_stand_in_the_place_of_one() {
    let one_or_two = decided(&[(&[0], 0.6), (&[1, 2], 0.4), (&[], 0.0)], 90.0, 0.0);
    assert_eq!((one_or_two.verdict, one_or_two.sets), (Verdict::Ambiguous, vec![vec![0, 1, 2]]));
}

/// One effect by itself, or another beside any of many: each of those models is far behind, and what is open is which of the two it is.
#[test]
fn many_models_of_one_rival_stand_in_the_place_of_an_effect_together() {
    let many: &[(&[usize], f64)] =
        &[(&[0], 0.88), (&[1, 2], 0.035), (&[1, 3], 0.035), (&[1, 4], 0.035), (&[4], 0.005), (&[], 0.01)];
    let found = decided(many, 90.0, 0.0);
    assert_eq!((found.verdict, found.sets), (Verdict::Ambiguous, vec![vec![0, 1]]));
    // three rivals that share it alike are none
    let apart: &[(&[usize], f64)] = &[(&[0], 0.88), (&[1, 2], 0.035), (&[3], 0.035), (&[4], 0.035), (&[], 0.01)];
    assert_eq!(decided(apart, 90.0, 0.0).verdict, Verdict::Undecided);
}

/// Two effects, of which the first is sure: what most of the few models without it hold is no rival of it, and the second is 0.7 likely, with another effect in most of what is without it.
#[test]
fn what_is_sure_has_no_rival_in_what_most_models_without_it_hold() {
    let models: &[(&[usize], f64)] =
        &[(&[0, 1], 0.7), (&[0, 2, 3], 0.033), (&[0, 2, 4], 0.033), (&[0, 2, 3, 4], 0.034), (&[0], 0.1)];
    let few: &[(&[usize], f64)] = &[(&[3, 4, 1], 0.034), (&[3, 2, 1], 0.033), (&[3, 4, 2], 0.033), (&[], 0.0)];
    let among = selection(3000.0, &[models, few].concat());
    // 0.7 + 0.2 of the probability has the first; 0.133 of 0.233 without the second has effect 2
    assert_eq!(crate::selection::rival_sets::sets_told(&among, 0), [vec![0], vec![1, 2]]);
}

/// The first effect has a rival in its place, the second is rather not there: it is not told beside the two.
#[test]
fn an_effect_that_is_rather_not_there_is_not_told_beside_rivals() {
    let models: &[(&[usize], f64)] = &[(&[0, 2], 0.34), (&[0], 0.3), (&[1], 0.3), (&[1, 2], 0.06), (&[], 0.0)];
    let found = decided(models, 90.0, 0.0);
    assert_eq!((found.verdict, found.sets), (Verdict::Ambiguous, vec![vec![0, 1]]));
}

/// All but 0.5 % of a misfit is removed, and what is left stands a hundred times out of the noise: there is more to be found.
#[test]
fn a_loud_rest_is_no_adequate_equation() {
    let one: &[(&[usize], f64)] = &[(&[0], 0.99), (&[], 0.01)];
    let decided =
        |left_over_noise| decide(&selection(2000.0, one), &left(0.0), &Adequacy { left_over_noise, ..left(5.0) }, |_| false);
    assert_eq!(decided(3.0).verdict, Verdict::Explained);
    assert_eq!(decided(100.0).verdict, Verdict::WrongForm);
}

/// The likeliest model holds an effect that is not sure and has no rival: the smaller one is stated.
#[test]
fn an_effect_that_is_not_sure_is_left_out_of_what_is_stated() {
    let two: &[(&[usize], f64)] = &[(&[0, 1], 0.6), (&[0], 0.39), (&[], 0.01)];
    let found = decided(two, 0.0, 0.0);
    assert_eq!((found.verdict, found.sets, found.model), (Verdict::Explained, vec![vec![0]], 1));
}

/// A curve is sure, and beside it one of two or both; the curve alone is excluded. It is not stated for want of a sure second one: the likeliest of the two stands, with the other as rival.
#[test]
fn what_the_evidence_excludes_is_not_stated_for_want_of_a_sure_name() {
    let open: &[(&[usize], f64)] = &[(&[0, 1, 2], 0.45), (&[0, 1], 0.42), (&[0, 2], 0.13), (&[0], 0.0), (&[], 0.0)];
    let found = decided(open, 0.0, 0.0);
    assert_eq!((found.verdict, found.model, found.sets), (Verdict::Ambiguous, 1, vec![vec![0], vec![1, 2]]));
}

/// Two effects were stood behind; the second is not claimed any more. What is left decides on the form as before, and a set stays with its effect.
#[test]
fn a_smaller_model_takes_over_with_its_own_sets_and_form() {
    let models: &[(&[usize], f64)] = &[(&[0, 1], 0.99), (&[0], 0.005), (&[], 0.005)];
    let selection = selection(3000.0, models);
    let fuller =
        Decision { verdict: Verdict::Explained, sets: vec![vec![0], vec![1, 2]], ..Decision::nothing(Verdict::Explained, 0) };
    let of = |excess: f64| stepped_back(&selection, &fuller, 1, &left(excess));
    assert_eq!((of(0.0).verdict, of(0.0).model, of(0.0).sets), (Verdict::Explained, 1, vec![vec![0]]));
    assert_eq!(of(300.0).verdict, Verdict::WrongForm);
    let little = of(5000.0);
    assert_eq!((little.verdict, little.model), (Verdict::Unexplained, 2));
    let other = Decision { sets: vec![vec![0, 2], vec![1]], ..fuller.clone() };
    assert_eq!(stepped_back(&selection, &other, 1, &left(0.0)).verdict, Verdict::Ambiguous);
}

/// Effect 3 is a rival of effect 0; the told model holds them in another order than the likeliest does.
#[test]
fn sets_stand_in_the_order_of_the_model_that_is_told() {
    let among = selection(3000.0, &[(&[1, 0, 2], 0.4), (&[1, 3, 2], 0.3), (&[0, 1], 0.25), (&[], 0.05)]);
    assert_eq!(crate::selection::rival_sets::sets_told(&among, 2), [vec![0, 3], vec![1]]);
}
