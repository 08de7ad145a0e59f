//! A base model that foresees something else altogether: another sensor, another unit, another column.
//!
//! Limits: only models that are not scaled by the recording itself; physics that is left out changes a reading by less than is asked here.

use crate::{
    data::problem::Problem,
    quality::notice::{Notice, NoticeKind},
    quality::tuning::{ALIKE, FAR_FROM_PRIOR, LEVEL_RANGE, LEVEL_SAMPLE, LOADED, MOVES_WITH, OFF_BY, POWER_OF_A_THOUSAND},
    stats::{median, spread},
    text::Scale,
};
use truegap_core::Parameter;

/// A notice where recording and base model do not belong together.
pub fn wrong_sensor(problem: &Problem<'_>) -> Option<Notice> {
    if !problem.simulator.knows_its_level() {
        return None;
    }
    // medians and ranges need no more rows than this, however long the recording
    let stride = problem.response.len().div_ceil(LEVEL_SAMPLE);
    let keep: Vec<usize> = (0..problem.response.len()).step_by(stride.max(1)).collect();
    let (inputs, response) = (problem.inputs.select(&keep), keep.iter().map(|row| problem.response[*row]).collect::<Vec<_>>());
    let problem = &Problem { inputs: &inputs, response: &response, simulator: problem.simulator };
    let foreseen = problem.simulator.respond(&problem.simulator.centre(), problem.inputs, &[]).ok()?;
    let (level, range) = (level(problem, &foreseen), range(problem, &foreseen));
    // another sensor, unit or column moves otherwise as well; a level alone may be a capacitance beside the sensor
    let withholds = range.is_some() || !moves_alike(problem, &foreseen);
    let mut says = format!("{}; check --sensor, the response's column and its unit", level.or(range)?);
    if !withholds {
        says +=
            "; since the readings move as they should, the diagnosis takes the difference for something that is added to them";
    }
    Some(Notice { kind: NoticeKind::WrongSensor, says, rows: Vec::new(), withholds })
}

/// Whether the readings move as far as foreseen, and with it, under a load that says something.
fn moves_alike(problem: &Problem<'_>, foreseen: &[f64]) -> bool {
    let loaded = problem.simulator.load(problem.inputs).is_some_and(|load| spread(&load) > LOADED);
    let ratio = spread(problem.response) / spread(foreseen);
    loaded && (1.0 / ALIKE..=ALIKE).contains(&ratio) && correlation(problem.response, foreseen) > MOVES_WITH
}

fn level(problem: &Problem<'_>, foreseen: &[f64]) -> Option<String> {
    let (read, expected) = (median(problem.response), median(foreseen));
    let sd = tolerance(problem, expected);
    let off = (read - expected).abs();
    let text = |v: f64| Scale::of(problem.simulator.unit(), v.abs()).text(v);
    (off > FAR_FROM_PRIOR * sd + OFF_BY * expected.abs()).then(|| {
        let ratio = read / expected;
        let unit = [1e-6, 1e-3, 1e3, 1e6].iter().any(|power| (ratio / power - 1.0).abs() < POWER_OF_A_THOUSAND);
        let hint = if unit { ", a power of a thousand apart" } else { "" };
        format!(
            "the recording does not look like this sensor: half of the readings lie above {}, where the sensor's file foresees {} (its tolerances \
             allow {} either way){hint}",
            text(read),
            text(expected),
            text(2.0 * sd)
        )
    })
}

fn range(problem: &Problem<'_>, foreseen: &[f64]) -> Option<String> {
    problem.simulator.load(problem.inputs).filter(|load| spread(load) > LOADED)?;
    let (read, expected) = (spread(problem.response), spread(foreseen));
    let text = |v: f64| Scale::of(problem.simulator.unit(), v.abs()).text(v);
    let told =
        || format!("the readings move by {}, where the sensor's file foresees {} for what was done", text(read), text(expected));
    if expected > 0.0 && read > 0.0 && !(1.0 / LEVEL_RANGE..=LEVEL_RANGE).contains(&(read / expected)) {
        return Some(format!("the recording does not look like this sensor: {}", told()));
    }
    (correlation(problem.response, foreseen) < -0.7)
        .then(|| format!("the readings fall where the sensor's file foresees that they rise ({})", told()))
}

/// Standard deviation that the tolerances of the file give the median reading.
fn tolerance(problem: &Problem<'_>, expected: f64) -> f64 {
    let centres = problem.simulator.centre();
    let moved = |(index, p): (usize, &Parameter)| {
        let mut values = centres.clone();
        values[index] = (values[index] + p.sd()).clamp(p.bounds.0, p.bounds.1);
        let there = problem.simulator.respond(&values, problem.inputs, &[]).ok()?;
        Some((median(&there) - expected).powi(2))
    };
    problem.simulator.parameters().iter().enumerate().filter_map(moved).sum::<f64>().sqrt()
}

/// Of two columns of one length; 0 where one does not move.
pub(super) fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len() as f64;
    let mean = |c: &[f64]| c.iter().sum::<f64>() / n;
    let (ma, mb) = (mean(a), mean(b));
    let sum = |x: &[f64], mx: f64, y: &[f64], my: f64| x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).sum::<f64>();
    let both = sum(a, ma, a, ma) * sum(b, mb, b, mb);
    if both > 0.0 { sum(a, ma, b, mb) / both.sqrt() } else { 0.0 }
}
