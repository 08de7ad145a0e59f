//! The program run in a folder of its own.

#![allow(dead_code, clippy::unwrap_used)] // each test file uses a part of this; a bench that cannot be set up is a failed test

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// A folder in which the program runs.
pub struct Bench {
    folder: tempfile::TempDir,
}

/// What the program said.
pub struct Said {
    pub code: i32,
    pub out: String,
    pub err: String,
}

impl Said {
    fn of(output: Output) -> Self {
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        Self { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
    }
}

impl Bench {
    pub fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    /// Puts a file into the folder.
    pub fn file(&self, name: &str, text: &str) -> &Self {
        std::fs::write(self.folder.path().join(name), text).unwrap();
        self
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Names in the folder, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    pub fn run(&self, arguments: &[&str]) -> Said {
        let mut command = Command::new(env!("CARGO_BIN_EXE_truegap"));
        Said::of(command.args(arguments).current_dir(self.folder.path()).output().unwrap())
    }

    /// The same with a file of the folder on standard input, whole at once or through a pipe.
    pub fn run_with(&self, input: &str, piped: bool, arguments: &[&str]) -> Said {
        let mut command = Command::new(env!("CARGO_BIN_EXE_truegap"));
        command.args(arguments).current_dir(self.folder.path()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let child = if piped {
            let mut child = command.stdin(Stdio::piped()).spawn().unwrap();
            let bytes = std::fs::read(self.path(input)).unwrap();
            child.stdin.take().unwrap().write_all(&bytes).unwrap();
            child
        } else {
            command.stdin(std::fs::File::open(self.path(input)).unwrap()).spawn().unwrap()
        };
        Said::of(child.wait_with_output().unwrap())
    }

    /// Runs what must be refused: exit code 2, one paragraph that holds all `parts`, nothing on standard output, nothing left behind.
    pub fn refuses(&self, arguments: &[&str], parts: &[&str]) -> String {
        let before = self.names();
        let said = self.run(arguments);
        assert_eq!(said.code, 2, "{arguments:?} said: {}{}", said.out, said.err);
        assert!(said.out.is_empty(), "{arguments:?} printed: {}", said.out);
        assert!(said.err.starts_with("error: ") && said.err.trim_end().lines().count() == 1, "not one paragraph: {}", said.err);
        for part in parts {
            assert!(said.err.contains(part), "`{part}` is missing in: {}", said.err);
        }
        assert_eq!(self.names(), before, "{arguments:?} left something behind");
        said.err
    }
}

/// A model file: a simulation of one's own, read by electronics that follow it with a time constant of 2 s.
pub const LATE_SIMULATION: &str = r#"schema = "truegap.model/1"
made_by = "truegap 0.1.0"
recording = "cell.toml"
sha256 = "aa"
verdict = "explained"
unit = "mV/V"
[base]
model = "external"
reference_c = 20.0
[base.scale]
unit = "mV/V"
centre = 0.5
range = 1.0
at_rest = 0.0
span = 1.0
gaps_m = [0.0, 0.0]
response_times_gap = 1.0
[base.options]
offset = true
[scales]
longest_run_s = 300.0
shortest_step_s = 0.1
duration_s = 300.0
response_span = 1.0
noise_sd = 0.002
runs = 1
[scales.moved]
temperature_k = 0.0
load = 0.0
gap = false
simulated = true
drivers = []
round = []
[scales.moved.ranges]
[[parameter]]
name = "offset"
unit = "mV/V"
value = 0.0
sd = 0.0001
[[base_alone]]
name = "offset"
unit = "mV/V"
value = 0.0
sd = 0.0001
[[effect]]
id = "readout_lag"
[[effect.parameters]]
name = "tau"
unit = "s"
value = 2.0
sd = 0.05
"#;
