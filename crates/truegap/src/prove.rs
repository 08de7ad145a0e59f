//! A blind study: recordings with sealed answers, a diagnosis of each, then the key is opened and the scores are counted.
//!
//! Limits: the diagnosis reads nothing but `CASE/recording.*`; key and plan lie in the same folder, so a study proves something to others only
//! where its commitments were published, or its seed drawn, after the program was frozen.
//!
//! ```text
//! DIR/commitments.txt            SHA-256 of every salted answer, every recording and the plan, written before the first diagnosis
//! DIR/case-001/recording.*       what the diagnosis gets
//! DIR/case-001/without.txt       the effect that it is to do without, where one is left out
//! DIR/key/                       answers, and the plan with its seed
//! DIR/diagnoses/case-001/        diagnosis.json, augmented.toml, controls.json (what simpler methods say of the same residual); refused.txt where there is no diagnosis
//! DIR/answers.txt                SHA-256 of each file in `diagnoses`, complete before the key is opened
//! DIR/score.json, DIR/score.md   once every case has its diagnosis
//! ```

mod answers;
mod controls;
mod document;
mod error;
mod fresh;
mod plan;
mod process;
mod result;
mod score;
mod seal;
mod sparse;

pub use answers::{Answered, Told, answer};
pub use error::ProveError;
pub use plan::{Plan, Sort, begin, entropy, resume};
pub use result::{CaseScore, Control, Score, Worded};
pub use score::score;
pub use truegap_generator::protocol::Kind;
pub use truegap_generator::score::targets::Row;
