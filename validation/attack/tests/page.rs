//! The page beside the list.

#![allow(clippy::unwrap_used)]

use truegap_attack::{list, readers};

const PAGE: &str = include_str!("../README.md");

#[cfg(unix)]
#[test]
fn the_page_counts_the_attacks_of_the_list() {
    let all = list::all();
    let short = all.iter().filter(|attack| attack.is_short).count();
    let line = format!("**{} attacks, {short} of them short**", all.len());
    assert!(PAGE.contains(&line), "the page does not say {line}");
    for attack in &all {
        let of_class = |line: &str| line.split('|').nth(1).is_some_and(|c| c.split(',').any(|c| c.trim() == attack.class));
        assert!(PAGE.lines().any(of_class), "{}: class {} is not on the page", attack.name, attack.class);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn the_page_says_at_how_many_moments_each_command_was_broken() {
    let table = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/moments.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|row| row.split(',').collect()).collect();
    let names: Vec<&str> = rows.iter().map(|row| row[0]).collect();
    let jobs: Vec<&str> = truegap_attack::moments::jobs::all().iter().map(|job| job.name).collect();
    assert_eq!(names, jobs);
    for row in rows {
        let line = format!("| {} |", row.join(" | "));
        assert!(PAGE.contains(&line), "the page does not say {line}");
    }
}

#[test]
fn the_page_says_how_many_inputs_each_reader_was_given() {
    let table = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/fuzzed.csv")).unwrap();
    for reader in readers::all() {
        let row: Vec<&str> =
            table.lines().map(|line| line.split(',').collect()).find(|row: &Vec<_>| row[0] == reader.name).unwrap();
        let inputs: u64 = row[1].parse().unwrap();
        // the first runs counted only that every input held
        let counted: Vec<u64> =
            row[2..4].iter().filter(|cell| **cell != "not counted").map(|cell| cell.parse().unwrap()).collect();
        assert!(inputs > 0 && (counted.is_empty() || counted[0] > 0 && counted.iter().sum::<u64>() == inputs), "{}", reader.name);
        assert_eq!(row[4], readers::SEED.to_string(), "{}: drawn from another seed", reader.name);
        let line = format!("| {} |", row.join(" | "));
        assert!(PAGE.contains(&line), "the page does not say {line}");
    }
}
