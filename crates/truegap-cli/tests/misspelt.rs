//! Keys that are misspelt, and units that are not those: the message says where, what was meant, and what may stand there.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;

const COLUMNS: &str =
    "schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n[columns]\ntemperature = \"temp\"\n[units]\ntemperature = \"degC\"\n";
const COMMAND: &str =
    "[base]\nmodel = \"command\"\nrun = [\"./sim\"]\n[base.parameters]\nk = { value = 2.0, sd = 0.3, unit = \"N/mm\" }\n";

fn recording(bench: &Bench) {
    let row = |i: usize| format!("{i},{},{},{}\n", (i as f64 / 9.0).sin(), 20 + i % 3, 74.0 + (i as f64 / 9.0).sin());
    bench.file("r.csv", &format!("time_s,force_n,temp,capacitance_pf\n{}", (0..40).map(row).collect::<String>()));
}

#[test]
fn twenty_misspelt_keys_name_the_one_that_was_meant() {
    let bench = Bench::new();
    recording(&bench);
    let in_columns: [(&str, &str, &str, &str); 9] = [
        ("schema =", "shema =", "line 1: the file has no key `shema`", "`schema`"),
        ("file =", "fiel =", "line 2: the file has no key `fiel`", "`file`"),
        ("[columns]", "[colums]", "line 3: the file has no key `colums`", "`columns`"),
        ("[units]", "[unit]", "line 5: the file has no key `unit`", "`units`"),
        ("temperature = \"temp\"", "temprature = \"temp\"", "line 4: [columns] has no key `temprature`", "`temperature`"),
        ("temperature = \"temp\"", "temp = \"temp\"", "line 4: [columns] has no key `temp`", "`temperature`"),
        ("temperature = \"temp\"", "load = \"force_n\"", "line 4: [columns] has no key `load`", "`force`"),
        ("temperature = \"temp\"", "cap = \"capacitance_pf\"", "line 4: [columns] has no key `cap`", "`response`"),
        ("temperature = \"degC\"", "temperatur = \"degC\"", "line 6: [units] has no key `temperatur`", "`temperature`"),
    ];
    let behind: [(&str, &str, &str); 12] = [
        ("[driver]\nx = { column = \"temp\" }\n", "line 7: the file has no key `driver`", "`drivers`"),
        ("[drivers]\nx = { colunm = \"temp\" }\n", "line 8: [drivers], x has no key `colunm`", "`column`"),
        ("[drivers]\nx = { column = \"temp\", units = \"V\" }\n", "line 8: [drivers], x has no key `units`", "`unit`"),
        ("[Base]\nmodel = \"linear\"\n", "line 7: the file has no key `Base`", "`base`"),
        ("[base]\nmodle = \"linear\"\n", "line 8: [base] has no key `modle`", "`model`"),
        ("[base]\nmodel = \"linear\"\nordre = 2\n", "[base] has no key `ordre`", "`order`"),
        ("[base]\nmodel = \"stack\"\nsensr = \"x\"\n", "[base] has no key `sensr`", "`sensor`"),
        ("[base]\nmodel = \"liner\"\n", "no base model `liner`", "`linear`"),
        (&COMMAND.replace("sd =", "std ="), "[base.parameters], k has no key `std`", "`sd`"),
        (&COMMAND.replace("value =", "vaule ="), "[base.parameters], k has no key `vaule`", "`value`"),
        (&COMMAND.replace("unit =", "low = 0.1, max ="), "[base.parameters], k has no key `max`", "`high`"),
        (&COMMAND.replace("base.parameters", "base.params"), "[base] has no key `params`", "`parameters`"),
    ];
    let changed = in_columns.into_iter().map(|(from, to, where_, meant)| (COLUMNS.replace(from, to), where_, meant));
    let added = behind.into_iter().map(|(text, where_, meant)| (format!("{COLUMNS}{text}"), where_, meant));
    for (toml, where_, meant) in changed.chain(added) {
        bench.file("r.toml", &toml);
        bench.refuses(&["-q", "diagnose", "r.toml", "-o", "out"], &["r.toml", where_, &format!("did you mean {meant}? ")]);
    }
}

