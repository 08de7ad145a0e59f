//! A free number of a model: its unit, what is known of it beforehand, and how far it may go.
//!
//! Limits: priors are independent of one another.

use serde::{Deserialize, Serialize};

/// What is known of a parameter before the recording is seen.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Prior {
    /// Gaussian.
    Normal {
        /// mean, in the parameter's unit
        mean: f64,
        /// one standard deviation, in the parameter's unit
        sd: f64,
    },
    /// Gaussian in the logarithm; for positive scales such as time constants.
    LogNormal {
        /// median, in the parameter's unit
        median: f64,
        /// one standard deviation of the natural logarithm
        log_sd: f64,
    },
    /// Gaussian in the inverse hyperbolic sine: as a Gaussian about 0 where it is usual, and as one of the logarithm far out. For a ratio whose divisor may be nothing, such as a bend over a slope.
    Wide {
        /// one standard deviation near 0, in the parameter's unit
        sd: f64,
    },
}

impl Prior {
    /// Value at `z` standard deviations from the centre.
    pub fn at(self, z: f64) -> f64 {
        match self {
            Self::Normal { mean, sd } => mean + sd * z,
            Self::LogNormal { median, log_sd } => median * (log_sd * z).exp(),
            Self::Wide { sd } => sd * z.sinh(),
        }
    }

    /// Standard deviations by which `value` lies off the centre.
    pub fn z(self, value: f64) -> f64 {
        match self {
            Self::Normal { mean, sd } => (value - mean) / sd,
            Self::LogNormal { median, log_sd } => (value / median).ln() / log_sd,
            Self::Wide { sd } => (value / sd).asinh(),
        }
    }

    /// Change of the value per standard deviation, at `z`.
    pub fn slope(self, z: f64) -> f64 {
        match self {
            Self::Normal { sd, .. } => sd,
            Self::LogNormal { median, log_sd } => median * log_sd * (log_sd * z).exp(),
            Self::Wide { sd } => sd * z.cosh(),
        }
    }
}

/// A free number of a simulator or of an effect.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Parameter {
    /// name as in files, e.g. `young_rtv`
    pub name: String,
    /// unit of `prior` and `bounds`, e.g. `Pa`
    pub unit: String,
    /// what is known beforehand
    pub prior: Prior,
    /// closed range outside which the number has no physical meaning
    pub bounds: (f64, f64),
    /// what it is, for a reader
    pub meaning: String,
}

impl Parameter {
    /// A parameter with a Gaussian prior and no bounds.
    pub fn normal(name: &str, unit: &str, mean: f64, sd: f64, meaning: &str) -> Self {
        let prior = Prior::Normal { mean, sd };
        Self { name: name.into(), unit: unit.into(), prior, bounds: (f64::NEG_INFINITY, f64::INFINITY), meaning: meaning.into() }
    }

    /// A positive parameter that is Gaussian in the logarithm.
    pub fn log_normal(name: &str, unit: &str, median: f64, log_sd: f64, meaning: &str) -> Self {
        let prior = Prior::LogNormal { median, log_sd };
        Self { name: name.into(), unit: unit.into(), prior, bounds: (0.0, f64::INFINITY), meaning: meaning.into() }
    }

    /// A parameter about 0 that may be many times its usual size, without bounds.
    pub fn wide(name: &str, unit: &str, sd: f64, meaning: &str) -> Self {
        Self { prior: Prior::Wide { sd }, ..Self::normal(name, unit, 0.0, sd, meaning) }
    }

    /// The same parameter, held inside a closed range.
    #[must_use]
    pub fn within(mut self, low: f64, high: f64) -> Self {
        self.bounds = (low, high);
        self
    }

    /// The centre of the prior.
    pub fn centre(&self) -> f64 {
        self.prior.at(0.0)
    }

    /// Standard deviation at the centre of the prior, in the parameter's unit.
    pub fn sd(&self) -> f64 {
        self.prior.slope(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// There and back, and the change of the value against differences.
    #[test]
    fn values_and_standard_deviations_are_inverse_and_slopes_are_differences() {
        let wide = Prior::Wide { sd: 0.2 };
        for prior in [Prior::Normal { mean: 4.0, sd: 0.5 }, Prior::LogNormal { median: 20.0, log_sd: 0.3 }, wide] {
            for z in [-2.0, 0.0, 1.5] {
                approx::assert_abs_diff_eq!(prior.z(prior.at(z)), z, epsilon = 1e-12);
                let difference = (prior.at(z + 1e-5) - prior.at(z - 1e-5)) / 2e-5;
                approx::assert_relative_eq!(prior.slope(z), difference, max_relative = 1e-8);
            }
        }
        // a third of the logarithm is 35 % up
        approx::assert_relative_eq!(Prior::LogNormal { median: 20.0, log_sd: 0.3 }.at(1.0), 26.997_176, max_relative = 1e-7);
        // a thousand times the usual size costs what 7.6 deviations do
        approx::assert_relative_eq!(wide.z(200.0), 7.6, max_relative = 1e-3);
        assert_eq!(Parameter::log_normal("tau", "s", 20.0, 0.3, "").sd(), 6.0);
    }
}
