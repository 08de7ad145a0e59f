//! Which of several designs no other beats.
//!
//! Limits: one to three objectives, all minimised; of equal designs the first counts.

/// Places of the designs that no other beats, sorted by the first objective; n log n for n designs.
///
/// Sorted by the first objective, a design is beaten when one before it is no worse in the two others: a staircase of those is kept.
///
/// **Source:** Kung, Luccio, Preparata (1975).
pub(super) fn nondominated<const M: usize>(points: &[[f64; M]]) -> Vec<usize> {
    const { assert!(M >= 1 && M <= 3, "one to three objectives") };
    let third = |i: usize| -> [f64; 3] { std::array::from_fn(|m| if m < M { points[i][m] } else { 0.0 }) };
    let order = |a: &[f64; 3], b: &[f64; 3]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]));
    let mut sorted: Vec<usize> = (0..points.len()).collect();
    sorted.sort_by(|&a, &b| order(&third(a), &third(b)).then(a.cmp(&b)));
    // second objective rising, third falling
    let mut stairs: Vec<[f64; 2]> = Vec::new();
    let mut kept = Vec::new();
    for i in sorted {
        let [_, y, z] = third(i);
        let after = stairs.partition_point(|s| s[0] <= y);
        if after > 0 && stairs[after - 1][1] <= z {
            continue;
        }
        let begin = stairs.partition_point(|s| s[0] < y);
        let end = begin + stairs[begin..].partition_point(|s| s[1] >= z);
        stairs.splice(begin..end, [[y, z]]);
        kept.push(i);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::uniform;

    fn beats<const M: usize>(a: &[f64; M], b: &[f64; M]) -> bool {
        a.iter().zip(b).all(|(a, b)| a <= b) && a != b
    }

    fn against_all_pairs<const M: usize>(levels: f64) {
        let at = |i: usize| -> [f64; M] { std::array::from_fn(|m| (uniform(3, i, m) * levels).floor()) };
        let points: Vec<[f64; M]> = (0..400).map(at).collect();
        let mut found = nondominated(&points);
        let first = |i: usize| !points[..i].contains(&points[i]);
        let known: Vec<usize> = (0..400).filter(|&i| first(i) && !points.iter().any(|p| beats(p, &points[i]))).collect();
        assert!(found.windows(2).all(|p| points[p[0]][0] <= points[p[1]][0]), "sorted");
        found.sort_unstable();
        assert_eq!(found, known);
    }

    #[test]
    fn the_staircase_keeps_what_comparing_all_pairs_keeps() {
        // few levels make many ties
        for levels in [4.0, 30.0, 1e9] {
            against_all_pairs::<1>(levels);
            against_all_pairs::<2>(levels);
            against_all_pairs::<3>(levels);
        }
    }
}
