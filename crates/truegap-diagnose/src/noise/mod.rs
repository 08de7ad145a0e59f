//! Noise before anything else: of the inputs, and of the response, from rest or replicates; never from what a model leaves over a slow change.
//!
//! Limits: one noise for a whole recording.

pub(crate) mod apart;
pub(crate) mod beside_louder;
pub(crate) mod beyond_the_ends;
pub(crate) mod block_average;
pub(crate) mod changing_level;
pub(crate) mod clock;
pub(crate) mod crossings;
pub(crate) mod denoise;
pub(crate) mod denoised_inputs;
pub(crate) mod errors_in_load;
pub(crate) mod follows_drivers;
pub(crate) mod grows;
pub(crate) mod input;
pub(crate) mod input_error;
pub(crate) mod learned_again;
pub(crate) mod louder;
pub(crate) mod louder_neighbours;
pub(crate) mod neighbours;
pub(crate) mod off_at_rest;
pub(crate) mod reml;
pub(crate) mod rescale;
pub(crate) mod response;
pub(crate) mod rest;
pub(crate) mod rounding;
pub(crate) mod scout;
pub(crate) mod several;
pub(crate) mod slow;
pub(crate) mod slow_parts;
pub(crate) mod slow_rivals;
pub(crate) mod switching;
pub(crate) mod tones;
pub(crate) mod tuning;
