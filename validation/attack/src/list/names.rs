//! Names that are more than names: parts of a path, markup, formulas, what ends a cell or a quote.

use super::material::{HEADER, SENSOR, SQUARE, case, csv, quoted, region, sensor_named};
use crate::attack::{Attack, Put};
use std::fs;
use std::path::Path;

/// Markup that would run where it is not escaped.
const MARKUP: &str = "<img src=x onerror=alert(1)>&\"'";

pub fn all() -> Vec<Attack> {
    let study = |class, name: &str, sensor: &str| {
        Attack::new(class, name, &["-q", "sensitivity", "--sensor", "./s.toml", "--rows", "64", "-o", "out"])
            .file("s.toml", sensor_named(sensor))
            .ends(0, &["out"])
    };
    let refused = |name: &str, sensor: &str| {
        Attack::new("17", name, &["coefficients", "--sensor", "./s.toml"])
            .file("s.toml", sensor_named(sensor))
            .says(&["s.toml", "name", "one line"])
    };
    let region_named = |name: &str, file: &str| {
        Attack::new("17", format!("a region named {name:?}"), &["-q", "mesh", "c.toml", "-o", file])
            .file("c.toml", case(&region(name, SQUARE), "max_edge = \"1 mm\""))
    };
    let mut all = vec![
        study("6", "a sensor that climbs out of the folder", "../../escaped"),
        study("6", "a sensor with a path", "/tmp/truegap-attack-escaped")
            .look(|_| fs::metadata("/tmp/truegap-attack-escaped_span.svg").ok().map(|_| "wrote into /tmp".into())),
        study("6", "a sensor named ..", ".."),
        study("names", "a sensor that is markup", MARKUP).look(no_markup),
        study("names", "a sensor that is a formula", "=HYPERLINK(\"http://example.org\",1)").look(whole_cells),
        study("names", "a sensor with commas and quotes", "a,b\",c;d").look(whole_cells),
        study("names", "a sensor that is LaTeX", "$\\input{/etc/passwd}$ \\write18{ls} %"),
        refused("a sensor that steers the terminal", "\u{1b}[31mred"),
        refused("a sensor of two lines", "a\nb"),
        refused("a sensor without a name", " "),
        refused("a sensor with a name of 10 000 letters", &"x".repeat(10_000)),
        region_named("a\"b", "m.msh").says(&["c.toml", "quotes"]),
        region_named("a\nb", "m.msh").says(&["c.toml", "one line"]),
        region_named("", "m.msh").says(&["c.toml", "1 to 200"]),
        region_named("a] <b>&", "m.vtu").ends(0, &["m.vtu"]),
    ];
    all.extend(marked());
    let batch =
        ["-q", "diagnose", "--batch", "a/run.csv", "b/run.csv", "--sensor", SENSOR, "--effects", "thermal_lag", "-o", "out"];
    let two = |folder: &Path| {
        let both = ["a-run", "b-run"].iter().all(|name| folder.join("out").join(name).join("diagnosis.json").is_file());
        (!both).then(|| "two recordings of one name do not have an answer each".to_owned())
    };
    all.push(
        Attack::new("7", "two recordings of one name", &batch)
            .file("a/run.csv", csv(HEADER))
            .file("b/run.csv", csv(HEADER))
            .ends(1, &["out"])
            .look(two),
    );
    all
}

/// Markup in every field of a recording, of a model and of an effect.
fn marked() -> Vec<Attack> {
    let header = format!("{HEADER},\"{}\"", MARKUP.replace('"', "\"\""));
    let rows: String = csv(&header)
        .lines()
        .enumerate()
        .map(|(k, line)| if k == 0 { format!("{line}\n") } else { format!("{line},{}\n", k % 17) })
        .collect();
    let toml = format!(
        "schema = \"truegap.recording/1\"\nfile = {}\n[columns]\nresponse = \"capacitance_pf\"\n[units]\nresponse = {}\n[drivers]\n{MARKUP:?} = {{ column = {}, unit = {} }}\n[base]\nmodel = \"linear\"\n",
        quoted("<b>&'.csv"),
        quoted(MARKUP),
        quoted(MARKUP),
        quoted(MARKUP)
    );
    let says = format!(
        "schema = \"truegap.mechanism/1\"\nid = \"marked\"\nsays = {}\nquantity = \"reading\"\naction = \"adds\"\ndriver = \"temperature\"\nkinetics = \"static\"\nform = \"linear\"\nsize = {{ sd = 10.0, unit = {} }}\n",
        quoted(MARKUP),
        quoted(MARKUP)
    );
    let diagnose = |typed: &[&str]| Attack::new("names", "markup in every field of a recording", typed);
    vec![
        diagnose(&["-q", "diagnose", "<i>.toml", "-o", "out", "--effect", "e.toml"])
            .file("<b>&'.csv", rows.clone())
            .file("<i>.toml", toml)
            .file("e.toml", says)
            .ends(1, &["out"])
            .look(no_markup)
            .long(120),
        Attack::new("names", "an id that is markup", &["-q", "diagnose", "example", "-o", "out", "--effect", "e.toml"])
            .file("e.toml", "schema = \"truegap.mechanism/1\"\nid = \"<b>\"\nquantity = \"reading\"\naction = \"adds\"\ndriver = \"load\"\nkinetics = \"static\"\nform = \"linear\"\nsize = { sd = 1.0 }\n")
            .says(&["e.toml", "small letters"]),
        Attack::new("names", "a recording whose file is markup", &["simulate", "--drive", "<b>.csv"]).with(Put::Folder("x".into())).says(&["no such file"]),
        Attack::new("names", "markup in a note", &["-q", "export", "--sensor", "./s.toml", "--load", "1 N", "-o", "e.html"])
            .file("s.toml", sensor_named("</script><img src=x onerror=alert(1)>"))
            .ends(0, &["e.html"])
            .look(no_markup)
            .long(120),
    ]
}

/// No page and no figure holds markup that came from a name.
fn no_markup(folder: &Path) -> Option<String> {
    let mut pages = Vec::new();
    gather(folder, &mut pages);
    pages.into_iter().find_map(|page| {
        let text = fs::read_to_string(&page).ok()?;
        text.contains("<img src=x").then(|| format!("{} holds markup from a name", page.display()))
    })
}

fn gather(folder: &Path, pages: &mut Vec<std::path::PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            gather(&path, pages);
        } else if path.extension().is_some_and(|e| e == "html" || e == "svg") {
            pages.push(path);
        }
    }
}

/// Every line of the table has as many cells as its header, and none is a formula.
fn whole_cells(folder: &Path) -> Option<String> {
    let text = fs::read_to_string(folder.join("out/sensitivity.csv")).ok()?;
    let cells = |line: &str| {
        let mut inside = false;
        1 + line
            .chars()
            .filter(|c| {
                inside ^= *c == '"';
                *c == ',' && !inside
            })
            .count()
    };
    let expected = text.lines().next().map_or(0, cells);
    text.lines()
        .find(|line| cells(line) != expected || line.starts_with('='))
        .map(|line| format!("a line of sensitivity.csv is `{line}`"))
}
