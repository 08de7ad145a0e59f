//! Joining what shards have computed.
//!
//! Limits: the folder says which study it is; the cases are listed anew from its request.

use super::answer::optimise::OptimiseAnswer;
use super::answer::tolerance::ToleranceAnswer;
use super::optimise::OptimiseRequest;
use super::tolerance::ToleranceRequest;
use super::{StudyError, optimise, tolerance};
#[cfg(feature = "fem")]
use super::{
    answer::audit::SpaceAuditAnswer,
    audit::{self, SpaceAuditRequest},
};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::path::Path;
use truegap_sweep::describe;

/// A study that was computed in shards.
#[derive(Clone, Debug)]
pub enum Study {
    /// `truegap tolerance`
    Tolerance(Box<ToleranceAnswer>),
    /// `truegap optimise`
    Optimise(Box<OptimiseAnswer>),
    /// `truegap audit --space`
    #[cfg(feature = "fem")]
    Audit(Box<SpaceAuditAnswer>),
}

#[cfg(feature = "fem")]
const KNOWN: [&str; 3] = [tolerance::STUDY, optimise::STUDY, audit::STUDY];
#[cfg(not(feature = "fem"))]
const KNOWN: [&str; 2] = [tolerance::STUDY, optimise::STUDY];

/// Joins the cases in `folder`, writes the results beside them and returns the answer; `partial` takes what is there.
///
/// # Errors
/// [`SweepError::Missing`](truegap_sweep::SweepError::Missing) names what is missing; otherwise as [`StudyError`] says.
pub fn merge(folder: &Path, partial: bool) -> Result<Study, StudyError> {
    let there = describe(folder)?;
    if there.study == tolerance::STUDY {
        let request: ToleranceRequest = request(there.context)?;
        let answer = request.merge(folder, partial)?;
        answer.write(folder)?;
        return Ok(Study::Tolerance(Box::new(answer)));
    }
    if there.study == optimise::STUDY {
        let request: OptimiseRequest = request(there.context)?;
        let answer = request.merge(folder, partial)?;
        answer.write(folder)?;
        return Ok(Study::Optimise(Box::new(answer)));
    }
    #[cfg(feature = "fem")]
    if there.study == audit::STUDY {
        let request: SpaceAuditRequest = request(there.context)?;
        let answer = request.merge(folder, partial)?;
        answer.write(folder)?;
        return Ok(Study::Audit(Box::new(answer)));
    }
    let known = KNOWN.map(|study| format!("`{study}`")).join(" and ");
    Err(StudyError::UnknownStudy { study: there.study, known })
}

fn request<R: DeserializeOwned>(context: Value) -> Result<R, StudyError> {
    serde_json::from_value(context).map_err(|source| StudyError::Request { reason: source.to_string() })
}
