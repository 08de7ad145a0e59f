//! What is told of a recording beside its files.

use truegap::core::recording::{Mapped, Told};

/// Columns and dates of a recording, where its files do not tell.
#[derive(Clone, Debug, clap::Args)]
pub struct TellArgs {
    /// Column of every recording that plays a role or drives something, with its unit where the name has none: response=C_measured:pF, driver.position=position_mm:mm. Roles: response, force, pressure, gap, temperature, humidity, time, run, simulated, sensor; may be given several times
    #[arg(long, value_name = "ROLE=COLUMN[:UNIT]")]
    map: Vec<Mapped>,
    /// Whether the day stands first in dates such as 01/03/2026, where no date of the column shows it: --dayfirst, or --dayfirst=false for the month
    #[arg(long, value_name = "true|false", num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    dayfirst: Option<bool>,
}

impl TellArgs {
    /// The same as the library takes it.
    pub fn told(&self) -> Told {
        Told { map: self.map.clone(), dayfirst: self.dayfirst, ..Told::default() }
    }

    /// Whether nothing is told.
    pub fn is_empty(&self) -> bool {
        self.map.is_empty() && self.dayfirst.is_none()
    }
}
