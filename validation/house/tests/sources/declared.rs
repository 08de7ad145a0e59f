//! What breaks the order, and what does not.

use super::{files, findings};
use std::fs;
use truegap_house::{Finding, House, HouseError, ORDER};

const LIB: (&str, &str) = ("lib.rs", "mod high; mod low; pub use low::Low;");
const ROOMS: &str = "[rooms]\na = [\"high\", \"low\"]";

#[test]
fn a_planted_circle_fails_through_a_re_export_and_says_what_ties_it() {
    let low = "pub struct Low;\nfn f(x: crate::high::High) {}";
    let found = findings(&[LIB, ("high.rs", "use crate::Low;\npub struct High(Low);"), ("low.rs", low)], "");
    let [Finding::Circle { files, .. }] = found.as_slice() else { panic!("{found:?}") };
    assert!(files.iter().eq(["a/src/high.rs", "a/src/low.rs"]));
    let text = found[0].to_string();
    for part in [
        "high.rs -> a/src/low.rs: Low (line 1)",
        "low.rs -> a/src/high.rs: High (line 2)",
        "mend: ",
        "files = [\"a/src/high.rs\", ",
    ] {
        assert!(text.contains(part), "{part} is not in:\n{text}");
    }
}

#[test]
fn the_same_files_without_the_way_back_are_fine() {
    let found = findings(&[LIB, ("high.rs", "use crate::Low;"), ("low.rs", "pub struct Low;")], ROOMS);
    assert_eq!(found, []);
}

#[test]
fn an_allowed_circle_is_allowed_until_it_grows_or_goes() {
    let order = "[[circle]]\nfiles = [\"a/src/low.rs\", \"a/src/high.rs\"]\nreason = \"a trait and its type\"";
    let high = ("high.rs", "use crate::Low; pub struct High;");
    let back = "pub struct Low; use crate::high::High;";
    assert_eq!(findings(&[LIB, high, ("low.rs", back)], order), []);

    let gone = findings(&[LIB, high, ("low.rs", "pub struct Low;")], order);
    assert!(matches!(gone.as_slice(), [Finding::NoCircle { reason, .. }] if reason == "a trait and its type"), "{gone:?}");

    let third = [LIB, ("high.rs", "use crate::Low; pub struct High; mod third;"), ("low.rs", back)];
    let third = [third[0], third[1], third[2], ("high/third.rs", "use crate::Low;")];
    assert_eq!(findings(&third, order), [], "a file that only uses the circle is not in it");
    let mut grown = third;
    grown[1].1 = "use crate::Low; pub struct High; mod third; use third::f;";
    let grown = findings(&grown, order);
    assert!(
        matches!(grown.as_slice(), [Finding::Circle { files, .. }, Finding::NoCircle { .. }] if files.len() == 3),
        "{grown:?}"
    );
}

#[test]
fn a_circle_of_a_folder_with_its_own_mod_file_counts() {
    let sources = [
        ("lib.rs", "mod room;"),
        ("room/mod.rs", "mod part; pub trait Shape {} pub fn all() -> part::Part {}"),
        ("room/part.rs", "use super::Shape; pub struct Part;"),
    ];
    assert!(matches!(findings(&sources, "").as_slice(), [Finding::Circle { .. }]));
}

#[test]
fn an_arrow_upwards_is_found_and_one_downwards_is_not() {
    let up = [LIB, ("high.rs", "pub struct High;"), ("low.rs", "pub struct Low; use crate::high::High;")];
    let found = findings(&up, ROOMS);
    let [Finding::Upward { arrow, from, to }] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!((arrow.names.contains_key("High"), from.as_str(), to.as_str()), (true, "low", "high"));
    assert_eq!(findings(&up, ""), [], "where no order is declared there is no upwards");
    assert_eq!(findings(&up, "[rooms]\na = [\"low\", \"high\"]"), []);
}

#[test]
fn rooms_of_one_storey_do_not_know_each_other() {
    let sources = [LIB, ("high.rs", "use crate::Low;"), ("low.rs", "pub struct Low;")];
    assert!(matches!(findings(&sources, "[rooms]\na = [[\"low\", \"high\"]]").as_slice(), [Finding::Upward { .. }]));
}

