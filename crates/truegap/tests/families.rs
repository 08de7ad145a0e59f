//! The blind studies score the families that a reader is told.

#![allow(clippy::unwrap_used)]

use std::collections::BTreeSet;
use truegap::diagnose::{Effect, Library};
use truegap_generator::score::told::told_family;

fn spoken(effect: &dyn Effect) -> String {
    serde_json::to_value(effect.family()).unwrap().as_str().unwrap().to_owned()
}

#[test]
fn the_scorer_has_the_family_of_every_effect_as_the_library_has_it() {
    let library = Library::default();
    let mut families = BTreeSet::new();
    for effect in library.iter() {
        assert_eq!(told_family(effect.id().0), Some(spoken(effect).as_str()), "{}", effect.id());
        families.insert(spoken(effect));
    }
    assert_eq!(families.len(), 6);
    assert_eq!(told_family("a cause that no library holds"), None);
}
