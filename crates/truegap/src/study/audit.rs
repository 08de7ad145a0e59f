//! The audit of a space of designs: every assumption for every design, in shards where one machine is not enough.
//!
//! Limits: designs of a Latin hypercube; a design whose gap closes is a case with a reason instead of rows; rows keep numbers, not figures.

use super::answer::audit::{Audited, Row, Share, SpaceAuditAnswer};
use super::work::{check_memory, merged, write};
use super::{Finished, SensorText, StudyError, Work, page};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;
use truegap_audit::{Assumption, Options, Study, Verdict, Watch, chosen};
use truegap_core::Sensor;
use truegap_design::optimise::{Axis, Space, latin_hypercube};
use truegap_sweep::Sweep;

/// Name of the study in a sweep's folder.
pub const STUDY: &str = concat!("truegap.audit-space/3 of ", env!("CARGO_PKG_VERSION"));

/// Memory of an audited design, bytes: its values, its name, and a row for each assumption.
const MEMORY_OF_A_DESIGN: f64 = 8e3;

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
    /// Reads a space from its file.
    ///
    /// # Errors
    /// [`StudyError::Unread`], or as [`SpaceFile::from_toml`].
    pub fn open(file: &Path) -> Result<Self, StudyError> {
        let text = truegap_limits::read_text(file).map_err(|source| StudyError::Unread { path: file.to_owned(), source })?;
        Self::from_toml(&text)
    }

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
        check_memory("designs", self.designs as f64, "designs", MEMORY_OF_A_DESIGN)?;
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
