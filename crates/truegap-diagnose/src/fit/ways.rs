//! The ways of searches from several starts: one that comes upon the way of another would only go to the same end.
//!
//! Two starts of one shape differ in a size, which the first step finds; without this each is followed to the end, and a fifth of the work of fits is done twice.
//!
//! Limits: searches of one model under one noise with the same settings.

use crate::fit::tuning::SAME_PLACE;

/// The points that searches went through, each before its steps.
#[derive(Default)]
pub(crate) struct Ways(Vec<Vec<Vec<f64>>>);

impl Ways {
    /// Keeps one more way.
    pub fn keep(&mut self, way: Vec<Vec<f64>>) {
        self.0.push(way);
    }

    /// Whether one of them leads through `z`, after fewer than `steps` steps.
    pub fn lead_through(&self, z: &[f64], steps: usize) -> bool {
        let near = |there: &Vec<f64>| there.iter().zip(z).all(|(a, b)| (a - b).abs() < SAME_PLACE);
        self.0.iter().any(|way| way.iter().take(steps).any(near))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_leads_through_its_points_but_no_sooner_than_it_came_there() {
        let mut ways = Ways::default();
        assert!(!ways.lead_through(&[0.0, 0.0], 1));
        ways.keep(vec![vec![0.0, 0.0], vec![1.0, -2.0]]);
        let aside = 0.5 * SAME_PLACE;
        assert!(ways.lead_through(&[aside, -aside], 1));
        assert!(!ways.lead_through(&[2.0 * SAME_PLACE, 0.0], 1));
        // a search that is there at once has more steps left than the one that came there by a step
        assert!(!ways.lead_through(&[1.0, -2.0], 1));
        assert!(ways.lead_through(&[1.0, -2.0 + aside], 2));
    }
}
