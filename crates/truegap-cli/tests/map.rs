//! Columns named on the command line in place of a TOML.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;

/// A straight line of a reading in a load, in columns that no default name fits.
fn bench() -> Bench {
    let bench = Bench::new();
    let load = |i: usize| 2.0 + (i as f64 / 9.0).sin();
    let row = |i: usize| format!("{i},{},{}\n", load(i), 3.0 + load(i) + 1e-3 * ((i * 37 % 11) as f64));
    let rows: String = (0..120).map(row).collect();
    bench.file("bench.csv", &format!("Elapsed,Load cell: left,C_measured\n{rows}"));
    bench
}

const TYPED: [&str; 6] = ["-q", "diagnose", "bench.csv", "--base", "linear", "--map"];

/// The only way without a TOML was to rename the columns in the file.
#[test]
fn columns_are_named_with_their_units_where_no_toml_is() {
    let bench = bench();
    let map = ["response=C_measured:fF", "--map", "force=Load cell: left:mN", "--map", "time=Elapsed:s", "-o", "out"];
    let said = bench.run(&[&TYPED[..], &map].concat());
    assert!(said.code < 2, "{}", said.err);
    let json: Value = serde_json::from_str(&std::fs::read_to_string(bench.path("out/diagnosis.json")).unwrap()).unwrap();
    let first = std::fs::read_to_string(bench.path("out/prediction.csv")).unwrap().lines().take(2).collect::<Vec<_>>().join("\n");
    assert_eq!(json["recording"]["rows"], 120);
    // 2 mN and 5 fF, in newton and picofarad
    assert!(first.contains("0.002") && first.contains("0.005"), "{first}");
}

#[test]
fn what_is_mapped_to_what_is_not_there_is_told_with_what_is() {
    let bench = bench();
    let refuses = |map: &str, parts: &[&str]| bench.refuses(&[&TYPED[..], &[map, "-o", "out"]].concat(), parts);
    refuses("response=C_mesured:pF", &["`C_mesured`", "did you mean `C_measured`", "`Elapsed`, `Load cell: left`", "--map"]);
    refuses("response=C_measured:PF", &["--map response", "`PF`", "pF"]);
    // clap refuses what is no map before anything is read
    let said = bench.run(&[&TYPED[..], &["forse=Elapsed"]].concat());
    assert!(said.code == 2 && said.err.contains("did you mean `force`"), "{}", said.err);
    let said = bench.run(&[&TYPED[..], &["force"]].concat());
    assert!(said.code == 2 && said.err.contains("ROLE=COLUMN:UNIT"), "{}", said.err);
}

/// Of two columns the last was taken, and a column could be followed by what it is.
#[test]
fn what_is_named_twice_is_refused() {
    let bench = bench();
    fn typed<'a>(map: &[&'a str]) -> Vec<&'a str> {
        [&TYPED[..], map, &["-o", "out"]].concat()
    }
    let two = ["force=Elapsed:N", "--map", "force=Load cell: left:N"];
    bench.refuses(
        &typed(&two),
        &["bench.csv", "--map", "two columns for force", "`Elapsed:N` and `Load cell: left:N`", "leave one"],
    );
    let two = ["driver.place=Elapsed:s", "--map", "driver.place=Load cell: left:N"];
    bench.refuses(&typed(&two), &["--map", "two columns for driver.place", "leave one"]);
    let both = ["response=C_measured:pF", "--map", "simulated=C_measured:pF"];
    bench.refuses(&typed(&both), &["bench.csv: column `C_measured` is both simulated and response", "name another column"]);
    let both = ["response=C_measured:pF", "--map", "driver.a=Elapsed:s", "--map", "driver.b=Elapsed:s"];
    bench.refuses(&typed(&both), &["--map driver.b", "column `Elapsed` is the driver `a` already", "leave one"]);
    let toml = "schema = \"truegap.recording/1\"\nfile = \"bench.csv\"\n[columns]\nforce = \"C_measured\"\nresponse = \"C_measured\"\n[units]\nforce = \"kN\"\nresponse = \"pF\"\n[base]\nmodel = \"linear\"\n";
    bench.file("bench.toml", toml);
    let toml = ["-q", "diagnose", "bench.toml", "-o", "out"];
    bench.refuses(&toml, &["bench.toml, line 5: column `C_measured` is both force and response"]);
}

