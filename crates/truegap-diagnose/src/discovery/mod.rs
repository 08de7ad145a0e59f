//! Physics that no library lists: mechanisms composed of words, screened by the thousand, fitted, and told with a probability for each word.
//!
//! A mechanism says *where* (place), *what it follows* (driver), *how in time* (kinetics), *by which law* (form) and *how it acts* (action). Each word is a value
//! of an enumeration in [`crate::effects::composed::words`]; [`levers`] is what a change of each quantity does to the reading.
//!
//! Limits: one driver a mechanism; entered where the library leaves something reproducible, never to decide whether something is missing.

pub(crate) mod compose;
pub(crate) mod discover;
pub(crate) mod grammar;
pub(crate) mod levers;
pub(crate) mod marginals;
pub(crate) mod phrase_book;
pub(crate) mod same_words;
pub(crate) mod screen;
