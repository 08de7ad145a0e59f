//! Wild studies and those that leave an effect out: what is drawn, and how what is said of it is judged.

use serde_json::{Value, json};
use std::sync::LazyLock;
use truegap_generator::causes::{FURTHER, LIBRARY, left_out};
use truegap_generator::protocol::Kind;
use truegap_generator::score::mechanisms::{judged, rows};
use truegap_generator::score::truth::Truth;
use truegap_generator::score::words::words_of;
use truegap_generator::score::{Scored, judge::Outcome, score, table::table};
use truegap_generator::settings::Only;
use truegap_generator::{Answer, Options, Study};

fn study(only: Only, cases: usize, protocols: Vec<Kind>) -> Vec<Answer> {
    let options = Options { only, detectability_from: 20.0, detectability_to: 60.0, protocols };
    let study = Study::new(31, cases, options).expect("options");
    study.iter().map(|case| case.expect("case").answer).collect()
}

/// The table is the cheapest protocol: some 500 rows. Drawn once for all tests.
fn wild() -> &'static [Answer] {
    static ANSWERS: LazyLock<Vec<Answer>> = LazyLock::new(|| study(Only::Wild, 30, vec![Kind::Table]));
    &ANSWERS
}

fn says(verdict: &str, named: &[&str], words: Option<[&str; 3]>) -> Value {
    let findings: Vec<Value> = named.iter().map(|id| json!({"effect": id, "probability": 0.95})).collect();
    let discovered: Vec<Value> = words
        .iter()
        .map(|[place, driver, kinetics]| {
            let held_out = json!({"rmse_before": 0.010, "rmse_after": 0.005});
            json!({"place": place, "driver": driver, "kinetics": kinetics, "named": true, "held_out": held_out})
        })
        .collect();
    json!({"verdict": verdict, "findings": findings, "discovered": discovered, "fit": {"noise_floor": 0.004}})
}

#[test]
fn a_bath_is_weak_and_of_other_families_and_every_sort_of_case_is_drawn() {
    let answers = wild();
    let mut baths = 0;
    for answer in answers {
        assert!(answer.bath.len() <= 3 && answer.bath.values().all(|d| (0.9..4.2).contains(d)), "{:?}", answer.bath);
        assert!(answer.effects.iter().all(|id| !answer.bath.contains_key(id)));
        assert!(answer.logger.is_some() && answer.without.is_none());
        baths += usize::from(!answer.bath.is_empty());
    }
    assert!(baths > 12, "{baths}");
    assert!(answers.iter().any(|a| a.effects.is_empty() && a.stranger.is_none()));
    assert!(answers.iter().any(|a| a.effects.len() >= 2) && answers.iter().any(|a| a.stranger.is_some()));
    let words = answers.iter().filter_map(|a| a.stranger.as_deref()).map(words_of);
    assert!(words.into_iter().all(|words| words.is_some()));
}

#[test]
fn each_effect_is_left_out_once_and_named_beside_its_recording() {
    let ids: Vec<&str> = (0..29).map(|index| left_out(index).0).collect();
    let mut apart = ids.clone();
    apart.sort_unstable();
    apart.dedup();
    assert_eq!((ids.len(), apart.len(), left_out(29).0), (LIBRARY.len() + FURTHER.len(), 29, ids[0]));
    let folder = tempfile::tempdir().expect("folder");
    let options = Options { only: Only::WithoutEach, protocols: vec![Kind::Bench], ..Options::default() };
    Study::new(3, 2, options).expect("options").write(folder.path(), "{}", |_| ()).expect("written");
    for (case, id) in ["case-001", "case-002"].iter().zip(&ids) {
        assert_eq!(std::fs::read_to_string(folder.path().join(case).join("without.txt")).expect("file"), *id);
    }
}

fn scored(words: [&str; 3], named: &[&str]) -> Scored {
    let answers = study(Only::WithoutEach, 1, vec![Kind::Bench]);
    score(Truth::from(&answers[0]), &says("explained", named, Some(words))).expect("scored")
}

