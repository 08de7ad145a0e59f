//! Carries out an attack in a folder of its own and says what went through.
//!
//! Limits: memory is limited as address space, so a program that reserves much and uses little is judged too hard.

use crate::attack::{Attack, Put};
use std::fs;
use std::io::{self, Read};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// How an attack ended.
#[derive(Clone, Debug)]
pub struct Ended {
    /// what went through; nothing where it was held
    pub through: Vec<String>,
    /// time it took
    pub seconds: f64,
}

/// What a command did.
struct Said {
    /// `None` where it was killed by a signal or by us
    code: Option<i32>,
    late: bool,
    out: String,
    err: String,
}

/// Carries out an attack on the program at `truegap`.
///
/// # Errors
/// [`io::Error`] where the folder cannot be made or nothing can be started.
pub fn attack(truegap: &Path, attack: &Attack) -> io::Result<Ended> {
    let place = tempfile::tempdir()?;
    // one level below, so that what leaves its folder is found
    let folder = place.path().join("work");
    fs::create_dir(&folder)?;
    attack.put.iter().try_for_each(|put| lay(&folder, put))?;
    let before = names(&folder)?;
    let begin = Instant::now();
    let said = run(truegap, attack, &folder)?;
    let seconds = begin.elapsed().as_secs_f64();
    let mut through = judge(attack, &said);
    left(attack, &folder, &before, &mut through)?;
    if names(place.path())? != ["work"] {
        through.push(format!("wrote beside its folder: {:?}", names(place.path())?));
    }
    through.extend(attack.look.and_then(|look| look(&folder)));
    Ok(Ended { through, seconds })
}

/// What is left behind and should not be, or is not there and should be; and numbers that are none in it.
fn left(attack: &Attack, folder: &Path, before: &[String], wrong: &mut Vec<String>) -> io::Result<()> {
    let new: Vec<String> = names(folder)?.into_iter().filter(|name| !before.contains(name)).collect();
    let surplus: Vec<&String> = new.iter().filter(|name| !attack.leaves.contains(&name.as_str())).collect();
    if !surplus.is_empty() {
        wrong.push(format!("left behind: {surplus:?}"));
    }
    if let Some(missing) = attack.leaves.iter().find(|name| !new.iter().chain(before).any(|there| there == *name)) {
        wrong.push(format!("`{missing}` is not there"));
    }
    attack.leaves.iter().try_for_each(|left| numbers(&folder.join(left), wrong))
}

/// Puts something into a folder.
pub(crate) fn lay(folder: &Path, put: &Put) -> io::Result<()> {
    let parent = |path: &Path| path.parent().map_or(Ok(()), fs::create_dir_all);
    match put {
        Put::File(name, bytes) => {
            let path = folder.join(name);
            parent(&path)?;
            fs::write(path, bytes)
        }
        Put::Hole(name, bytes) => fs::File::create(folder.join(name))?.set_len(*bytes),
        Put::Folder(name) => fs::create_dir_all(folder.join(name)),
        Put::Pipe(name) => {
            let made = Command::new("mkfifo").arg(folder.join(name)).status()?;
            if made.success() { Ok(()) } else { Err(io::Error::other("mkfifo failed")) }
        }
        Put::Link(name, to) => link(to, &folder.join(name)),
    }
}

#[cfg(unix)]
fn link(to: &str, at: &Path) -> io::Result<()> {
    std::os::unix::fs::symlink(to, at)
}

#[cfg(not(unix))]
fn link(_: &str, _: &Path) -> io::Result<()> {
    Err(io::Error::other("no links here"))
}

/// Numbers that are none, in what is left for people and programs to read.
fn numbers(path: &Path, wrong: &mut Vec<String>) -> io::Result<()> {
    if path.is_dir() {
        return fs::read_dir(path)?.try_for_each(|entry| numbers(&entry?.path(), wrong));
    }
    if !path.exists() {
        return Ok(());
    }
    let is_read = path.extension().is_some_and(|e| ["html", "json", "toml", "csv", "md"].iter().any(|read| e == *read));
    let text = if is_read { String::from_utf8_lossy(&fs::read(path)?).into_owned() } else { String::new() };
    // words of a text, and not of the program that a page may hold
    let told = text.split("<script").map(|part| part.rsplit("</script>").next().unwrap_or(part));
    if let Some(line) = told.flat_map(str::lines).find(|line| line.split(|c: char| !c.is_alphanumeric()).any(|w| w == "NaN")) {
        let shown: String = line.chars().take(200).collect();
        wrong.push(format!("{} holds a number that is none: {shown}", path.display()));
    }
    Ok(())
}

