//! A simulation of the user's own that moves as the reading does, but a power of a thousand as far: a unit was mistaken.
//!
//! Limits: base models that are not scaled by the recording and whose own numbers cannot make the difference; a factor of ten or of sixty is not seen.

use crate::{
    data::problem::Problem,
    quality::{
        notice::{Notice, NoticeKind},
        tuning::{LEVEL_RANGE, LEVEL_SAMPLE, MOVES_WITH, POWER_OF_A_THOUSAND, REACHED_BY},
        wrong_sensor::correlation,
    },
    stats::spread,
    text::significant,
};

/// A notice where the base model moves a thousand (or a million) times as far as the reading, or the other way about.
pub fn wrong_unit(problem: &Problem<'_>) -> Option<Notice> {
    let simulator = problem.simulator;
    if simulator.knows_its_level() || !simulator.moves() || simulator.joined().is_some() {
        return None;
    }
    let stride = problem.response.len().div_ceil(LEVEL_SAMPLE).max(1);
    let keep: Vec<usize> = (0..problem.response.len()).step_by(stride).collect();
    let inputs = problem.inputs.select(&keep);
    let response: Vec<f64> = keep.iter().map(|row| problem.response[*row]).collect();
    let read = spread(&response);
    let centres = simulator.centre();
    let of = |values: &[f64]| simulator.respond(values, &inputs, &[]).ok();
    let foreseen = of(&centres)?;
    let ratio = read / spread(&foreseen);
    let power = [1e-6, 1e-3, 1e3, 1e6].into_iter().find(|power| (ratio / power - 1.0).abs() < POWER_OF_A_THOUSAND)?;
    if correlation(&response, &foreseen).abs() < MOVES_WITH {
        return None;
    }
    let reached = simulator.parameters().iter().enumerate().any(|(index, parameter)| {
        [-REACHED_BY, REACHED_BY].into_iter().any(|z| {
            let mut values = centres.clone();
            values[index] = parameter.prior.at(z).clamp(parameter.bounds.0, parameter.bounds.1);
            of(&values).is_some_and(|moved| (1.0 / LEVEL_RANGE..=LEVEL_RANGE).contains(&(read / spread(&moved))))
        })
    });
    let unit = simulator.unit();
    (!reached).then(|| Notice {
        kind: NoticeKind::WrongUnit,
        says: format!(
            "the readings move by {} {unit} and the simulation by {} {unit}, in the same way but a factor of {power:e} apart: a unit is mistaken; check those of the response, \
             of the inputs and of what the simulator answers in",
            significant(read, 3),
            significant(spread(&foreseen), 3)
        ),
        rows: Vec::new(),
        withholds: true,
    })
}
