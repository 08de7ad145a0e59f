//! What the cases of a study are drawn from: its seed, its options, and the shares that the seed draws.
//!
//! Limits: nobody is told the shares before the key is opened.

use crate::causes::{LIBRARY, STRANGERS, WILD};
use crate::draws::Draws;
use crate::protocol::Kind;
use serde::Serialize;

/// All that a case depends on besides its number.
#[derive(Debug, Clone)]
pub(crate) struct Settings {
    pub seed: u64,
    pub options: Options,
    pub shares: Shares,
}

impl Settings {
    pub(crate) fn new(seed: u64, options: Options) -> Self {
        Self { seed, shares: Shares::drawn(seed, &options), options }
    }
}

/// What a user may choose of a study.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Options {
    /// Least detectability asked of a cause.
    pub detectability_from: f64,
    /// Largest.
    pub detectability_to: f64,
    /// Protocols to draw from; empty: all.
    pub protocols: Vec<Kind>,
    /// What to conceal.
    pub only: Only,
}

/// Restriction of a study, to count one thing well; a tool that is told of it is no longer blind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Only {
    /// Everything, in shares that the seed draws.
    #[default]
    Everything,
    /// Nothing is concealed.
    Nulls,
    /// One library cause each.
    Singles,
    /// Two library causes each.
    Pairs,
    /// A stranger each.
    Strangers,
    /// Nothing is concealed, and the measuring chain is at fault: the loggers of [`crate::logger`] in turn.
    Loggers,
    /// Each effect of the library in turn, to be diagnosed without it.
    WithoutEach,
    /// As a workshop records: protocols nobody planned, loggers as they are, a bath of weak imperfections, causes outside the library.
    Wild,
}

impl Default for Options {
    fn default() -> Self {
        Self { detectability_from: 4.0, detectability_to: 120.0, protocols: Vec::new(), only: Only::Everything }
    }
}

/// Shares drawn from the seed.
#[derive(Debug, Clone, PartialEq)]
pub struct Shares {
    /// Weights of: nothing, one cause, two, three, a stranger.
    pub makeup: [f64; 5],
    /// Weights of the library's causes.
    pub library: Vec<f64>,
    /// Weights of the strangers.
    pub strangers: Vec<f64>,
    /// Weights of the wild causes.
    pub wild: Vec<f64>,
    /// Weights of the protocols.
    pub protocols: Vec<(Kind, f64)>,
    /// Share of recordings with strongly autocorrelated noise.
    pub coloured: f64,
    /// Share with a humidity column for no reason.
    pub humidity: f64,
    /// Share whose base model rightly leaves the warp out.
    pub flat: f64,
}

impl Shares {
    fn drawn(seed: u64, options: &Options) -> Self {
        let draws = &mut Draws::of(seed, "shares");
        let nothing = draws.between(0.12, 0.35);
        let stranger = draws.between(0.06, 0.15);
        let two = draws.between(0.08, 0.2);
        let three = draws.between(0.0, 0.03);
        let weights =
            |count: usize, draws: &mut Draws| (0..count).map(|_| (0.4 * draws.truncated_normal(2.0)).exp()).collect::<Vec<f64>>();
        let own: &[Kind] = match options.only {
            Only::Wild => &Kind::WILD,
            Only::WithoutEach => &[Kind::Full],
            _ => &Kind::ALL,
        };
        let kinds: &[Kind] = if options.protocols.is_empty() { own } else { &options.protocols };
        let rich = |kind: &Kind| if matches!(kind, Kind::Full | Kind::Thermal | Kind::Mechanical) { 3.0 } else { 1.0 };
        Self {
            makeup: match options.only {
                Only::Everything => [nothing, 1.0 - nothing - stranger - two - three, two, three, stranger],
                Only::Nulls | Only::Loggers => [1.0, 0.0, 0.0, 0.0, 0.0],
                Only::Singles => [0.0, 1.0, 0.0, 0.0, 0.0],
                Only::Pairs => [0.0, 0.0, 1.0, 0.0, 0.0],
                Only::Strangers => [0.0, 0.0, 0.0, 0.0, 1.0],
                Only::WithoutEach => [0.0, 1.0, 0.0, 0.0, 0.0],
                Only::Wild => [0.15, 0.28, 0.17, 0.08, 0.32],
            },
            library: weights(LIBRARY.len(), draws),
            strangers: weights(STRANGERS.len(), draws),
            wild: vec![1.0; WILD.len()],
            protocols: kinds.iter().map(|kind| (*kind, rich(kind) * (0.3 * draws.normal()).exp())).collect(),
            coloured: draws.between(0.15, 0.4),
            humidity: draws.between(0.2, 0.5),
            flat: draws.between(0.05, 0.2),
        }
    }
}
