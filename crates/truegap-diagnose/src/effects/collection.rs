//! The effects that a diagnosis knows, as data: the built-in ones, and whatever a caller adds.
//!
//! Limits: two effects with one id are not told apart; the later one replaces the earlier.

use crate::effects::effect::Effect;
use std::{fmt, sync::Arc};
use truegap_core::EffectId;

/// Effects in the order of the chain, in which their stages are plugged in. Cheap to clone.
///
/// [`Library::default`] holds the built-in ones; [`Library::with`] adds one of your own, from code or from a file:
///
/// ```
/// use truegap_diagnose::{Library, Options, library};
///
/// let mine = library().into_iter().next().unwrap(); // stands for an effect of your own
/// let options = Options { library: Library::empty().with(mine), ..Options::default() };
/// assert_eq!(options.library.ids(), ["time_offset"]);
/// ```
#[derive(Clone)]
pub struct Library(Vec<Arc<dyn Effect>>);

impl Default for Library {
    fn default() -> Self {
        Self(crate::effects::library().into_iter().map(Arc::from).collect())
    }
}

impl Library {
    /// No effects.
    pub fn empty() -> Self {
        Self(Vec::new())
    }

    /// The same effects and one more, behind those of its stage and of the stages before it; it takes the place of an effect with its id.
    #[must_use]
    pub fn with(mut self, effect: Box<dyn Effect>) -> Self {
        self.0.retain(|known| known.id() != effect.id());
        let place = self.0.iter().rposition(|known| known.stage() <= effect.stage()).map_or(0, |last| last + 1);
        self.0.insert(place, Arc::from(effect));
        self
    }

    /// Every effect, in the order of the chain.
    pub fn iter(&self) -> impl Iterator<Item = &dyn Effect> {
        self.0.iter().map(AsRef::as_ref)
    }

    /// The effect with this id.
    pub fn find(&self, id: &str) -> Option<&dyn Effect> {
        self.iter().find(|effect| effect.id().0 == id)
    }

    /// All ids, in the order of the chain.
    pub fn ids(&self) -> Vec<&'static str> {
        self.iter().map(|effect| effect.id().0).collect()
    }
}

impl PartialEq for Library {
    /// Whether the ids are the same, in the same order.
    fn eq(&self, other: &Self) -> bool {
        self.ids() == other.ids()
    }
}

impl fmt::Debug for Library {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ids: Vec<EffectId> = self.iter().map(Effect::id).collect();
        f.debug_tuple("Library").field(&ids).finish()
    }
}
