//! Loggers as they are: what a measuring chain adds to a recording in which nothing is missing.
//!
//! Limits: one trouble a logger, at the sizes of ordinary instruments; none of it is physics of the sensor.

use crate::draws::Draws;
use crate::noise::Noise;
use crate::recording::Recording;
use serde::{Deserialize, Serialize};

/// Standard deviation of the reading's own noise, pF.
const SD_PF: f64 = 0.004;

/// What is the matter with the measuring chain; load has 5 mN and temperature 30 mK of white noise besides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Logger {
    /// White noise, nothing else.
    White,
    /// Time stamps wrong by up to a tenth of a step.
    JitteredStamps,
    /// Time stamps rounded to the power of ten below the shortest step.
    RoundedStamps,
    /// Converter of 12 bits over 10 pF.
    ConverterFine,
    /// Converter of 12 bits over 100 pF: steps of six standard deviations of the noise.
    ConverterCoarse,
    /// Noise that grows with the reading above its least value.
    Proportional,
    /// Heavy tails: Student's t with three degrees of freedom.
    StudentT,
    /// 1/f noise: one autoregressive part a factor of four in time, all of one size.
    Flicker,
    /// Autoregressive noise, 0.9 from row to row.
    Autoregressive,
    /// The mains as the sampling folds it: a tone, one and a half standard deviations high.
    AliasedMains,
    /// One reading in a hundred off by 0.1 to 1 pF.
    LargeSpikes,
    /// One reading in thirty off by 5 to 10 standard deviations.
    SmallSpikes,
    /// Rows that repeat the one before them, two to eight at a time.
    StuckRows,
    /// Thermometer in steps of 0.5 K.
    TemperatureHalf,
    /// Thermometer in steps of 0.25 K.
    TemperatureQuarter,
    /// Thermometer in steps of 0.1 K.
    TemperatureTenth,
    /// Thermometer in steps of 0.0625 K.
    TemperatureSixteenth,
    /// Load cell in steps of 50 mN.
    LoadFifty,
    /// Load cell in steps of 20 mN.
    LoadTwenty,
    /// Load cell in steps of 5 mN.
    LoadFive,
    /// Load in steps of 20 mN and temperature in steps of 0.5 K.
    LoadAndTemperature,
    /// One row in thirty is lost, and two stretches of a fiftieth of the recording each.
    LostRows,
}

impl Logger {
    /// All of them.
    pub const ALL: [Self; 21] = [
        Self::White,
        Self::JitteredStamps,
        Self::RoundedStamps,
        Self::ConverterFine,
        Self::ConverterCoarse,
        Self::Proportional,
        Self::StudentT,
        Self::Flicker,
        Self::Autoregressive,
        Self::AliasedMains,
        Self::LargeSpikes,
        Self::SmallSpikes,
        Self::StuckRows,
        Self::TemperatureHalf,
        Self::TemperatureQuarter,
        Self::TemperatureTenth,
        Self::TemperatureSixteenth,
        Self::LoadFifty,
        Self::LoadTwenty,
        Self::LoadFive,
        Self::LoadAndTemperature,
    ];

    /// Those that a wild study draws from: what ordinary benches do, in no order of merit.
    pub const WILD: [Self; 14] = [
        Self::White,
        Self::ConverterCoarse,
        Self::Proportional,
        Self::StudentT,
        Self::Flicker,
        Self::Autoregressive,
        Self::AliasedMains,
        Self::LargeSpikes,
        Self::SmallSpikes,
        Self::StuckRows,
        Self::TemperatureQuarter,
        Self::LoadTwenty,
        Self::LostRows,
        Self::JitteredStamps,
    ];

    /// Name in files and tables.
    pub fn name(self) -> String {
        serde_json::to_value(self).ok().and_then(|v| v.as_str().map(str::to_owned)).unwrap_or_default()
    }

    /// The noise of inputs and reading that this logger adds by itself.
    pub fn noise(self) -> Noise {
        let (coloured_share, correlation) = if self == Self::Autoregressive { (1.0, 0.9) } else { (0.0, 0.0) };
        Noise { sd_pf: SD_PF, coloured_share, correlation, force_n: 0.005, temperature_k: 0.03 }
    }

    /// Steps of load (N) and temperature (K); 0 where they are fine.
    fn steps(self) -> (f64, f64) {
        match self {
            Self::TemperatureHalf => (0.0, 0.5),
            Self::TemperatureQuarter => (0.0, 0.25),
            Self::TemperatureTenth => (0.0, 0.1),
            Self::TemperatureSixteenth => (0.0, 0.0625),
            Self::LoadFifty => (0.05, 0.0),
            Self::LoadTwenty => (0.02, 0.0),
            Self::LoadFive => (0.005, 0.0),
            Self::LoadAndTemperature => (0.02, 0.5),
            _ => (0.0, 0.0),
        }
    }

