//! Some hundred mutated inputs for every reader; `cargo run -p truegap-attack -- fuzz` gives a million.

#![allow(clippy::unwrap_used)]

use truegap_attack::readers::{all, feed};

#[test]
fn no_input_gets_through_a_reader() {
    for reader in all() {
        feed(&reader, 300).unwrap_or_else(|what| panic!("{}: {what}", reader.name));
    }
}
