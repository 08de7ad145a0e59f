//! What an assumption of the register must say and do.
//!
//! Limits: one finding an assumption and sensor.

use crate::{error::AuditError, finding::Finding, study::Study};
use truegap_core::Sensor;

/// Something that the analytic model takes to be true.
pub trait Assumption: Send + Sync {
    /// Stable name, as in files: `NO-FRINGING`.
    fn id(&self) -> &'static str;

    /// The assumption as one sentence that is true or false.
    fn says(&self) -> &'static str;

    /// Where the model makes it, and what it is measured against.
    fn source(&self) -> &'static str;

    /// Whether the sensor has what the assumption is about; otherwise the reason why not.
    ///
    /// # Errors
    /// The reason, as a sentence for the report.
    fn applies(&self, _sensor: &Sensor) -> Result<(), String> {
        Ok(())
    }

    /// Measures the assumption for the sensor of a study.
    ///
    /// # Errors
    /// [`AuditError`] where a solver fails, the sensor has no answer in the range of the study, or the caller cancelled.
    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError>;
}
