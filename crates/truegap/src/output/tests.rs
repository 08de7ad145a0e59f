//! A folder appears whole, replaces what is ours, and leaves alone what is not.

use super::*;

/// What makes a folder one of ours.
const DOCUMENT: &str = "{\"schema\": \"truegap.audit/1\"}";

fn place(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("truegap-output-{}-{name}", std::process::id()));
    remove(&path).unwrap();
    fs::create_dir_all(&path).unwrap();
    path
}

#[test]
fn a_folder_appears_whole() {
    let place = place("whole");
    let target = place.join("deep/er/out");
    let folder = OutputFolder::begin(&target).unwrap();
    folder.write("meshes/a.glb", "1").unwrap();
    assert!(!target.exists());
    folder.publish().unwrap();
    assert_eq!(fs::read_to_string(target.join("meshes/a.glb")).unwrap(), "1");
    assert_eq!(entries(target.parent().unwrap()).unwrap(), ["out"]);
    remove(&place).unwrap();
}

#[test]
fn what_is_given_up_leaves_nothing() {
    let place = place("dropped");
    let folder = OutputFolder::begin(place.join("out")).unwrap();
    folder.write("a", "1").unwrap();
    drop(folder);
    assert!(entries(&place).unwrap().is_empty());
    remove(&place).unwrap();
}

#[test]
fn an_earlier_result_is_replaced_and_anything_else_is_not() {
    let place = place("again");
    let target = place.join("out");
    for round in ["1", "2"] {
        let folder = OutputFolder::begin(&target).unwrap();
        folder.write("a", round).unwrap();
        folder.write("audit.json", DOCUMENT).unwrap();
        folder.publish().unwrap();
    }
    assert_eq!(fs::read_to_string(target.join("a")).unwrap(), "2");
    fs::write(target.join("thesis.tex"), "mine").unwrap();
    let folder = OutputFolder::begin(&target).unwrap();
    folder.write("a", "3").unwrap();
    folder.write("audit.json", DOCUMENT).unwrap();
    assert!(matches!(folder.publish(), Err(OutputError::Foreign { entry, .. }) if entry == "thesis.tex"));
    assert_eq!(fs::read_to_string(target.join("a")).unwrap(), "2");
    assert_eq!(entries(&place).unwrap(), ["out"]);
    remove(&place).unwrap();
}

#[test]
fn a_place_is_checked_without_a_trace() {
    let place = place("checked");
    let files = ["audit.json", "report.html"];
    OutputFolder::check(place.join("new/deep"), &files).unwrap();
    assert!(entries(&place).unwrap().is_empty());
    fs::write(place.join("file"), "x").unwrap();
    assert!(matches!(OutputFolder::check(place.join("file"), &files), Err(OutputError::NotAFolder { .. })));
    assert!(matches!(OutputFolder::check(place.join("file/out"), &files), Err(OutputError::NotAFolder { .. })));
    fs::create_dir(place.join("old")).unwrap();
    fs::write(place.join("old/audit.json"), DOCUMENT).unwrap();
    OutputFolder::check(place.join("old"), &files).unwrap();
    fs::write(place.join("old/thesis.tex"), "x").unwrap();
    assert!(
        matches!(OutputFolder::check(place.join("old"), &files), Err(OutputError::Foreign { entry, .. }) if entry == "thesis.tex")
    );
    remove(&place).unwrap();
}

/// A page that somebody wrote and called as we call ours: it was replaced without a word, as only names were compared.
#[test]
fn a_page_of_somebody_else_stays_whatever_it_is_called() {
    let place = place("page");
    let out = place.join("out");
    fs::create_dir(&out).unwrap();
    OutputFolder::check(&out, &["report.html"]).unwrap();
    fs::write(out.join("report.html"), "mine").unwrap();
    let theirs = |refused: OutputError| matches!(refused, OutputError::NotAResult { entry, .. } if entry == "report.html");
    assert!(theirs(OutputFolder::check(&out, &["report.html", "audit.json"]).unwrap_err()));
    assert!(theirs(OutputFolder::check_beside(&out, &["report.html"]).unwrap_err()));
    OutputFolder::check_beside(&out, &["other.html"]).unwrap();
    let folder = OutputFolder::begin(&out).unwrap();
    folder.write("report.html", "ours").unwrap();
    folder.write("audit.json", DOCUMENT).unwrap();
    assert!(theirs(folder.publish().unwrap_err()));
    assert_eq!(fs::read_to_string(out.join("report.html")).unwrap(), "mine");
    remove(&place).unwrap();
}

/// A second result with fewer files than the first: found by running a diagnosis twice into one folder, once with a mechanism and once without.
#[test]
fn a_result_with_fewer_files_replaces_an_earlier_one() {
    let place = place("fewer");
    let write = |files: &[&str]| {
        let folder = OutputFolder::begin(place.join("out")).unwrap().replacing(&["audit.json", "b"]);
        files.iter().for_each(|file| folder.write(file, DOCUMENT).unwrap());
        folder.publish()
    };
    write(&["audit.json", "b"]).unwrap();
    write(&["audit.json"]).unwrap();
    assert_eq!(entries(&place.join("out")).unwrap(), ["audit.json"]);
    fs::write(place.join("out/thesis.tex"), "x").unwrap();
    assert!(matches!(write(&["audit.json"]), Err(OutputError::Foreign { entry, .. }) if entry == "thesis.tex"));
    remove(&place).unwrap();
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link() {
    let place = place("link");
    fs::create_dir(place.join("real")).unwrap();
    std::os::unix::fs::symlink("real", place.join("out")).unwrap();
    std::os::unix::fs::symlink("nowhere", place.join("lost")).unwrap();
    for round in ["1", "2"] {
        OutputFolder::check(place.join("out"), &["a", "audit.json"]).unwrap();
        let folder = OutputFolder::begin(place.join("out")).unwrap();
        folder.write("a", round).unwrap();
        folder.write("audit.json", DOCUMENT).unwrap();
        folder.publish().unwrap();
        assert!(place.join("out").is_symlink());
        assert_eq!(fs::read_to_string(place.join("real/a")).unwrap(), round);
    }
    assert!(matches!(OutputFolder::check(place.join("lost"), &["a"]), Err(OutputError::NotAFolder { .. })));
    assert_eq!(entries(&place).unwrap().len(), 3);
    remove(&place).unwrap();
}

#[cfg(target_os = "linux")]
#[test]
fn there_is_a_folder_at_every_moment_of_a_replacement() {
    let place = place("exchange");
    for (name, text) in [("part", "new"), ("target", "old")] {
        fs::create_dir(place.join(name)).unwrap();
        fs::write(place.join(name).join("a"), text).unwrap();
    }
    assert!(exchange(&place.join("part"), &place.join("target")));
    let read = |name: &str| fs::read_to_string(place.join(name).join("a")).unwrap();
    assert_eq!((read("target").as_str(), read("part").as_str()), ("new", "old"));
    remove(&place).unwrap();
}

#[test]
fn a_file_is_not_a_folder() {
    let place = place("file");
    fs::write(place.join("out"), "x").unwrap();
    assert!(matches!(OutputFolder::begin(place.join("out")), Err(OutputError::NotAFolder { .. })));
    remove(&place).unwrap();
}