/// Case 1 leaves out `contact_toe_in`: a static law of the load.
#[test]
fn words_are_right_together_and_a_library_name_is_wrong() {
    let right = scored(["mechanics", "load", "static"], &["discovered"]);
    let judgement = judged(&right).expect("words");
    assert!(judgement.law && judgement.place && right.outcome == Outcome::Right);
    let late = scored(["readout", "load", "first_order"], &["discovered"]);
    let judgement = judged(&late).expect("words");
    assert!(judgement.driver && !judgement.law && !judgement.kinetics && !judgement.place);
    assert_eq!(scored(["mechanics", "load", "static"], &["strain_stiffening"]).outcome, Outcome::Wrong);
    // 1 - (5^2 - 4^2) / (10^2 - 4^2)
    let removed = right.claim.mechanism.as_ref().and_then(|m| m.misfit_removed).expect("share");
    assert!((removed - 75.0 / 84.0).abs() < 1e-12, "{removed}");
}

/// No mechanism is listed, and another effect of the library stands in: its words are those of the answer, with those of its rivals.
#[test]
fn an_answer_under_another_name_is_judged_by_its_words() {
    let answers = study(Only::WithoutEach, 1, vec![Kind::Bench]);
    let mut diagnosis = says("ambiguous", &["strain_stiffening", "offset_drift"], None);
    let words = |place: &str, driver: &str| json!({"place": {place: 0.9}, "driver": {driver: 0.9, "reading": 0.1}, "kinetics": {"static": 1.0}});
    for (k, (stands_out, words)) in [(30.0, words("mechanics", "load")), (4.0, words("readout", "time"))].into_iter().enumerate()
    {
        diagnosis["findings"][k]["detectability"] = json!(stands_out);
        diagnosis["findings"][k]["words"] = words;
    }
    let case = score(Truth::from(&answers[0]), &diagnosis).expect("scored");
    let row = |says: &str| rows(std::slice::from_ref(&case)).into_iter().find(|row| row.says.contains(says)).expect("row").hits;
    assert_eq!(
        [row("whole answer: driver"), row("whole answer: place"), row("mechanisms: driver and")],
        [Some(1), Some(1), Some(0)]
    );
}

#[test]
fn an_oracle_meets_the_rows_of_the_wild_tier_and_silence_does_not() {
    let all = |speaks: bool| -> Vec<Scored> {
        let said = |truth: &Truth| match (&truth.words, truth.is_null() || !speaks) {
            (_, true) => says("agrees", &[], None),
            (Some(words), _) => {
                let place = words.places.first().expect("place");
                let (driver, kinetics) = words.laws.first().expect("law");
                says("explained", &["discovered"], Some([place, driver, kinetics]))
            }
            (None, _) => says("explained", &truth.causes.iter().map(String::as_str).collect::<Vec<_>>(), None),
        };
        wild().iter().map(Truth::from).map(|truth| score(truth.clone(), &said(&truth)).expect("scored")).collect()
    };
    let oracle = rows(&all(true));
    let misses: Vec<_> = oracle.iter().filter(|row| row.met == Some(false) && !row.says.contains("misfit removed")).collect();
    assert!(misses.is_empty() && oracle.len() == 15, "{misses:#?}");
    let silent = rows(&all(false));
    let row = |says: &str| silent.iter().find(|row| row.says.contains(says)).unwrap_or_else(|| panic!("{says}"));
    assert_eq!(row("single causes").met, Some(false));
    assert_eq!(row("nulls with bath and any logger: right").met, Some(true));
    assert_eq!(row("driver right").hits, Some(0));
    assert!(table(&all(true)).contains("mechanisms one by one"));
    // the loggers of recordings with a cause are not counted where nothing is missing
    let nulls = wild().iter().map(Truth::from).filter(Truth::is_null).count();
    let text = table(&all(true));
    let (_, loggers) = text.split_once("nothing missing, written down by").expect("loggers");
    let sum = loggers.lines().find(|line| line.starts_with("all ")).expect("their sum");
    assert!(nulls > 0);
    assert_eq!(sum.split_whitespace().collect::<Vec<_>>(), ["all", "0", &nulls.to_string(), "0", "0"]);
}

#[test]
fn the_truth_of_a_shared_wild_recording_says_which_words_are_right() {
    let mechanism =
        json!({"kind": "stick_slip", "place": ["geometry"], "driver": ["load", "load_history"], "kinetics": ["event"]});
    let shared =
        json!({"effects": [], "bath": {"gain_drift": 1.1}, "mechanism": mechanism, "detectability": 65.0, "protocol": "sines"});
    let truth = Truth::of_shared("case-01", &shared).expect("truth");
    assert!(!truth.is_null() && truth.stranger.as_deref() == Some("stick_slip") && truth.bath.contains("gain_drift"));
    let words = truth.words.expect("words");
    assert!(words.laws.contains(&("load_history".into(), "event".into())) && !words.has_kinetics("static"));
}
