//! What is asked of a firmware besides its model: ranges of the table, its bytes, and how much noise a lag may cost.
//!
//! Limits: whether a range is one of a column that is followed is asked where the columns are known.

use super::FirmwareError;
use std::collections::BTreeMap;

/// Least growth of the noise by which a lag is undone: at the root of 5 all of it is left.
const LEAST_GROWTH: f64 = 3.0;
/// Bytes of one cell along reading and two columns.
const LEAST_BYTES: usize = 32;
/// Bytes from which on a table is no table for a microcontroller.
const MOST_BYTES: usize = 1 << 20;

/// What is asked of a firmware.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// whether it corrects for what the model only carries, without a claim to its name
    pub carried: bool,
    /// most bytes of the table
    pub bytes: usize,
    /// most that undoing a lag of the reading may make the noise grow
    pub noise_growth: f64,
    /// range of a column, by its name, in the unit of the recording (degC, % and SI of roles), or of the `reading`
    pub ranges: BTreeMap<String, [f64; 2]>,
}

impl Default for Asked {
    fn default() -> Self {
        Self { carried: false, bytes: 16_384, noise_growth: 10.0, ranges: BTreeMap::new() }
    }
}

impl Asked {
    /// Adds a range that is written as `NAME=LOW:HIGH`.
    ///
    /// # Errors
    /// [`FirmwareError::NoRange`].
    pub fn add_range(&mut self, text: &str) -> Result<(), FirmwareError> {
        let refused = |why| FirmwareError::NoRange { text: text.to_owned(), why };
        let (name, ends) = text.rsplit_once('=').ok_or_else(|| refused("there is no `=`"))?;
        let (low, high) = ends.split_once(':').ok_or_else(|| refused("there is no `:`"))?;
        let number = |text: &str| text.trim().parse::<f64>().ok().filter(|value| value.is_finite());
        let [low, high] = [number(low), number(high)].map(|end| end.ok_or_else(|| refused("an end is no number")));
        let (low, high) = (low?, high?);
        if low >= high {
            return Err(refused("it does not go up"));
        }
        self.ranges.insert(name.trim().to_owned(), [low, high]);
        Ok(())
    }

    /// Whether its numbers can be.
    pub(super) fn check(&self) -> Result<(), FirmwareError> {
        if !(self.noise_growth >= LEAST_GROWTH && self.noise_growth.is_finite()) {
            let (value, wanted) =
                (self.noise_growth.to_string(), "a finite number from 3 on: below it hardly any of a lag is undone");
            return Err(FirmwareError::Option { option: "--noise-growth", value, wanted });
        }
        if !(LEAST_BYTES..=MOST_BYTES).contains(&self.bytes) {
            let (value, wanted) = (self.bytes.to_string(), "32 to 1048576");
            return Err(FirmwareError::Option { option: "--bytes", value, wanted });
        }
        Ok(())
    }
}
