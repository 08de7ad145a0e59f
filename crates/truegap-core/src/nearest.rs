//! Names that a misspelt one may have meant.
//!
//! Limits: single letters added, lost, changed or swapped with a neighbour; no knowledge of meaning.

/// The names closest to `wanted`, best first, at most three, none that shares little with it.
pub fn nearest<'a>(wanted: &str, names: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let wanted = wanted.to_lowercase();
    let distance = |name: &str| {
        let lower = name.to_lowercase();
        if !wanted.is_empty() && lower.contains(&wanted) { 1 } else { edits(&wanted, &lower) }
    };
    let close = |name: &&str| distance(name) <= 1 + wanted.chars().count().max(name.chars().count()) / 2;
    let mut found: Vec<&str> = names.into_iter().filter(close).collect();
    found.sort_by_key(|name| distance(name));
    found.truncate(3);
    found
}

/// The name that a misspelt key most likely means: the closest of `names`, where it differs in no more than a third of its letters.
pub fn meant<'a>(wanted: &str, names: &[&'a str]) -> Option<&'a str> {
    let lower = wanted.to_lowercase();
    let begins = |name: &str| lower.len() > 2 && name.starts_with(&lower);
    let close = |name: &&str| begins(name) || edits(&lower, name) <= 1 + lower.chars().count().max(name.len()) / 3;
    let found = names.iter().copied().filter(close);
    found.min_by_key(|name| if begins(name) { 0 } else { edits(&lower, name) })
}

/// A key that means nothing, as the end of a message: what may have been meant, and what may stand there.
pub fn instead(wanted: &str, synonyms: &[(&str, &'static str)], known: &[&str]) -> String {
    let synonym = synonyms.iter().find(|(word, _)| wanted.eq_ignore_ascii_case(word)).map(|(_, key)| *key);
    let near = synonym.or_else(|| meant(wanted, known)).map_or_else(String::new, |near| format!("did you mean `{near}`? "));
    format!("{near}known there: {}", known.join(", "))
}

/// Fewest single-letter changes between two texts (Levenshtein, with swapped neighbours counted once).
fn edits(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![(0..=b.len()).collect::<Vec<usize>>()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let changed = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = changed.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            row.push(best);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_pen_finds_its_name() {
        let names = ["singletact-s15-4.5n", "singletact-s8-optimised", "other"];
        assert_eq!(nearest("singeltact-s15-4.5n", names), ["singletact-s15-4.5n", "singletact-s8-optimised"]);
        assert_eq!(nearest("s8", names), ["singletact-s8-optimised"]);
        assert!(nearest("completely-different-thing", ["abc"]).is_empty());
        assert_eq!((meant("std", &["value", "sd", "unit"]), meant("min", &["unit", "value"])), (Some("sd"), None));
        assert_eq!((meant("temp", &["time", "temperature"]), meant("Base", &["base"])), (Some("temperature"), Some("base")));
        assert_eq!(instead("min", &[("min", "low")], &["low", "high"]), "did you mean `low`? known there: low, high");
        assert_eq!((edits("abcd", "abdc"), edits("kitten", "sitting"), edits("", "ab")), (1, 3, 2));
    }
}
