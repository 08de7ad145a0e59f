//! Rows that are not whole, and rows of one instant: counted, so that a reader is told, and too many refused.
//!
//! Limits: counts; what becomes of the rows is for whoever reads them.

use super::{error::RecordingError, note::Note};
use std::path::PathBuf;

/// Part of the rows that may go.
const MOST_GONE: f64 = 0.5;

/// What was not taken as it stands.
#[derive(Clone, Debug, Default)]
pub(super) struct Gone {
    /// rows without a value, and the line (or what stands for it) of the first
    empty: Option<(usize, usize)>,
    /// columns without a value in one of them
    columns: Vec<String>,
    /// rows with the time of the row before, and the line of the first
    again: Option<(usize, usize)>,
}

impl Gone {
    /// A row without a value in `column`.
    pub fn empty(&mut self, column: &str, line: usize) {
        self.empty = Some(self.empty.map_or((1, line), |(rows, first)| (rows + 1, first)));
        if self.columns.iter().all(|known| known != column) {
            self.columns.push(column.to_owned());
        }
    }

    /// A row with the time of the row before.
    pub fn again(&mut self, line: usize) {
        self.again = Some(self.again.map_or((1, line), |(rows, first)| (rows + 1, first)));
    }

    /// The lines of the first rows of both kinds, as `line_of` finds them.
    ///
    /// # Errors
    /// That of `line_of`.
    pub fn find_lines(&mut self, mut line_of: impl FnMut(usize) -> Result<usize, RecordingError>) -> Result<(), RecordingError> {
        for (_, line) in [&mut self.empty, &mut self.again].into_iter().flatten() {
            *line = line_of(*line)?;
        }
        Ok(())
    }

    /// These, and those of a table that was read later.
    pub fn and(mut self, later: Self) -> Self {
        let sum = |a: Option<(usize, usize)>, b: Option<(usize, usize)>| match (a, b) {
            (Some((rows, line)), Some((more, _))) => Some((rows + more, line)),
            (one, other) => one.or(other),
        };
        let new: Vec<String> = later.columns.into_iter().filter(|column| !self.columns.contains(column)).collect();
        self.columns.extend(new);
        Self { empty: sum(self.empty, later.empty), again: sum(self.again, later.again), columns: self.columns }
    }

    /// Refuses a table of which less than half would be left; `taken` rows were.
    ///
    /// # Errors
    /// [`RecordingError::FewWhole`], [`RecordingError::FewInstants`].
    pub fn check(&self, file: PathBuf, taken: usize) -> Result<(), RecordingError> {
        let (empty, again) = (self.empty.map_or(0, |(rows, _)| rows), self.again.map_or(0, |(rows, _)| rows));
        let rows = taken + empty + again;
        let most = MOST_GONE * rows as f64;
        match (self.empty, self.again) {
            (Some((gone, line)), _) if gone as f64 > most => {
                Err(RecordingError::FewWhole { file, gone, rows, columns: format!("`{}`", self.named()), line })
            }
            (_, Some((gone, line))) if gone as f64 > most => Err(RecordingError::FewInstants { file, gone, rows, line }),
            _ => Ok(()),
        }
    }

    /// What is told of both.
    pub fn notes(&self) -> impl Iterator<Item = Note> {
        let column = self.named();
        let empty = self.empty.map(|(rows, first_line)| Note::RowsWithoutValue { column, rows, first_line });
        let again = self.again.map(|(rows, first_line)| Note::RowsOfOneInstant { rows, first_line });
        empty.into_iter().chain(again)
    }

    fn named(&self) -> String {
        self.columns.join("`, `")
    }
}

/// Whether a unit is one of an angle, which begins anew after a turn.
pub(super) fn is_angle(unit: &str) -> bool {
    matches!(
        unit.trim().to_ascii_lowercase().as_str(),
        "deg"
            | "degree"
            | "degrees"
            | "°"
            | "rad"
            | "radian"
            | "radians"
            | "gon"
            | "turn"
            | "turns"
            | "rev"
            | "revolution"
            | "revolutions"
    )
}

/// Means of the rows of an instant, as they come in.
#[derive(Clone, Debug, Default)]
pub(super) struct Instant {
    /// rows that are in the mean beside the first
    more: usize,
}

impl Instant {
    /// The next instant begins.
    pub fn next(&mut self) {
        self.more = 0;
    }

    /// One more row of this instant.
    pub fn again(&mut self) {
        self.more += 1;
    }

    /// The mean, with one more value in it.
    pub fn mean(&self, so_far: f64, value: f64) -> f64 {
        so_far + (value - so_far) / (self.more as f64 + 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_than_half_is_refused_and_half_is_not() {
        let mut gone = Gone::default();
        (0..10).for_each(|line| gone.empty(if line < 5 { "force_n" } else { "cap" }, line + 2));
        gone.check("r.csv".into(), 10).unwrap();
        let refused = gone.check("r.csv".into(), 9).unwrap_err().to_string();
        assert!(
            refused.contains("10 of 19 rows") && refused.contains("`force_n`, `cap`") && refused.contains("line 2"),
            "{refused}"
        );
        let mut gone = Gone::default();
        (0..3).for_each(|line| gone.again(line + 5));
        let refused = gone.check("r.csv".into(), 2).unwrap_err().to_string();
        assert!(refused.contains("3 of 5 rows") && refused.contains("line 5"), "{refused}");
    }

    #[test]
    fn the_mean_of_an_instant_is_that_of_its_rows() {
        let (values, mut instant, mut mean) = ([3.0, 5.0, 10.0, -2.0], Instant::default(), 3.0);
        for value in &values[1..] {
            instant.again();
            mean = instant.mean(mean, *value);
        }
        assert!((mean - 4.0).abs() < 1e-12, "{mean}");
    }
}
