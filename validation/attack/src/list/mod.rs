//! The attacks, one file a class.

mod arguments;
mod bases;
mod files;
pub mod material;
mod names;
mod outputs;
mod sizes;
mod values;

use crate::attack::Attack;

/// Every attack; none where there is no Unix shell.
pub fn all() -> Vec<Attack> {
    if !cfg!(unix) {
        return Vec::new();
    }
    [arguments::all(), bases::all(), files::all(), sizes::all(), values::all(), names::all(), outputs::all()]
        .into_iter()
        .flatten()
        .collect()
}
