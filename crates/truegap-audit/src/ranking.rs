//! Assumptions in the order of what they do to each coefficient.
//!
//! Limits: effects one at a time; they do not add up where two assumptions touch the same piece.

use crate::{effect::EffectOn, finding::Finding};
use serde::{Deserialize, Serialize};

/// An assumption's effect on one coefficient.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ranked {
    /// assumption
    pub id: String,
    /// change of the coefficient, %
    pub pct: f64,
}

/// Assumptions by their effect on one coefficient, largest first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ranking {
    /// coefficient, as in [`EffectOn::NAMES`]
    pub coefficient: String,
    /// effects
    pub order: Vec<Ranked>,
}

/// One ranking a coefficient; ties keep the order of the register.
pub(crate) fn ranking(findings: &[Finding]) -> Vec<Ranking> {
    let rank = |(k, name): (usize, &&str)| {
        let effect = |f: &Finding| Some(Ranked { id: f.id.clone(), pct: f.effect_on.values()[k]? });
        let mut order: Vec<Ranked> = findings.iter().filter_map(effect).collect();
        order.sort_by(|a, b| b.pct.abs().total_cmp(&a.pct.abs()));
        Ranking { coefficient: (*name).to_owned(), order }
    };
    EffectOn::NAMES.iter().enumerate().map(rank).collect()
}
