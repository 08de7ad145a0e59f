//! Every table of the pages is what the result files say.

use std::path::{Path, PathBuf};
use truegap_tables::{TablesError, collect, pages, rewritten};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn the_pages_show_what_the_result_files_say() {
    for page in pages(&root()).unwrap() {
        assert!(
            !page.differs(),
            "{} differs from the result files; write it again: cargo run -p truegap-tables",
            page.path.display()
        );
    }
}

/// A page whose marks were lost would pass the comparison.
#[test]
fn readme_and_results_have_their_tables() {
    let marks = |name: &str| std::fs::read_to_string(root().join(name)).unwrap().matches("<!-- table: ").count();
    assert_eq!(marks("README.md"), 1);
    assert!(marks("docs/results.md") >= 5);
}

#[test]
fn a_number_changed_by_hand_is_a_difference() {
    let table = |_: &str, _: usize| Ok("| a |\n|---|\n| 1 |\n".to_owned());
    let page = "before\n<!-- table: x -->\n| a |\n|---|\n| 1 |\n<!-- end -->\nafter\n";
    assert_eq!(rewritten(page, table).unwrap(), page);
    assert_eq!(rewritten(&page.replace("| 1 |", "| 2 |"), table).unwrap(), page);
    assert_eq!(rewritten("<!-- table: x -->\n<!-- end -->\n", table).unwrap().lines().count(), 5);
}

#[test]
fn a_mark_without_its_end_is_an_error_that_names_it() {
    let table = |_: &str, _: usize| Ok(String::new());
    for page in ["text\n<!-- table: x -->\n", "text\n<!-- table: x -->\n<!-- table: y -->\n<!-- end -->\n"] {
        let error = rewritten(page, table).unwrap_err();
        assert!(matches!(&error, TablesError::NoEnd { line: 2, name } if name == "x"), "{error}");
    }
}

const ANSWER: &str = r#"{
    "recording": {"rows": 2908, "runs": 1, "sha256": "1ef2df150d5fe4fc38c7", "source": "/elsewhere/hold.toml"},
    "base": {"model": "parallel-plate", "parameters": []},
    "verdict": "ambiguous",
    "findings": [{"effect": "clock_rate", "probability": 0.999, "says": "a clock", "rivals": ["time_offset"]}],
    "fit": {
        "in_sample": {"rmse_before": 0.71, "rmse_after": 0.17},
        "held_out": {"how": "6 blocks", "rmse_before": 1.01, "rmse_after": 0.24, "shuffled_control": 0.56, "parts": []},
        "noise_floor": 0.118,
        "unit": "counts"
    },
    "seconds": 13.2
}"#;

#[test]
fn folders_of_answers_become_records_without_paths_of_this_machine() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::create_dir(dir.path().join("foam-insole--hold")).unwrap();
    std::fs::write(dir.path().join("foam-insole--hold/diagnosis.json"), ANSWER).unwrap();
    std::fs::write(dir.path().join("log.txt"), "not an answer").unwrap();
    let real = collect(dir.path()).unwrap();
    let [hold] = real.recordings.as_slice() else { panic!("{real:?}") };
    assert_eq!((hold.name.as_str(), hold.sha256.as_str()), ("foam-insole/hold", "1ef2df150d5f"));
    assert_eq!((hold.held_out, hold.permutation_control), (Some((1.01, 0.24)), Some(0.56)));
    assert_eq!(hold.findings[0].rivals, ["time_offset"]);
    assert!(!format!("{real:?}").contains("elsewhere"));
}

#[test]
fn a_recording_of_which_nothing_could_be_predicted_has_no_held_out_error() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::create_dir(dir.path().join("short")).unwrap();
    let nothing = ANSWER.replace(r#""rmse_before": 1.01, "rmse_after": 0.24,"#, r#""rmse_before": null, "rmse_after": null,"#);
    std::fs::write(dir.path().join("short/diagnosis.json"), nothing).unwrap();
    assert_eq!(collect(dir.path()).unwrap().recordings[0].held_out, None);
}

#[test]
fn folders_without_an_answer_are_named() {
    let dir = tempfile::tempdir().unwrap();
    assert!(matches!(collect(dir.path()).unwrap_err(), TablesError::NoFolders { .. }));
    std::fs::create_dir(dir.path().join("stopped")).unwrap();
    let error = collect(dir.path()).unwrap_err();
    assert!(matches!(&error, TablesError::NoAnswer { path } if path.ends_with("stopped")), "{error}");
}
