//! A clock in two columns: days in one, times of day in the other.
//!
//! Limits: where one column alone holds days and one alone times of day; a table with more of them has to say which is the clock by joining two.

use super::heading::Heading;

/// The columns of days and of times of day, of which `index` is one, where there is one of each.
pub(super) fn date_and_time(header: &[Heading], index: usize) -> Option<(usize, usize)> {
    let only = |fits: fn(&Heading) -> bool| {
        let mut found = (0..header.len()).filter(|index| fits(&header[*index]));
        found.next().filter(|_| found.next().is_none())
    };
    let (days, times) = (only(|heading| heading.days)?, only(|heading| heading.of_day)?);
    (days == index || times == index).then_some((days, times))
}

/// What the two are called in messages, where a name stands in backquotes.
pub(super) fn joined(date: &str, time: &str) -> String {
    format!("{date}` and `{time}")
}