    /// A recording with the noise of [`Logger::noise`] as this logger writes it down; `truth_pf` are the readings without noise.
    pub fn written(self, mut recording: Recording, truth_pf: &[f64], draws: &mut Draws) -> Recording {
        let (load, kelvin) = self.steps();
        in_steps(&mut recording.force_n, load);
        in_steps(&mut recording.temperature_c, kelvin);
        self.stamps(&mut recording.time_s, draws);
        self.reading(&mut recording.capacitance_pf, truth_pf, draws);
        if self == Self::StuckRows {
            stick(&mut recording, draws);
        }
        if self == Self::LostRows {
            lose(&mut recording, draws);
        }
        recording
    }

    fn stamps(self, time_s: &mut [f64], draws: &mut Draws) {
        match self {
            Self::JitteredStamps => {
                let step = shortest(time_s);
                time_s.iter_mut().for_each(|t| *t += step * draws.between(0.0, 0.1));
            }
            Self::RoundedStamps => in_steps(time_s, 10f64.powf(shortest(time_s).log10().floor())),
            _ => {}
        }
    }

    fn reading(self, reading: &mut [f64], truth_pf: &[f64], draws: &mut Draws) {
        let least = truth_pf.iter().copied().fold(f64::INFINITY, f64::min);
        match self {
            Self::ConverterFine => in_steps(reading, 10.0 / 4096.0),
            Self::ConverterCoarse => in_steps(reading, 100.0 / 4096.0),
            Self::Proportional => {
                let more = |truth: f64| 4e-3 * (truth - least);
                reading.iter_mut().zip(truth_pf).for_each(|(r, t)| *r += more(*t) * draws.normal());
            }
            Self::StudentT => {
                // a t variable of three degrees of freedom has the variance 3
                let t = |draws: &mut Draws| {
                    let squares: f64 = (0..3).map(|_| draws.normal().powi(2)).sum();
                    draws.normal() / (squares / 3.0).sqrt()
                };
                reading.iter_mut().zip(truth_pf).for_each(|(r, truth)| *r = truth + SD_PF * t(draws) / 3f64.sqrt());
            }
            Self::Flicker => reading.iter_mut().zip(flicker(truth_pf.len(), draws)).for_each(|(r, n)| *r += SD_PF * n),
            Self::AliasedMains => {
                let (pace, phase) = (draws.between(0.05, 0.45), draws.between(0.0, std::f64::consts::TAU));
                let tone = |row: usize| 1.5 * SD_PF * (std::f64::consts::TAU * pace * row as f64 + phase).sin();
                reading.iter_mut().enumerate().for_each(|(row, r)| *r += tone(row));
            }
            Self::LargeSpikes => spikes(reading, 0.01, (0.1, 1.0), draws),
            Self::SmallSpikes => spikes(reading, 1.0 / 30.0, (5.0 * SD_PF, 10.0 * SD_PF), draws),
            _ => {}
        }
    }
}

/// Shortest step of a clock.
fn shortest(time_s: &[f64]) -> f64 {
    time_s.windows(2).map(|t| t[1] - t[0]).fold(f64::INFINITY, f64::min)
}

/// Rounds to multiples of `step`, where there is one.
fn in_steps(column: &mut [f64], step: f64) {
    if step > 0.0 {
        column.iter_mut().for_each(|v| *v = (*v / step).round() * step);
    }
}

/// Noise with a spectrum like 1/f, of unit variance: autoregressive parts with memories of 1, 4, 16, ... 4096 rows.
fn flicker(rows: usize, draws: &mut Draws) -> Vec<f64> {
    const PARTS: usize = 7;
    let memory: Vec<f64> = (0..PARTS).map(|k| (-(0.25f64).powi(k as i32)).exp()).collect();
    let mut state: Vec<f64> = memory.iter().map(|_| draws.normal()).collect();
    (0..rows)
        .map(|_| {
            for (s, m) in state.iter_mut().zip(&memory) {
                *s = m * *s + (1.0 - m * m).sqrt() * draws.normal();
            }
            state.iter().sum::<f64>() / (PARTS as f64).sqrt()
        })
        .collect()
}

/// Adds spikes of either sign to a share of the readings.
fn spikes(reading: &mut [f64], share: f64, (least, most): (f64, f64), draws: &mut Draws) {
    for r in reading {
        if draws.chance(share) {
            *r += draws.sign() * draws.log_between(least, most);
        }
    }
}

/// Makes one row in sixty the first of two to eight that repeat the row before them, in every column but the clock; not across runs.
fn stick(recording: &mut Recording, draws: &mut Draws) {
    let mut row = 1;
    while row < recording.run.len() {
        if draws.chance(1.0 / 60.0) {
            let last = (row + 2 + draws.index(7)).min(recording.run.len());
            while row < last && recording.run[row] == recording.run[row - 1] {
                recording.force_n[row] = recording.force_n[row - 1];
                recording.temperature_c[row] = recording.temperature_c[row - 1];
                recording.capacitance_pf[row] = recording.capacitance_pf[row - 1];
                row += 1;
            }
        }
        row += 1;
    }
}

