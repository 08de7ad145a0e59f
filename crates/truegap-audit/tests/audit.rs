//! Whole audits: remembered, stopped, asked for by name.

#![allow(clippy::unwrap_used)]

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use truegap_audit::*;
use truegap_core::sensor::builtin_sensors;

#[test]
fn an_audit_is_remembered_and_the_second_time_nothing_is_computed() {
    let folder = std::env::temp_dir().join(format!("truegap-audit-run-{}", std::process::id()));
    let (cache, sensor) = (Cache::in_folder(&folder), builtin_sensors()[0].sensor().unwrap());
    let names: Vec<String> = ["TAIL-PARALLEL-PLATE", "MIXING-PARALLEL", "FREE-EXPANSION"].map(String::from).to_vec();
    let told = AtomicUsize::new(0);
    let tell = |p: &Progress| {
        assert!(p.done <= p.total && p.total == 3);
        told.fetch_add(1, Ordering::Relaxed);
    };
    let watch = Watch { progress: Some(&tell), cancel: None };
    let first = run(&sensor, &chosen(&names).unwrap(), Options::default(), &cache, &watch).unwrap();
    assert!(told.load(Ordering::Relaxed) >= 6);
    // Not rounded anywhere, so what is read back is what was written, bit by bit.
    let again = run(&sensor, &chosen(&names).unwrap(), Options::default(), &cache, &Watch::default()).unwrap();
    assert_eq!(first, again);
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 3);
    let order: Vec<&str> = first.assumptions.iter().map(|f| f.id.as_str()).collect();
    assert_eq!(order, ["FREE-EXPANSION", "MIXING-PARALLEL", "TAIL-PARALLEL-PLATE"]);
    assert_eq!(first.ranking.len(), 5);
    assert_eq!(first.ranking[2].order[0].id, "FREE-EXPANSION");
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn an_audit_stops_when_asked_and_a_name_that_is_not_there_is_answered_with_the_register() {
    let sensor = builtin_sensors()[0].sensor().unwrap();
    let stop = AtomicBool::new(true);
    let watch = Watch { progress: None, cancel: Some(&stop) };
    let stopped = run(&sensor, &register(), Options::default(), &Cache::none(), &watch);
    assert!(matches!(stopped, Err(AuditError::Cancelled)));
    let unknown = chosen(&["NO-FRINGES".into()]).map(|_| ()).unwrap_err().to_string();
    assert!(unknown.contains("NO-FRINGES") && unknown.contains("NO-FRINGING"), "{unknown}");
}

#[test]
fn ids_are_unique_and_every_row_has_words() {
    let all = register();
    for (i, a) in all.iter().enumerate() {
        assert!(all[..i].iter().all(|b| b.id() != a.id()), "{}", a.id());
        assert!(!a.says().is_empty() && !a.source().is_empty());
        assert!(a.id().chars().all(|c| c.is_ascii_uppercase() || c == '-'));
    }
    assert!(all.len() >= 16);
}