#[test]
fn a_map_goes_before_the_toml() {
    let bench = bench();
    let toml = "schema = \"truegap.recording/1\"\nfile = \"bench.csv\"\n[columns]\nforce = \"Elapsed\"\nresponse = \"C_measured\"\n[units]\nforce = \"kN\"\nresponse = \"pF\"\n[base]\nmodel = \"linear\"\n";
    bench.file("bench.toml", toml);
    let typed = ["--json", "-q", "diagnose", "bench.toml", "--map", "force=Load cell: left:N", "-o", "out"];
    let said = bench.run(&typed);
    let slope = said.out.contains("\"verdict\":\"agrees\"");
    assert!(said.code == 0 && slope, "{}{}", said.out, said.err);
}

/// What was told of the built-in recording was dropped without a word.
#[test]
fn the_example_is_read_as_it_is_told() {
    let bench = Bench::new();
    let typed = ["-q", "diagnose", "example", "-o", "out", "--map"];
    let refuses = |map: &str, parts: &[&str]| bench.refuses(&[&typed[..], &[map]].concat(), parts);
    refuses("response=nothere:pF", &["recording.csv", "`nothere`", "found: `", "--map response=COLUMN"]);
    refuses("temperature=temperature_c:pF", &["--map temperature", "`pF`", "degC"]);
    bench.refuses(&["-q", "simulate", "--drive", "example", "--map", "force=nothere:N"], &["`nothere`", "--map force=COLUMN"]);
    // newtons called millinewtons: what the model answers is all but flat
    let said = bench.run(&["-q", "--json", "simulate", "--drive", "example", "--map", "force=force_n:mN"]);
    let forces = said.out.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()["force_n"].as_f64().unwrap());
    let greatest = forces.fold(0.0, f64::max);
    assert!(said.code == 0 && (1e-3..1e-2).contains(&greatest), "{greatest}: {}", said.err);
}

/// A driver needed a TOML.
#[test]
fn a_driver_is_named_in_the_same_line_as_a_role() {
    let bench = bench();
    let map = ["time=Elapsed:s", "--map", "response=C_measured:pF", "--map", "driver.cell=Load cell: left:N", "-o", "out"];
    let said =
        bench.run(&["-q", "diagnose", "bench.csv", "--base", "linear", "--map"].iter().chain(&map).copied().collect::<Vec<_>>());
    assert!(said.code < 2, "{}", said.err);
    let header = std::fs::read_to_string(bench.path("out/prediction.csv")).unwrap().lines().next().unwrap().to_owned();
    assert!(header.contains("driver_cell"), "{header}");
    let reading = ["response=C_measured:pF", "--map"];
    let refuses = |map: &str, parts: &[&str]| bench.refuses(&[&TYPED[..], &reading, &[map, "-o", "out2"]].concat(), parts);
    refuses("driver.cell=Load cell: left", &["--map driver.cell", "no unit in its name", "driver.cell=\"Load cell: left:mm\""]);
    refuses(
        "driver.force=Elapsed:s",
        &["--map driver.force", "`s`, the unit of column `Elapsed`", "driver.force_signal=\"Elapsed:s\""],
    );
    refuses("driver.response=Elapsed:s", &["`response` is a role", "--map response=COLUMN"]);
}

/// A driver that is called after a role was refused, also with a base that needs no such role.
#[test]
fn a_driver_called_after_a_role_is_that_role() {
    let bench = bench();
    let predicted = |name: &str, out: &str| {
        let load = format!("{name}=Load cell: left:N");
        let map = ["time=Elapsed:s", "--map", "response=C_measured:pF", "--map", &load, "-o", out];
        let said = bench.run(&[&TYPED[..], &map].concat());
        assert!(said.code < 2, "{}", said.err);
        std::fs::read_to_string(bench.path(&format!("{out}/prediction.csv"))).unwrap()
    };
    assert_eq!(predicted("driver.force", "a"), predicted("force", "b"));
    let toml = "schema = \"truegap.recording/1\"\nfile = \"bench.csv\"\n[columns]\ntime = \"Elapsed\"\nresponse = \"C_measured\"\n[units]\ntime = \"s\"\nresponse = \"pF\"\n\
                [drivers]\nforce = { column = \"Load cell: left\", unit = \"N\" }\n[base]\nmodel = \"linear\"\ndriver = \"force\"\n";
    bench.file("bench.toml", toml);
    let said = bench.run(&["-q", "diagnose", "bench.toml", "-o", "c"]);
    assert!(said.code < 2, "{}", said.err);
    assert_eq!(std::fs::read_to_string(bench.path("c/prediction.csv")).unwrap(), predicted("force", "b"));
    let twice = ["response=C_measured:pF", "--map", "force=Elapsed:N", "--map", "driver.force=Load cell: left:N", "-o", "d"];
    bench.refuses(&[&TYPED[..], &twice].concat(), &["--map", "two columns for driver.force", "leave one"]);
}

