//! Dates with two digits of a year between dots, `26.03.01`: does the day stand first, or the year?
//!
//! Limits: one column; where both can be, the order in which time runs on, by steps that are much smaller, is taken.

use super::stamp::{First, short, stamp};

/// Parts by which the largest step of one order is smaller than that of the other, where it is taken.
const MUCH_SMALLER: f64 = 3.0;

/// What such dates have shown in one order.
#[derive(Clone, Copy, Debug)]
struct Read {
    /// whether all can be dates
    possible: bool,
    /// whether time runs on
    forwards: bool,
    /// largest step, s
    largest: f64,
    last: Option<f64>,
}

/// What such dates of a column have shown.
#[derive(Clone, Debug)]
pub(super) struct ShortYears {
    /// with the day first, and with the year first
    orders: [(First, Read); 2],
    /// the first date, and the place of its row
    first: Option<([i64; 3], String, u64)>,
    /// whether another day came after it
    several: bool,
}

impl Default for ShortYears {
    fn default() -> Self {
        let read = Read { possible: true, forwards: true, largest: 0.0, last: None };
        Self { orders: [(First::Day, read), (First::Year, read)], first: None, several: false }
    }
}

impl ShortYears {
    pub fn see(&mut self, cell: &[u8], place: u64) {
        let Some(date) = short(cell) else { return };
        match &self.first {
            None => self.first = Some((date, String::from_utf8_lossy(cell).trim().to_owned(), place)),
            Some((first, ..)) => self.several |= *first != date,
        }
        for (order, read) in &mut self.orders {
            let Some(stamp) = stamp(cell, *order) else {
                read.possible = false;
                continue;
            };
            let now = stamp.seconds as f64 + stamp.fraction;
            let step = now - read.last.replace(now).unwrap_or(now);
            read.forwards &= step >= 0.0;
            read.largest = read.largest.max(step);
        }
    }

    /// The order; the first date and its place where nothing shows it; `None` where there are no such dates.
    pub fn order(self, told: Option<bool>) -> Option<Result<First, (String, u64)>> {
        let (_, text, place) = self.first?;
        let [(_, day), (_, year)] = self.orders;
        let ran = |read: Read| read.possible && read.forwards;
        let steps = |one: Read, other: Read| MUCH_SMALLER * one.largest < other.largest;
        Some(match (told, day.possible, year.possible) {
            (Some(true), ..) | (None, true, false) => Ok(First::Day),
            (Some(false), ..) | (None, false, true) => Ok(First::Year),
            (None, false, false) => Ok(First::Day), // refused where the row is read
            _ if !self.several => Ok(First::Day),
            _ if ran(day) && (!ran(year) || steps(day, year)) => Ok(First::Day),
            _ if ran(year) && (!ran(day) || steps(year, day)) => Ok(First::Year),
            _ => Err((text, place)),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_column_says_whether_day_or_year_stands_first() {
        let order = |cells: &[&str], told: Option<bool>| {
            let mut seen = ShortYears::default();
            cells.iter().enumerate().for_each(|(at, cell)| seen.see(cell.as_bytes(), at as u64));
            seen.order(told).map(|order| order.ok())
        };
        let (day, year) = (Some(Some(First::Day)), Some(Some(First::Year)));
        for (cells, wanted) in [
            (&["26.03.01 23:30", "26.03.02 00:00"][..], year),
            (&["26.03.31 23:30", "26.04.01 00:00"], year),
            (&["99.03.01", "99.03.02"], year),
            (&["01.03.26 23:30", "02.03.26 00:00"], day),
            (&["31.03.26", "01.04.26"], day),
            (&["28.02.99", "01.03.99"], day),
            (&["26.03.01 12:00", "26.03.01 13:00"], day),
            (&["01.01.02", "01.02.02", "01.03.02"], Some(None)),
            (&["2026-03-01"], None),
        ] {
            assert_eq!(order(cells, None), wanted, "{cells:?}");
        }
        assert_eq!(order(&["01.01.02", "01.02.02"], Some(false)), year);
        assert_eq!(order(&["01.01.02", "01.02.02"], Some(true)), day);
    }
}
