//! What the command says of effects, and of itself: completions and manual pages.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;

#[test]
fn an_effect_is_explained_in_the_librarys_own_words() {
    let bench = Bench::new();
    let said = bench.run(&["explain", "thermal_lag"]);
    let page = include_str!("../../../docs/effects.md");
    let section = page.split("\n## thermal_lag\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let equation = section.lines().find(|line| line.starts_with("    ")).unwrap();
    assert!(said.code == 0 && said.out.contains(equation), "{}{}", said.out, said.err);
    for lead in ["needs", "mistaken for", "told apart by", "fitted", "source"] {
        assert!(said.out.lines().any(|line| line.starts_with(lead)), "`{lead}` is missing in: {}", said.out);
    }
    let json: serde_json::Value = serde_json::from_str(&bench.run(&["--json", "explain", "thermal lag"]).out).unwrap();
    assert_eq!(json["equation"].as_str().unwrap(), equation.trim());
    bench.refuses(&["explain", "thermal_leg"], &["no effect `thermal_leg`", "`thermal_lag`"]);
}

#[test]
fn without_a_name_every_effect_is_listed() {
    let said = Bench::new().run(&["explain"]);
    let page = include_str!("../../../docs/effects.md");
    let on_page = page.lines().filter(|line| line.starts_with("| [`")).count();
    assert!(on_page > 30);
    assert_eq!((said.code, said.out.lines().count()), (0, on_page));
}

#[test]
fn completions_know_every_subcommand_and_its_flags() {
    let bench = Bench::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let said = bench.run(&["completions", shell]);
        for word in ["diagnose", "optimise", "select-in-folds", "json"] {
            assert!(said.code == 0 && said.out.contains(word), "{shell}: {word}");
        }
    }
    bench.file("truegap.bash", &bench.run(&["completions", "bash"]).out);
    let script = "source ./truegap.bash && COMP_WORDS=(truegap dia) && COMP_CWORD=1 && _truegap truegap dia truegap && echo ${COMPREPLY[@]}";
    let done = std::process::Command::new("bash").args(["-c", script]).current_dir(bench.path(".")).output().unwrap();
    assert_eq!(String::from_utf8(done.stdout).unwrap().trim(), "diagnose", "{}", String::from_utf8_lossy(&done.stderr));
}

#[test]
fn there_is_a_manual_page_for_every_subcommand() {
    let bench = Bench::new();
    let said = bench.run(&["man", "-o", "man1"]);
    assert_eq!(said.code, 0, "{}", said.err);
    let help = bench.run(&["--help"]).out;
    let listed = help.split("Commands:").nth(1).unwrap().split("Options:").next().unwrap();
    let commands: Vec<&str> = listed
        .lines()
        .filter_map(|l| l.strip_prefix("  "))
        .filter(|l| !l.starts_with(' '))
        .map(|l| l.split(' ').next().unwrap())
        .collect();
    assert!(commands.len() > 15, "{commands:?}");
    for command in commands.iter().filter(|c| **c != "help") {
        let page = std::fs::read_to_string(bench.path(&format!("man1/truegap-{command}.1"))).unwrap();
        assert!(page.contains(".SH NAME") && page.contains(&format!("truegap\\-{command}")), "{page}");
    }
    assert!(bench.run(&["man"]).out.contains(".SH SUBCOMMANDS"));
    assert!(bench.run(&["man", "diagnose"]).out.contains("\\-\\-select\\-in\\-folds"));
    bench.refuses(&["man", "diagnoze"], &["no subcommand `diagnoze`", "diagnose"]);
}
