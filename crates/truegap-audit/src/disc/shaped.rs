//! The analytic chain with another shape of the electrode in place of the sphere of (9) and (18).
//!
//! The mean gap stays that of the chain: the shape only distributes it, as (16) does.

use super::profile::Profile;
use crate::{error::AuditError, swap::Swap};
use truegap_model::equations::electrodes::series;
use truegap_model::stack::Warm;

impl<'a> Swap<'a> {
    /// Replaces the spherical cap: `shape` gives the electrode's shape at a temperature and a force (N).
    #[must_use]
    pub(crate) fn shape(self, shape: impl Fn(&Warm, f64) -> Result<Profile, AuditError> + Send + Sync + 'a) -> Self {
        self.squeeze(|_, row| {
            row.warp_factor = 0.0;
            Ok(())
        })
        .parts(move |warm, row, parts| {
            let gap = warm.layers.beads * (1.0 - row.strain);
            let gain = shape(warm, row.force_n)?.gain(gap).ok_or(AuditError::NoResponse {
                force_n: row.force_n,
                temperature_c: f64::NAN,
                strain: row.strain,
            })?;
            parts.beads *= gain;
            parts.shares.main = series([parts.beads, parts.insulator]);
            Ok(())
        })
    }
}

/// A shape that grows in proportion to the temperature difference, known at `kelvin`.
pub(crate) fn shaped<'a>(at_hot: &Profile, kelvin: f64) -> Swap<'a> {
    let hot = at_hot.clone();
    Swap::none().shape(move |warm, _| {
        let t = if kelvin == 0.0 { 0.0 } else { warm.kelvin / kelvin };
        Ok(hot.times(t))
    })
}
