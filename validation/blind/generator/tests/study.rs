//! A study is the same from the same seed, binds to its answers, and has the format of the contract.

use truegap_generator::protocol::Kind;
use truegap_generator::study::{StudyError, open};
use truegap_generator::{Options, Study};

fn small(seed: u64, cases: usize) -> Study {
    let protocols = vec![Kind::Short, Kind::Bench];
    Study::new(seed, cases, Options { protocols, ..Options::default() }).expect("options")
}

#[test]
fn the_same_seed_gives_the_same_study_and_another_seed_another() {
    let [first, again, other] = [4, 4, 5].map(|seed| small(seed, 4));
    for index in 0..4 {
        let [a, b, c] = [&first, &again, &other].map(|study| study.case(index).expect("case"));
        assert_eq!(a.recording, b.recording);
        assert_eq!(a.answer, b.answer);
        assert_ne!(a.recording, c.recording);
        assert_ne!(a.answer.salt, c.answer.salt);
    }
    // A case does not depend on how many come before it.
    let alone = small(4, 1).case(3).expect("case");
    assert_eq!(alone.answer, first.case(3).expect("case").answer);
}

#[test]
fn a_written_study_opens_and_one_in_which_a_file_was_altered_does_not() {
    let folder = tempfile::tempdir().expect("folder");
    let study = small(9, 3);
    study.write(folder.path(), "{\"seed\": 9}", |_| ()).expect("written");
    let answers = open(folder.path()).expect("opened");
    assert_eq!(answers.len(), 3);
    assert_eq!(answers[1], study.case(1).expect("case").answer);
    for file in ["key/case-002.json", "key/plan.json", "case-003/recording.csv", "case-001/recording.toml", "commitments.txt"] {
        let path = folder.path().join(file);
        let right = std::fs::read_to_string(&path).expect("file");
        // the first line of the commitments is that of the first answer
        std::fs::write(&path, right.replacen(char::is_alphanumeric, "0", 3)).expect("altered");
        assert!(matches!(open(folder.path()), Err(StudyError::Commitment(_))), "{file}");
        std::fs::remove_file(&path).expect("removed");
        assert!(matches!(open(folder.path()), Err(StudyError::File { .. })), "{file}");
        std::fs::write(&path, right).expect("put back");
    }
    assert_eq!(open(folder.path()).expect("opened"), answers);
}

#[test]
fn recordings_have_the_columns_units_and_resolution_of_the_contract() {
    let study = small(21, 6);
    for case in study.iter() {
        let case = case.expect("case");
        let csv = case.recording.csv();
        let humidity = if case.answer.humidity_column { "humidity_pct," } else { "" };
        let mut lines = csv.lines();
        assert_eq!(lines.next(), Some(format!("run,time_s,force_n,temperature_c,{humidity}capacitance_pf").as_str()));
        assert_eq!(csv.lines().count(), case.truth_pf.len() + 1);
        let mut before = f64::NEG_INFINITY;
        for line in lines {
            let numbers: Vec<f64> = line.split(',').map(|text| text.parse().expect("number")).collect();
            assert!(numbers[1] > before);
            before = numbers[1];
            let femto = numbers[numbers.len() - 1] * 1e3;
            assert!((femto - femto.round()).abs() < 1e-6, "{line}");
        }
        assert!(case.recording.toml().contains(&format!("warp = {}", case.answer.warp_declared)));
    }
}

/// Six standard errors of the sample mean and spread; the resolution of 1 fF adds 0.3 fF in quadrature.
#[test]
fn what_is_recorded_differs_from_the_truth_by_the_noise_stated() {
    let case = small(33, 1).case(0).expect("case");
    let pairs = case.recording.capacitance_pf.iter().zip(&case.truth_pf);
    let apart: Vec<f64> = pairs.map(|(recorded, truth)| recorded - truth).collect();
    let rows = apart.len() as f64;
    let spread = (apart.iter().map(|a| a * a).sum::<f64>() / rows).sqrt();
    let stated = case.answer.noise.sd_pf;
    assert!((spread / stated - 1.0).abs() < 6.0 * (2.0 / rows).sqrt() * 2.0, "{spread} against {stated}");
}

#[test]
fn detectability_in_the_answer_is_what_was_drawn_within_its_range() {
    let study = Study::new(2, 40, Options { protocols: vec![Kind::Bench], ..Options::default() }).expect("options");
    let (mut nulls, mut causes) = (0, 0);
    for case in study.iter() {
        let answer = case.expect("case").answer;
        let nothing = answer.effects.is_empty() && answer.stranger.is_none();
        assert_eq!(nothing, answer.detectability == 0.0);
        assert!(answer.each.iter().all(|d| *d > 4.0 * 0.8 && *d < 120.0 * 1.2), "{:?}", answer.each);
        if nothing { nulls += 1 } else { causes += 1 }
    }
    assert!(nulls > 0 && causes > 10, "{nulls} nulls, {causes} others");
}

#[test]
fn a_fresh_history_has_the_same_sensor_and_other_rows() {
    let study = small(6, 12);
    let case = study.iter().map(|case| case.expect("case")).find(|case| !case.acts.is_empty()).expect("a cause");
    let [first, second] = [0, 1].map(|number| case.fresh(number).expect("fresh"));
    assert_ne!(first.recording, second.recording);
    assert_eq!(first.truth_pf.len(), first.recording.capacitance_pf.len());
    assert_eq!(first.quiet.capacitance_pf, first.truth_pf);
    assert_eq!(first.recording.warp, case.answer.warp_declared);
}

#[test]
fn a_range_of_detectability_that_runs_backwards_is_refused() {
    let options = Options { detectability_from: 50.0, detectability_to: 4.0, ..Options::default() };
    assert!(matches!(Study::new(1, 1, options), Err(StudyError::Range { .. })));
}

/// What makes the study blind to errors of the model: no truegap crate among the dependencies.
#[test]
fn the_generator_shares_no_code_with_the_model() {
    let manifest = include_str!("../Cargo.toml");
    let shared: Vec<&str> = manifest.lines().filter(|line| line.starts_with("truegap")).collect();
    assert!(shared.is_empty() && manifest.contains("[dependencies]"), "{shared:?}");
}