fn names(folder: &Path) -> io::Result<Vec<String>> {
    let mut names: Vec<String> =
        fs::read_dir(folder)?.map(|e| e.map(|e| e.file_name().to_string_lossy().into_owned())).collect::<Result<_, _>>()?;
    names.sort();
    Ok(names)
}

/// The command under limits that a shell sets.
fn run(truegap: &Path, attack: &Attack, folder: &Path) -> io::Result<Said> {
    // a file that may not grow is an error to write, not a signal
    let disk = attack.blocks.map_or_else(String::new, |blocks| format!("trap '' XFSZ; ulimit -f {blocks}; "));
    let limits = format!("ulimit -c 0; ulimit -v {}; {disk}exec \"$0\" \"$@\"", attack.megabytes * 1000);
    let mut command = Command::new("sh");
    command.arg("-c").arg(limits).arg(truegap).args(&attack.typed).current_dir(folder);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    // what is remembered between commands, and what the machine says, must not decide
    command.env_remove("TRUEGAP_MEMORY").env("RUST_BACKTRACE", "0").env("XDG_CACHE_HOME", folder.join(".cache"));
    let mut child = command.spawn()?;
    let out = child.stdout.take().filter(|_| !attack.unread).map(reader);
    let err = child.stderr.take().map(reader);
    let code = wait(&mut child, Duration::from_secs(attack.seconds))?;
    let text = |thread: Option<std::thread::JoinHandle<String>>| thread.and_then(|t| t.join().ok()).unwrap_or_default();
    drop(fs::remove_dir_all(folder.join(".cache")));
    Ok(Said { late: code.is_none(), code: code.flatten(), out: text(out), err: text(err) })
}

fn reader(mut stream: impl Read + Send + 'static) -> std::thread::JoinHandle<String> {
    std::thread::spawn(move || {
        let mut bytes = Vec::new();
        // what was read before an error is judged
        drop(stream.read_to_end(&mut bytes));
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

/// The exit code, which a signal takes away; `None` where time was up.
fn wait(child: &mut Child, longest: Duration) -> io::Result<Option<Option<i32>>> {
    let until = Instant::now() + longest;
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status.code()));
        }
        if Instant::now() > until {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// What is wrong with an answer.
fn judge(attack: &Attack, said: &Said) -> Vec<String> {
    let mut wrong = Vec::new();
    let told = format!("{}{}", said.out, said.err);
    let shown: String = told.chars().take(300).collect();
    match (said.late, said.code) {
        (true, _) => wrong.push(format!("no answer in {} s", attack.seconds)),
        (_, None) => wrong.push(format!("killed by a signal; it said: {shown}")),
        (_, Some(code)) if code != attack.exit => wrong.push(format!("exit code {code}, not {}; it said: {shown}", attack.exit)),
        _ => {}
    }
    if told.contains("panicked") || told.contains("defect of truegap") {
        wrong.push(format!("panicked: {shown}"));
    }
    if let Some(c) = told.chars().find(|c| c.is_control() && !matches!(c, '\n' | '\t')) {
        wrong.push(format!("sends the control character {c:?} to the terminal"));
    }
    wrong.extend(attack.words.iter().filter(|word| !told.contains(*word)).map(|word| format!("`{word}` is missing in: {shown}")));
    if attack.exit == 2 && said.code == Some(2) {
        let refusal = said.err.lines().filter(|line| line.starts_with("error: ")).count();
        if refusal != 1 || !said.out.is_empty() {
            wrong.push(format!("not one paragraph that begins with `error: `: {shown}"));
        }
    }
    let number = |word: &str| matches!(word.trim_matches(|c: char| !c.is_alphanumeric()), "NaN" | "inf");
    if said.code == Some(0) && said.out.split_whitespace().any(number) {
        wrong.push(format!("prints a number that is none: {shown}"));
    }
    wrong
}
