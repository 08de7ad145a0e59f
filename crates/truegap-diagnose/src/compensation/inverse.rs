//! From a reading of the base model back to its input, row by row.
//!
//! Limits: a curve is inverted on the stretch about the middle of its span on which it does not turn back; a reading beyond that gets the input at its end.

use super::models::{Models, Reading};
use truegap_core::ends;

/// Cells into which the span of an input is cut where the stretch without a turn is looked for.
const CELLS: i32 = 50;
/// Cells that are looked at below and above the span: a reading may go a little beyond what was recorded when the model was made.
const BEYOND: [i32; 2] = [5, 10];
/// Most steps of one inversion; each halves the bracket of a row at least in every third step.
const STEPS: usize = 60;
/// Part of the range of the readings to which a reading is met.
const MET: f64 = 1e-11;

/// Where the input lay when the model was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// its beginning: no load, the least gap
    pub zero: f64,
    /// from there to its end
    pub width: f64,
    /// whether the model ends there as well, as a table does
    pub ends: bool,
}

/// How a reading leads to an input.
#[derive(Clone, Debug, PartialEq)]
pub enum Inverse {
    /// there is nothing to be estimated: the base model follows what is known
    Known,
    /// the base model is a straight line in its input
    Straight {
        /// reading of each row where the input is 0
        at_zero: Vec<f64>,
        /// change of the reading by a unit of the input
        slope: Vec<f64>,
    },
    /// the base model is a curve
    Curve {
        /// input of each row at the ends of the stretch without a turn
        ends: [Vec<f64>; 2],
        /// readings there
        readings: [Vec<f64>; 2],
        /// rows whose curve turns back inside of the span
        turns: usize,
    },
}

impl Inverse {
    /// Of a base model that is a straight line; `width` is the size of an input.
    ///
    /// # Errors
    /// Those of the base model.
    pub fn straight<E>(models: &Models<'_, E>, rows: usize, width: f64) -> Result<Self, E> {
        let at_zero = (models.base)(&vec![0.0; rows])?;
        let at_width = (models.base)(&vec![width; rows])?;
        let slope = at_width.iter().zip(&at_zero).map(|(far, near)| (far - near) / width).collect();
        Ok(Self::Straight { at_zero, slope })
    }

    /// Of a base model that is a curve, from the middle of `span` outwards to where it turns back, ends, or one of the two models has no answer.
    ///
    /// # Errors
    /// Those of the base model at the middle.
    pub fn curve<E>(models: &Models<'_, E>, rows: usize, span: Span) -> Result<Self, E> {
        let at = |cell: i32| span.zero + span.width * f64::from(cell) / f64::from(CELLS);
        let beyond = if span.ends { [0, 0] } else { BEYOND };
        let (middle, last) = (CELLS / 2, [-beyond[0], CELLS + beyond[1]]);
        let answer = |cell: i32| (models.base)(&vec![at(cell); rows]);
        let [below, above] = [answer(middle)?, answer(middle + 1)?];
        let rises: Vec<f64> = above.iter().zip(&below).map(|(above, below)| (above - below).signum()).collect();
        let mut turned = vec![false; rows];
        let mut outwards = |mut cell: i32, step: i32, start: Vec<f64>| {
            let (mut ends, mut readings, mut open) = (vec![at(cell); rows], start, vec![true; rows]);
            while cell != last[usize::from(step > 0)] && open.contains(&true) {
                cell += step;
                let answers = (models.augmented)(&vec![at(cell); rows]).and_then(|_| answer(cell));
                let Ok(next) = answers else { break };
                for row in 0..rows {
                    open[row] = open[row] && (next[row] - readings[row]) * f64::from(step) * rises[row] > 0.0;
                    if open[row] {
                        (ends[row], readings[row]) = (at(cell), next[row]);
                    } else if (0..=CELLS).contains(&cell) {
                        turned[row] = true;
                    }
                }
            }
            (ends, readings)
        };
        let (low, at_low) = outwards(middle, -1, below);
        let (high, at_high) = outwards(middle + 1, 1, above);
        let turns = turned.iter().filter(|turned| **turned).count();
        Ok(Self::Curve { ends: [low, high], readings: [at_low, at_high], turns })
    }

