//! A clock in two columns: days in one, times of day in the other. Times of day alone are a clock where no column holds dates; past midnight they go on.
//!
//! Limits: where one column alone holds days and one alone times of day; a table with more of them has to say which is the clock by joining two.

use super::heading::Heading;

/// Seconds of a day.
const DAY_S: i64 = 86_400;

/// Midnights that a clock of times of day has passed.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Midnights {
    /// time of day of the row before, s
    before_s: Option<i64>,
    days: i64,
}

impl Midnights {
    /// Whether the clock is one of times of day: of what day they are is not known.
    pub fn are_counted(&self) -> bool {
        self.before_s.is_some()
    }

    /// Seconds of the days that have passed until a row with this time of day: where it is earlier than that of the row before by more than half a day, a midnight has.
    pub fn passed(&mut self, of_day_s: i64) -> i64 {
        self.days += i64::from(self.before_s.is_some_and(|before| of_day_s + DAY_S / 2 < before));
        self.before_s = Some(of_day_s);
        DAY_S * self.days
    }
}

/// The columns of days and of times of day, of which `index` is one, where there is one of each.
pub(super) fn date_and_time(header: &[Heading], index: usize) -> Option<(usize, usize)> {
    let only = |fits: fn(&Heading) -> bool| {
        let mut found = (0..header.len()).filter(|index| fits(&header[*index]));
        found.next().filter(|_| found.next().is_none())
    };
    let (days, times) = (only(|heading| heading.days)?, only(|heading| heading.of_day)?);
    (days == index || times == index).then_some((days, times))
}

/// Takes the one column of times of day for a clock, where no column holds dates: what was recorded in less than a day needs none.
pub(super) fn times_without_dates(header: &mut [Heading]) {
    let dated = header.iter().any(|heading| heading.dated);
    let mut times = header.iter_mut().filter(|heading| heading.of_day && !dated);
    if let (Some(clock), None) = (times.next(), times.next()) {
        clock.dated = true;
    }
}

/// What the two are called in messages, where a name stands in backquotes.
pub(super) fn joined(date: &str, time: &str) -> String {
    format!("{date}` and `{time}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A clock that is put back by an hour passes no midnight; what is out of order by a row neither.
    #[test]
    fn a_midnight_is_passed_where_the_clock_falls_by_more_than_half_a_day() {
        let mut midnights = Midnights::default();
        assert!(!midnights.are_counted());
        let days = [86_390, 86_399, 1, 40_000, 36_400, 86_000, 3].map(|of_day| midnights.passed(of_day) / DAY_S);
        assert_eq!(days, [0, 0, 1, 1, 1, 1, 2]);
        assert!(midnights.are_counted());
    }

    #[test]
    fn times_of_day_are_a_clock_where_nothing_else_is() {
        let heading = |dated: bool, of_day: bool| Heading { dated, of_day, ..Heading::of("column") };
        let clocks = |mut header: Vec<Heading>| {
            times_without_dates(&mut header);
            header.into_iter().filter(|heading| heading.dated && heading.of_day).count()
        };
        assert_eq!(clocks(vec![heading(false, true), heading(false, false)]), 1);
        assert_eq!(clocks(vec![heading(false, true), heading(true, false)]), 0);
        assert_eq!(clocks(vec![heading(false, true), heading(false, true)]), 0);
    }
}
