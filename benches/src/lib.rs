//! The problems that the benches time.