/// Takes away one row in thirty and two stretches of a fiftieth of the rows.
fn lose(recording: &mut Recording, draws: &mut Draws) {
    let rows = recording.run.len();
    let stretches = [0, 1].map(|_| draws.index(rows));
    let lost = |row: usize, draws: &mut Draws| {
        stretches.iter().any(|start| (*start..start + rows / 50).contains(&row)) || draws.chance(1.0 / 30.0)
    };
    let keep: Vec<usize> = (0..rows).filter(|row| !lost(*row, draws)).collect();
    let kept = |values: &mut Vec<f64>| *values = keep.iter().map(|row| values[*row]).collect();
    recording.run = keep.iter().map(|row| recording.run[*row]).collect();
    kept(&mut recording.time_s);
    kept(&mut recording.force_n);
    kept(&mut recording.temperature_c);
    kept(&mut recording.capacitance_pf);
    recording.humidity_pct.iter_mut().for_each(kept);
    recording.driver.iter_mut().for_each(|driver| kept(&mut driver.values));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recorded(rows: usize) -> (Recording, Vec<f64>) {
        let truth: Vec<f64> = (0..rows).map(|i| 200.0 + 0.01 * i as f64).collect();
        let recording = Recording {
            run: vec![1; rows],
            time_s: (0..rows).map(|i| 0.5 * i as f64).collect(),
            force_n: (0..rows).map(|i| 1e-3 * i as f64).collect(),
            temperature_c: (0..rows).map(|i| 20.0 + 0.01 * i as f64).collect(),
            humidity_pct: None,
            driver: None,
            capacitance_pf: truth.clone(),
            warp: true,
        };
        (recording, truth)
    }

    #[test]
    fn a_column_in_steps_lies_within_half_a_step_of_itself_and_on_few_values() {
        let (recording, truth) = recorded(1000);
        let written = Logger::LoadAndTemperature.written(recording.clone(), &truth, &mut Draws::of(1, "test"));
        for (a, b) in written.force_n.iter().zip(&recording.force_n) {
            assert!((a - b).abs() < 0.01 + 1e-12);
        }
        let mut values = written.temperature_c;
        values.dedup();
        // 10 K in steps of 0.5 K
        assert_eq!(values.len(), 21);
    }

    /// 200 000 rows: the variance of noise with a memory of 4096 rows is good to some 10 %.
    #[test]
    fn flicker_has_unit_variance_and_equal_power_in_each_octave() {
        let noise = flicker(200_000, &mut Draws::of(5, "test"));
        let variance = |x: &[f64]| x.iter().map(|v| v * v).sum::<f64>() / x.len() as f64;
        assert!((variance(&noise) - 1.0).abs() < 0.15, "{}", variance(&noise));
        // differences over n rows of 1/f noise grow by the same amount for each factor of four
        let grown = |n: usize| noise.windows(n + 1).map(|w| (w[n] - w[0]).powi(2)).sum::<f64>() / noise.len() as f64;
        let (first, second) = (grown(16) - grown(4), grown(64) - grown(16));
        assert!((first / second - 1.0).abs() < 0.2, "{first} {second}");
    }

    #[test]
    fn lost_rows_leave_the_others_as_they_were() {
        let (recording, truth) = recorded(3000);
        let written = Logger::LostRows.written(recording.clone(), &truth, &mut Draws::of(3, "test"));
        let left = written.run.len();
        // a thirtieth of 3000 is 100, give or take 30; the stretches are 60 rows each and may overlap or end with the recording
        assert!((2750..2950).contains(&left), "{left}");
        assert!(written.time_s.windows(2).all(|t| t[1] > t[0]) && written.capacitance_pf.len() == left);
        // the clock of the test is half a second a row
        assert!((0..left).all(|row| written.force_n[row] == recording.force_n[(2.0 * written.time_s[row]) as usize]));
    }

    #[test]
    fn rows_that_stick_repeat_all_but_the_clock() {
        let (recording, truth) = recorded(3000);
        let written = Logger::StuckRows.written(recording.clone(), &truth, &mut Draws::of(2, "test"));
        let repeats = |c: &[f64]| c.windows(2).filter(|w| w[0] == w[1]).count();
        let stuck = repeats(&written.capacitance_pf);
        // one row in sixty starts five repeats on average
        assert!((100..400).contains(&stuck), "{stuck}");
        assert_eq!(stuck, repeats(&written.force_n));
        assert_eq!(written.time_s, recording.time_s);
    }
}
