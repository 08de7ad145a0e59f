//! Dates with a time of day as a clock: ISO 8601, with or without a zone, and `01.03.2026 12:00:00`, where dots say that the day is first.
//!
//! Limits: `01/03/2026` may be January or March and is none; no leap seconds; without a zone the clock is taken to run through, so the hour that summer time takes or gives is seen as a pause or a step back.

/// Seconds since 1970-01-01T00:00Z, whole and the rest, so that a microsecond is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stamp {
    pub seconds: i64,
    pub fraction: f64,
}

/// `2026-03-01T12:00:00.250+01:00`, `2026/03/01 12:00`, `01.03.2026 12:00`; `None` for anything else.
pub(super) fn stamp(cell: &[u8]) -> Option<Stamp> {
    let text = std::str::from_utf8(cell).ok()?.trim();
    let (date, rest) = text.split_at_checked(10)?;
    let year_first = |sign: char| numbers(date, sign, [4, 2, 2]);
    let day_first = || numbers(date, '.', [2, 2, 4]).map(|[day, month, year]| [year, month, day]);
    let [year, month, day] = year_first('-').or_else(|| year_first('/')).or_else(day_first)?;
    let rest = rest.strip_prefix(['T', 't', ' '])?;
    let zone_at = rest.find(['Z', 'z', '+', '-', ' ']).unwrap_or(rest.len());
    let (time, zone) = rest.split_at(zone_at);
    let (clock, fraction) = match time.split_once(['.', ',']) {
        Some((clock, digits)) if digits.bytes().all(|b| b.is_ascii_digit()) => (clock, format!("0.{digits}").parse().ok()?),
        Some(_) => return None,
        None => (time, 0.0),
    };
    let [hour, minute, second] =
        numbers(clock, ':', [2, 2, 2]).or_else(|| numbers(clock, ':', [2, 2]).map(|[h, m]| [h, m, 0]))?;
    let possible = (1..=12).contains(&month) && (1..=31).contains(&day) && hour < 25 && minute < 60 && second < 61;
    let seconds = 86_400 * days(year, month, day) + 3600 * hour + 60 * minute + second - offset(zone.trim())?;
    possible.then_some(Stamp { seconds, fraction })
}

/// Numbers of so many digits with `sign` between them.
fn numbers<const N: usize>(text: &str, sign: char, digits: [usize; N]) -> Option<[i64; N]> {
    let parts: Vec<&str> = text.split(sign).collect();
    let fits = |(part, digits): (&&str, usize)| part.len() == digits && part.bytes().all(|b| b.is_ascii_digit());
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
    let [hours, minutes] = numbers(digits, ':', [2, 2])
        .or_else(|| numbers(digits, ':', [4]).map(|[both]| [both / 100, both % 100]))
        .or_else(|| numbers(digits, ':', [2]).map(|[hours]| [hours, 0]))?;
    Some(sign * (3600 * hours + 60 * minutes))
}

/// Days from 1970-01-01 to a date of the Gregorian calendar: years begin in March, so that a leap day is a year's last.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let (year, month) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    365 * year + year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400) + (153 * month + 2) / 5 + day - 719_469
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
            ("2026/03/01 12:00", 1_772_366_400, 0.0),
            ("1969-12-31 23:59:58 UTC", -2, 0.0),
        ];
        for (text, seconds, fraction) in cases {
            assert_eq!(stamp(text.as_bytes()), Some(Stamp { seconds, fraction }), "{text}");
        }
    }

    #[test]
    fn anything_else_is_no_date() {
        for text in [
            "",
            "12:00:00",
            "2026-03-01",
            "01/03/2026 12:00",
            "31.13.2026 12:00",
            "2026-13-01T00:00",
            "2026-03-01T12:00:00x",
            "2026-3-1 12:00",
            "0.5",
            "2026-03-01T1é:00",
        ] {
            assert_eq!(stamp(text.as_bytes()), None, "{text}");
        }
    }
}
