//! The audit of a space of designs: every assumption for every design, in shards where one machine is not enough.
//!
//! Limits: designs of a Latin hypercube; a design whose gap closes is a case with a reason instead of rows; rows keep numbers, not figures.

use super::work::{merged, write};
use super::{Finished, SensorText, StudyError, Work, page};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use truegap_audit::{Assumption, EffectOn, Finding, Measure, Options, Study, Verdict, Watch, chosen};
use truegap_core::Sensor;
use truegap_design::optimise::{Axis, Space, latin_hypercube};
use truegap_sweep::Sweep;

/// Name of the study in a sweep's folder.
pub const STUDY: &str = concat!("truegap.audit-space/3 of ", env!("CARGO_PKG_VERSION"));

/// A file that describes a space.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpaceFile {
    /// `truegap.space/1`
    pub schema: String,
    /// sensor around which designs are made: built-in name or path
    pub sensor: String,
    /// number of designs
    pub designs: usize,
    /// seed of the Latin hypercube
    #[serde(default = "one")]
    pub seed: u64,
    /// assumptions; all where none is named
    #[serde(default)]
    pub only: Vec<String>,
    /// what a quantity may be, as text: `height = "150 um:210 um"`; the paper's space where none is given
    #[serde(default)]
    pub axes: BTreeMap<String, String>,
}

fn one() -> u64 {
    1
}

impl SpaceFile {
    /// Reads a space.
    ///
    /// # Errors
    /// [`StudyError::Request`] with what is wrong in it.
    pub fn from_toml(text: &str) -> Result<Self, StudyError> {
        let space: Self = toml::from_str(text).map_err(|e| StudyError::Request { reason: e.to_string() })?;
        let reason = match (space.schema.as_str(), space.designs) {
            ("truegap.space/1", 1..) => return Ok(space),
            ("truegap.space/1", _) => "designs = 0 leaves nothing to audit; give at least 1".to_owned(),
            (other, _) => format!("its schema is `{other}`; this program reads schema = \"truegap.space/1\""),
        };
        Err(StudyError::Request { reason })
    }
}

/// What is asked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SpaceAuditRequest {
    /// sensor around which designs are made
    pub sensor: SensorText,
    /// what may change
    pub axes: Vec<Axis>,
    /// number of designs
    pub designs: usize,
    /// seed of the Latin hypercube
    pub seed: u64,
    /// assumptions; all where none is named
    pub only: Vec<String>,
}

/// A case: one design.
#[derive(Clone, Debug, Serialize)]
struct Case {
    design: usize,
    values: Vec<f64>,
}

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
    schema: &'static str,
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

struct Checked {
    space: Space,
    assumptions: Vec<&'static dyn Assumption>,
    sweep: Sweep<Case>,
}

impl SpaceAuditRequest {
    /// Computes the work's share; writes the results where it is the whole and has a folder.
    ///
    /// # Errors
    /// [`StudyError`].
    pub fn run(&self, work: Work<'_>) -> Result<Finished<SpaceAuditAnswer>, StudyError> {
        let checked = self.checked()?;
        let (ran, answers) = work.answers(&checked.sweep, |case| checked.solve(case))?;
        let answer = answers.map(|answers| self.answer(answers));
        if let (Some(answer), Some(folder)) = (&answer, work.folder) {
            answer.write(folder)?;
        }
        Ok(Finished { ran, answer })
    }

    pub(super) fn merge(&self, folder: &Path, partial: bool) -> Result<SpaceAuditAnswer, StudyError> {
        let answers = merged(&self.checked()?.sweep, folder, partial)?;
        Ok(self.answer(answers))
    }

    fn checked(&self) -> Result<Checked, StudyError> {
        let space = Space::new(self.sensor.sensor()?, self.axes.clone())?;
        let assumptions = chosen(&self.only).map_err(|e| StudyError::Case { reason: e.to_string() })?;
        let cube = latin_hypercube(self.designs, self.axes.len(), self.seed);
        let cases = cube.iter().enumerate().map(|(design, unit)| Case { design, values: space.values(unit) }).collect();
        Ok(Checked { sweep: Sweep::new(STUDY, self, cases)?, space, assumptions })
    }

    fn answer(&self, answers: Vec<Option<Audited>>) -> SpaceAuditAnswer {
        let complete = answers.iter().all(Option::is_some);
        let designs: Vec<Audited> = answers.into_iter().flatten().collect();
        let refused = designs.iter().filter(|d| d.refused.is_some()).count();
        SpaceAuditAnswer {
            schema: "truegap.audit-space/1",
            sensor: self.sensor.name.clone(),
            complete,
            audited: designs.len() - refused,
            refused,
            shares: shares(&designs),
            axes: self.axes.iter().map(|a| a.quantity.symbol().to_owned()).collect(),
            designs,
            count: self.designs,
            seed: self.seed,
            only: self.only.clone(),
            space: self.axes.clone(),
        }
    }
}

