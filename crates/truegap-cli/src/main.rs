//! The command `truegap`.
fn main() {}
