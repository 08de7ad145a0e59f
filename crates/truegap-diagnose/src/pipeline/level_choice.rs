//! Noise whose level changes in place of a cause that nobody can name.
//!
//! Where nothing is named and the noise was not measured, loud hours look like jumps and wanders: all that is left is weighed once more under noise whose level changes. It has to be clearly likelier than the noise that was taken,
//! with whatever stands beside the base model there.
//!
//! Limits: one recording with a clock, and no base model with plates; nothing is named.

use crate::{
    data::error::DiagnoseError,
    noise::{changing_level::changing_levels, tuning::CLEARLY_QUIETER},
    pipeline::{
        noise_choice::{deviance, unmodelled},
        prepare::Prepared,
    },
    selection::{examine::Examined, verdict::Verdict},
    whitening::noise_model::NoiseModel,
};

impl Prepared<'_> {
    /// The noise whose level changes, where it is clearly likelier and nothing is named.
    ///
    /// # Errors
    /// Those of the simulator.
    pub(crate) fn of_changing_level(&self, examined: &Examined) -> Result<Option<NoiseModel>, DiagnoseError> {
        let (decision, selection) = (&examined.decision, &examined.selection);
        let nothing = decision.verdict != Verdict::Agrees && decision.model == selection.base;
        let one = self.problem.is_one_with_a_clock();
        // with plates what is left without a name is most of it physics
        if !nothing || !one || self.context.has_plates() || self.noise.measured || self.noise.step > 0.0 {
            return Ok(None);
        }
        let base = selection.base();
        let misfit = self.misfit(base)?;
        let log = |noise: &NoiseModel| -0.5 * deviance(&noise.whitener(&self.problem.runs(), None), &misfit);
        let taken = log(&self.noise) + unmodelled(selection, base);
        let tried = changing_levels(self.problem, &misfit, &self.noise).into_iter().map(|noise| (log(&noise), noise));
        let best = tried.max_by(|a, b| a.0.total_cmp(&b.0));
        Ok(best.filter(|(log, _)| *log > taken + CLEARLY_QUIETER).map(|(_, noise)| noise))
    }
}
