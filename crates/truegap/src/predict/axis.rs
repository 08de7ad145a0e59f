//! Values along an axis, as text: `4.5 N`, `0, 1, 4.5 N`, `0:4.5 N:10` (ten values, both ends included).
//!
//! Limits: commas separate values, so decimal signs are points; a value without a unit takes that of the next one that has a unit.

use truegap_core::units::{self, Dimension, UnitError};

/// Why a text is not a list of values.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum AxisError {
    /// A value is not a quantity.
    #[error("in `{text}`: {source}")]
    Value { text: String, source: UnitError },
    /// A range is not first:last:count.
    #[error("`{text}` is not a range; write first:last:count with a count from 2 to {MOST}, as in `0:4.5 N:10`")]
    Range { text: String },
    /// More values than one command answers.
    #[error("{values} values and more, and a list has at most {MOST}; ask for fewer, or in several commands")]
    TooMany { values: usize },
}

/// Most values that one list may have, ranges included.
const MOST: usize = 1_000_000;

/// Values of a text, SI (degrees Celsius for temperatures).
///
/// # Errors
/// [`AxisError`] where a number, a unit or a count is missing or wrong.
pub fn values(text: &str, dimension: Dimension) -> Result<Vec<f64>, AxisError> {
    let items: Vec<&str> = text.split(',').collect();
    let mut unit = String::new();
    let mut backwards = Vec::new();
    for item in items.into_iter().rev() {
        let mut found = item_values(item, dimension, &mut unit)?;
        if backwards.len() + found.len() > MOST {
            return Err(AxisError::TooMany { values: backwards.len() + found.len() });
        }
        found.reverse();
        backwards.extend(found);
    }
    backwards.reverse();
    Ok(backwards)
}

/// Values of one item; `unit` is what an item further right used, and is set to what this one uses.
fn item_values(item: &str, dimension: Dimension, unit: &mut String) -> Result<Vec<f64>, AxisError> {
    let parts: Vec<&str> = item.split(':').map(str::trim).collect();
    match parts.as_slice() {
        [value] => Ok(vec![quantity(value, dimension, unit)?]),
        [first, last, count] => {
            let wrong = || AxisError::Range { text: item.trim().to_owned() };
            let end = count.find(|c: char| !c.is_ascii_digit()).unwrap_or(count.len());
            let behind = count[end..].trim();
            if !behind.is_empty() {
                behind.clone_into(unit);
            }
            let count: usize = count[..end].parse().ok().filter(|n| (2..=MOST).contains(n)).ok_or_else(wrong)?;
            let last = quantity(last, dimension, unit)?;
            let first = quantity(first, dimension, unit)?;
            let step = (last - first) / (count - 1) as f64;
            let value = |k: usize| if k + 1 == count { last } else { first + step * k as f64 };
            Ok((0..count).map(value).collect())
        }
        _ => Err(AxisError::Range { text: item.trim().to_owned() }),
    }
}

fn quantity(text: &str, dimension: Dimension, unit: &mut String) -> Result<f64, AxisError> {
    let bare = text.parse::<f64>().is_ok();
    let whole = if bare && !unit.is_empty() { format!("{text} {unit}") } else { text.to_owned() };
    if !bare {
        *unit = text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.eE".contains(c)).trim().to_owned();
    }
    units::parse(&whole, dimension).map_err(|source| AxisError::Value { text: text.to_owned(), source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_lists_and_ranges_are_read() {
        let newtons = |text| values(text, Dimension::Force).unwrap();
        assert_eq!(newtons("4.5 N"), [4.5]);
        assert_eq!(newtons("0,1,4.5 N"), [0.0, 1.0, 4.5]);
        assert_eq!(newtons("500 mN, 1 N"), [0.5, 1.0]);
        for text in ["0:4.5 N:4", "0 N:4.5 N:4", "0:4.5:4 N"] {
            assert_eq!(newtons(text), [0.0, 1.5, 3.0, 4.5], "{text}");
        }
        assert_eq!(newtons("0:1:3, 4.5 N"), [0.0, 0.5, 1.0, 4.5]);
        assert_eq!(values("-10:50 degC:3", Dimension::Temperature).unwrap(), [-10.0, 20.0, 50.0]);
        assert_eq!(values("293.15 K, 20 degC", Dimension::Temperature).unwrap()[1], 20.0);
    }

    #[test]
    fn what_is_wrong_is_told() {
        let told = |text| values(text, Dimension::Force).unwrap_err().to_string();
        assert!(told("4.5").contains("has no unit"));
        assert!(told("4.5 pF").contains("`pF`"));
        assert!(told("1,,2 N").contains("number"));
        assert!(told("0:1 N:1").contains("from 2 to 1000000"));
        assert!(told("0:1 N").contains("first:last:count"));
        assert!(told("0:1 N:99999999").contains("count"));
        assert!(told("0:1 N:600000, 1:2 N:600000").contains("at most 1000000"));
    }
}
