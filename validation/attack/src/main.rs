//! Carries out the list of attacks on `truegap`, or gives mutated inputs to its readers; exit code 0 (all held), 1 (something went through) or 2 (could not run).

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
#[cfg(target_os = "linux")]
use truegap_attack::moments;
use truegap_attack::{bench, list, readers};

const HELP: &str = "truegap-attack [--short] [WORD]
truegap-attack fuzz [COUNT] [READER]
truegap-attack moments [MOST] [COMMAND]

Carries out every attack whose class or name holds WORD on target/debug/truegap, or on the program that TRUEGAP names, and prints what went through.
  --short  the attacks that take seconds, as `cargo test` does
  fuzz     gives COUNT mutated inputs (1000000 where nothing is said) to each reader, or to READER
  moments  kills each command that writes, or COMMAND, at MOST of the moments at which it changes a file (all where nothing is said), and has the disk full there";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    let done = match words.first().map(String::as_str) {
        Some("-h" | "--help") => {
            println!("{HELP}");
            return ExitCode::SUCCESS;
        }
        Some("fuzz") => fuzz(&words[1..]),
        #[cfg(target_os = "linux")]
        Some("moments") => broken(&words[1..]),
        _ => attacks(&words),
    };
    done.unwrap_or_else(|error| {
        eprintln!("error: {error}");
        ExitCode::from(2)
    })
}

fn attacks(words: &[String]) -> Result<ExitCode, String> {
    let is_short = words.iter().any(|word| word == "--short");
    let wanted = words.iter().find(|word| !word.starts_with("--")).map_or("", String::as_str);
    let truegap = program()?;
    let chosen: Vec<_> =
        list::all().into_iter().filter(|a| (a.class == wanted || a.name.contains(wanted)) && (a.is_short || !is_short)).collect();
    let mut through = 0;
    for attack in &chosen {
        let ended = bench::attack(&truegap, attack).map_err(|error| format!("{}: {error}", attack.name))?;
        for what in &ended.through {
            println!("[{}] {} ({:.1} s): {what}", attack.class, attack.name, ended.seconds);
        }
        through += usize::from(!ended.through.is_empty());
    }
    println!("{} attacks, {through} went through", chosen.len());
    Ok(ExitCode::from(u8::from(through > 0)))
}

/// The program under attack, built where it is missing.
fn program() -> Result<PathBuf, String> {
    if let Some(named) = std::env::var_os("TRUEGAP") {
        return std::path::absolute(named).map_err(|error| error.to_string());
    }
    let own = std::env::current_exe().map_err(|error| error.to_string())?;
    let truegap = own.with_file_name(format!("truegap{}", std::env::consts::EXE_SUFFIX));
    if !truegap.exists() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let built = Command::new(env!("CARGO")).args(["build", "-p", "truegap-cli"]).current_dir(root).status();
        built
            .map_err(|error| error.to_string())
            .and_then(|s| if s.success() { Ok(()) } else { Err("the build failed".into()) })?;
    }
    Ok(truegap)
}

/// Commands broken at the moments at which they change a file.
#[cfg(target_os = "linux")]
fn broken(words: &[String]) -> Result<ExitCode, String> {
    let most: usize =
        words.first().map_or(Ok(usize::MAX), |n| n.parse()).map_err(|_| format!("{}: no count of moments", words[0]))?;
    let wanted = words.get(1).map_or("", String::as_str);
    let truegap = program()?;
    let mut through = 0;
    for job in moments::jobs::all().iter().filter(|job| job.name.starts_with(wanted)) {
        let came = moments::moments(&truegap, job, most).map_err(|error| error.to_string())?;
        came.through.iter().for_each(|what| println!("[{}] {what}", job.name));
        println!(
            "{}: {} kills, {} calls without space, {} small disks; {} went through",
            job.name,
            came.kills,
            came.refusals,
            came.disks,
            came.through.len()
        );
        through += came.through.len();
    }
    Ok(ExitCode::from(u8::from(through > 0)))
}

fn fuzz(words: &[String]) -> Result<ExitCode, String> {
    let count: u32 =
        words.first().map_or(Ok(1_000_000), |n| n.parse()).map_err(|_| format!("{}: no count of inputs", words[0]))?;
    let wanted = words.get(1).map_or("", String::as_str);
    let mut found = 0;
    for reader in readers::all().iter().filter(|r| r.name.contains(wanted)) {
        let begin = std::time::Instant::now();
        let told = match readers::feed(reader, count) {
            Ok(fed) => format!("{} taken and sound, the others refused; at most {:.3} s", fed.taken, fed.slowest.as_secs_f64()),
            Err(what) => {
                found += 1;
                format!("WENT THROUGH: {what}")
            }
        };
        println!("{}: {count} inputs in {:.0} s, {told}", reader.name, begin.elapsed().as_secs_f64());
    }
    Ok(ExitCode::from(u8::from(found > 0)))
}
