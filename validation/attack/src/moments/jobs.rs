//! The commands that write, each with what it finds and what may be there when it is broken off.

use crate::attack::Put;
use crate::list::material::{HEADER, SENSOR, csv, square};

/// A command.
#[derive(Clone, Debug)]
pub struct Job {
    /// what it is
    pub name: &'static str,
    /// what lies in the folder
    pub put: Vec<Put>,
    /// what was typed before
    pub earlier: &'static [&'static [&'static str]],
    /// what is typed
    pub typed: &'static [&'static str],
    /// exit code that is due
    pub exit: i32,
    /// what is typed after it was broken off: the first that is not refused
    pub again: &'static [&'static [&'static str]],
    /// whether its folder is replaced as one
    pub is_one: bool,
    /// whether it never writes over a file
    pub writes_once: bool,
    /// the file that says that an answer is whole
    pub document: Option<&'static str>,
    /// names of files that grow while it works
    pub grows: &'static [&'static str],
    /// names, one of which an error must hold
    pub names: &'static [&'static str],
}

const DIAGNOSE: &[&str] =
    &["-q", "diagnose", "r.csv", "--base", "linear", "--effects", "offset_drift", "--library-only", "-o", "out"];
const OTHER: &[&str] =
    &["-q", "diagnose", "other.csv", "--base", "linear", "--effects", "offset_drift", "--library-only", "-o", "out"];
const CONFIRM: &[&str] = &["-q", "confirm", "out/augmented.toml", "other.csv", "-o", "borne"];
const PROVE: &[&str] = &["-q", "prove", "--cases", "1", "--seed", "7", "--protocols", "shelf", "-o", "out"];
const RESUME: &[&str] = &["-q", "prove", "--resume", "-o", "out"];
const SENSITIVITY: &[&str] = &["-q", "sensitivity", "--rows", "64", "-o", "out"];
const TOLERANCE: &[&str] = &["-q", "tolerance", "--samples", "64", "-o", "out"];
const OPTIMISE: &[&str] = &["-q", "optimise", "--searches", "1", "-o", "out"];
const SHARD: &[&str] = &["-q", "tolerance", "--samples", "64", "--shard", "1/2", "-o", "out"];
const SECOND: &[&str] = &["-q", "tolerance", "--samples", "64", "--shard", "2/2", "-o", "out"];
const MERGE: &[&str] = &["-q", "merge", "out"];
const MSH: &[&str] = &["-q", "mesh", "c.toml", "-o", "m.msh"];
const VTU: &[&str] = &["-q", "mesh", "c.toml", "--solved", "-o", "m.vtu"];
const EXPORT: &[&str] = &["-q", "export", "--load", "1 N", "-o", "s.glb"];
const AUDIT: &[&str] = &["-q", "audit", "--only", "BIMETAL-STRIP", "--no-scene", "-o", "out"];
const SPACE: &[&str] = &["-q", "audit", "--space", "space.toml", "-o", "out"];
const SOLVE: &[&str] = &["-q", "solve", "c.toml"];
const INIT: &[&str] = &["-q", "init", "r.csv"];
const MAN: &[&str] = &["man", "-o", "pages"];

fn job(
    name: &'static str,
    typed: &'static [&'static str],
    exit: i32,
    again: &'static [&'static [&'static str]],
    names: &'static [&'static str],
) -> Job {
    let (put, earlier, document, grows) = (Vec::new(), &[][..], None, &[][..]);
    Job { name, put, earlier, typed, exit, again, is_one: false, writes_once: false, document, grows, names }
}

fn file(name: &str, text: impl Into<Vec<u8>>) -> Put {
    Put::File(name.into(), text.into())
}

/// A recording whose reading rises by itself.
fn drifting() -> String {
    let rows = csv(HEADER);
    let rise = |(row, line): (usize, &str)| match line.rsplit_once(',') {
        Some((inputs, reading)) if row > 0 => {
            let force: f64 = inputs.split(',').nth(1).and_then(|force| force.parse().ok()).unwrap_or_default();
            let reading: f64 = reading.parse().unwrap_or_default();
            format!("{inputs},{:.5}\n", reading - 2.0 * force + 0.002 * row as f64)
        }
        _ => format!("{line}\n"),
    };
    rows.lines().enumerate().map(rise).collect()
}

/// Every command that writes.
pub fn all() -> Vec<Job> {
    let recorded = || vec![file("r.csv", csv(HEADER))];
    let case = || vec![file("c.toml", square())];
    let cases = &["out/cases/", "out/sweep.json"][..];
    let space =
        format!("schema = \"truegap.space/1\"\nsensor = \"{SENSOR}\"\ndesigns = 3\nseed = 1\nonly = [\"BIMETAL-STRIP\"]\n");
    vec![
        Job { put: recorded(), is_one: true, ..job("diagnose", DIAGNOSE, 1, &[DIAGNOSE], &["out"]) },
        Job {
            put: vec![file("r.csv", csv(HEADER)), file("other.csv", csv(HEADER).replace("0,0.000000", "0,0.000001"))],
            earlier: &[OTHER],
            is_one: true,
            ..job("diagnose over an earlier answer", DIAGNOSE, 1, &[DIAGNOSE], &["out"])
        },
        Job {
            put: vec![file("r.csv", drifting()), file("other.csv", drifting().replace("\n0,0.000000", "\n0,0.000001"))],
            earlier: &[DIAGNOSE],
            is_one: true,
            ..job("confirm", CONFIRM, 0, &[CONFIRM], &["borne"])
        },
        Job {
            grows: &["out/diagnoses/", "out/answers.txt", "out/case", "out/key", "out/commitments.txt"],
            document: Some("out/score.json"),
            ..job("prove", PROVE, 1, &[RESUME, PROVE], &["out"])
        },
        Job { document: Some("out/sensitivity.json"), ..job("sensitivity", SENSITIVITY, 0, &[SENSITIVITY], &["out"]) },
        Job { grows: cases, document: Some("out/tolerance.json"), ..job("tolerance", TOLERANCE, 0, &[TOLERANCE], &["out"]) },
        Job { grows: cases, document: Some("out/optimise.json"), ..job("optimise", OPTIMISE, 0, &[OPTIMISE], &["out"]) },
        Job { grows: cases, earlier: &[SECOND], ..job("shard", SHARD, 0, &[SHARD], &["out"]) },
        Job { earlier: &[SHARD, SECOND], document: Some("out/tolerance.json"), ..job("merge", MERGE, 0, &[MERGE], &["out"]) },
        Job { put: case(), ..job("solve", SOLVE, 0, &[SOLVE], &["c.toml"]) },
        Job { put: case(), ..job("mesh", MSH, 0, &[MSH], &["m.msh"]) },
        Job { put: case(), ..job("solved mesh", VTU, 0, &[VTU], &["m.vtu"]) },
        Job { ..job("export", EXPORT, 0, &[EXPORT], &["s.glb"]) },
        Job { is_one: true, ..job("audit", AUDIT, 1, &[AUDIT], &["out"]) },
        Job {
            put: vec![file("space.toml", space)],
            grows: cases,
            document: Some("out/audit-space.json"),
            ..job("audit of a space", SPACE, 1, &[SPACE], &["out"])
        },
        Job { put: recorded(), writes_once: true, ..job("init", INIT, 0, &[INIT], &["r.toml"]) },
        job("man", MAN, 0, &[MAN], &["pages"]),
    ]
}
