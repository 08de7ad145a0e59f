//! The augmented model on a history that it has never seen, against what the generator says without noise.
//!
//! Limits: one fresh history per case; the reading before is that of the declared base model with the true sensor.

use super::answers::place;
use crate::models::ModelFile;
use std::path::Path;
use truegap_core::{Driver, Inputs};
use truegap_generator::Study;
use truegap_generator::commitment::Sums;
use truegap_generator::recording::{Column, Recording};
use truegap_generator::score::misfit::misfit_removed;

/// Share of the misfit that `case` of `study` loses on a fresh history by its diagnosis; the reason where there is no such share.
pub(super) fn misfit(folder: &Path, study: &Study, case: &str, commitments: &Sums) -> Result<f64, String> {
    let number = case.trim_start_matches("case-").parse::<usize>().ok().and_then(|n| n.checked_sub(1));
    let number = number.ok_or_else(|| format!("`{case}` is not the name of a case"))?;
    let drawn = study.case(number).map_err(|e| e.to_string())?;
    let text = drawn.answer.text().map_err(|e| e.to_string())?;
    if commitments.check(&format!("{case}.json"), text).is_err() {
        return Err("the generator of this version draws another case from the seed".into());
    }
    let fresh = drawn.fresh(0).map_err(|e| e.to_string())?;
    let model =
        ModelFile::open(&place(folder, case).join("augmented.toml")).and_then(|m| m.build()).map_err(|e| e.to_string())?;
    let after = model.respond(&inputs(&fresh.quiet)).map_err(|e| e.to_string())?;
    misfit_removed(&fresh.truth_pf, &fresh.base_pf, &after).ok_or_else(|| "nothing to remove".into())
}

fn driver(column: &Column) -> Driver {
    Driver { name: column.name.clone(), unit: column.unit.clone(), values: column.values.clone() }
}

fn inputs(recording: &Recording) -> Inputs {
    Inputs {
        run: recording.run.clone(),
        time_s: Some(recording.time_s.clone()),
        force_n: Some(recording.force_n.clone()),
        temperature_c: Some(recording.temperature_c.clone()),
        humidity_pct: recording.humidity_pct.clone(),
        drivers: recording.driver.iter().map(driver).collect(),
        ..Inputs::default()
    }
}
