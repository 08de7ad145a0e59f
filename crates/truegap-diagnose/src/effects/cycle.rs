//! The reading follows the time of day or of the year: something that was not recorded comes back with it.
//!
//! Limits: one shape for all days, of two waves, or of four where rows left out bear these out; periods of the sun only, since any other period is a tone.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::elapsed_s,
    },
    text::{rounded, with_sd},
};
use std::f64::consts::TAU;
use truegap_core::{Drive, EffectId, Inputs, Parameter, Readout, Stage, simulator::StageName};

/// A reading that comes back with the sun.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cycle {
    /// each day
    Daily,
    /// each year
    Yearly,
}

/// Why it is not looked for in a recording of hours.
pub const TOO_SHORT: &str = "the recording is too short, or its rows are too far apart, to show a cycle twice";

/// Periods that a recording must hold: each foretells the other, where rows are left out. A slow course that is taken for one of them does not.
const FEWEST_PERIODS: f64 = 2.0;

/// Rows that a period must hold.
const ROWS_A_PERIOD: f64 = 6.0;

impl Cycle {
    /// Period, s.
    fn period_s(self) -> f64 {
        match self {
            Self::Daily => 86_400.0,
            Self::Yearly => 365.2425 * 86_400.0,
        }
    }
    fn name(self) -> &'static str {
        match self {
            Self::Daily => "day",
            Self::Yearly => "year",
        }
    }
}

/// `size (cos(2 pi (t - highest) / T) + second cos(4 pi (t - second_highest) / T) + c3 cos(6 pi t / T) + s3 sin(6 pi t / T) + c4 cos(8 pi t / T) + s4 sin(8 pi t / T)) / 2`.
struct Waves {
    period_s: f64,
    /// whether `t` is counted from the begin of a day or year, and not from the first row
    dated: bool,
    size: f64,
    highest_s: f64,
    second: f64,
    second_highest_s: f64,
    /// `c3`, `s3`, `c4`, `s4`
    further: [f64; 4],
}

/// Numbers of a sharper day: waves of a third and of a quarter of the period, as shares of the first, by cosine and sine.
const FURTHER: [&str; 4] = ["third_cos", "third_sin", "fourth_cos", "fourth_sin"];

impl Waves {
    /// What the waves of a third and of a quarter of the period add where the first has turned by `angle`, over half the size.
    fn further(&self, angle: f64) -> f64 {
        if self.further == [0.0; 4] {
            return 0.0;
        }
        let [c3, s3, c4, s4] = self.further;
        let ((sin3, cos3), (sin4, cos4)) = ((3.0 * angle).sin_cos(), (4.0 * angle).sin_cos());
        c3 * cos3 + s3 * sin3 + c4 * cos4 + s4 * sin4
    }

    /// Time of a row, s.
    fn time_s(&self, inputs: &Inputs, row: usize) -> f64 {
        match (self.dated, inputs.began_s, &inputs.time_s) {
            // the begin of 1970 is the begin of a day and of a year
            (true, Some(began), Some(time)) => began.rem_euclid(self.period_s) + time[row],
            _ => elapsed_s(inputs, row),
        }
    }
}

impl Stage for Waves {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        for (row, value) in value.iter_mut().enumerate() {
            let turn = |from: f64| TAU * (self.time_s(drive.inputs, row) - from) / self.period_s;
            let two = turn(self.highest_s).cos() + self.second * (2.0 * turn(self.second_highest_s)).cos();
            *value += 0.5 * self.size * (two + self.further(turn(0.0)));
        }
    }
}

/// Sibling: half of the first wave is the sun by day and nothing by night, about its mean; the rest stays.
struct ByDay(Waves);

impl Stage for ByDay {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        for (row, value) in value.iter_mut().enumerate() {
            let turn = |from: f64| TAU * (self.0.time_s(drive.inputs, row) - from) / self.0.period_s;
            let first = turn(self.0.highest_s).cos();
            let by_day = first.max(0.0) - std::f64::consts::FRAC_1_PI;
            let second = self.0.second * (2.0 * turn(self.0.second_highest_s)).cos();
            *value += 0.5 * self.0.size * (by_day + 0.5 * first + second);
        }
    }
}