    /// Whether the base model moves with its input in any row.
    pub fn moves(&self) -> bool {
        match self {
            Self::Known => false,
            Self::Straight { slope, .. } => slope.iter().any(|slope| *slope != 0.0 && slope.is_finite()),
            Self::Curve { readings: [low, high], .. } => low.iter().zip(high).any(|(low, high)| low != high),
        }
    }

    /// Least and greatest reading that the base model gives over all rows; `None` where it gives any.
    pub fn gives(&self) -> Option<[f64; 2]> {
        let Self::Curve { readings: [low, high], .. } = self else { return None };
        Some(ends(low.iter().chain(high).copied()).into())
    }

    /// Rows whose reading is beyond what the base model gives there by more than `part` of its range.
    pub fn far_outside(&self, readings: &[f64], part: f64) -> usize {
        let Self::Curve { readings: [low, high], .. } = self else { return 0 };
        let is_far = |row: &usize| {
            let (least, most) = (low[*row].min(high[*row]), low[*row].max(high[*row]));
            let margin = part * (most - least);
            readings[*row] < least - margin || readings[*row] > most + margin
        };
        (0..readings.len()).filter(is_far).count()
    }

    /// Input of each row at which the base model gives these readings, and the number of rows that no input gives, which get the nearest.
    ///
    /// # Errors
    /// Those of the base model.
    pub fn input<E>(&self, base: &Reading<'_, E>, readings: &[f64]) -> Result<(Vec<f64>, usize), E> {
        match self {
            Self::Known => Ok((vec![0.0; readings.len()], 0)),
            Self::Straight { at_zero, slope } => {
                let input = |row: usize| if slope[row] == 0.0 { 0.0 } else { (readings[row] - at_zero[row]) / slope[row] };
                Ok(((0..readings.len()).map(input).collect(), 0))
            }
            Self::Curve { ends, readings: at, .. } => {
                let mut brackets: Vec<Bracket> = (0..readings.len())
                    .map(|row| Bracket::new([0, 1].map(|k| ends[k][row]), [0, 1].map(|k| at[k][row]), readings[row]))
                    .collect();
                let outside = brackets.iter().filter(|bracket| bracket.outside).count();
                for step in 0..STEPS {
                    if brackets.iter().all(|bracket| bracket.met) {
                        break;
                    }
                    let tried: Vec<f64> = brackets.iter().map(|bracket| bracket.next(step)).collect();
                    let found = base(&tried)?;
                    brackets.iter_mut().zip(&found).for_each(|(bracket, found)| bracket.narrow(step, *found));
                }
                Ok((brackets.iter().map(|bracket| bracket.best).collect(), outside))
            }
        }
    }
}

/// Two inputs of a row between which the reading lies: the false position of Illinois, halved in every third step.
///
/// **Source:** Dowell & Jarratt, BIT 11 (1971) 168.
struct Bracket {
    ends: [f64; 2],
    /// reading less the wanted one at both ends
    off: [f64; 2],
    /// which end was moved last
    moved: Option<usize>,
    wanted: f64,
    near: f64,
    best: f64,
    met: bool,
    outside: bool,
}

impl Bracket {
    fn new(ends: [f64; 2], readings: [f64; 2], wanted: f64) -> Self {
        let off = readings.map(|reading| reading - wanted);
        let nearest = usize::from(off[1].abs() < off[0].abs());
        let outside = off[0] * off[1] > 0.0;
        let near = MET * (readings[1] - readings[0]).abs();
        // a reading that is no number has no input, and is left to whoever gave it
        let met = outside || off[nearest].abs() <= near || off[0].is_nan();
        Self { ends, off, moved: None, wanted, near, best: ends[nearest], met, outside }
    }

    fn next(&self, step: usize) -> f64 {
        if self.met {
            return self.best;
        }
        let [low, high] = self.ends;
        let false_position = (low * self.off[1] - high * self.off[0]) / (self.off[1] - self.off[0]);
        if step % 3 == 2 || !false_position.is_finite() { 0.5 * (low + high) } else { false_position }
    }

    fn narrow(&mut self, step: usize, reading: f64) {
        if self.met {
            return;
        }
        let (tried, off) = (self.next(step), reading - self.wanted);
        let side = usize::from(off * self.off[0] <= 0.0);
        (self.ends[side], self.off[side]) = (tried, off);
        if self.moved == Some(side) {
            self.off[1 - side] *= 0.5;
        }
        (self.moved, self.best) = (Some(side), tried);
        self.met = off.abs() <= self.near || self.ends[0] == self.ends[1];
    }
}
