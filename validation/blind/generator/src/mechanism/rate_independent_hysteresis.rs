//! `rate_independent_hysteresis`: compression follows the load with friction, as a set of plays of different slack.
//!
//! Limits: rate-independent; the set is at rest when a run starts. The size is the share of the compression that goes through the plays.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::memory::play;
use crate::state::{Scene, State};

/// Prandtl-Ishlinskii: eight plays of evenly spaced slack, weights falling linearly.
///
/// **Source:** Brokate and Sprekels, Hysteresis and Phase Transitions, 2.4.
#[derive(Debug, Clone)]
pub struct Hysteresis {
    slack: f64,
}

const PLAYS: usize = 8;

/// Draws the largest slack, as a compression.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(Hysteresis { slack: draws.between(0.03, 0.09) })
}

/// Slack (share of the largest) and weight of each play; the weights sum to 1.
fn plays() -> impl Iterator<Item = (f64, f64)> {
    let total = (PLAYS * (PLAYS + 1)) as f64 / 2.0;
    (1..=PLAYS).map(move |j| (j as f64 / PLAYS as f64, (PLAYS + 1 - j) as f64 / total))
}

impl Mechanism for Hysteresis {
    fn id(&self) -> &'static str {
        "rate_independent_hysteresis"
    }
    fn size_start(&self) -> f64 {
        0.002
    }
    fn size_limit(&self) -> f64 {
        0.5
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share", size), ("largest_slack", self.slack)])
    }
    fn strain(&self, size: f64, scene: Scene, state: &mut State) {
        for run in scene.history.runs() {
            let mut memory = [0.0; PLAYS];
            for row in run {
                let elastic = state.compression[row];
                let mut late = 0.0;
                for (q, (slack, weight)) in memory.iter_mut().zip(plays()) {
                    *q = play(*q, elastic, slack * self.slack);
                    late += weight * *q;
                }
                state.compression[row] += size * (late - elastic);
            }
        }
    }
}
