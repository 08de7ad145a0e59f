//! Whether mechanisms say in words what effects of the library say under their names.
//!
//! An equation of the library is worth more than a composed one, and its name is what a reader knows: where both follow the same driver in the same way, and may act at the same place, the law is a matter
//! of form and the name stands.
//!
//! Limits: driver, kinetics and place; laws are not compared.

use crate::{
    data::context::Context,
    discovery::{
        discover::Discovery,
        marginals::{TOLD, WordProbabilities},
    },
    effects::{
        composed::words::{Driver, InWords},
        course::Course,
    },
    selection::candidates::{Search, Tried},
};

/// The words with the reading for a driver that the base model follows by itself: one moves with the other.
pub fn with_followed_driver(words: InWords, context: &Context<'_>) -> InWords {
    let recorded = |name: &String| {
        let place = context.inputs.drivers.iter().position(|driver| driver.name == *name);
        place.is_some_and(|place| Course::Driver(place).is_followed(context))
    };
    match &words.driver {
        Driver::Recorded(name) if recorded(name) => InWords { driver: Driver::Reading, ..words },
        _ => words,
    }
}

/// Whether each mechanism, beside the base model alone, says what an effect of `named` says, and there is one for each of those.
pub fn says_all_of(search: &Search<'_>, named: &Tried, tried: &Tried, mechanisms: &[Discovery]) -> bool {
    mechanisms.len() == named.effects.len() && says_the_same(search, named, tried, mechanisms)
}

/// Whether each mechanism, `tried` beside the base model alone, says what an effect of `named` says.
pub fn says_the_same(search: &Search<'_>, named: &Tried, tried: &Tried, mechanisms: &[Discovery]) -> bool {
    let library = search.library.len();
    let beside_base = tried.effects.iter().all(|e| *e >= library);
    beside_base && mechanisms.iter().all(|mechanism| says_one_of(search, &named.effects, mechanism))
}

/// Whether a mechanism says what one of these `effects` of the library says.
pub fn says_one_of(search: &Search<'_>, effects: &[usize], mechanism: &Discovery) -> bool {
    let own = moved(mechanism.effect.sentence.in_words(), search.context);
    let names = effects.iter().filter_map(|e| search.library.get(*e)?.in_words(search.context));
    names
        .map(|words| moved(words, search.context))
        .any(|name| (&name.driver, name.kinetics) == (&own.driver, own.kinetics) && acts_at(&mechanism.words, &name))
}

/// The words with the reading for the load as well: the plates of a sensor follow it.
fn moved(words: InWords, context: &Context<'_>) -> InWords {
    match words.driver {
        Driver::Load => InWords { driver: Driver::Reading, ..words },
        _ => with_followed_driver(words, context),
    }
}

fn acts_at(words: &WordProbabilities, name: &InWords) -> bool {
    words.place.get(name.place.word()).is_some_and(|p| *p >= TOLD)
}
