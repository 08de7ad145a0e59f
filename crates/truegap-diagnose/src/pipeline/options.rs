//! What a caller may choose of a diagnosis.
//!
//! Limits: plain data.

use crate::{
    effects::{collection::Library, effect::Effect},
    explain::hidden_input::slow_input::Hidden,
    validation::recovery::fill::BankOptions,
};
use std::sync::Arc;

/// What a caller may choose.
#[derive(Clone, Debug)]
pub struct Options {
    /// the effects that are known, the built-in ones unless somebody gives others
    pub library: Library,
    /// ids of the effects to try; all where empty
    pub effects: Vec<String>,
    /// whether mechanisms are composed of words where the library leaves something
    pub compose: bool,
    /// whether what is named is chosen again without each part of the recording, which takes as many searches as there are parts
    pub select_in_folds: bool,
    /// permuted recordings on which the whole search is made again; none where 0
    pub permuted_searches: usize,
    /// columns that were hidden on purpose: the first is set beside the slow course that the recording asks for without it
    pub hidden: Vec<Hidden>,
    /// the only effects that may be named, where something is wrong with the recording
    pub restricted: Option<Restriction>,
    /// why no physics may be named, where something is wrong with the recording
    pub withheld: Option<String>,
    /// recovery bank; none where absent
    pub bank: Option<Arc<BankOptions>>,
}

impl Default for Options {
    /// The built-in effects, all of them; what they leave is composed.
    fn default() -> Self {
        Self {
            library: Library::default(),
            effects: Vec::new(),
            compose: true,
            select_in_folds: false,
            permuted_searches: 0,
            hidden: Vec::new(),
            restricted: None,
            withheld: None,
            bank: None,
        }
    }
}

/// The only effects that may be named, and why.
#[derive(Clone, Copy, Debug)]
pub struct Restriction {
    /// whether an effect may be named
    pub only: fn(&dyn Effect) -> bool,
    /// why no other may
    pub why: &'static str,
}
