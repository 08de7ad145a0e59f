//! Sizes that nothing can hold: checked against what they would take, before anything is allocated.

use super::material::{HEADER, SENSOR, SQUARE, case, csv, polygon, region, square};
use crate::attack::Attack;

pub fn all() -> Vec<Attack> {
    let memory: [(&str, &[&str]); 7] = [
        ("a million by a million points", &["simulate", "--load", "0:4.5 N:1000000", "--temperature", "20:50 degC:1000000"]),
        ("a table of a hundred million points", &["simulate", "--load", "0:4.5 N:10000", "--temperature", "20:50 degC:10000"]),
        ("searches", &["optimise", "--searches", "100000000000", "-o", "out"]),
        ("as many searches as there are numbers", &["optimise", "--searches", "18446744073709551615"]),
        ("samples", &["tolerance", "--samples", "9000000000000000000", "-o", "out"]),
        ("as many samples as there are numbers", &["tolerance", "--samples", "18446744073709551615"]),
        ("designs", &["audit", "--space", "s.toml", "-o", "out"]),
    ];
    let space = "schema = \"truegap.space/1\"\nsensor = \"singletact-s15-4.5n\"\ndesigns = 1000000000000\n";
    let limit = ["of memory", "may take 4 GB", "ask for fewer", "TRUEGAP_MEMORY"];
    let mut all: Vec<Attack> =
        memory.into_iter().map(|(name, typed)| Attack::new("9", name, typed).file("s.toml", space).says(&limit)).collect();
    let list = "0:4.5 N:1000000,".repeat(30) + "1 N";
    all.extend([
        Attack::new("9", "a list of thirty million loads", &["simulate", "--load", &list]).says(&["at most 1000000"]),
        Attack::new("9", "rows of a study", &["-q", "sensitivity", "--rows", "9000000000000000000"]).says(&["65536"]),
        Attack::new(
            "9",
            "rows of two studies",
            &["-q", "sensitivity", "--rows", "18446744073709551615", "--compare", "foam-s15"],
        )
        .says(&["65536"]),
        Attack::new("9", "cases of a blind study", &["prove", "--cases", "1000000000000", "--seed", "1"]).says(&["--cases"]),
        Attack::new("9", "diagnoses at a time", &["prove", "--cases", "1", "--jobs", "1000000000"]).says(&["--jobs"]),
        Attack::new("9", "a bank", &["diagnose", "example", "--bank", "4000000000"]).says(&["--bank"]),
        Attack::new(
            "9",
            "a shard of many",
            &["-q", "tolerance", "--samples", "64", "--shard", "1/18446744073709551615", "-o", "out"],
        )
        .ends(0, &["out"]),
        // a program that the system gives no threads
        Attack::new("9", "300 MB for everything", &["-q", "tolerance", "--samples", "1000"]).memory(300).ends(0, &[]),
    ]);
    all.extend(drawings());
    let rows = csv(HEADER).lines().skip(1).collect::<Vec<_>>().join("\n");
    let long = format!("{HEADER}\n{}", format!("{rows}\n").repeat(2));
    all.push(
        Attack::new("9", "time that begins again", &["-q", "diagnose", "r.csv", "--sensor", SENSOR, "-o", "out"])
            .file("r.csv", long)
            .says(&["time goes back"]),
    );
    all
}

fn drawings() -> Vec<Attack> {
    let solve = |class, name: &str, text: String| {
        Attack::new(class, name, &["-q", "solve", "c.toml"]).file("c.toml", text).says(&["c.toml"])
    };
    let many = |count: usize| -> String {
        (0..count).map(|k| region(&format!("r{k}"), &format!("[[{k}, 0], [{}, 0], [{}, 1], [{k}, 1]]", k + 1, k + 1))).collect()
    };
    let layer = |thickness: &str| {
        let square = case(&region("space", "[[0, 0], [1, 0], [1, H], [0, H]]"), "");
        square
            .replace('H', thickness)
            .replace("[[0, 1], [1, 1]]", &format!("[[0, {thickness}], [1, {thickness}]]"))
            .replace("\"higT\"", "\"high\"")
    };
    vec![
        solve("9", "edges of a picometre", case(&region("space", SQUARE), "max_edge = \"1e-9 mm\""))
            .says(&["max_edge", "of memory"]),
        solve("9", "edges of no length at all", case(&region("space", SQUARE), "max_edge = \"1e-300 mm\""))
            .says(&["max_edge", "of memory"]),
        solve("16", "a layer of a millionth of its width", layer("1e-6")).says(&["times as thin", "of memory"]),
        solve("16", "a layer of a billionth of its width", layer("1e-9")),
        solve("16", "an error that no number has", case(&region("space", SQUARE), "target_error = 1e-300")).says(&["1e-12"]),
        solve("16", "an outline of a hundred thousand corners", case(&region("space", &polygon(100_000)), ""))
            .says(&["100004 corners", "20000"]),
        solve("16", "seventy thousand regions", case(&many(70_000), "")).says(&["280004 corners", "20000"]),
        Attack::new("16", "an outline of ten thousand corners", &["-q", "solve", "c.toml"])
            .file("c.toml", case(&region("space", &polygon(10_000)), "target_error = 0.5"))
            .ends(0, &[])
            .long(60),
        Attack::new("16", "an outline of ten thousand corners as a mesh", &["-q", "mesh", "c.toml", "-o", "m.msh"])
            .file("c.toml", case(&region("space", &polygon(10_000)), ""))
            .ends(0, &["m.msh"])
            .long(30),
        solve(
            "17",
            "a region that no potential reaches",
            case(&(region("space", SQUARE) + &region("island", "[[3, 0], [4, 0], [4, 1]]")), ""),
        )
        .says(&["`island`", "potential"]),
        solve(
            "17",
            "a key of an arc that means nothing",
            square().replace("[1, 1], [0, 1]]", "{ via = [1.1, 0.5], to = [1, 1], radius = 7 }, [0, 1]]"),
        )
        .says(&["arc { via"]),
        solve("17", "corners that are no numbers", square().replace("[1, 1]", "[nan, 1]")).says(&["not finite"]),
        solve("17", "corners that are too far", square().replace("[1, 1]", "[1e308, 1]")),
        solve("17", "an outline that crosses itself", square().replace(SQUARE, "[[0, 0], [1, 1], [1, 0], [0, 1]]"))
            .says(&["crosses itself"]),
    ]
}
