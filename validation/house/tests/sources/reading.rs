//! What a source says, and what it does not.

use super::arrows;

const LIB: (&str, &str) = ("lib.rs", "mod one; mod two; mod three;");

#[test]
fn nested_use_trees_globs_and_renames_are_read() {
    let one = "use crate::{two::{self, Two as Deux, deep::{Deep, deeper}}, three::*};\nfn f() { two::free(); Three::new(); }";
    let two = "pub mod deep; pub struct Two; pub fn free() {}";
    let three = "pub struct Three; pub struct Other;";
    let sources =
        [LIB, ("one.rs", one), ("two/mod.rs", two), ("two/deep.rs", "pub struct Deep; pub fn deeper() {}"), ("three.rs", three)];
    let expected = ["one.rs -> three.rs: Three", "one.rs -> two/deep.rs: Deep deeper", "one.rs -> two/mod.rs: Two free"];
    assert_eq!(arrows(&sources), expected);
}

#[test]
fn paths_in_code_count_wherever_they_stand() {
    let one = "pub(in crate::three) fn f(x: super::two::Two) -> usize { for k in 0..crate::two::count(x) { g(k) } }";
    let sources =
        [LIB, ("one.rs", one), ("two.rs", "pub struct Two; pub const fn count(x: Two) -> usize { 3 }"), ("three.rs", "")];
    assert_eq!(arrows(&sources), ["one.rs -> two.rs: Two count"]);
}

#[test]
fn comments_strings_characters_and_attributes_do_not_count() {
    let one = r##"
        //! See [`crate::two::Two`].
        // use crate::two::Two;
        /* use crate::two::Two; /* crate::two::Two */ crate::two::Two */
        /// `crate::two::Two`
        #[doc = "crate::two::Two"]
        #[serde(with = crate::two::Two)]
        fn f<'a>(x: &'a str) -> char {
            let a = "\" crate::two::Two"; let b = r#"" crate::two::Two "#; let c = b"crate::two::Two";
            if x == a { '"' } else { '\'' } // crate::two::Two
        }
        fn g() { crate::three::h() }
    "##;
    let sources = [LIB, ("one.rs", one), ("two.rs", "pub struct Two;"), ("three.rs", "pub fn h() {}")];
    assert_eq!(arrows(&sources), ["one.rs -> three.rs: h"]);
}

#[test]
fn modules_for_tests_do_not_count() {
    let one = "#[cfg(test)]\nuse crate::two::{Two};\n#[cfg(test)]\n#[allow(unused)]\nmod tests { use crate::two::Two; mod inner {} }\n\
               #[cfg(test)] mod apart;\n#[cfg(not(test))] use crate::three::Three;";
    let sources = [LIB, ("one.rs", one), ("two.rs", "pub struct Two;"), ("three.rs", "pub struct Three;")];
    assert_eq!(arrows(&sources), ["one.rs -> three.rs: Three"]);
}

#[test]
fn a_module_in_place_belongs_to_its_file() {
    let one = "mod inner { use super::super::two::Two; pub struct Inner; }";
    let two = "pub struct Two; fn f() { crate::one::inner::Inner; }";
    let sources = [LIB, ("one.rs", one), ("two.rs", two), ("three.rs", "")];
    assert_eq!(arrows(&sources), ["one.rs -> two.rs: Two", "two.rs -> one.rs: Inner"]);
}

#[test]
fn re_exports_lead_to_the_file_that_defines() {
    let lib = ("lib.rs", "mod one; mod two; mod three; pub use two::Two; pub const HERE: f64 = 1.0;");
    let one = "use crate::{Two, HERE}; use crate::three::Alias; use crate::three::Made;";
    let three = "pub use super::Two as Alias; macro_rules! make { () => {} } make!();";
    let sources = [lib, ("one.rs", one), ("two.rs", "pub struct Two;"), ("three.rs", three)];
    let expected = ["one.rs -> lib.rs: HERE", "one.rs -> three.rs: Made", "one.rs -> two.rs: Two", "three.rs -> two.rs: Two"];
    assert_eq!(arrows(&sources), expected);
}

#[test]
fn a_function_may_have_the_name_of_its_module() {
    let lib = ("lib.rs", "mod one; mod two; mod three; pub use two::two;");
    let one = "use crate::two; fn f() { two::other(); two(); }";
    let sources = [lib, ("one.rs", one), ("two.rs", "pub fn two() {} pub fn other() {}"), ("three.rs", "use crate::one::f;")];
    assert_eq!(arrows(&sources), ["one.rs -> two.rs: other two", "three.rs -> one.rs: f"]);
}

#[test]
fn globs_that_name_each_other_end() {
    let sources = [
        LIB,
        ("one.rs", "pub use crate::two::*; pub struct One;"),
        ("two.rs", "pub use crate::one::*; pub struct Two;"),
        ("three.rs", "use crate::one::{One, Two}; use crate::two::Nothing;"),
    ];
    let expected = ["three.rs -> one.rs: One", "three.rs -> two.rs: Nothing Two"];
    assert_eq!(arrows(&sources), expected);
}

#[test]
fn what_lib_shows_is_no_arrow_and_what_it_uses_is_one() {
    let lib =
        ("lib.rs", "mod one; mod two; mod three; pub use one::One; pub mod face { pub use crate::two::Two; }\nuse three::Three;");
    let sources = [lib, ("one.rs", "pub struct One;"), ("two.rs", "pub struct Two;"), ("three.rs", "pub struct Three;")];
    assert_eq!(arrows(&sources), ["lib.rs -> three.rs: Three"]);
}
