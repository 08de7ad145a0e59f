//! Tests of several stages together, which no user of the crate can reach.

#![allow(clippy::unwrap_used)]

/// What every effect of these tests says alike: it is one of the reading, any recording can show it, and it has no words.
macro_rules! of_the_reading {
    () => {
        fn id(&self) -> truegap_core::EffectId {
            self.id
        }
        fn stage(&self) -> truegap_core::StageName {
            truegap_core::StageName::Readout
        }
        fn family(&self) -> crate::Family {
            crate::Family::Readout
        }
        fn about(&self) -> crate::About {
            crate::About { physics: "", equation: "", excitation: "", impostors: &[], separates: "", source: "" }
        }
        fn testable(&self, _: &crate::Context<'_>) -> Result<(), String> {
            Ok(())
        }
    };
}
pub(crate) use of_the_reading;

mod around;
mod evidence;
mod linear;
mod noise;
pub(crate) mod search;
