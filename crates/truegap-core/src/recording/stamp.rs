//! Dates as a clock, with or without a time of day: ISO 8601, with or without a zone, `01.03.2026 12:00:00` or `01.03.26 12:00:00`, where dots say that the day is first, and `01/03/2026`, where somebody has to say it.
//!
//! Limits: no leap seconds; without a zone the clock is taken to run through, so the hour that summer time takes or gives is seen as a pause or a step back.

use std::ops::RangeInclusive;

/// Seconds since 1970-01-01T00:00Z, whole and the rest, so that a microsecond is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stamp {
    pub seconds: i64,
    pub fraction: f64,
    /// whether a zone is written
    pub zoned: bool,
}

/// Which of day and month stands first in `01/03/2026`, and whether the year does in `26.03.01`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum First {
    #[default]
    Day,
    Month,
    Year,
}

/// Whether a cell is a date, whichever of day and month stands first.
pub(super) fn is_date(cell: &[u8]) -> bool {
    [First::Day, First::Month, First::Year].into_iter().any(|first| stamp(cell, first).is_some())
}

/// Whether a cell is a date without a time of day.
pub(super) fn is_day(cell: &[u8]) -> bool {
    is_date(cell) && !cell.contains(&b':')
}

/// Whether a cell is a time of day without a date.
pub(super) fn is_time_of_day(cell: &[u8]) -> bool {
    of_day(cell).is_some()
}

/// A time of day without a date, as one of the day 0; `None` for anything else.
pub(super) fn of_day(cell: &[u8]) -> Option<Stamp> {
    let text = std::str::from_utf8(cell).ok()?.trim();
    let (seconds, fraction, zoned) = time_of_day(text).filter(|_| text.contains(':'))?;
    Some(Stamp { seconds, fraction, zoned })
}

/// The numbers of a date that does not show its order, `[1, 3, 2026]` of `01/03/2026 12:00`; `None` for anything else.
pub(super) fn unordered(cell: &[u8]) -> Option<[i64; 3]> {
    let text = std::str::from_utf8(cell).ok()?.trim();
    let date = text.split(' ').next()?;
    ['/', '-'].into_iter().find_map(|sign| numbers(date, sign, [1..=2, 1..=2, 4..=4]))
}

/// The numbers of a date with two digits of a year between dots, `[26, 3, 1]` of `26.03.01 12:00`; `None` for anything else.
pub(super) fn short(cell: &[u8]) -> Option<[i64; 3]> {
    let text = std::str::from_utf8(cell).ok()?.trim();
    numbers(text.split(['T', 't', ' ']).next()?, '.', [2..=2, 2..=2, 2..=2])
}

/// `2026-03-01T12:00:00.250+01:00`, `2026/03/01 12:00`, `01.03.2026 12:00`, `3/1/2026 9:05 PM`; `None` for anything else.
pub(super) fn stamp(cell: &[u8], first: First) -> Option<Stamp> {
    let text = std::str::from_utf8(cell).ok()?.trim();
    let (date, rest) = text.split_at(text.find(['T', 't', ' ']).unwrap_or(text.len()));
    let year_first = |sign: char| numbers(date, sign, [4..=4, 2..=2, 2..=2]);
    let day_first = || numbers(date, '.', [2..=2, 2..=2, 4..=4]).map(|[day, month, year]| [year, month, day]);
    // two digits of a year between dots, 1970 to 2069; between other signs such a date could stand in any order
    let short = || {
        let [one, month, other] = short(cell)?;
        let (year, day) = if first == First::Year { (one, other) } else { (other, one) };
        Some([year + if year < 70 { 2000 } else { 1900 }, month, day])
    };
    let told = || {
        unordered(cell).map(|[one, other, year]| match first {
            First::Day | First::Year => [year, other, one],
            First::Month => [year, one, other],
        })
    };
    let [year, month, day] = year_first('-').or_else(|| year_first('/')).or_else(day_first).or_else(short).or_else(told)?;
    let (of_day, fraction, zoned) = time_of_day(rest.get(1..).unwrap_or_default())?;
    let possible = (1..=12).contains(&month) && (1..=length_of(year, month)).contains(&day);
    possible.then_some(Stamp { seconds: 86_400 * days(year, month, day) + of_day, fraction, zoned })
}

