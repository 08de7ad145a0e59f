//! Prints the page of effects: `cargo run -p truegap-diagnose --example effects > docs/effects.md`.

#[path = "../tests/common/mod.rs"]
mod common;

fn main() {
    print!("{}", common::page::page(&truegap_diagnose::Library::default()));
}
