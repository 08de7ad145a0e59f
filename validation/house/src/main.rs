//! Prints the module graph of the workspace; exit code 0 (as declared), 1 (something breaks the order) or 2 (could not be read).

use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};
use truegap_house::{Dot, Finding, House, HouseError, Numbers, Plan, Reviewed, Unnamed};

const HELP: &str = "truegap-house [--table | --review | --unnamed | --dot] [FOLDER]

Prints rooms, arrows and circles of the workspace in FOLDER (default: this one), then all that breaks validation/house/order.toml.
  --table   one row a package, in Markdown
  --review  the numbers that a review of the workspace asked for, as CSV
  --unnamed public items that no other package names, with the file that defines each
  --dot     for Graphviz: cargo run -p truegap-house -- --dot | dot -Tsvg > house.svg";

fn main() -> ExitCode {
    let mut root = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let mut form = String::new();
    for argument in std::env::args().skip(1) {
        match argument.as_str() {
            "--table" | "--review" | "--unnamed" | "--dot" => form = argument,
            option if option.starts_with('-') => {
                println!("{HELP}");
                return ExitCode::from(if matches!(option, "-h" | "--help") { 0 } else { 2 });
            }
            folder => root = PathBuf::from(folder),
        }
    }
    print(&root, &form).unwrap_or_else(|error| {
        eprintln!("error: {error}");
        ExitCode::from(2)
    })
}

fn print(root: &Path, form: &str) -> Result<ExitCode, HouseError> {
    let house = House::open(root)?;
    match form {
        "--table" => print!("{}", Numbers(&house)),
        "--review" => print!("{}", Reviewed(&house)),
        "--unnamed" => print!("{}", Unnamed(&house)),
        "--dot" => print!("{}", Dot(&house)),
        _ => return Ok(report(&house)),
    }
    Ok(ExitCode::SUCCESS)
}

fn report(house: &House) -> ExitCode {
    print!("{}", Plan(house));
    let findings = house.findings();
    findings.iter().for_each(|finding: &Finding| println!("{finding}\n"));
    println!("{} findings", findings.len());
    ExitCode::from(u8::from(!findings.is_empty()))
}