/// Seconds of a time of day, whole and the rest, less those of its zone, and whether that is written; midnight where there is none.
fn time_of_day(text: &str) -> Option<(i64, f64, bool)> {
    if text.is_empty() {
        return Some((0, 0.0, false));
    }
    let (text, half) = halved(text);
    let zone_at = text.find(['Z', 'z', '+', '-', ' ']).unwrap_or(text.len());
    let (time, zone) = text.split_at(zone_at);
    let (clock, fraction) = match time.split_once(['.', ',']) {
        Some((clock, digits)) if digits.bytes().all(|b| b.is_ascii_digit()) => (clock, format!("0.{digits}").parse().ok()?),
        Some(_) => return None,
        None => (time, 0.0),
    };
    let [hour, minute, second] =
        numbers(clock, ':', [1..=2, 2..=2, 2..=2]).or_else(|| numbers(clock, ':', [1..=2, 2..=2]).map(|[h, m]| [h, m, 0]))?;
    let hour = match half {
        None => hour,
        Some(_) if !(1..=12).contains(&hour) => return None,
        Some(half) => hour % 12 + half,
    };
    // 24:00 is the end of a day, and no minute of it is later
    let possible = (hour < 24 || (hour, minute, second) == (24, 0, 0)) && minute < 60 && second < 61;
    possible.then_some((3600 * hour + 60 * minute + second - offset(zone.trim())?, fraction, !zone.trim().is_empty()))
}

/// A time without `AM` or `PM`, and the hours that these add.
fn halved(text: &str) -> (&str, Option<i64>) {
    let ends = [("AM", 0), ("am", 0), ("PM", 12), ("pm", 12)];
    let found = ends.into_iter().find_map(|(end, hours)| Some((text.strip_suffix(end)?.trim_end(), Some(hours))));
    found.unwrap_or((text, None))
}

/// Numbers of so many digits with `sign` between them.
fn numbers<const N: usize>(text: &str, sign: char, digits: [RangeInclusive<usize>; N]) -> Option<[i64; N]> {
    let parts: Vec<&str> = text.split(sign).collect();
    let fits =
        |(part, digits): (&&str, RangeInclusive<usize>)| digits.contains(&part.len()) && part.bytes().all(|b| b.is_ascii_digit());
    if parts.len() != N || !parts.iter().zip(digits).all(fits) {
        return None;
    }
    let mut numbers = [0; N];
    for (number, part) in numbers.iter_mut().zip(parts) {
        *number = part.parse().ok()?;
    }
    Some(numbers)
}

/// Seconds that a zone is ahead of Greenwich: `Z`, `+01:00`, `-0530`, `+01`, or nothing.
fn offset(zone: &str) -> Option<i64> {
    if matches!(zone, "" | "Z" | "z" | "UTC" | "GMT") {
        return Some(0);
    }
    let sign = if zone.starts_with('-') { -1 } else { 1 };
    let digits = zone.strip_prefix(['+', '-'])?;
    let [hours, minutes] = numbers(digits, ':', [2..=2, 2..=2])
        .or_else(|| numbers(digits, ':', [4..=4]).map(|[both]| [both / 100, both % 100]))
        .or_else(|| numbers(digits, ':', [2..=2]).map(|[hours]| [hours, 0]))?;
    Some(sign * (3600 * hours + 60 * minutes))
}

/// Days of a month.
fn length_of(year: i64, month: i64) -> i64 {
    let next = if month == 12 { days(year + 1, 1, 1) } else { days(year, month + 1, 1) };
    next - days(year, month, 1)
}

/// Days from 1970-01-01 to a date of the Gregorian calendar: years begin in March, so that a leap day is a year's last.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let (year, month) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    365 * year + year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400) + (153 * month + 2) / 5 + day - 719_469
}