#[test]
fn the_root_of_a_crate_stands_above_its_rooms() {
    let sources = [("lib.rs", "mod low; pub struct Root; use low::Low;"), ("low.rs", "pub struct Low;")];
    assert_eq!(findings(&sources, "[rooms]\na = [\"low\"]"), []);
    let sources = [("lib.rs", "mod low; pub struct Root;"), ("low.rs", "use crate::Root;")];
    assert!(matches!(findings(&sources, "[rooms]\na = [\"low\"]").as_slice(), [Finding::Upward { to, .. }] if to == "lib.rs"));
}

#[test]
fn a_room_without_a_storey_is_unknown() {
    let sources = [LIB, ("high.rs", ""), ("low.rs", "pub struct Low;")];
    let found = findings(&sources, "[rooms]\na = [\"low\"]");
    assert!(matches!(found.as_slice(), [Finding::UnknownRoom { room, .. }] if room == "high"), "{found:?}");
}

#[test]
fn dependencies_are_compared_with_the_order() {
    let manifest = |name: &str, on: &str| format!("[package]\nname = \"{name}\"\n[dev-dependencies]\n{on}\nserde = \"1\"");
    let mut files =
        files(&[("lib.rs", "")], "may-depend-on = [\"b\"]\nmust-not-know = [\"c\"]\nbecause = \"c is secret\"\n[crates.b]");
    files.insert("a/Cargo.toml".into(), manifest("a", "b.workspace = true"));
    files.insert("b/Cargo.toml".into(), manifest("b", "c.workspace = true"));
    files.insert("c/Cargo.toml".into(), manifest("c", ""));
    let found = House::of(&files).unwrap().findings();
    let way = ["a", "b", "c"].map(str::to_owned).to_vec();
    let expected = [
        Finding::MustNotKnow { way, because: "c is secret".into() },
        Finding::Dependency { package: "b".into(), folder: "b".into(), on: "c".into() },
        Finding::UnknownPackage { package: "c".into() },
    ];
    assert_eq!(found, expected);
}

#[test]
fn what_cannot_be_read_is_an_error() {
    let missing = House::of(&files(&[("lib.rs", "mod gone;")], "")).unwrap_err();
    assert!(matches!(&missing, HouseError::NoModule { name, .. } if name == "gone"), "{missing}");
    let reason = House::of(&files(&[], "[[circle]]\nfiles = [\"x\", \"y\"]")).unwrap_err();
    assert!(matches!(&reason, HouseError::Order { key, .. } if key == "circle.reason"), "{reason}");
    let toml = House::of(&files(&[], "[")).unwrap_err();
    assert!(matches!(&toml, HouseError::Toml { path, .. } if path == ORDER), "{toml}");
}

#[test]
fn the_command_ends_with_1_where_a_circle_is_planted() {
    let root = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("planted");
    let sources = [LIB, ("high.rs", "use crate::Low; pub struct High;"), ("low.rs", "pub struct Low; use crate::high::High;")];
    let mut files = files(&sources, "");
    files.insert("Cargo.toml".into(), "[workspace]\nmembers = [\"a\"]".into());
    for (path, text) in files {
        fs::create_dir_all(root.join(&path).parent().unwrap()).unwrap();
        fs::write(root.join(path), text).unwrap();
    }
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_truegap-house")).arg(&root).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("circle of files: a/src/high.rs, a/src/low.rs") && text.contains("1 findings"), "{text}");
}

#[test]
fn a_private_word_in_a_name_is_found_whatever_the_case_and_told_what_to_say() {
    let order = "[words]\ngate = { instead = \"lack-of-fit test\" }\nleap = { instead = \"nonmonotone step\", in = [\"b\"] }";
    let lib = "mod my_gate; fn gates() {} // a gate\nconst OPEN_GATE: &str = \"gate\"; struct GateOf; fn delegate(leap: f64) {}";
    let found = findings(&[("lib.rs", lib), ("my_gate.rs", "")], order);
    let names: Vec<&str> =
        found.iter().filter_map(|f| if let Finding::PrivateWord { name, .. } = f { Some(name.as_str()) } else { None }).collect();
    assert_eq!(names, ["my_gate", "OPEN_GATE", "GateOf", "my_gate"], "comments, strings, other words, other packages: nothing");
    assert!(found[1].to_string().contains("`OPEN_GATE` in a/src/lib.rs, line 2 says \"gate\"\n  mend: say lack-of-fit test;"));
    let kept =
        format!("{}, except = [\"my_gate\", \"OPEN_GATE\", \"GateOf\"] }}", order.lines().nth(1).unwrap().trim_end_matches(" }"));
    assert_eq!(findings(&[("lib.rs", lib), ("my_gate.rs", "")], &format!("[words]\n{kept}")), []);
}
