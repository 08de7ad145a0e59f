//! Which effects a model holds, whatever the order in which they were added.
//!
//! Limits: indices into one library; says nothing of sets of another.

use std::ops::Deref;

/// A set of effects: indices into the library searched, ascending, each once.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EffectSet(Vec<usize>);

impl EffectSet {
    /// The same set without one of its effects.
    #[must_use]
    pub fn without(&self, effect: usize) -> Self {
        Self(self.0.iter().copied().filter(|e| *e != effect).collect())
    }
}

impl FromIterator<usize> for EffectSet {
    fn from_iter<I: IntoIterator<Item = usize>>(effects: I) -> Self {
        let mut effects: Vec<usize> = effects.into_iter().collect();
        effects.sort_unstable();
        effects.dedup();
        Self(effects)
    }
}

impl From<&[usize]> for EffectSet {
    fn from(effects: &[usize]) -> Self {
        effects.iter().copied().collect()
    }
}

impl Deref for EffectSet {
    type Target = [usize];
    fn deref(&self) -> &[usize] {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_knows_no_order_and_no_effect_twice() {
        let set = EffectSet::from(&[7, 2, 5][..]);
        assert_eq!(set, EffectSet::from(&[5, 7, 2, 2][..]));
        assert_eq!(set.without(5), EffectSet::from(&[2, 7][..]));
        assert_eq!(set.without(3), set);
    }
}
