//! Every assumption for every design, as a study answers it.
//!
//! Limits: numbers, no figures.

use crate::verify::word;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::Write;
use truegap_audit::{EffectOn, Finding, Measure, Verdict};
use truegap_design::optimise::Axis;

/// One assumption for one design.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// assumption
    pub id: String,
    /// verdict
    pub verdict: Verdict,
    /// analytic over finite elements, less 1; absent where it is not finite
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub relative_error: Option<f64>,
    /// the number that decides
    pub measure: f64,
    /// what it is
    pub measure_name: String,
    /// the measure up to which the equation is known to be good
    pub limit: f64,
    /// effect on each coefficient that is not zero, %
    pub effect_pct: BTreeMap<String, f64>,
}

/// What became of one design.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Audited {
    /// number of the design
    pub design: usize,
    /// its values, SI, in the order of the axes
    pub values: Vec<f64>,
    /// why there are no rows
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub refused: Option<String>,
    /// rows
    pub rows: Vec<Row>,
    /// assumptions that could not be examined, and why
    #[serde(skip_serializing_if = "BTreeMap::is_empty", default)]
    pub failed: BTreeMap<String, String>,
}

/// How often an assumption holds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Share {
    /// assumption
    pub id: String,
    /// designs examined
    pub designs: usize,
    /// share of designs for which it holds
    pub holds: f64,
    /// share for which it is strained
    pub strained: f64,
    /// share for which it is broken
    pub broken: f64,
    /// median of the relative error
    #[serde(skip_serializing_if = "Option::is_none")]
    pub median_relative_error: Option<f64>,
}

/// What is answered.
#[derive(Clone, Debug, Serialize)]
pub struct SpaceAuditAnswer {
    pub(in crate::study) schema: &'static str,
    /// sensor around which designs were made
    pub sensor: String,
    /// whether all cases are in it
    pub complete: bool,
    /// designs with rows
    pub audited: usize,
    /// designs without an answer of the analytic model
    pub refused: usize,
    /// one entry an assumption
    pub shares: Vec<Share>,
    /// one entry a design
    pub designs: Vec<Audited>,
    /// names of the axes
    pub axes: Vec<String>,
    /// number of designs asked for
    #[serde(skip)]
    pub count: usize,
    /// seed of the Latin hypercube
    #[serde(skip)]
    pub seed: u64,
    /// assumptions asked for; all where none is named
    #[serde(skip)]
    pub only: Vec<String>,
    /// what may change
    #[serde(skip)]
    pub space: Vec<Axis>,
}

impl Row {
    pub(in crate::study) fn of(finding: Finding) -> Self {
        let Measure { name: measure_name, value: measure, limit } = finding.measure;
        let named = EffectOn::NAMES.into_iter().zip(finding.effect_on.values());
        Self {
            id: finding.id,
            verdict: finding.verdict,
            relative_error: Some(finding.relative_error).filter(|e| e.is_finite()),
            measure,
            measure_name,
            limit,
            effect_pct: named.filter_map(|(name, pct)| Some((name.to_owned(), pct?))).collect(),
        }
    }
}

impl SpaceAuditAnswer {
    /// One line a design and assumption.
    pub fn csv(&self) -> String {
        let mut text = format!("design,{},assumption,verdict,relative_error,measure", self.axes.join(","));
        EffectOn::NAMES.iter().for_each(|name| text += &format!(",{}_pct", name.to_lowercase()));
        text.push('\n');
        for (design, row) in self.designs.iter().flat_map(|d| d.rows.iter().map(move |r| (d, r))) {
            let values: Vec<String> = design.values.iter().map(f64::to_string).collect();
            let optional = |value: Option<f64>| value.map_or_else(String::new, |v| v.to_string());
            let effects: Vec<String> = EffectOn::NAMES.iter().map(|name| optional(row.effect_pct.get(*name).copied())).collect();
            let verdict = word(row.verdict);
            let error = optional(row.relative_error);
            // writing to a String does not fail
            let _ = writeln!(
                text,
                "{},{},{},{verdict},{error},{},{}",
                design.design,
                values.join(","),
                row.id,
                row.measure,
                effects.join(",")
            );
        }
        text
    }
}
