//! What the bank says: how often each cause was recovered, what was named instead, and how far stated probabilities can be trusted.
//!
//! Limits: counts are small; they are printed as counts.

use crate::{
    validation::recovery::{
        case::BankCase,
        power::{calibration_error, claims, power},
    },
    validation::tuning::{PAIRS_FROM, SINGLES_FROM},
};
use serde::Serialize;
use std::collections::BTreeMap;

/// A bank that was run.
#[derive(Clone, Debug, Serialize)]
pub struct Bank {
    /// hash of protocol, priors, noise and library
    pub key: String,
    /// recordings answered
    pub recordings: usize,
    /// rows on which they were searched
    pub rows: usize,
    /// seconds that it took now; stored recordings cost none
    pub seconds: f64,
    /// power that corrects the probabilities of models
    pub power: f64,
    /// expected calibration error as stated, and after the correction (on the same claims)
    pub calibration_error: [f64; 2],
    /// claims that these rest on
    pub claims: usize,
    /// recordings with nothing concealed, and those among them in which something was named
    pub false_alarms: [usize; 2],
    /// unmodelled causes, and those among them that got a library name
    #[serde(rename = "strangers_named")]
    pub unmodelled_named: [usize; 2],
    /// single causes at detectability 10 and above: number, exact, exact or within the set
    pub singles_above_ten: [usize; 3],
    /// pairs at detectability 16 and above: number, both named (or within their sets)
    pub pairs_above_sixteen: [usize; 2],
    /// per cause, what became of it
    pub recovered: Vec<Recovered>,
    /// the answers
    #[serde(skip)]
    pub cases: Vec<BankCase>,
}

/// What became of one cause concealed alone.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Recovered {
    /// id of the cause
    pub concealed: String,
    /// recordings
    pub recordings: usize,
    /// named exactly
    pub exact: usize,
    /// not exactly, but within the stated set
    pub within_set: usize,
    /// something there, nothing named
    pub unnamed: usize,
    /// not noticed
    pub missed: usize,
    /// other names, with how often
    pub named_instead: BTreeMap<String, usize>,
}

impl Bank {
    /// Counts.
    pub fn of(cases: Vec<BankCase>, key: String, rows: usize, seconds: f64) -> Self {
        let power = power(&cases);
        let stated = claims(&cases, 1.0);
        let count = |test: &dyn Fn(&BankCase) -> bool| cases.iter().filter(|c| test(c)).count();
        let nothing = |c: &BankCase| c.truth.effects.is_empty() && c.truth.unmodelled.is_none();
        let single = |c: &BankCase| c.truth.effects.len() == 1 && c.truth.detectability >= SINGLES_FROM;
        let pair = |c: &BankCase| c.truth.effects.len() == 2 && c.truth.detectability >= PAIRS_FROM;
        let unmodelled = |c: &BankCase| c.truth.unmodelled.is_some();
        Self {
            key,
            recordings: cases.len(),
            rows,
            seconds,
            power,
            calibration_error: [calibration_error(&stated), calibration_error(&claims(&cases, power))],
            claims: stated.len(),
            false_alarms: [count(&nothing), count(&|c| nothing(c) && !c.named.is_empty())],
            unmodelled_named: [count(&unmodelled), count(&|c| unmodelled(c) && !c.named.is_empty())],
            singles_above_ten: [
                count(&single),
                count(&|c| single(c) && c.right()),
                count(&|c| single(c) && (c.right() || c.within())),
            ],
            pairs_above_sixteen: [count(&pair), count(&|c| pair(c) && (c.right() || c.within()))],
            recovered: recovered(&cases),
            cases,
        }
    }

    /// The bank in two sentences.
    pub fn says_overall(&self) -> Vec<String> {
        let [nulls, alarms] = self.false_alarms;
        let [unmodelled, called] = self.unmodelled_named;
        let [singles, exact, within] = self.singles_above_ten;
        let [pairs, both] = self.pairs_above_sixteen;
        vec![
            format!(
                "{} recordings simulated on this protocol, with its noise and priors: {alarms} of {nulls} with nothing concealed got a name; \
                 of {singles} single causes at detectability 10 and above {exact} were named exactly and {within} within the stated set; \
                 {both} of {pairs} pairs at 16 and above; {called} of {unmodelled} unmodelled causes got a library name",
                self.recordings
            ),
            format!(
                "over {} claims the stated probabilities were off by {:.3} on average, {:.3} after raising them to the power {:.2}, as is done here",
                self.claims, self.calibration_error[0], self.calibration_error[1], self.power
            ),
        ]
    }

    /// Rows that matter to somebody who reads that `effect` was named: what became of it where it was concealed, and what else was called by its name.
    pub fn says(&self, effect: &str) -> Vec<String> {
        let mut lines = Vec::new();
        if let Some(row) = self.recovered.iter().find(|r| r.concealed == effect) {
            let mut line = format!(
                "{} simulated recordings of this protocol conceal {effect}: named in {}, within the stated set in {} more",
                row.recordings, row.exact, row.within_set
            );
            for (other, times) in &row.named_instead {
                line += &format!(", called {other} in {times}");
            }
            line += &format!(", noticed without a name in {}, missed in {}", row.unnamed, row.missed);
            lines.push(line);
        }
        let impostors = self.recovered.iter().filter(|r| r.named_instead.contains_key(effect));
        for row in impostors {
            let times = row.named_instead[effect];
            lines.push(format!("{} conceal {}: called {effect} in {times}", row.recordings, row.concealed));
        }
        lines
    }
}

fn recovered(cases: &[BankCase]) -> Vec<Recovered> {
    let mut rows: BTreeMap<String, Recovered> = BTreeMap::new();
    for case in cases.iter().filter(|c| c.truth.effects.len() == 1) {
        let concealed = case.truth.effects[0].clone();
        let row = rows.entry(concealed.clone()).or_insert_with(|| Recovered { concealed, ..Recovered::default() });
        row.recordings += 1;
        if case.right() {
            row.exact += 1;
        } else if case.within() {
            row.within_set += 1;
        } else if !case.named.is_empty() {
            *row.named_instead.entry(case.named.join(" + ")).or_default() += 1;
        } else if case.verdict == "agrees" {
            row.missed += 1;
        } else {
            row.unnamed += 1;
        }
    }
    rows.into_values().collect()
}