impl Effect for Cycle {
    fn id(&self) -> EffectId {
        EffectId(match self {
            Self::Daily => "daily_cycle",
            Self::Yearly => "yearly_cycle",
        })
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Environment
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Time, kinetics: Kinetics::Periodic })
    }
    fn about(&self) -> About {
        About {
            physics: match self {
                Self::Daily => {
                    "something that was not recorded follows the time of day: sunlight, the temperature of the room, people, the load of the mains"
                }
                Self::Yearly => "something that was not recorded follows the season: temperature, humidity, growth",
            },
            equation: "value = true + a / 2 (cos(2 pi (t - t1) / T) + b cos(4 pi (t - t2) / T)), and waves of T / 3 and T / 4 where rows left out bear them out, T a day or a year, t from midnight or the begin of the year; from the first row where the clock is no date",
            excitation: "two periods on one clock, six rows a period",
            impostors: &["temperature_coefficient", "thermal_lag", "driver_coefficient", "offset_drift", "gain_drift"],
            separates: "comes back with the sun whatever the recorded inputs do",
            source: "influence quantities, IEC 60359; the diurnal and annual harmonics of a record, Wilks, Statistical Methods in the Atmospheric Sciences, sec. 10.4",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let (unit, period) = (context.simulator.unit(), self.period_s());
        let from = match (self, context.moved.dated) {
            (_, false) => "from the first row",
            // the sun is at the same place then in every recording
            (Self::Daily, true) => "from midnight",
            (Self::Yearly, true) => "from the begin of the year",
        };
        let phase = |name: &str, period: f64, to: &str| {
            Parameter::normal(name, "s", 0.5 * period, 0.5 * period, &format!("{from} {to}")).within(-period, 2.0 * period)
        };
        vec![
            // a fifth of the days and a third of the years in recordings by other people are more than three times as large
            Parameter::wide("size", unit, 0.1 * context.response_span.abs(), "of the first wave, from its least to its most")
                .within(0.0, f64::INFINITY),
            phase("highest", period, "to where the first wave is highest"),
            Parameter::normal("second", "1", 0.0, 0.3, "size of the wave of half the period, as a share of the first")
                .within(-1.0, 1.0),
            phase("second_highest", 0.5 * period, "to where that wave is highest"),
        ]
        .into_iter()
        .chain(FURTHER.map(|name| {
            Parameter::normal(name, "1", 0.0, 0.2, "wave of a third or a quarter of the period, as a share of the first")
                .within(-1.0, 1.0)
        }))
        .collect()
    }
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        &[&FURTHER]
    }
    fn of_start(&self, context: &Context<'_>) -> &'static [&'static str] {
        if context.moved.dated { &[] } else { &["highest", "second_highest", FURTHER[0], FURTHER[1], FURTHER[2], FURTHER[3]] }
    }
    fn comes_back_s(&self) -> Option<f64> {
        Some(Self::period_s(*self))
    }
    fn by_date(&self) -> bool {
        true
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        let period = self.period_s();
        // from there the size and the phase of the second wave are found without a second minimum
        (0..6).map(|k| f64::from(k) * period / 6.0).map(|highest| vec![highest, 0.1, 0.5 * highest, 0.0, 0.0, 0.0, 0.0]).collect()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        context.needs_clock()?;
        let step = context.shortest_step_s.unwrap_or(f64::INFINITY);
        let held = context.duration_s >= FEWEST_PERIODS * self.period_s() && ROWS_A_PERIOD * step <= self.period_s();
        if held { Ok(()) } else { Err(TOO_SHORT.into()) }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(self.waves(values, context.moved.dated))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(ByDay(self.waves(values, context.moved.dated))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        self.sentence(fitted, false)
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        self.sentence(fitted, context.moved.dated)
    }
}

impl Cycle {
    fn sentence(self, fitted: &[FittedParameter], dated: bool) -> String {
        let unit = &fitted[0].parameter.unit;
        let at = fitted.get(1).map_or_else(String::new, |highest| format!(", highest {}", self.when(highest.value, dated)));
        format!(
            "the reading goes up and down with the time of the {} by {}{at}: something that was not recorded follows it",
            self.name(),
            with_sd(fitted[0].value, fitted[0].sd, unit)
        )
    }

    /// `at 14:20`, `191 days after the begin of the year`, `3.2 h after the first row`.
    fn when(self, highest_s: f64, dated: bool) -> String {
        let after_s = highest_s.rem_euclid(self.period_s());
        match (self, dated) {
            (_, false) => format!("{} after the first row", rounded(after_s, "s")),
            (Self::Daily, true) => {
                let minutes = (after_s / 60.0).round() as u32 % 1440;
                format!("at {:02}:{:02}", minutes / 60, minutes % 60)
            }
            (Self::Yearly, true) => format!("{:.0} days after the begin of the year", after_s / 86_400.0),
        }
    }

    fn waves(self, values: &[f64], dated: bool) -> Waves {
        let or = |index: usize, nothing: f64| values.get(index).copied().unwrap_or(nothing);
        Waves {
            period_s: self.period_s(),
            dated,
            size: values[0],
            highest_s: or(1, 0.0),
            second: or(2, 0.0),
            second_highest_s: or(3, 0.0),
            further: [4, 5, 6, 7].map(|index| or(index, 0.0)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn through(stage: &dyn Stage, hours: &[f64]) -> Vec<f64> {
        through_from(None, stage, hours)
    }

    fn through_from(began_s: Option<f64>, stage: &dyn Stage, hours: &[f64]) -> Vec<f64> {
        let times: Vec<f64> = hours.iter().map(|hour| 1000.0 + 3600.0 * hour).collect();
        let rows = times.len();
        let inputs = Inputs { began_s, time_s: Some(times), run: vec![1; rows], ..Inputs::default() };
        let still = vec![0.0; rows];
        let drive = Drive { inputs: &inputs, load: &still, temperature_c: &still, reference_c: 20.0, full_load: 1.0 };
        let mut value = vec![0.0; rows];
        stage.readout(&drive, &Readout { zero: 0.0, span: 1.0 }, &mut value);
        value
    }

    #[test]
    fn a_day_goes_from_its_least_to_its_most_and_comes_back() {
        let one_wave = Cycle::Daily.waves(&[4.0, 6.0 * 3600.0, 0.0, 0.0], false);
        let found = through(&one_wave, &[0.0, 6.0, 18.0, 30.0, 54.0]);
        [0.0, 2.0, -2.0, 2.0, 2.0]
            .iter()
            .zip(&found)
            .for_each(|(exact, found)| approx::assert_abs_diff_eq!(exact, found, epsilon = 1e-12));
        // a wave of half a day, highest at the third hour: half of 4 times 0.5
        let both = Cycle::Daily.waves(&[4.0, 6.0 * 3600.0, 0.5, 3.0 * 3600.0], false);
        let second = through(&both, &[0.0, 3.0, 9.0])
            .iter()
            .zip(through(&one_wave, &[0.0, 3.0, 9.0]))
            .map(|(a, b)| a - b)
            .collect::<Vec<_>>();
        [0.0, 1.0, -1.0]
            .iter()
            .zip(&second)
            .for_each(|(exact, found)| approx::assert_abs_diff_eq!(exact, found, epsilon = 1e-12));
    }

    /// Three cosines of a day's third wave in the first eight hours, one sine of its fourth in the first six; half of 4 times their shares.
    #[test]
    fn a_sharper_day_has_waves_of_a_third_and_of_a_quarter() {
        let added = |further: [f64; 4], hours: &[f64]| {
            let with = |further: [f64; 4]| {
                let values = [&[4.0, 6.0 * 3600.0, 0.5, 3.0 * 3600.0], further.as_slice()].concat();
                through(&Cycle::Daily.waves(&values, false), hours)
            };
            with(further).iter().zip(with([0.0; 4])).map(|(with, without)| with - without).collect::<Vec<_>>()
        };
        let close = |found: Vec<f64>, exact: &[f64]| {
            found.iter().zip(exact).for_each(|(found, exact)| approx::assert_abs_diff_eq!(found, exact, epsilon = 1e-12));
        };
        close(added([0.5, 0.0, 0.0, 0.0], &[0.0, 4.0, 8.0, 32.0]), &[1.0, -1.0, 1.0, 1.0]);
        close(added([0.0, 0.5, 0.0, 0.0], &[0.0, 2.0, 6.0]), &[0.0, 1.0, -1.0]);
        close(added([0.0, 0.0, 0.25, 0.5], &[0.0, 1.5, 3.0, 4.5]), &[0.5, 1.0, -0.5, -1.0]);
    }

    /// A second recording that begins at another time of day was given the phase of the first.
    #[test]
    fn by_its_dates_a_recording_has_the_phase_of_another_one() {
        let by_date = Cycle::Daily.waves(&[4.0, 14.0 * 3600.0, 0.0, 0.0], true);
        // `through` begins 1000 s after second 0; 2026-11-29 was day 20786
        let midnight = 20_786.0 * 86_400.0 - 1000.0;
        let from_noon = through_from(Some(midnight + 12.0 * 3600.0), &by_date, &[2.0, 14.0]);
        let from_six = through_from(Some(midnight + 6.0 * 3600.0), &by_date, &[8.0, 20.0]);
        for (at, exact) in [from_noon, from_six].iter().flatten().zip([2.0, -2.0, 2.0, -2.0]) {
            approx::assert_abs_diff_eq!(*at, exact, epsilon = 1e-6);
        }
    }

    /// The first harmonic of half a wave is half of the whole one.
    #[test]
    fn the_sibling_has_the_same_first_wave() {
        let hours: Vec<f64> = (0..240).map(|k| 0.1 * f64::from(k)).collect();
        let first = |values: &[f64]| {
            let wave = |k: usize| (TAU * (hours[k] - 6.0) / 24.0).cos();
            values.iter().enumerate().map(|(k, v)| v * wave(k)).sum::<f64>() * 2.0 / 240.0
        };
        let waves = || Cycle::Daily.waves(&[4.0, 6.0 * 3600.0, 0.0, 0.0], false);
        approx::assert_relative_eq!(first(&through(&waves(), &hours)), 2.0, max_relative = 1e-9);
        approx::assert_relative_eq!(first(&through(&ByDay(waves()), &hours)), 2.0, max_relative = 1e-3);
    }
}