/// They were read and not used, and somebody thought that the line had a free gain.
#[test]
fn a_key_of_another_base_model_is_refused() {
    let bench = Bench::new();
    recording(&bench);
    for (base, key, says) in [
        ("model = \"linear\"\nrun = [\"./sim\"]\n", "run", "it is a key of `command`, and the model is `linear`"),
        ("model = \"linear\"\nfree = [\"gain\"]\n", "free", "it is a key of `table` and `external`"),
        ("model = \"linear\"\ngain = true\n", "gain", "known there: model, sensor, driver, order"),
        ("model = \"constant\"\norder = 2\n", "order", "it is a key of `linear`"),
        ("model = \"linear\"\nwarp = false\n", "warp", "it is a key of `stack`"),
    ] {
        bench.file("r.toml", &format!("{COLUMNS}[base]\n{base}"));
        let key = format!("[base] has no key `{key}`");
        bench.refuses(&["-q", "diagnose", "r.toml", "-o", "out"], &["r.toml", &key, says]);
    }
    // what stood there for another model is no part of the one that takes its place, which is refused here for want of its table
    bench.file("r.toml", &format!("{COLUMNS}[base]\nmodel = \"linear\"\norder = 2\n"));
    bench.refuses(&["-q", "diagnose", "r.toml", "--base", "table", "-o", "out"], &["`table` needs a CSV"]);
    let words = ["--channel A chooses among several sensors", "--map response=\"A\""];
    bench.refuses(&["-q", "diagnose", "r.toml", "--channel", "A", "-o", "out"], &words);
}

const MECHANISM: &str = r#"
schema = "truegap.mechanism/1"
id = "gap_follows_heating"
quantity = "gap"
action = "adds"
driver = "temperature_rate"
kinetics = "first_order"
form = "linear"
size = { sd = 0.5, unit = "unloaded gap/(K/s)" }
tau = { value = 30.0, sd = 20.0, unit = "s" }
"#;

#[test]
fn an_effect_in_other_units_or_words_is_refused() {
    let bench = Bench::new();
    let cases: [(&str, &str, &[&str]); 7] = [
        ("unit = \"s\"", "unit = \"min\"", &["tau is in `min`", "`s`", "30 min are 1800 s"]),
        (", unit = \"s\"", "", &["tau has no unit", "`s`", "unit = \"s\""]),
        ("unloaded gap/(K/s)", "um/K", &["size is in `um/K`", "`unloaded gap/(K/s)`"]),
        (", unit = \"unloaded gap/(K/s)\"", "", &["size has no unit", "`unloaded gap/(K/s)`"]),
        ("kinetics =", "kinetic =", &["no key `kinetic`", "did you mean `kinetics`?"]),
        ("first_order", "firstorder", &["kinetics = \"firstorder\"", "`first_order`"]),
        ("sd = 20.0", "std = 20.0", &["tau has no key `std`", "did you mean `sd`?"]),
    ];
    for (from, to, parts) in cases {
        bench.file("e.toml", &MECHANISM.replace(from, to));
        bench.refuses(&["-q", "diagnose", "example", "--effect", "e.toml", "-o", "out"], &[&["e.toml"], parts].concat());
    }
}

#[test]
fn one_row_is_too_few_whatever_it_is_compared_with() {
    let bench = Bench::new();
    bench.file("one.csv", "time_s,force_n,capacitance_pf\n0,1,230\n");
    bench.refuses(&["-q", "diagnose", "one.csv", "--base", "linear", "-o", "out"], &["1 row is too few", "at least 20"]);
}

/// A program that takes its time is timed before the search; the search itself is ended at once.
#[cfg(unix)]
#[test]
fn a_slow_program_is_told_of_before_the_search() {
    use std::io::{BufRead, BufReader};
    use std::process::{Command, Stdio};
    let bench = Bench::new();
    recording(&bench);
    bench.file(
        "sim.sh",
        "while read word rest; do case $word in\ntruegap) echo truegap 1;;\ninputs) set -- $rest; n=$1; i=0; while [ $i -lt $n ]; do read line; i=$((i+1)); done;;\n\
         ask) sleep 0.2; echo answer $n; i=0; while [ $i -lt $n ]; do echo 74; i=$((i+1)); done;;\nesac; done\n",
    );
    bench.file("r.toml", &format!("{COLUMNS}{}", COMMAND.replace("[\"./sim\"]", "[\"sh\", \"sim.sh\"]")));
    let mut command = Command::new(env!("CARGO_BIN_EXE_truegap"));
    // answers that an earlier test has kept would not be slow
    command
        .args(["diagnose", "r.toml", "-o", "out", "--no-cache"])
        .current_dir(bench.path(""))
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    let mut running = command.spawn().unwrap();
    let lines = BufReader::new(running.stderr.take().unwrap()).lines();
    let told = lines.map_while(Result::ok).find(|line| line.contains("the simulator answers in"));
    running.kill().unwrap();
    running.wait().unwrap();
    let told = told.unwrap();
    assert!(told.contains("1000 to 76100 times") && told.contains(" min to ") && told.contains("Ctrl-C"), "{told}");
}
