//! The drift of the baseline with every way of treating the warp, from none to bonded beads.
//!
//! Limits: shapes only; the rest of the chain is the paper's.

use super::buckled::{buckled, critical_curvature, gain};
use super::{
    bead_spring::BeadSpring,
    body::{Disc, Loading, Strains},
    fineness::Fineness,
    laminate::Laminate,
    profile::Profile,
    shaped::shaped,
};
use crate::{error::AuditError, study::Study, swap::Swap};
use truegap_model::Coefficients;
use truegap_model::equations::electrodes::series;

/// The value that the data sheet gives, %FSR/K. **Source:** \[hampson2023\], abstract: nominal temperature sensitivity of the S15-4.5N.
pub const DATA_SHEET_PCT_FSR_PER_K: f64 = 0.2;

/// One way of treating the warp.
#[derive(Clone, Debug, PartialEq)]
pub struct Baseline {
    /// how
    pub says: &'static str,
    /// rim above centre at the hot end, um; along two diameters where they differ
    pub sag_um: [f64; 2],
    /// coefficients with it
    pub coefficients: Coefficients,
}

/// Every way, for a sensor with a warping electrode.
///
/// # Errors
/// What finite elements or the chain refuse.
pub fn baselines(study: &Study<'_>) -> Result<Vec<Baseline>, AuditError> {
    let (bare, backed) = (Laminate::electrode(study.sensor), Laminate::backed(study.sensor));
    let kelvin = study.hot_kelvin();
    let flat = Profile::from_fn(1, |_| 0.0);
    let warm = study.device.at(study.options.hot_c);
    let beads = BeadSpring::of_paper(study.sensor, &study.device, &warm, 0.0)?;
    let stiffer = BeadSpring { young: 2.0 * beads.young, ..beads };
    let paper = Profile::sphere(study.chain(Swap::none()).row(0.0, study.options.hot_c)?.parts.curvature, warm.radius);
    let free = |plate: &Laminate, strains| shape(Disc::free(plate.clone(), strains, Fineness::FINE)?, kelvin);
    let held = |plate: &Laminate, beads| shape(Disc::on_layer(plate.clone(), beads, Strains::Large, Fineness::FINE)?, kelvin);
    let mut rows = Vec::new();
    let mut row = |says, shape: Profile| -> Result<(), AuditError> {
        study.keep_going()?;
        let sag = 1e6 * shape.sag();
        rows.push(Baseline { says, sag_um: [sag; 2], coefficients: study.coefficients(shaped(&shape, kelvin))? });
        Ok(())
    };
    row("parallel plates, no warp", flat)?;
    row("sphere of (9), the paper's model", paper)?;
    row("free disc, small deflection", free(&bare, Strains::Small)?)?;
    row("free disc, large deflection, kept a bowl", free(&bare, Strains::Large)?)?;
    row("free disc with the insulator bonded behind it, small deflection", free(&backed, Strains::Small)?)?;
    row("free disc with the insulator bonded behind it, large deflection", free(&backed, Strains::Large)?)?;
    row("bonded to the beads (the model's stiffness)", held(&bare, beads)?)?;
    row("bonded to the beads, insulator bonded behind it", held(&backed, beads)?)?;
    row("bonded to beads twice as stiff, insulator bonded behind it", held(&backed, stiffer)?)?;
    rows.extend(cylinder(study, &bare)?);
    Ok(rows)
}

fn shape(disc: Disc, kelvin: f64) -> Result<Profile, AuditError> {
    disc.profile(&disc.solve(kelvin, &Loading::None, &[])?)
}

/// The free disc beyond its instability, where the range reaches that.
fn cylinder(study: &Study<'_>, plate: &Laminate) -> Result<Option<Baseline>, AuditError> {
    let per_kelvin = plate.curvature_per_kelvin();
    let hot = buckled(plate, per_kelvin * study.hot_kelvin());
    if hot.first == hot.second || hot.first.abs() <= critical_curvature(plate) {
        return Ok(None);
    }
    let coefficients = study.coefficients(cylindrical(plate, per_kelvin))?;
    let sag = |curvature: f64| 0.5e6 * curvature * plate.radius * plate.radius;
    Ok(Some(Baseline {
        says: "free disc, buckled into a cylinder (energy)",
        sag_um: [sag(hot.first), sag(hot.second)],
        coefficients,
    }))
}

/// The chain with the disc of least energy, bowl or cylinder; `per_kelvin` is its free curvature, 1/(m K).
pub(crate) fn cylindrical<'a>(plate: &Laminate, per_kelvin: f64) -> Swap<'a> {
    let (plate, flat) = (plate.clone(), Profile::from_fn(1, |_| 0.0));
    Swap::none().shape(move |_, _| Ok(flat.clone())).parts(move |warm, row, parts| {
        let gap = warm.layers.beads * (1.0 - row.strain);
        let shape = buckled(&plate, per_kelvin * warm.kelvin);
        let closed = AuditError::NoResponse { force_n: row.force_n, temperature_c: warm.kelvin, strain: row.strain };
        parts.beads *= gain(shape, plate.radius, gap).ok_or(closed)?;
        parts.shares.main = series([parts.beads, parts.insulator]);
        Ok(())
    })
}
