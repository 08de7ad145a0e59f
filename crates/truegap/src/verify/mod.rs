//! Whether the model's assumptions hold: audits, finite-element cases and the deformed stack, as files and pages.
//!
//! ```no_run
//! use truegap::{audit::Watch, verify::{AuditRequest, audit, default_cache}};
//!
//! let sensor = truegap::predict::find_sensor("singletact-s15-4.5n", None)?;
//! let request = AuditRequest { sensor, only: vec![], options: Default::default(), cache: default_cache(), command: "by hand".into() };
//! let audited = audit(request, &Watch::default())?; // minutes where nothing is in the cache
//! audited.write("out".as_ref(), &[])?; // audit.json, report.html
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod audit_report;
mod audit_run;
mod audited;
pub mod case_file;
pub mod export;

pub(crate) use audit_report::{MOVED, short_percent};
pub use audit_report::{count, summary_lines, word};
pub use audit_run::{AuditRequest, AuditRunError, FILES, audit, default_cache, loaded_stack};
pub use audited::{Audited, Body};
