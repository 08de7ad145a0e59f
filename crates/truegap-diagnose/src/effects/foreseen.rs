//! What effects have in common whose size finite elements have computed.

use truegap_core::{Parameter, Stage};

/// Standard deviation of the share: sensors as made differ from the section that was computed by more than the section's own error of some per cent.
const SHARE_SD: f64 = 0.15;

/// The only parameter: a share of what was computed. Less than half of it, or more than one and a half times, would be something else.
pub(crate) fn share(meaning: &str) -> Parameter {
    Parameter::normal("share", "1", 1.0, SHARE_SD, meaning).within(0.5, 1.5)
}

struct Nothing;

impl Stage for Nothing {}

/// What was computed as a stage; one that changes nothing where nothing was computed.
pub(crate) fn stage(computed: Option<impl Stage + 'static>) -> Box<dyn Stage> {
    match computed {
        Some(computed) => Box::new(computed),
        None => Box::new(Nothing),
    }
}
