//! Columns taken whole: compared, and their ends.
//!
//! Limits: a row that is not a number differs from itself, and is no end.

/// Whether two columns are the same, looked at in blocks: a comparison that may stop at each row takes rows one by one.
pub fn same_column(a: &[f64], b: &[f64]) -> bool {
    let differ = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(false, |any, (a, b)| any | (a != b));
    a.len() == b.len() && a.chunks(64).zip(b.chunks(64)).all(|(a, b)| !differ(a, b))
}

/// Least and greatest value; from infinity down to minus infinity where there is none.
pub fn ends(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    values.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// Median, the upper of two; 0 where there is no value.
pub fn median(values: &[f64]) -> f64 {
    let mut values = values.to_vec();
    let middle = values.len() / 2;
    if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

/// Median absolute value of a unit normal.
pub const MEDIAN_NORMAL: f64 = 0.674_489_750_196_081_7;

/// Standard deviation of independent normal numbers, from the absolute values of differences of neighbours whose weights have this sum of `squares` (6 of the second, 20 of the third): by their median, which neither a
/// smooth course nor few steps reach. In the unit of the numbers; 0 where there is no difference.
pub fn sd_of_differences(differences: &[f64], squares: f64) -> f64 {
    median(differences) / MEDIAN_NORMAL / squares.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_row_that_differs_is_seen_wherever_it_is() {
        let column = vec![0.5; 130];
        assert!(same_column(&column, &column) && !same_column(&column, &column[1..]) && !same_column(&[f64::NAN], &[f64::NAN]));
        for row in [0, 63, 64, 129] {
            let mut other = column.clone();
            other[row] = 0.25;
            assert!(!same_column(&column, &other));
        }
    }
}
