//! `truegap compensate` on the command line: exit codes, what is printed, and what is written.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use serde_json::Value;

/// A line in the force that reads 0.1 mm/K of heat as well.
const MODEL: &str = r#"schema = "truegap.model/1"
made_by = "test"
recording = "bench.csv"
sha256 = "b"
verdict = "explained"
unit = "mm"

[base]
model = "linear"
order = 1
reference_c = 20.0
driver = { role = "force", zero = 0.0, width = 10.0 }
scale = { unit = "mm", centre = 8.5, range = 15.0, at_rest = 1.0, span = 15.0, gaps_m = [0.0, 0.0], response_times_gap = 1.0 }

[scales]
longest_run_s = 299.0
shortest_step_s = 1.0
duration_s = 299.0
response_span = 15.0
noise_sd = 0.01
moved = { temperature_k = 16.0, load = 1.0, gap = false, simulated = false, drivers = [] }

[[parameter]]
name = "offset"
unit = "mm"
value = 1.0
sd = 0.1

[[parameter]]
name = "slope"
unit = "mm"
value = 15.0
sd = 0.1

[[effect]]
id = "temperature_coefficient"
parameters = [{ name = "per_kelvin", unit = "mm/K", value = 0.1, sd = 0.01 }, { name = "bend", unit = "1/K", value = 0.0, sd = 0.01 }]
"#;

/// Rows of a sensor in use: true reading `1 + 1.5 F`; the force stands in the file where `with_force` says so.
fn rows(with_force: bool) -> String {
    let row = |t: u32| {
        let (force, heat) = (5.0 + 3.0 * (f64::from(t) / 30.0).sin(), 20.0 + 8.0 * (f64::from(t) / 70.0).sin());
        let read = 1.0 + 1.5 * force + 0.1 * (heat - 20.0) + if t.is_multiple_of(2) { 0.01 } else { -0.01 };
        if with_force { format!("{t},{heat},{read},{force}\n") } else { format!("{t},{heat},{read}\n") }
    };
    let header = if with_force { "time_s,temperature_c,response_mm,force_n\n" } else { "time_s,temperature_c,response_mm\n" };
    std::iter::once(header.to_owned()).chain((0..300).map(row)).collect()
}

fn bench() -> Bench {
    let bench = Bench::new();
    bench.file("augmented.toml", MODEL).file("use.csv", &rows(false)).file("known.csv", &rows(true));
    bench
}

#[test]
fn corrected_rows_are_printed_or_written_and_the_gain_is_told() {
    let bench = bench();
    let printed = bench.run(&["compensate", "augmented.toml", "use.csv"]);
    assert_eq!(printed.code, 0, "{}", printed.err);
    assert!(printed.out.starts_with("run,time_s,reading,corrected,estimated_force_n\n"), "{}", printed.out);
    assert!(printed.err.contains("Corrected for temperature coefficient in 1 pass"), "{}", printed.err);
    let true_reading = |t: f64| 1.0 + 1.5 * (5.0 + 3.0 * (t / 30.0).sin());
    for line in printed.out.lines().skip(1) {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        approx::assert_abs_diff_eq!(cells[3], true_reading(cells[1]), epsilon = 0.0101);
    }
    let written = bench.run(&["-q", "compensate", "augmented.toml", "known.csv", "-o", "fixed.csv"]);
    assert_eq!((written.code, written.err.as_str()), (0, ""));
    assert_eq!(std::fs::read_to_string(bench.path("fixed.csv")).unwrap(), printed.out);
    for part in ["error (RMS)", "corrected reading", "noise of a reading"] {
        assert!(written.out.contains(part), "`{part}` is missing in: {}", written.out);
    }
    let said = bench.run(&["-q", "--json", "compensate", "augmented.toml", "known.csv"]);
    let document: Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(document["schema"], "truegap.compensation/1");
    let [before, after] = ["before", "after"].map(|key| document["error"][key].as_f64().unwrap());
    assert!(before > 0.3 && (after - 0.01).abs() < 1e-6, "{before} {after}");
}

#[test]
fn what_is_missing_or_would_be_lost_is_refused_before_the_work() {
    let bench = bench();
    let cold: String = rows(false)
        .lines()
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            format!("{},{}\n", cells[0], cells[2])
        })
        .collect();
    bench.file("cold.csv", &cold);
    bench.refuses(
        &["-q", "compensate", "augmented.toml", "cold.csv", "-o", "no.csv"],
        &["cold.csv", "no column for temperature", "--map temperature=COLUMN"],
    );
    bench.refuses(&["-q", "compensate", "augmented.toml", "use.csv", "-o", "known.csv"], &["known.csv", "no earlier result"]);
    bench.refuses(&["-q", "compensate", "use.csv", "use.csv"], &["use.csv", "model file"]);
    // a column under another name is mapped as everywhere
    let renamed = rows(false).replace("temperature_c", "heat").replace("response_mm", "read");
    bench.file("renamed.csv", &renamed);
    let said = bench.run(&[
        "-q",
        "compensate",
        "augmented.toml",
        "renamed.csv",
        "--map",
        "response=read:mm",
        "--map",
        "temperature=heat:degC",
    ]);
    assert_eq!(said.code, 0, "{}", said.err);
}

/// A base that bends gives readings up to 13.24 mm; the sensor of `other.csv` reads 30 mm more.
#[test]
fn a_recording_of_another_sensor_is_refused_and_nothing_is_written() {
    let bench = bench();
    let bend = "[[parameter]]\nname = \"order_2\"\nunit = \"mm\"\nvalue = -4.0\nsd = 0.1\n\n[[effect]]";
    bench.file("bent.toml", &MODEL.replace("order = 1", "order = 2").replace("[[effect]]", bend));
    let more = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        cells[2].parse::<f64>().map_or(format!("{line}\n"), |read| format!("{},{},{}\n", cells[0], cells[1], read + 30.0))
    };
    bench.file("other.csv", &rows(false).lines().map(more).collect::<String>());
    bench.refuses(
        &["-q", "compensate", "bent.toml", "other.csv", "-o", "none.csv"],
        &["other.csv: in 300 of 300 rows no force", "bent.toml", "13.24 mm", "another sensor", "--map response=COLUMN:UNIT"],
    );
    assert!(!bench.path("none.csv").exists());
    // the first quarter of the rows alone: counted in a note, and corrected
    let all = rows(false);
    let few = all.lines().enumerate().map(|(row, line)| if row > 75 { format!("{line}\n") } else { more(line) });
    bench.file("few.csv", &few.collect::<String>());
    let said = bench.run(&["compensate", "bent.toml", "few.csv", "-o", "some.csv"]);
    assert!(said.code != 2 && said.err.contains("in 75 of 300 rows no force"), "{} {}", said.code, said.err);
    assert!(bench.path("some.csv").exists());
}

/// A coefficient of the wrong sign doubles the error: it was told as two numbers, with exit code 0.
#[test]
fn a_correction_that_does_harm_is_told() {
    let bench = bench();
    bench.file("wrong.toml", &MODEL.replace("value = 0.1, sd = 0.01", "value = -0.1, sd = 0.01"));
    let said = bench.run(&["-q", "compensate", "wrong.toml", "known.csv", "-o", "fixed.csv"]);
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    assert!(said.out.contains("farther from") && said.out.contains("does harm"), "{}", said.out);
    let said = bench.run(&["-q", "compensate", "augmented.toml", "known.csv", "-o", "fixed.csv"]);
    assert!(said.code == 0 && !said.out.contains("harm"), "{}", said.out);
}
