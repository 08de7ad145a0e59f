//! Do stated deviations cover? Shares of intervals that hold what was drawn.
//!
//! Limits: numbers of one recording are not independent, so that the intervals of the shares are too narrow.

use super::Scored;
use super::judge::Outcome;
use super::targets::{Row, Target, counted};

/// Half width of the 95 % interval of a Gaussian, in standard deviations.
const TWO_SIDED_95: f64 = 1.96;
/// Share that 95 % intervals should cover at least.
const WANTED: f64 = 0.9;

/// Share of intervals that hold what was drawn, of right answers and of others apart; none where no number was drawn.
pub fn rows(cases: &[Scored]) -> Vec<Row> {
    let right = |case: &&Scored| matches!(case.outcome, Outcome::Right | Outcome::WithinSet);
    let (right, other): (Vec<&Scored>, Vec<&Scored>) = cases.iter().partition(|case| right(case));
    let mut rows = Vec::new();
    for (answers, cases) in [("right answers", right), ("other answers", other)] {
        for (kind, of_effect) in [("sensor", false), ("effects", true)] {
            let off: Vec<f64> =
                cases.iter().flat_map(|case| &case.numbers).filter(|n| n.of_effect == of_effect).map(|n| n.off).collect();
            if off.is_empty() {
                continue;
            }
            for (level, width, target) in [("68", 1.0, Target::None), ("95", TWO_SIDED_95, Target::AtLeast(WANTED))] {
                let hits = off.iter().filter(|off| off.abs() < width).count();
                rows.push(counted(&format!("numbers of {kind} within {level} %, {answers}"), target, hits, off.len()));
            }
        }
    }
    rows
}
