//! Every command that reads a file, and every file that is none.

use super::material::{HEADER, SENSOR, csv};
use crate::attack::{Attack, Put};

/// Commands that read the file `x.toml`, or `x.csv`.
const READ_TOML: [(&str, &[&str]); 9] = [
    ("a recording", &["simulate", "--drive", "x.toml"]),
    ("a recording to diagnose", &["-q", "diagnose", "x.toml", "-o", "out"]),
    ("a sensor", &["coefficients", "--sensor", "./x.toml"]),
    ("a sensor to study", &["-q", "sensitivity", "--sensor", "./x.toml", "-o", "out"]),
    ("a case", &["-q", "solve", "x.toml"]),
    ("a case to mesh", &["-q", "mesh", "x.toml", "-o", "m.msh"]),
    ("a model", &["simulate", "--load", "1 N", "--model", "x.toml"]),
    ("an effect", &["-q", "diagnose", "r.csv", "--sensor", SENSOR, "-o", "out", "--effect", "x.toml"]),
    ("a space", &["-q", "audit", "-o", "out", "--space", "x.toml"]),
];
const READ_CSV: [(&str, &[&str]); 3] = [
    ("a bare recording", &["simulate", "--drive", "x.csv"]),
    ("a bare recording to diagnose", &["-q", "diagnose", "x.csv", "--sensor", SENSOR, "-o", "out"]),
    ("a header", &["init", "x.csv"]),
];

pub fn all() -> Vec<Attack> {
    let mut all = Vec::new();
    for (what, typed) in READ_TOML {
        all.extend(bad(what, typed, "x.toml"));
        let read = |name: &str| Attack::new("files", format!("{what}: {name}"), typed).file("r.csv", csv(HEADER));
        all.push(read("brackets without end").file("x.toml", format!("a = {}", "[".repeat(200_000))));
        all.push(read("keys without end").file("x.toml", format!("a{} = 1", ".a".repeat(200_000))));
        all.push(read("another schema").file("x.toml", "schema = \"truegap.nothing/1\"\n"));
        all.push(read("one key twice").file("x.toml", "schema = \"a\"\nschema = \"b\"\n"));
        all.push(
            Attack::new("9", format!("{what}: a text of 10 GB"), typed)
                .file("r.csv", csv(HEADER))
                .with(Put::Hole("x.toml".into(), 10_000_000_000))
                .says(&["10000 MB"]),
        );
    }
    for (what, typed) in READ_CSV {
        all.extend(bad(what, typed, "x.csv"));
        let huge =
            Attack::new("9", format!("{what}: a table of 10 TB"), typed).with(Put::Hole("x.csv".into(), 10_000_000_000_000));
        all.push(huge.says(&["10000000 MB", "of memory", "TRUEGAP_MEMORY"]));
        all.push(
            Attack::new("9", format!("{what}: a line of 300 MB"), typed)
                .with(Put::Hole("x.csv".into(), 300_000_000))
                .says(&["1 MB"])
                .long(60),
        );
    }
    let program = "schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n[base]\nmodel = \"command\"\ntimeout = \"2 s\"\nrun = [\"sh\", \"-c\", \"SCRIPT\"]\n";
    let typed = ["-q", "diagnose", "x.toml", "-o", "out"];
    for (name, script) in [
        ("writes a line without end", "cat /dev/zero"),
        ("writes lines without end", "yes"),
        ("writes errors without end", "yes >&2"),
        ("ends at once", "exit 3"),
        ("says nothing", "sleep 100"),
        ("steers the terminal", "printf '\\\\033[31mred\\\\033[0m'; exit 1"),
    ] {
        let toml = program.replace("SCRIPT", script);
        all.push(
            Attack::new("files", format!("a base model's program {name}"), &typed)
                .file("r.csv", csv(HEADER))
                .file("x.toml", toml),
        );
    }
    all
}

/// What is no such file, whoever reads it.
fn bad(what: &str, typed: &[&str], name: &str) -> Vec<Attack> {
    let read = |class, how: &str| Attack::new(class, format!("{what}: {how}"), typed).file("r.csv", csv(HEADER)).says(&["x."]);
    let put = |how: &str, bytes: &[u8]| read("files", how).file(name, bytes);
    vec![
        read("files", "not there"),
        put("empty", b""),
        put("bytes that are no text", &(0..=255).cycle().take(4096).collect::<Vec<u8>>()),
        put("a mark of byte order and nothing else", b"\xef\xbb\xbf"),
        put("zeros", &[0; 70_000]),
        put("UTF-16 with half a letter", b"\xff\xfe\x00\xd8s\0"),
        read("9", "a pipe that nobody writes to").with(Put::Pipe(name.into())).says(&["a pipe, not a file"]),
        read("9", "a device without an end").with(Put::Link(name.into(), "/dev/zero".into())).says(&["a device, not a file"]),
        read("files", "a folder").with(Put::Folder(name.into())),
        read("files", "a link that leads nowhere").with(Put::Link(name.into(), "nowhere".into())),
        read("files", "a link to itself").with(Put::Link(name.into(), name.into())),
    ]
}