#[test]
fn what_is_told_to_init_stands_in_the_toml() {
    let bench = bench();
    let told = ["time=Elapsed:s", "response=C_measured:pF", "driver.cell=Load cell: left:N"].map(|map| ["--map", map]).concat();
    let said = bench.run(&[&["init", "bench.csv"][..], &told].concat());
    assert_eq!(said.code, 0, "{}", said.err);
    let toml = std::fs::read_to_string(bench.path("bench.toml")).unwrap();
    for line in ["time = \"s\"", "response = \"pF\"", "[drivers]", "cell = { column = \"Load cell: left\", unit = \"N\" }"] {
        assert!(toml.lines().any(|found| found == line), "{line} is missing in:\n{toml}");
    }
    let said = bench.run(&["-q", "diagnose", "bench.toml", "--base", "linear", "-o", "out"]);
    assert!(said.code < 2, "{}", said.err);
    bench.file("other.csv", "a,b\n1,2\n");
    bench.refuses(&["init", "other.csv", "--map", "response=c:pF"], &["`c` is not in the header", "`a`, `b`"]);
}

#[test]
fn a_history_to_simulate_is_read_by_what_is_told() {
    let bench = bench();
    let typed = [
        "-q",
        "--json",
        "simulate",
        "--drive",
        "bench.csv",
        "--map",
        "force=Load cell: left:mN",
        "--map",
        "response=C_measured:pF",
    ];
    let said = bench.run(&typed);
    let first: Value = serde_json::from_str(said.out.lines().next().unwrap()).unwrap();
    assert!(said.code == 0 && (first["force_n"].as_f64().unwrap() - 0.002).abs() < 1e-9, "{}{}", said.out, said.err);
    bench.refuses(&["simulate", "--load", "1 N", "--map", "force=a:N"], &["--map", "--drive RECORDING"]);
}

#[test]
fn the_order_of_dates_is_told_by_an_option() {
    let bench = Bench::new();
    let rows: String =
        (0..40).map(|i| format!("{:02}/{:02}/2026 12:00,{},{}\n", i % 10 + 1, i / 10 + 1, i % 7, 3 * (i % 7) + i % 2)).collect();
    bench.file("dates.csv", &format!("time,force_n,capacitance_pf\n{rows}"));
    let typed = ["-q", "diagnose", "dates.csv", "--base", "linear", "-o", "out"];
    bench.refuses(&typed, &["line 2: `01/01/2026 12:00`", "--dayfirst", "dayfirst = true or false"]);
    for option in ["--dayfirst", "--dayfirst=true"] {
        let said = bench.run(&[&typed[..], &[option]].concat());
        assert!(said.code < 2, "{option}: {}", said.err);
    }
    bench.refuses(&[&typed[..], &["--dayfirst=false"]].concat(), &["time goes back"]);
}

#[cfg(not(feature = "columnar"))]
#[test]
fn a_parquet_file_is_answered_with_the_build_that_reads_it() {
    let bench = Bench::new();
    let file = include_bytes!("../../truegap-core/tests/columnar/bench.parquet");
    std::fs::write(bench.path("x.parquet"), file).unwrap();
    bench.refuses(&["diagnose", "x.parquet"], &["x.parquet: it is a Parquet file", "--features columnar", "CSV"]);
    bench.refuses(&["init", "x.parquet"], &["--features columnar"]);
}

/// The first column that moved was taken without a word.
#[test]
fn a_straight_line_says_what_it_follows_where_it_could_follow_something_else() {
    let bench = Bench::new();
    let row = |i: usize| format!("{i},{},{},{}\n", i % 7, 20 + i % 5, 3 * (i % 7) + i % 2);
    bench.file("bench.csv", &format!("time_s,force_n,temperature_c,response_mv\n{}", (0..60).map(row).collect::<String>()));
    let typed = ["-q", "diagnose", "bench.csv", "--base", "linear", "--library-only", "-o", "out"];
    let says = "the straight line follows force; to have it follow temperature, write driver = \"temperature\" under [base]";
    let said = bench.run(&typed);
    assert!(said.code < 2 && said.out.contains(says), "{}{}", said.out, said.err);
    let named = "schema = \"truegap.recording/1\"\nfile = \"bench.csv\"\n[base]\nmodel = \"linear\"\ndriver = \"force\"\n";
    bench.file("named.toml", named);
    let said = bench.run(&["-q", "diagnose", "named.toml", "--library-only", "-o", "out"]);
    assert!(said.code < 2 && !said.out.contains("the straight line follows"), "{}{}", said.out, said.err);
}
