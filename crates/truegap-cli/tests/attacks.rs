//! The short version of the list of attacks; `cargo run -p truegap-attack` carries out all of it.

#![allow(clippy::unwrap_used)]

use std::path::Path;
use truegap_attack::{bench, list};

#[test]
fn no_attack_gets_through() {
    let truegap = Path::new(env!("CARGO_BIN_EXE_truegap"));
    let short: Vec<_> = list::all().into_iter().filter(|attack| attack.is_short).collect();
    let next = std::sync::Mutex::new(short.iter());
    let through = std::sync::Mutex::new(Vec::new());
    // side by side, as most attacks take hundredths of a second and a few take seconds
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let Some(attack) = next.lock().unwrap().next() else { break };
                    let ended = bench::attack(truegap, attack).unwrap();
                    let told = ended.through.into_iter().map(|what| format!("[{}] {}: {what}", attack.class, attack.name));
                    through.lock().unwrap().extend(told);
                }
            });
        }
    });
    let through = through.into_inner().unwrap();
    assert!(through.is_empty(), "{} of {} attacks:\n{}", through.len(), short.len(), through.join("\n"));
}
