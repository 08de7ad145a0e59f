//! How far an answer can be trusted: rows left out, permuted histories, recordings whose cause is known, another recording.
//!
//! Limits: takes back what rows left out contradict, and chooses among rivals; names nothing that the selection has not tried.

pub(crate) mod all_rows;
pub(crate) mod among_rivals;
pub mod ceiling;
pub mod confirmation;
pub(crate) mod cross_validation;
pub(crate) mod held_numbers;
pub(crate) mod main_causes;
pub(crate) mod moved_numbers;
pub mod other_clock;
pub(crate) mod permutation;
pub mod recovery;
pub(crate) mod reference;
pub(crate) mod selected_again;
pub(crate) mod step_back;
pub(crate) mod tuning;
pub(crate) mod unforetold;
pub(crate) mod veto;
