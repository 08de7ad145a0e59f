//! Which quantity of a design tells where in a space an assumption breaks.
//!
//! Limits: one quantity at a time, by the order of its values alone.

use super::answer::audit::SpaceAuditAnswer;
use truegap_audit::Verdict;
use truegap_design::optimise::Axis;

/// The quantity that tells best for one assumption.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Where {
    /// assumption
    pub id: String,
    /// the worst verdict that some designs have and others have not
    pub verdict: Verdict,
    /// quantity
    pub axis: Axis,
    /// its place among the axes
    pub place: usize,
    /// number of designs with the verdict
    pub designs: usize,
    /// share of pairs of designs that it puts in the right order, 0.5 to 1
    pub right: f64,
    /// median where the verdict is found, SI
    pub inside: f64,
    /// median elsewhere, SI
    pub outside: f64,
}

/// One entry an assumption whose verdict is not the same everywhere.
pub(super) fn wheres(answer: &SpaceAuditAnswer) -> Vec<Where> {
    answer.shares.iter().filter_map(|share| best(answer, &share.id)).collect()
}

/// Designs on either side below which an order means nothing.
const FEWEST: usize = 3;

fn best(answer: &SpaceAuditAnswer, id: &str) -> Option<Where> {
    let found: Vec<(Verdict, &[f64])> = answer
        .designs
        .iter()
        .flat_map(|d| d.rows.iter().filter(|r| r.id == id).map(|r| (r.verdict, d.values.as_slice())))
        .collect();
    let mixed = |verdict: &Verdict| {
        let count = found.iter().filter(|f| f.0 == *verdict).count();
        count >= FEWEST && count + FEWEST <= found.len()
    };
    let verdict = [Verdict::Broken, Verdict::Strained].into_iter().find(mixed)?;
    let told = |place: usize| {
        let side = |inside: bool| found.iter().filter(|f| (f.0 == verdict) == inside).map(|f| f.1[place]).collect::<Vec<f64>>();
        let (inside, outside) = (side(true), side(false));
        let (order, designs) = (in_order(&inside, &outside), inside.len());
        let right = order.max(1.0 - order);
        Where {
            id: id.to_owned(),
            verdict,
            axis: answer.space[place].clone(),
            place,
            designs,
            right,
            inside: median(inside),
            outside: median(outside),
        }
    };
    (0..answer.space.len()).map(told).max_by(|a, b| a.right.total_cmp(&b.right))
}

/// Share of pairs whose first is the greater one; equal ones count half.
fn in_order(first: &[f64], second: &[f64]) -> f64 {
    let pair = |a: f64, b: f64| match a.total_cmp(&b) {
        std::cmp::Ordering::Greater => 1.0,
        std::cmp::Ordering::Equal => 0.5,
        std::cmp::Ordering::Less => 0.0,
    };
    let sum: f64 = first.iter().flat_map(|&a| second.iter().map(move |&b| pair(a, b))).sum();
    sum / (first.len() * second.len()) as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    if values.len() % 2 == 1 { values[middle] } else { 0.5 * (values[middle - 1] + values[middle]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_in_order_are_counted_and_equal_ones_count_half() {
        assert_eq!(in_order(&[3.0, 4.0], &[1.0, 2.0]), 1.0);
        assert_eq!(in_order(&[1.0, 4.0], &[2.0, 3.0]), 0.5);
        assert_eq!(in_order(&[1.0], &[1.0, 0.0]), 0.75);
        assert_eq!((median(vec![3.0, 1.0, 2.0]), median(vec![4.0, 1.0])), (2.0, 2.5));
    }
}
