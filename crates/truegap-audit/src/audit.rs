//! All assumptions of the register for one sensor.
//!
//! Limits: assumptions run side by side on plain threads, one a core; each may use rayon inside.

use crate::{
    assumption::Assumption,
    cache::{Cache, Key},
    error::AuditError,
    finding::Finding,
    ranking::{Ranking, ranking},
    study::{Options, Progress, Study, Watch},
};
use serde::{Deserialize, Serialize};
use std::{
    collections::BTreeMap,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
};
use truegap_core::Sensor;
use truegap_model::Coefficients;

/// An assumption that the sensor has nothing to do with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotApplicable {
    /// assumption
    pub id: String,
    /// why not
    pub says: String,
}

/// The audit of one sensor.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Audit {
    /// `truegap.audit/1`
    pub schema: String,
    /// name of the sensor
    pub sensor: String,
    /// what the analytic model says between the two temperatures
    pub coefficients: Coefficients,
    /// one row an assumption, in the order of the register
    pub assumptions: Vec<Finding>,
    /// what the sensor has nothing to do with
    pub not_applicable: Vec<NotApplicable>,
    /// assumptions by effect, one list a coefficient
    pub ranking: Vec<Ranking>,
}

/// Examines `assumptions` (usually [`crate::register()`]) for a sensor.
///
/// Findings come from the cache where it has them; what is computed is stored at once, so that a stopped audit continues where it was.
///
/// # Errors
/// The first [`AuditError`] in the order of the register.
pub fn run(
    sensor: &Sensor,
    assumptions: &[&'static dyn Assumption],
    options: Options,
    cache: &Cache,
    watch: &Watch<'_>,
) -> Result<Audit, AuditError> {
    let study = Study::new(sensor, options, watch)?;
    let (asked, not_applicable) = sort_out(sensor, assumptions);
    let work = Work {
        study: &study,
        asked: &asked,
        cache,
        watch,
        next: AtomicUsize::new(0),
        done: AtomicUsize::new(0),
        found: Mutex::default(),
    };
    let workers = std::thread::available_parallelism().map_or(1, usize::from).min(asked.len()).max(1);
    std::thread::scope(|scope| (0..workers).for_each(|_| drop(scope.spawn(|| work.drain()))));
    let found = work.found.into_inner().unwrap_or_else(PoisonError::into_inner);
    if found.len() < asked.len() && found.values().all(Result::is_ok) {
        return Err(AuditError::Cancelled);
    }
    let findings = found.into_values().collect::<Result<Vec<_>, _>>()?;
    Ok(Audit {
        schema: "truegap.audit/1".into(),
        sensor: sensor.name.clone(),
        coefficients: *study.base(),
        ranking: ranking(&findings),
        assumptions: findings,
        not_applicable,
    })
}

type Asked = Vec<&'static dyn Assumption>;

fn sort_out(sensor: &Sensor, assumptions: &[&'static dyn Assumption]) -> (Asked, Vec<NotApplicable>) {
    let mut asked = Vec::new();
    let mut not = Vec::new();
    for &assumption in assumptions {
        match assumption.applies(sensor) {
            Ok(()) => asked.push(assumption),
            Err(says) => not.push(NotApplicable { id: assumption.id().into(), says }),
        }
    }
    (asked, not)
}

struct Work<'a> {
    study: &'a Study<'a>,
    asked: &'a [&'static dyn Assumption],
    cache: &'a Cache,
    watch: &'a Watch<'a>,
    next: AtomicUsize,
    done: AtomicUsize,
    found: Mutex<BTreeMap<usize, Result<Finding, AuditError>>>,
}

impl Work<'_> {
    /// Takes assumptions until none is left, one failed or the caller stops.
    fn drain(&self) {
        while !self.watch.stopped() {
            let at = self.next.fetch_add(1, Ordering::Relaxed);
            let Some(&assumption) = self.asked.get(at) else { return };
            self.tell(assumption, "examining");
            let finding = self.finding(assumption);
            let failed = finding.is_err();
            self.found.lock().unwrap_or_else(PoisonError::into_inner).insert(at, finding);
            self.done.fetch_add(1, Ordering::Relaxed);
            self.tell(assumption, if failed { "failed" } else { "done" });
            if failed {
                self.next.store(self.asked.len(), Ordering::Relaxed);
            }
        }
    }

    fn finding(&self, assumption: &'static dyn Assumption) -> Result<Finding, AuditError> {
        let key = Key::of(self.study.sensor, self.study.options, assumption.id());
        if let Some(known) = self.cache.finding(&key)? {
            return Ok(known);
        }
        let finding = assumption.examine(self.study)?;
        self.cache.store(&key, &finding)?;
        Ok(finding)
    }

    fn tell(&self, assumption: &'static dyn Assumption, says: &str) {
        let done = self.done.load(Ordering::Relaxed);
        self.watch.tell(&Progress { id: assumption.id(), says: says.into(), done, total: self.asked.len() });
    }
}