impl Checked {
    /// All assumptions of one design, one after the other on this thread: cases run side by side already.
    fn solve(&self, case: &Case) -> Result<Audited, StudyError> {
        let mut sensor = self.space.sensor(&case.values);
        // a plating of 0 is none
        sensor.plating = sensor.plating.filter(|plating| plating.thickness.value > 0.0);
        let mut audited = Audited {
            design: case.design,
            values: case.values.clone(),
            refused: None,
            rows: Vec::new(),
            failed: BTreeMap::new(),
        };
        audited.refused = self.examine(&sensor, &mut audited.rows, &mut audited.failed).err();
        Ok(audited)
    }

    fn examine(&self, sensor: &Sensor, rows: &mut Vec<Row>, failed: &mut BTreeMap<String, String>) -> Result<(), String> {
        sensor.check("design").map_err(|e| e.to_string())?;
        let watch = Watch::default();
        let study = Study::new(sensor, Options::default(), &watch).map_err(|e| e.to_string())?;
        for assumption in self.assumptions.iter().filter(|a| a.applies(sensor).is_ok()) {
            match assumption.examine(&study) {
                Ok(finding) => rows.push(Row::of(finding)),
                Err(reason) => {
                    failed.insert(assumption.id().to_owned(), reason.to_string());
                }
            }
        }
        if rows.is_empty() { Err("no assumption could be examined".into()) } else { Ok(()) }
    }
}

impl Row {
    fn of(finding: Finding) -> Self {
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

fn shares(designs: &[Audited]) -> Vec<Share> {
    let mut ids: Vec<&str> = Vec::new();
    for row in designs.iter().flat_map(|d| &d.rows) {
        if !ids.contains(&row.id.as_str()) {
            ids.push(&row.id);
        }
    }
    ids.into_iter().map(|id| share(id, designs.iter().flat_map(|d| &d.rows).filter(|r| r.id == id).collect())).collect()
}

fn share(id: &str, rows: Vec<&Row>) -> Share {
    let part = |verdict| rows.iter().filter(|r| r.verdict == verdict).count() as f64 / rows.len() as f64;
    let mut errors: Vec<f64> = rows.iter().filter_map(|r| r.relative_error).collect();
    errors.sort_by(f64::total_cmp);
    Share {
        id: id.to_owned(),
        designs: rows.len(),
        holds: part(Verdict::Holds),
        strained: part(Verdict::Strained),
        broken: part(Verdict::Broken),
        median_relative_error: errors.get(errors.len() / 2).copied(),
    }
}

impl SpaceAuditAnswer {
    /// Writes audit-space.json, audit-space.csv and report.html.
    ///
    /// # Errors
    /// [`StudyError`] where the disk refuses.
    pub fn write(&self, folder: &Path) -> Result<(), StudyError> {
        let json = serde_json::to_string_pretty(self)? + "\n";
        let page = page::audit::html(self)?;
        write(folder, &[("audit-space.json".into(), json), ("audit-space.csv".into(), self.csv()), ("report.html".into(), page)])
    }

    /// One line a design and assumption.
    pub fn csv(&self) -> String {
        let mut text = format!("design,{},assumption,verdict,relative_error,measure", self.axes.join(","));
        EffectOn::NAMES.iter().for_each(|name| text += &format!(",{}_pct", name.to_lowercase()));
        text.push('\n');
        for (design, row) in self.designs.iter().flat_map(|d| d.rows.iter().map(move |r| (d, r))) {
            let values: Vec<String> = design.values.iter().map(f64::to_string).collect();
            let optional = |value: Option<f64>| value.map_or_else(String::new, |v| v.to_string());
            let effects: Vec<String> = EffectOn::NAMES.iter().map(|name| optional(row.effect_pct.get(*name).copied())).collect();
            let verdict = crate::audit_report::word(row.verdict);
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

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_design::{Quantity, optimise::Choice};

    #[test]
    fn a_design_without_plating_is_audited_and_one_with_plating_has_the_rows_of_its_warp() {
        let audited = |plating: f64| {
            let request = SpaceAuditRequest {
                sensor: SensorText::find("singletact-s15-4.5n").unwrap(),
                axes: vec![Axis { quantity: Quantity::Plating, choice: Choice::Levels(vec![plating]) }],
                designs: 1,
                seed: 1,
                only: vec!["INSULATOR-EXPANDS-FREELY".into(), "BIMETAL-STRIP".into()],
            };
            let checked = request.checked().unwrap();
            checked.solve(&checked.sweep.cases()[0]).unwrap()
        };
        let [bare, plated] = [0.0, 9e-6].map(audited);
        assert_eq!((bare.refused, plated.refused), (None, None));
        let ids = |rows: &[Row]| rows.iter().map(|r| r.id.clone()).collect::<Vec<_>>();
        assert_eq!(ids(&bare.rows), ["INSULATOR-EXPANDS-FREELY"]);
        assert_eq!(plated.rows.len(), 2);
        assert!(bare.failed.is_empty() && plated.failed.is_empty());
    }
}
