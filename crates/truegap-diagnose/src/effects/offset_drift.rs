//! The zero moves slowly with the clock.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter, Separation, ZeroCourse},
        memory::elapsed_s,
    },
    text::{rounded, with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Zero that moves at a rate which may itself fade or grow.
pub struct OffsetDrift;

/// The number by which the speed changes for good.
const TURNING: &str = "turning";
/// Seconds in an hour.
pub const HOUR: f64 = 3600.0;

struct Drift {
    per_hour: f64,
    fading_per_hour: f64,
    /// change of the speed an hour, that goes on for good
    per_square_hour: f64,
}

impl Drift {
    /// Drift `hours` after the first row.
    fn after(&self, hours: f64) -> f64 {
        self.per_hour * drifted(hours, self.fading_per_hour) + 0.5 * self.per_square_hour * hours.powi(2)
    }
}

/// Hours of drift at the first rate that have gone by after `hours`: `(1 - exp(-k t)) / k`.
pub fn drifted(hours: f64, fading: f64) -> f64 {
    if (fading * hours).abs() < 1e-8 { hours * (1.0 - 0.5 * fading * hours) } else { -(-fading * hours).exp_m1() / fading }
}

impl Stage for Drift {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        value.iter_mut().enumerate().for_each(|(row, value)| *value += self.after(elapsed_s(drive.inputs, row) / HOUR));
    }
}

/// Sibling: a zero that settles as the logarithm of the clock, with the same rate at the start.
struct Settling(Drift);

/// Fading of the sibling where the drift has none, 1/h: a logarithm is never straight.
const LEAST_FADING: f64 = 0.2;

impl Stage for Settling {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        let Drift { per_hour, fading_per_hour, per_square_hour } = self.0;
        for (row, value) in value.iter_mut().enumerate() {
            let hours = elapsed_s(drive.inputs, row) / HOUR;
            let reach = fading_per_hour.abs() + LEAST_FADING;
            let fading = (reach * hours).ln_1p() / reach;
            *value += per_hour * if fading_per_hour < 0.0 { 2.0 * hours - fading } else { fading };
            *value += 0.5 * per_square_hour * hours.powi(2);
        }
    }
}

fn drift(values: &[f64]) -> Drift {
    Drift { per_hour: values[0], fading_per_hour: values[1], per_square_hour: values.get(2).copied().unwrap_or(0.0) }
}

/// Usual drift over a recording, of the span of the reading. Without plates, of which more is known, it may be many times that: of 33 drifts in recordings by other people every fifth is more than three times as large,
/// one 33 times, and under a Gaussian a gain that goes with the clock was likelier for the mere size.
const USUAL: f64 = 0.03;
/// Standard deviation of the fading, over the recording. Settling in an eighth of a recording is ordinary after an instrument was switched on (a glider's supply: a time constant of 523 s in 4066 s), and lay eight standard deviations away with one.
pub const USUAL_FADING: f64 = 5.0;
/// Greatest fading, over the recording: what has settled sooner is a few rows. No answer is known that hangs on it.
const QUICKEST_FADING: f64 = 100.0;