/// A time as text, `2026-03-01T12:00:00`; `fraction` in nanoseconds.
#[cfg(feature = "columnar")]
pub(super) fn iso(seconds: i64, nanoseconds: i64) -> String {
    let (days_since, of_day) = (seconds.div_euclid(86_400), seconds.rem_euclid(86_400));
    // no year after that of the date: a year has at most 366 days from 1970 on, and at least 365 back from it
    let guess = 1970 + days_since.div_euclid(if days_since < 0 { 365 } else { 366 });
    let year = (guess..).take_while(|year| days(*year, 1, 1) <= days_since).last().unwrap_or(guess);
    let month = (1..=12).take_while(|month| days(year, *month, 1) <= days_since).last().unwrap_or(1);
    let day = days_since - days(year, month, 1) + 1;
    let (hour, minute, second) = (of_day / 3600, of_day % 3600 / 60, of_day % 60);
    let fraction = format!(".{nanoseconds:09}");
    let fraction = fraction.trim_end_matches('0').trim_end_matches('.');
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}{fraction}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seconds as `date -u -d DATE +%s` of GNU coreutils gives them.
    #[test]
    fn a_date_is_a_number_of_seconds() {
        let cases = [
            ("1970-01-01T00:00:00Z", 0, 0.0),
            ("2000-02-29T12:00:00Z", 951_825_600, 0.0),
            ("2026-03-01T12:00:00.250+01:00", 1_772_362_800, 0.25),
            ("2026-03-01 12:00", 1_772_366_400, 0.0),
            ("2026-12-31T23:59:59,5-0530", 1_798_781_399, 0.5),
            ("01.03.2026 12:00:00", 1_772_366_400, 0.0),
            ("01.03.26 12:00:00", 1_772_366_400, 0.0),
            ("01.01.70", 0, 0.0),
            ("2026/03/01 12:00", 1_772_366_400, 0.0),
            ("1969-12-31 23:59:58 UTC", -2, 0.0),
            ("2026-03-01", 1_772_323_200, 0.0),
            ("01/03/2026 12:00", 1_772_366_400, 0.0),
            ("1/3/2026 9:05:00 PM", 1_772_399_100, 0.0),
            ("1/3/2026 12:05 am", 1_772_323_500, 0.0),
            ("01-03-2026", 1_772_323_200, 0.0),
        ];
        for (text, seconds, fraction) in cases {
            let found = stamp(text.as_bytes(), First::Day).map(|stamp| (stamp.seconds, stamp.fraction));
            assert_eq!(found, Some((seconds, fraction)), "{text}");
        }
    }

    #[test]
    fn anything_else_is_no_date() {
        for text in [
            "",
            "12:00:00",
            "12",
            "2026",
            "1/3/26 12:00",
            "13/13/2026 12:00",
            "01/03/2026 13:00 PM",
            "31.13.2026 12:00",
            "2026-02-29 12:00",
            "31.04.2026 12:00",
            "2026-03-01 24:00:01",
            "2026-13-01T00:00",
            "2026-03-01T12:00:00x",
            "2026-3-1 12:00",
            "0.5",
            "2026-03-01T1é:00",
        ] {
            assert_eq!(stamp(text.as_bytes(), First::Day), None, "{text}");
        }
    }

    #[cfg(feature = "columnar")]
    #[test]
    fn a_time_is_written_as_it_is_read() {
        for (text, nanoseconds) in
            [("2026-03-01T12:00:00.25", 250_000_000), ("2000-02-29T23:59:59", 0), ("1899-12-31T00:00:01", 0)]
        {
            let Stamp { seconds, .. } = stamp(text.as_bytes(), First::Day).unwrap();
            assert_eq!(iso(seconds, nanoseconds), text);
        }
    }

    #[test]
    fn the_month_stands_first_where_somebody_says_so() {
        let seconds = |first| stamp(b"01/03/2026 12:00", first).unwrap().seconds;
        assert_eq!((seconds(First::Day) - seconds(First::Month)) / 86_400, 31 + 28 - 2);
        assert_eq!(stamp(b"01/13/2026", First::Day), None);
        assert!(
            is_time_of_day(b" 12:00:01.5")
                && !is_time_of_day(b"2026-03-01 12:00")
                && !is_time_of_day(b"12")
                && !is_time_of_day(b"")
        );
        assert!(is_date(b"01/13/2026") && is_day(b"13/01/2026") && !is_day(b"2026-03-01 12:00") && !is_day(b"12"));
        assert_eq!(
            (unordered(b"1/13/2026 9:05"), unordered(b"2026-03-01"), unordered(b"01.03.2026")),
            (Some([1, 13, 2026]), None, None)
        );
    }
}
