//! Numbers as the tables show them.
//!
//! Limits: plain decimals, no powers of ten.

/// A number with three significant digits: `0.0763`, `1.02`, `26.6`, `120`.
pub(crate) fn three_digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let magnitude = |value: f64| value.abs().log10().floor() as i32;
    let decimals = |value: f64| usize::try_from(2 - magnitude(value)).unwrap_or(0);
    // 0.9996 has one digit less behind the point once it is rounded
    let rounded: f64 = format!("{value:.*}", decimals(value)).parse().unwrap_or(value);
    format!("{value:.*}", decimals(rounded))
}

/// A share in whole per cent, without the unit.
pub(crate) fn whole_percent(share: f64) -> String {
    let percent = (100.0 * share).round();
    // no minus before a zero
    format!("{:.0}", if percent == 0.0 { 0.0 } else { percent })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_are_three_digits() {
        let shown: Vec<String> = [0.076_281, 1.0243, 26.64, 119.7, 0.99961, 4321.0].into_iter().map(three_digits).collect();
        assert_eq!(shown, ["0.0763", "1.02", "26.6", "120", "1.00", "4321"]);
    }

    #[test]
    fn small_negative_shares_have_no_minus() {
        assert_eq!([-0.004, 0.004, -0.87, 0.5594].map(whole_percent), ["0", "0", "-87", "56"]);
    }
}