impl Effect for OffsetDrift {
    fn id(&self) -> EffectId {
        EffectId("offset_drift")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Time, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the zero of the electronics, or of the assembly, moves with the clock through all runs",
            equation: "value = true + r (1 - exp(-k t)) / k + a t^2 / 2, t from the first row; k = 0 is a straight line; a is 0 beside plates, and until rows left out bear it out",
            excitation: "a clock, and the same state visited early and late",
            impostors: &["ageing", "viscoelastic_creep", "offset_steps", "humidity_uptake", "thermal_lag"],
            separates: "the same at every load, goes on between the runs, knows no history of the load",
            source: "JCGM 200:2012 (VIM), 4.21 instrumental drift; frequency drift of clocks: Riley, Handbook of Frequency Stability Analysis, NIST SP 1065",
        }
    }
    fn separations(&self) -> &'static [Separation] {
        &[
            Separation { rival: "ageing", says: "record a fixed reference capacitor beside the sensor" },
            Separation { rival: "humidity_uptake", says: "record humidity, and dry the sensor overnight" },
        ]
    }
    fn zero_course(&self) -> ZeroCourse {
        ZeroCourse::InsideRuns
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let hours = context.length_s() / HOUR;
        let (moves, plates) = (context.simulator.moves(), context.has_plates());
        // a value that should not move has no span of its own: what moved may all be drift
        let usual = if moves { USUAL } else { 1.0 } * context.response_span.abs() / hours;
        let speed = |name: &str, unit: &str, sd: f64, meaning: &str| {
            let far = moves && !plates;
            if far { Parameter::wide(name, unit, sd, meaning) } else { Parameter::normal(name, unit, 0.0, sd, meaning) }
        };
        let unit = context.simulator.unit();
        let mut parameters = vec![
            speed("rate", &format!("{unit}/h"), usual, "speed of the zero at the first row"),
            Parameter::normal("fading", "1/h", 0.0, USUAL_FADING / hours, "share of the speed that is lost in an hour")
                .within(-1.5 / hours, QUICKEST_FADING / hours),
        ];
        if !plates {
            parameters.push(speed(TURNING, &format!("{unit}/h^2"), usual / hours, "change of the speed in an hour, for good"));
        }
        parameters
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let hours = context.length_s() / HOUR;
        let fadings = [0.0, 4.0 / hours, 40.0 / hours];
        let plates = context.has_plates();
        fadings.map(|fading| if plates { vec![fading] } else { vec![fading, 0.0] }).to_vec()
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["fading"]
    }
    fn may_be_more(&self) -> &'static [&'static str] {
        &[TURNING]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        context.needs_duration()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(drift(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Settling(drift(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let rate = &fitted[0];
        let fading = fitted.get(1).filter(|fading| fading.value > 2.0 * fading.sd && fading.value > 0.0);
        let turning = fitted.get(2).filter(|turning| turning.value != 0.0);
        match fading.filter(|_| turning.is_none()) {
            // at the first row it is of no use to say how fast: what is lost in the end is what one sees
            Some(fading) => {
                let reading = rate.parameter.unit.strip_suffix("/h").unwrap_or(&rate.parameter.unit);
                let end = |value: f64| value / fading.value;
                let tau = rounded(HOUR / fading.value, "s");
                format!(
                    "the zero drifts by {} in the end, settling with a time constant of {tau}",
                    with_sd(end(rate.value), end(rate.sd), reading)
                )
            }
            None => {
                let turns = turning.map(|turning| {
                    let by = with_sd(turning.value, turning.sd, &turning.parameter.unit);
                    format!(" at the first row, and its speed changes by {by}")
                });
                format!("the zero drifts by {}{}", with_sd(rate.value, rate.sd, &rate.parameter.unit), turns.unwrap_or_default())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(name: &str, unit: &str, value: f64, sd: f64) -> FittedParameter {
        let parameter = Parameter::normal(name, unit, 0.0, 1.0, "");
        FittedParameter { parameter, value, sd, sd_of_fit: sd, at_limit: false }
    }

    /// 2 us/h that grow by 0.5 us/h each hour are 3 us/h after two hours: 5 us by then, and 4 without.
    #[test]
    fn a_drift_that_turns_is_a_parabola_and_told_as_one() {
        let turning = drift(&[2.0, 0.0, 0.5]);
        approx::assert_relative_eq!(turning.after(2.0), 5.0, max_relative = 1e-12);
        approx::assert_relative_eq!(drift(&[2.0, 0.0]).after(2.0), 4.0, max_relative = 1e-12);
        let told = [number("rate", "us/h", 2.0, 0.1), number("fading", "1/h", 0.0, 0.1), number(TURNING, "us/h^2", 0.5, 0.1)];
        assert_eq!(
            OffsetDrift.says(&told),
            "the zero drifts by 2.00 us/h (sd 0.10) at the first row, and its speed changes by 0.50 us/h^2 (sd 0.10)"
        );
    }

    /// 16 000 um/h that are gone after a second and a half are 7 um.
    #[test]
    fn a_drift_that_settles_is_told_by_where_it_settles() {
        let settles = [number("rate", "um/h", 16_000.0, 800.0), number("fading", "1/h", 2400.0, 100.0)];
        assert_eq!(
            OffsetDrift.says(&settles),
            "the zero drifts by 6.67 um (sd 0.33) in the end, settling with a time constant of 1.50 s"
        );
        let straight = [number("rate", "ns/h", 0.256, 0.044), number("fading", "1/h", 0.0, 0.0)];
        assert_eq!(OffsetDrift.says(&straight), "the zero drifts by 0.256 ns/h (sd 0.044)");
    }

    #[test]
    fn a_drift_that_fades_by_a_fifth_an_hour_stops_after_five_hours_of_it() {
        // the limit of (1 - exp(-k t)) / k is 1 / k; the series meets it where they change over
        approx::assert_abs_diff_eq!(drifted(1e4, 0.2), 5.0, epsilon = 1e-12);
        approx::assert_relative_eq!(drifted(1.0, 0.999_999e-8), drifted(1.0, 1.000_001e-8), max_relative = 1e-13);
    }
}
