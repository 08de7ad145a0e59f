//! Runs an audit and writes the folder of its files.
//!
//! Limits: the physics is in `truegap-audit`; here are names, files and the place of the cache.

use crate::cache_folder::cache_folder;
use crate::output::{OutputError, OutputFolder};
use crate::verify::audited::{Audited, Body};
use crate::verify::{audit_report, export};
use std::path::{Path, PathBuf};
use truegap_audit::disc::CoupledOptions;
use truegap_audit::{AuditError, Cache, Options, Watch, chosen, run};
use truegap_core::Sensor;

/// Names of the files that an audit writes.
pub const FILES: [&str; 4] = ["audit.json", "report.html", "stack.glb", "stack.vtu"];

/// Why there is no audit.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AuditRunError {
    /// The audit failed.
    #[error(transparent)]
    Audit(#[from] AuditError),
    /// It cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// It cannot be put into words.
    #[error("the audit cannot be written as JSON: {0}; please report this")]
    Json(#[from] serde_json::Error),
}

/// What to audit.
#[derive(Clone, Debug)]
pub struct AuditRequest {
    /// the sensor
    pub sensor: Sensor,
    /// assumptions by name; all where empty
    pub only: Vec<String>,
    /// range and accuracy
    pub options: Options,
    /// where findings are remembered
    pub cache: Cache,
    /// the command, for the report
    pub command: String,
}

/// The stack of a sensor, heated and under full load.
///
/// # Errors
/// [`ExportError`](export::ExportError) where the sensor has no beads or its disc no equilibrium.
pub fn loaded_stack(sensor: &Sensor, options: Options, command: &str) -> Result<Body, export::ExportError> {
    let (force_n, temperature_c) = (sensor.full_scale, options.hot_c);
    let solved = export::solve(export::Request {
        sensor,
        force_n,
        temperature_c,
        colour: export::Colour::default(),
        wedge: true,
        beads: export::BeadModel::default(),
        options: CoupledOptions::default(),
        command: command.to_owned(),
    })?;
    let says = format!(
        "{} at {force_n} N and {temperature_c} degC by coupled finite elements, with bonded beads as rings of equal area share; a quarter is cut out.",
        sensor.name
    );
    Ok(Body { name: "stack".into(), says, glb: solved.scene().to_glb()?, vtu: solved.vtu()? })
}

/// Runs an audit.
///
/// # Errors
/// [`AuditRunError`] where an assumption cannot be examined.
pub fn audit(request: AuditRequest, watch: &Watch<'_>) -> Result<Audited, AuditRunError> {
    let AuditRequest { sensor, only, options, cache, command } = request;
    let audit = run(&sensor, &chosen(&only)?, options, &cache, watch)?;
    Ok(Audited { audit, options, full_n: sensor.full_scale, command })
}

impl Audited {
    /// Writes audit.json, report.html and the bodies, all or none.
    ///
    /// # Errors
    /// [`AuditRunError`] where the disk refuses.
    pub fn write(&self, folder: &Path, bodies: &[Body]) -> Result<PathBuf, AuditRunError> {
        let out = OutputFolder::begin(folder)?.replacing(&FILES);
        out.write("audit.json", serde_json::to_string_pretty(&self.audit)? + "\n")?;
        out.write("report.html", audit_report::html(self, bodies))?;
        for body in bodies {
            out.write(format!("{}.glb", body.name), &body.glb)?;
            out.write(format!("{}.vtu", body.name), &body.vtu)?;
        }
        Ok(out.publish()?)
    }
}

/// Where findings are remembered unless told otherwise: `audit` in the folder of everything that may be computed again; none where the system names no such folder.
pub fn default_cache() -> Cache {
    cache_folder("audit").map_or_else(Cache::none, |folder| Cache::in_folder(&folder))
}
