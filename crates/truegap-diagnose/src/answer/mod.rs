//! From a decision to the words, numbers and columns that are given back.
//!
//! Limits: decides nothing.

pub(crate) mod alternatives;
pub(crate) mod assemble;
pub(crate) mod augmented;
pub(crate) mod ceiling;
pub(crate) mod confirmation;
pub(crate) mod diagnosis;
pub(crate) mod discovered;
pub(crate) mod discovered_facts;
pub(crate) mod errors;
pub(crate) mod findings;
pub(crate) mod fit_facts;
pub(crate) mod found;
pub(crate) mod known;
pub(crate) mod next;
pub(crate) mod numbers;
pub(crate) mod outcome;
pub(crate) mod parameter_facts;
pub(crate) mod permuted_searches;
pub(crate) mod prediction;
pub(crate) mod reference;
pub(crate) mod stated;
pub(crate) mod traces;
pub(crate) mod tuning;
pub(crate) mod words;

pub use crate::{
    adequacy::{
        interference::{burst::Burst, tone::Tone},
        lack_of_fit::Adequacy,
    },
    data::joint::share::Sharing,
    explain::{
        conflicts::Conflict,
        hidden_input::{
            course::Through,
            slow_input::{ConcealedColumn, CourseErrors, CourseRun, CourseTrace, Hidden},
        },
        locate::{Map, Mismatch},
        next_experiment::{ExperimentOption, NextExperiment},
    },
    fit::score_test::JointTest,
    quality::notice::{Notice, NoticeKind},
    selection::{model_space::EvidenceCheck, verdict::Verdict},
    validation::reference::Reference,
};
pub(crate) use assemble::outcome;
pub use augmented::{AddedEffect, Augmented, NamedValue, RivalModel, Scales, UnknownEffect};
pub use confirmation::{AmongRivals, Confirmation, Confirmed, Errors, ModelFacts, OtherFacts, RivalErrors};
pub use diagnosis::*;
pub use discovered_facts::DiscoveredFacts;
pub use fit_facts::{
    BeforeAfter, BeforeAfterUnit, FitFacts, FlexibleTerm, HeldOut, PredictionOnly, RecordingError, SelectedAgain, SelectedWithout,
};
pub(crate) use found::{Found, Reserved, Rival};
pub use known::Known;
pub use outcome::Outcome;
pub use parameter_facts::ParameterFacts;
pub use permuted_searches::PermutedSearches;
pub use traces::Traces;
