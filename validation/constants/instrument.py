"""A copy of the crates in which every listed constant can be turned by a variable of the environment.

    TRUEGAP_TURN="selection.SURE=0.95"    another value, or as many as it has, with commas
    TRUEGAP_READS=FILE                    each constant that is read adds a line with its id

Limits: text is replaced, so a constant in an array's length or a pattern does not build; none of the list stands in one. A constant that is made of a listed one keeps its value where that is turned.
"""

import re
import shutil

from inventory import ROOT, constants

MODULE = '''//! Numbers that the environment can turn.
#![allow(missing_docs)]
use std::{fmt, io::Write, ops::Deref, sync::LazyLock};
use truegap_core::{Parameter, Prior};

pub(crate) struct Turned<T>(LazyLock<T>);
impl<T> Turned<T> {
    pub(crate) const fn new(read: fn() -> T) -> Self { Self(LazyLock::new(read)) }
}
impl<T> Deref for Turned<T> {
    type Target = T;
    fn deref(&self) -> &T { &self.0 }
}
impl<T: fmt::Display> fmt::Display for Turned<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result { (**self).fmt(f) }
}
pub(crate) trait Number: Sized { fn of(all: &[f64]) -> Self; }
impl Number for f64 { fn of(all: &[f64]) -> Self { all[0] } }
impl Number for usize { fn of(all: &[f64]) -> Self { all[0] as usize } }
impl Number for (usize, usize) { fn of(all: &[f64]) -> Self { (all[0] as usize, all[1] as usize) } }
impl<const N: usize> Number for [f64; N] { fn of(all: &[f64]) -> Self { std::array::from_fn(|i| all[i]) } }

pub(crate) fn turned<T: Number>(id: &str, value: T) -> T {
    if let Ok(path) = std::env::var("TRUEGAP_READS") {
        let file = std::fs::OpenOptions::new().create(true).append(true).open(path);
        let _ = file.and_then(|mut file| writeln!(file, "{id}"));
    }
    match std::env::var("TRUEGAP_TURN").ok().as_deref().and_then(|text| text.split_once('=')) {
        Some((name, all)) if name == id => {
            T::of(&all.split(',').map(|n| n.parse().expect("a number")).collect::<Vec<f64>>())
        }
        _ => value,
    }
}

fn wider(prior: Prior, factor: f64) -> Prior {
    match prior {
        Prior::Normal { mean, sd } => Prior::Normal { mean, sd: sd * factor },
        Prior::LogNormal { median, log_sd } => Prior::LogNormal { median, log_sd: log_sd * factor },
        Prior::Wide { sd } => Prior::Wide { sd: sd * factor },
    }
}
pub(crate) fn sized(mut own: Vec<Parameter>, foreseen: bool, factor: f64) -> Vec<Parameter> {
    own.iter_mut().take(if foreseen { 0 } else { 1 }).for_each(|p| p.prior = wider(p.prior, factor));
    own
}
pub(crate) fn known(mut all: Vec<Parameter>, factor: f64) -> Vec<Parameter> {
    all.iter_mut().for_each(|p| p.prior = wider(p.prior, factor));
    all
}
'''
# code, or what is none: comments, strings, characters
PIECE = re.compile(r'(?P<comment>//[^\n]*)|(?P<string>b?"(?:\\.|[^"\\])*")|(?P<char>\'(?:\\.|[^\'\\])\')', re.S)


def instrumented(scratch):
    """Writes the copy to `scratch`; its target folder stays from run to run."""
    for name in ["crates", "benches", "validation", "meshes", "docs"]:
        shutil.rmtree(scratch / name, ignore_errors=True)
        shutil.copytree(ROOT / name, scratch / name, ignore=shutil.ignore_patterns("target", "__pycache__"))
    for name in ["Cargo.toml", "Cargo.lock", "rustfmt.toml", "clippy.toml"]:
        shutil.copy2(ROOT / name, scratch / name)
    turn(scratch / "crates/truegap-diagnose/src")


