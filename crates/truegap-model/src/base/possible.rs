//! Whether the numbers of a base model that was read from a file can be: each is one, ranges have a width, a table has a value a combination.
//!
//! Limits: a model that was made for a recording is sound by how it is made, and is not asked.

use super::black_box::BlackBoxFacts;
use super::driver::{Driver, Followed, NamedDriver};
use super::external::ExternalOptions;
use super::grid::{Axis, Grid};
use super::linear::HIGHEST_ORDER;
use super::scale::ResponseScale;
use super::spec::{BaseError, BaseModel};
use super::surface::Surface;
use truegap_core::units::ABSOLUTE_ZERO_C;

/// Longest time that a program may be given for an answer, s: ten years.
const LONGEST_S: f64 = 3.2e8;

/// What cannot be, and what may stand there.
type Wrong = (String, &'static str);

impl BaseModel {
    /// Whether a model can be built of these numbers.
    ///
    /// # Errors
    /// [`BaseError::Order`], or [`BaseError::Impossible`] with the number and what may stand in its place.
    pub fn check(&self) -> Result<(), BaseError> {
        if let Self::Linear { order, .. } = self
            && !(1..=HIGHEST_ORDER).contains(order)
        {
            return Err(BaseError::Order { order: *order });
        }
        self.numbers().map_err(|(what, wanted)| BaseError::Impossible { what, wanted })
    }

    fn numbers(&self) -> Result<(), Wrong> {
        if let Some((scale, reference_c)) = self.scaled() {
            warm(*reference_c)?;
            scale.check()?;
        }
        match self {
            Self::Stack { .. } | Self::Constant { .. } => Ok(()),
            Self::ParallelPlate { full_load, .. } => above_zero("full_load", *full_load),
            Self::GapPlate { scale, .. } => scale.check_gaps(),
            Self::External { options, surface, .. } => {
                options.check()?;
                surface.as_ref().map_or(Ok(()), Surface::check)
            }
            Self::Linear { driver, .. } => driver.check(),
            Self::Table { options, grid, .. } => options.check().and_then(|()| grid.check()),
            Self::Command { timeout_s, simulator, .. } => {
                above_zero("timeout_s", *timeout_s)?;
                let is_short = *timeout_s <= LONGEST_S;
                is_short.then_some(()).ok_or_else(|| (format!("timeout_s = {timeout_s}"), "3.2e8 or less"))?;
                simulator.check()
            }
            Self::Function { simulator, .. } => simulator.check(),
        }
    }

    /// What the priors are scaled with, and the temperature at which it is described.
    fn scaled(&self) -> Option<(&ResponseScale, &f64)> {
        match self {
            Self::ParallelPlate { scale, reference_c, .. }
            | Self::GapPlate { scale, reference_c }
            | Self::Constant { scale, reference_c }
            | Self::External { scale, reference_c, .. }
            | Self::Linear { scale, reference_c, .. }
            | Self::Table { scale, reference_c, .. } => Some((scale, reference_c)),
            Self::Stack { .. } | Self::Command { .. } | Self::Function { .. } => None,
        }
    }
}

impl ResponseScale {
    fn check(&self) -> Result<(), Wrong> {
        let numbers = [
            ("centre", self.centre),
            ("range", self.range),
            ("at_rest", self.at_rest),
            ("span", self.span),
            ("response_times_gap", self.response_times_gap),
            ("gaps_m", self.gaps_m.0),
            ("gaps_m", self.gaps_m.1),
        ];
        numbers.iter().try_for_each(|(name, number)| finite(name, *number))?;
        above_zero("range", self.range)
    }

    fn check_gaps(&self) -> Result<(), Wrong> {
        let (narrowest, widest) = self.gaps_m;
        above_zero("response_times_gap", self.response_times_gap)?;
        let rises = widest > 0.0 && narrowest <= widest;
        rises
            .then_some(())
            .ok_or_else(|| (format!("gaps_m = [{narrowest}, {widest}]"), "the narrowest gap and the widest, above 0"))
    }
}

impl ExternalOptions {
    fn check(&self) -> Result<(), Wrong> {
        self.gain_sd.map_or(Ok(()), |sd| above_zero("gain_sd", sd))
    }
}

impl Surface {
    fn check(&self) -> Result<(), Wrong> {
        self.weights.iter().try_for_each(|weight| finite("weights", *weight))?;
        [&self.load, &self.temperature].into_iter().flatten().try_for_each(Driver::check)
    }
}

impl BlackBoxFacts {
    fn check(&self) -> Result<(), Wrong> {
        warm(self.reference_c)?;
        self.load.as_ref().map_or(Ok(()), Driver::check)
    }
}

impl Driver {
    fn check(&self) -> Result<(), Wrong> {
        finite("zero", self.zero).and_then(|()| above_zero("width", self.width))
    }
}

impl NamedDriver {
    fn check(&self) -> Result<(), Wrong> {
        finite("zero", self.zero).and_then(|()| above_zero("width", self.width))
    }
}

impl Followed {
    fn check(&self) -> Result<(), Wrong> {
        match self {
            Self::Column(driver) => driver.check(),
            Self::Named(driver) => driver.check(),
        }
    }
}

impl Grid {
    fn check(&self) -> Result<(), Wrong> {
        let axes = self.axes.len();
        if !(1..=2).contains(&axes) {
            return Err((format!("axes of the table = {axes}"), "one axis or two"));
        }
        self.axes.iter().try_for_each(Axis::check)?;
        self.values.iter().try_for_each(|value| finite("values", *value))?;
        let (values, cells) = (self.values.len(), self.axes.iter().map(|axis| axis.at.len()).product::<usize>());
        let is_filled = values == cells;
        is_filled.then_some(()).ok_or_else(|| {
            let found = format!("values of the table = {values} numbers for {cells} combinations of its axes");
            (found, "one number a combination, the last axis running fastest")
        })
    }
}

impl Axis {
    fn check(&self) -> Result<(), Wrong> {
        const RISING: &str = "two numbers or more, each above the one before";
        let role = self.role.key();
        self.at.iter().try_for_each(|at| finite("at", *at))?;
        if self.at.len() < 2 {
            return Err((format!("at of the axis {role} = {:?}", self.at), RISING));
        }
        let falls = self.at.windows(2).find(|pair| pair[0] >= pair[1]);
        falls.map_or(Ok(()), |pair| Err((format!("at of the axis {role} = [..., {}, {}, ...]", pair[0], pair[1]), RISING)))
    }
}

fn warm(reference_c: f64) -> Result<(), Wrong> {
    finite("reference_c", reference_c)?;
    let is_warm = reference_c >= ABSOLUTE_ZERO_C;
    let wanted = "a temperature in degC, not below -273.15";
    if is_warm { Ok(()) } else { Err((format!("reference_c = {reference_c}"), wanted)) }
}

fn finite(name: &str, number: f64) -> Result<(), Wrong> {
    if number.is_finite() { Ok(()) } else { Err((format!("{name} = {number}"), "a finite number")) }
}

fn above_zero(name: &str, number: f64) -> Result<(), Wrong> {
    let is_above = number.is_finite() && number > 0.0;
    if is_above { Ok(()) } else { Err((format!("{name} = {number}"), "a finite number above 0")) }
}
