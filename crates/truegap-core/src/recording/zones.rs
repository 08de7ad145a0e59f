//! Whether all dates of a column have a zone, or none.
//!
//! Limits: one column; a zone that is written is believed.

use super::stamp::Stamp;

/// The first date that was seen, and whether it has a zone.
#[derive(Clone, Debug, Default)]
pub(super) struct Zones(Option<(bool, String)>);

impl Zones {
    /// The first date, where this one has a zone and that has none, or the other way round.
    pub fn see(&mut self, stamp: Stamp, text: &[u8]) -> Option<String> {
        match &self.0 {
            None => self.0 = Some((stamp.zoned, String::from_utf8_lossy(text).trim().to_owned())),
            Some((zoned, first)) if *zoned != stamp.zoned => return Some(first.clone()),
            _ => {}
        }
        None
    }
}