def turn(sources):
    """Turns constants into values that are read at the first use, in place."""
    texts = {path: path.read_text() for path in sorted(sources.rglob("*.rs")) if "tests" not in path.relative_to(sources).parts}
    anonymous, named = [], {}
    for entry in constants():
        path = sources / entry["path"]
        if "at" in entry:
            texts[path] = replaced(texts[path], entry)
            kind = "usize" if entry.get("whole") else "f64"
            anonymous.append(statement(entry, kind, entry["value"], entry["id"].replace(".", "_").upper()))
        else:
            named[(module(sources, path), entry["name"])] = entry
    values = {name: entry["value"] for (_, name), entry in named.items()}
    for path, text in texts.items():
        own = module(sources, path)
        known = {name: name for (where, name) in named if where == own}
        for alias, full in imported(text, own):
            if (full[:-1], full[-1]) in named:
                known[alias] = full[-1]
        if known:
            text = of_values(used(text, known), {alias: values[name] for alias, name in known.items()})
        for (where, name), entry in named.items():
            if where == own:
                declaration = rf"\bconst {name}: ([^=]+?) =\s*([^;]+);"
                text = re.sub(declaration, lambda found: statement(entry, found.group(1), found.group(2), name), text, count=1)
        path.write_text(text)
    (sources / "turned.rs").write_text(MODULE + "".join(f"pub(crate) {line}\n" for line in anonymous))
    library = sources / "lib.rs"
    library.write_text(library.read_text() + "\nmod turned;\n")


def of_values(text, values):
    """The text with the values of listed constants in what other constants are made of."""
    made = re.compile(r"\bconst \w+: [^=;]+ =\s*[^;]*\(\*\w+\)[^;]*;")
    return made.sub(lambda found: re.sub(r"\(\*(\w+)\)", lambda name: values.get(name[1], name[0]), found[0]), text)


def statement(entry, kind, value, name):
    return f'static {name}: crate::turned::Turned<{kind}> = crate::turned::Turned::new(|| crate::turned::turned("{entry["id"]}", {value}));'


def replaced(text, entry):
    """The text with an unnamed number of it turned."""
    number = f"(*crate::turned::{entry['id'].replace('.', '_').upper()})"
    if "to" in entry:
        return text.replace(entry["at"], entry["to"].replace("@", number))
    return text.replace(entry["at"].replace("«", "").replace("»", ""), re.sub("«.*»", lambda _: number, entry["at"]))


def module(sources, path):
    """Path of a file's module from the crate's root, as a tuple."""
    parts = path.relative_to(sources).with_suffix("").parts
    return parts[:-1] if parts[-1] in ("mod", "lib") else parts


def imported(text, own):
    """Pairs of name here and full path, of every `use` in a file."""
    pairs = []
    for tree in re.findall(r"\buse\s+([^;]+);", text):
        pairs += leaves(re.sub(r"\s+", "", tree.replace(" as ", "=")), ())
    absolute = []
    for path in pairs:
        head, rest = path[0], list(path[1:])
        base = list(own)
        if head == "crate":
            base = []
        elif head == "super":
            base = base[:-1]
        elif head != "self":
            continue
        name, _, alias = rest[-1].partition("=")
        absolute.append((alias or name, tuple(base + rest[:-1] + [name])))
    return absolute


def leaves(tree, prefix):
    """Paths of a `use` tree without spaces."""
    depth, start, parts = 0, 0, []
    for at, character in enumerate(tree + ","):
        depth += (character == "{") - (character == "}")
        if character == "," and depth == 0:
            parts.append(tree[start:at])
            start = at + 1
    paths = []
    for part in filter(None, parts):
        head, brace, inside = part.partition("{")
        path = prefix + tuple(filter(None, head.split("::")))
        paths += leaves(inside[:-1], path) if brace else [path]
    return paths


def used(text, known):
    """The text with every use of these names read through its cell; declarations, imports, comments and strings stay."""
    name = "|".join(map(re.escape, sorted(known, key=len, reverse=True)))
    use = re.compile(rf"(?P<keep>\buse\s[^;]+;|\bconst (?:{name}):)|(?<![\w:])(?<![^.]\.)(?:tuning::)?(?P<name>{name})\b(?!\s*:[^:])")
    out, at = [], 0
    for piece in [*PIECE.finditer(text), None]:
        code = text[at : piece.start() if piece else len(text)]
        out.append(use.sub(lambda found: found.group(0) if found.group("keep") else f"(*{found.group('name')})", code))
        if piece:
            out.append(piece.group(0))
            at = piece.end()
    return "".join(out)
