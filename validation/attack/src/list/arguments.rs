//! What is typed: bytes that are not text, control characters, words that mean nothing.

use super::material::{HEADER, SENSOR, csv, square};
use crate::attack::Attack;
use std::ffi::OsString;

#[cfg(unix)]
fn not_text(bytes: &[u8]) -> OsString {
    std::os::unix::ffi::OsStringExt::from_vec(bytes.to_vec())
}

#[cfg(not(unix))]
fn not_text(_: &[u8]) -> OsString {
    OsString::new()
}

pub fn all() -> Vec<Attack> {
    let mut all = vec![
        Attack::new("8", "a recording whose path is not UTF-8", &["diagnose", "-o", "out"])
            .word(not_text(b"\xff.csv"))
            .says(&["no such file"]),
        Attack::new(
            "8",
            "an answer whose folder is not UTF-8",
            &["-q", "diagnose", "r.csv", "--sensor", SENSOR, "--effects", "thermal_lag", "-o"],
        )
        .word(not_text(b"o\xff"))
        .file("r.csv", csv(HEADER))
        .ends(1, &["o\u{fffd}"]),
        Attack::new("8", "a mesh whose path is not UTF-8", &["mesh", "c.toml", "-o"])
            .word(not_text(b"\xfe.msh"))
            .file("c.toml", square())
            .ends(0, &["\u{fffd}.msh"]),
        Attack::new("8", "an audit whose folders are not UTF-8", &["-q", "audit", "--only", "NO-FRINGING", "--no-cache", "-o"])
            .word(not_text(b"a\xff"))
            .ends(1, &["a\u{fffd}"])
            .long(60),
        Attack::new("8", "an export whose path is not UTF-8", &["-q", "export", "--load", "1 N", "-o"])
            .word(not_text(b"e\xff.vtu"))
            .ends(0, &["e\u{fffd}.vtu"])
            .long(120),
        Attack::new("8", "a sensor whose name is not UTF-8", &["coefficients", "--sensor"])
            .word(not_text(b"\xffs"))
            .says(&["invalid UTF-8"]),
    ];
    let red = "\u{1b}[31mred\u{1b}[0m";
    let escapes: [(&str, &[&str]); 7] = [
        ("a command", &[red]),
        ("a sensor", &["coefficients", "--sensor", red]),
        ("a number", &["optimise", "--searches", red]),
        ("a quantity", &["simulate", "--load", red]),
        ("a file", &["simulate", "--drive", red]),
        ("an effect", &["diagnose", "example", "-o", "out", "--effects", red]),
        ("a folder", &["merge", red]),
    ];
    all.extend(
        escapes
            .into_iter()
            .map(|(what, typed)| Attack::new("17", format!("a terminal's escapes in {what}"), typed).says(&["error: "])),
    );
    let turned = ["simulate", "--drive", "\u{202e}vsc.exe"];
    all.push(Attack::new("17", "a name that is written from right to left", &turned).says(&["\\u{202e}"]));
    let senseless: [&[&str]; 12] = [
        &["simulate", "--load", ""],
        &["simulate", "--load", "1 N", "--temperature", "warm"],
        &["simulate", "--load", "1 N:2 N"],
        &["simulate", "--load", "0:1 N:-5"],
        &["simulate", "--load", "nan N"],
        &["simulate", "--load", "1e999 N"],
        &["sensitivity", "--change", "nan"],
        &["sensitivity", "--change", "-1"],
        &["tolerance", "--limit", "span=nan:1"],
        &["optimise", "--vary", "height=1 um"],
        &["tolerance", "--shard", "5/4", "-o", "out"],
        &["prove", "--cases", "0"],
    ];
    all.extend(senseless.into_iter().map(|typed| Attack::new("17", format!("{typed:?}"), typed).says(&["error: "])));
    all
}
