use super::*;
use crate::selection::unmodelled::Cause;

fn tried(effects: &[usize]) -> Tried {
    Tried::leaving(vec![0.0; 3], effects)
}

fn selection(odds: f64) -> Selection {
    let wanders =
        Unmodelled { cause: Cause::WanderingZero, effects: EffectSet::from(&[][..]), weight: 0.0, gain: 0.0, row: None };
    Selection {
        models: vec![tried(&[]), tried(&[0])],
        probability: vec![0.2, 0.8],
        effect_probability: vec![0.8],
        temper: 1.0,
        base: 0,
        check: EvidenceCheck::default(),
        unmodelled: vec![(wanders, odds)],
    }
}

/// Odds of 3 against everything are a probability of 3/4, whatever an unmodelled cause has, and the rest keeps its shares; odds beyond any number are certainty.
#[test]
fn one_more_model_has_the_probability_of_its_odds() {
    for odds in [0.0, 1.0, 1e200] {
        let with = selection(odds).with_model(tried(&[1]), 3f64.ln(), 1);
        approx::assert_relative_eq!(with.effect_probability[1], 0.75, max_relative = 1e-12);
        approx::assert_relative_eq!(with.effect_probability[0], 0.25 * 0.8 / (1.0 + odds), max_relative = 1e-9);
        approx::assert_relative_eq!(with.probability_unmodelled(), 0.25 * odds / (1.0 + odds), max_relative = 1e-9);
        let certain = selection(odds).with_model(tried(&[1]), 5e4, 1);
        approx::assert_relative_eq!(certain.effect_probability[1], 1.0);
    }
}

/// Three models of 0.2, 0.5 and 0.3; the largest holds an effect that cannot be seen.
fn three() -> Selection {
    Selection {
        models: vec![tried(&[0]), tried(&[0, 1]), tried(&[])],
        probability: vec![0.5, 0.3, 0.2],
        effect_probability: vec![0.0; 2],
        base: 2,
        unmodelled: Vec::new(),
        ..selection(0.0)
    }
}

#[test]
fn what_cannot_be_seen_counts_for_the_model_without_it() {
    let merged = three().merged(|_, tried| tried.effects.contains(&1).then(|| tried.key().without(1)).into_iter().collect());
    approx::assert_relative_eq!(merged.effect_probability[0], 0.8, max_relative = 1e-12);
    assert_eq!(merged.effect_probability[1], 0.0);
    approx::assert_relative_eq!(merged.probability.iter().sum::<f64>(), 1.0, max_relative = 1e-12);
}

/// A mechanism of 0.3 and an effect of 0.5 that say the same have 0.8 together under the effect's name, whether its model was fitted before or not.
#[test]
fn what_is_told_by_a_name_keeps_its_probability() {
    let known = three().told_as(1, tried(&[0]));
    assert_eq!((known.models.len(), known.models[0].effects.as_slice()), (3, &[0][..]));
    approx::assert_relative_eq!(known.probability[0], 0.8, max_relative = 1e-12);
    let new = selection(0.0).with_model(tried(&[1]), 3f64.ln(), 1).told_as(0, tried(&[0, 1]));
    approx::assert_relative_eq!(new.probability.iter().sum::<f64>(), 1.0, max_relative = 1e-12);
    approx::assert_relative_eq!(new.probability[0], 0.75, max_relative = 1e-12);
    assert_eq!(new.models[0].effects, [0, 1]);
}

/// Squares of 0.5, 0.3 and 0.2 over their sum, 0.38.
#[test]
fn sharpened_probabilities_are_powers_over_their_sum() {
    let sharp = three().sharpened(2.0);
    approx::assert_relative_eq!(
        sharp.probability.as_slice(),
        [0.25 / 0.38, 0.09 / 0.38, 0.04 / 0.38].as_slice(),
        max_relative = 1e-12
    );
    approx::assert_relative_eq!(sharp.probability_none(), 0.04 / 0.38, max_relative = 1e-12);
    let beside = selection(0.5).sharpened(2.0);
    // 0.2, 0.8 and odds of 0.5: squares 0.04, 0.64, 0.25
    approx::assert_relative_eq!(beside.probability_unmodelled(), 0.25 / 0.93, max_relative = 1e-12);
}

/// Odds that stand for certainty do so at any power, and leave nothing to what the library names.
#[test]
fn certainty_stays_certainty_at_every_power() {
    for power in [0.25, 1.0, 4.06] {
        let certain = selection(LARGEST_GAIN.exp()).sharpened(power);
        approx::assert_relative_eq!(certain.probability_unmodelled(), 1.0, max_relative = 1e-12);
        assert!(certain.effect_probability[0] < 1e-9, "{:?}", certain.effect_probability);
    }
    let nothing = selection(0.0).sharpened(4.06);
    assert_eq!(nothing.probability_unmodelled(), 0.0);
}

/// Of 0.2, 0.5 and 0.3 the models that hold effect 0 are gone: the base model is alone, and no rival is left. Without those that hold effects 0 and 1, 0.2 and 0.5 are left of 0.7.
#[test]
fn without_what_rows_left_out_refute_rivals_keep_their_shares() {
    assert!(three().without_holders_of(&[0], 2).is_none());
    let left = three().without_holders_of(&[0, 1], 2).unwrap();
    approx::assert_relative_eq!(left.effect_probability[0], 0.5 / 0.7, max_relative = 1e-12);
    assert_eq!((left.effect_probability[1], left.models.len()), (0.0, 3));
    // a rival of a thousandth is none
    let sure = Selection { probability: vec![0.001, 0.998, 0.001], ..three() };
    assert!(sure.without_holders_of(&[0, 1], 2).is_none());
}

/// A model from behind one effect of the library gives its share back, and room is made for two others.
#[test]
fn mechanisms_make_room_for_others() {
    let left = three().of_the_library(1, 2);
    assert_eq!((left.models.len(), left.effect_probability.len()), (2, 3));
    approx::assert_relative_eq!(left.effect_probability[0], 0.5 / 0.7, max_relative = 1e-12);
}

/// A library that rows left out contradict has no probability left, and neither has what was composed beside it.
#[test]
fn what_is_refuted_leaves_the_base_model_alone() {
    let whole = selection(0.5).with_model(tried(&[1]), 2.0, 1);
    let alone = whole.refuted(1);
    assert_eq!(alone.models.len(), 2);
    assert_eq!((alone.base, alone.probability_none()), (0, 1.0));
    assert_eq!(alone.effect_probability, [0.0]);
    assert_eq!(alone.probability_unmodelled(), 0.0);
}

/// Of the models that hold a rival without the effect, the likeliest that holds all else that is named stands for it, also where another is likelier; and that one where none does.
#[test]
fn a_rival_is_judged_beside_what_else_is_named() {
    let models = vec![tried(&[]), tried(&[0, 1]), tried(&[2]), tried(&[0, 2]), tried(&[0, 2, 3]), tried(&[1, 2, 0]), tried(&[4])];
    let all = Selection {
        models,
        probability: vec![0.0, 0.4, 0.2, 0.1, 0.15, 0.05, 0.1],
        effect_probability: vec![0.0; 5],
        unmodelled: Vec::new(),
        ..selection(0.0)
    };
    let found =
        |effect, rival| crate::selection::rival_sets::in_place_of(&all, 1, effect, rival).map(|tried| tried.effects.clone());
    assert_eq!(found(1, 2), Some(vec![0, 2, 3]));
    assert_eq!(found(1, 4), Some(vec![4]));
    assert_eq!(found(0, 3), None);
}
