//! Round tick positions and their labels.
//!
//! Labels never lose the digits that tell two ticks apart: a common power of ten or a common offset moves to the axis title
//! where the labels would grow too long.

use super::scale::Scale;

/// Ticks of one axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ticks {
    /// Labelled positions in data units.
    pub major: Vec<(f64, String)>,
    /// Positions without label.
    pub minor: Vec<f64>,
    /// `10⁻⁶`-like factor of the labels, or empty.
    pub factor: String,
    /// Value that the labels count from, as text, or empty.
    pub offset: String,
    /// Factor and offset as numbers: a label is `(value - from) / times`.
    pub counts: Counts,
}

/// What the labels of an axis count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Counts {
    pub times: f64,
    pub from: f64,
}

impl Ticks {
    /// Ticks for `scale`, about `wanted` of them.
    pub fn new(scale: &Scale, wanted: usize) -> Self {
        if scale.log && scale.high / scale.low > 8.0 { decades(scale) } else { even(scale.low, scale.high, wanted) }
    }

    /// Axis title with unit, factor and offset.
    pub fn title(&self, label: &str, unit: &str) -> String {
        let from = if self.offset.is_empty() { String::new() } else { format!(" \u{2212} {}", self.offset) };
        let unit = match (self.factor.is_empty(), unit.is_empty()) {
            (true, true) => String::new(),
            (true, false) => format!(" ({unit})"),
            (false, true) => format!(" (×{})", self.factor),
            (false, false) => format!(" (×{} {unit})", self.factor),
        };
        format!("{label}{from}{unit}")
    }
}

/// 1, 2 or 5 times a power of ten, not below `raw`.
fn round_step(raw: f64) -> f64 {
    let power = 10f64.powf(raw.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|step| *step >= raw * 0.999_999).unwrap_or(10.0 * power)
}

/// Step and multiples of it inside the range: about `wanted` of them, at least three.
fn even_places(low: f64, high: f64, wanted: usize) -> (f64, Vec<f64>) {
    let places = |count: usize| {
        let step = round_step((high - low) / count as f64);
        let (first, last) = ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor());
        (step, (0..=(last - first).max(0.0) as usize).map(|i| (first + i as f64) * step).collect::<Vec<_>>())
    };
    let wanted = wanted.max(2);
    (wanted..wanted + 6).map(places).find(|(_, all)| all.len() > 2).unwrap_or_else(|| places(wanted))
}

fn even(low: f64, high: f64, wanted: usize) -> Ticks {
    let (step, places) = even_places(low, high, wanted);
    let largest = low.abs().max(high.abs());
    let exponent = if (1e-3..1e5).contains(&largest) { 0 } else { 3 * (largest.log10() / 3.0).floor() as i32 };
    let factor = 10f64.powi(exponent);
    let decimals = decimals_of(step / factor);
    let whole = (largest / factor).log10().floor().max(0.0) as usize + 1;
    let offset = if decimals + whole > 7 { places.first().copied().unwrap_or(0.0) } else { 0.0 };
    if offset != 0.0 {
        return counted_from(offset, &places, step);
    }
    Ticks {
        major: places.iter().map(|&v| (v, fixed(v / factor, decimals))).collect(),
        minor: Vec::new(),
        factor: power_of_ten(exponent),
        offset: String::new(),
        counts: Counts { times: factor, from: 0.0 },
    }
}

/// Labels as differences from `offset`, for axes whose span is tiny beside their values.
fn counted_from(offset: f64, places: &[f64], step: f64) -> Ticks {
    let span = step * places.len() as f64;
    let exponent = if (1e-3..1e5).contains(&span) { 0 } else { 3 * (span.log10() / 3.0).floor() as i32 };
    let factor = 10f64.powi(exponent);
    let decimals = decimals_of(step / factor);
    Ticks {
        major: places.iter().enumerate().map(|(i, &v)| (v, fixed(i as f64 * step / factor, decimals))).collect(),
        minor: Vec::new(),
        factor: power_of_ten(exponent),
        offset: fixed(offset, decimals_of(step)),
        counts: Counts { times: factor, from: offset },
    }
}

fn decades(scale: &Scale) -> Ticks {
    let (first, last) = (scale.low.log10().floor() as i32, scale.high.log10().ceil() as i32);
    let inside = |v: &f64| (scale.low * 0.999_999..=scale.high * 1.000_001).contains(v);
    let few = scale.high / scale.low < 300.0;
    let stride = ((last - first) / 10).max(1);
    let plain = scale.low >= 0.99e-3 && scale.high < 1e5;
    let multiples: &[f64] = if few { &[1.0, 2.0, 5.0] } else { &[1.0] };
    let major = (first..=last)
        .filter(|k| k.rem_euclid(stride) == 0)
        .flat_map(|k| multiples.iter().map(move |&m| (m * 10f64.powi(k), log_label(m, k, plain))))
        .filter(|(v, _)| inside(v))
        .collect();
    let minor = if last - first > 8 {
        Vec::new()
    } else {
        (first..=last).flat_map(|k| (2..10).map(move |m| f64::from(m) * 10f64.powi(k))).filter(inside).collect()
    };
    Ticks { major, minor, factor: String::new(), offset: String::new(), counts: Counts { times: 1.0, from: 0.0 } }
}

fn log_label(multiple: f64, exponent: i32, plain: bool) -> String {
    match (plain, multiple == 1.0) {
        (true, _) => fixed(multiple * 10f64.powi(exponent), exponent.min(0).unsigned_abs() as usize),
        (false, true) if exponent == 0 => "1".into(),
        (false, true) => power_of_ten(exponent),
        (false, false) => format!("{}·{}", fixed(multiple, 0), power_of_ten(exponent)),
    }
}

fn decimals_of(step: f64) -> usize {
    (-(step.log10() + 1e-9).floor()).max(0.0) as usize
}

/// `value` with a true minus sign.
pub(super) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| c == '0' || c == '.') => rest.to_owned(),
        Some(rest) => format!("\u{2212}{rest}"),
        None => text,
    }
}

/// `value` with three significant digits.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let magnitude = value.abs().log10().floor() as i32;
    if (-3..5).contains(&magnitude) {
        return fixed(value, (2 - magnitude).max(0) as usize);
    }
    format!("{}·{}", fixed(value / 10f64.powi(magnitude), 2), power_of_ten(magnitude))
}

/// `10⁻⁶`, or nothing for exponent 0.
fn power_of_ten(exponent: i32) -> String {
    if exponent == 0 {
        return String::new();
    }
    let text = exponent.to_string();
    let digits = text.chars().map(|c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => char::from_u32('⁰' as u32 + c as u32 - '0' as u32).unwrap_or(c),
    });
    format!("10{}", digits.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64) -> (Vec<String>, Ticks) {
        let ticks = even(low, high, 5);
        (ticks.major.iter().map(|(_, label)| label.clone()).collect(), ticks)
    }

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(labels(-0.3, 4.1).0, ["0", "1", "2", "3", "4"]);
        assert_eq!(labels(-0.25, 0.21).0, ["\u{2212}0.2", "\u{2212}0.1", "0.0", "0.1", "0.2"]);
    }

    #[test]
    fn small_values_share_a_power_of_ten_in_the_title() {
        let (text, ticks) = labels(0.0, 4.0e-6);
        assert_eq!(text, ["0", "1", "2", "3", "4"]);
        assert_eq!(ticks.title("charge", "C"), "charge (×10⁻⁶ C)");
    }

    #[test]
    fn a_tiny_span_on_a_large_value_counts_from_an_offset() {
        let (text, ticks) = labels(123_456.000_1, 123_456.000_5);
        assert_eq!(ticks.major.len(), text.len());
        assert!(ticks.offset.starts_with("123456.000"), "{ticks:?}");
        let distinct: std::collections::BTreeSet<_> = text.iter().collect();
        assert_eq!(distinct.len(), text.len());
    }

    #[test]
    fn short_logarithmic_axes_are_labelled_at_one_two_five() {
        let ticks = Ticks::new(&Scale { low: 0.02, high: 1.1, log: true, pixels: 1.0, flipped: false }, 5);
        let text: Vec<_> = ticks.major.iter().map(|(_, label)| label.as_str()).collect();
        assert_eq!(text, ["0.02", "0.05", "0.1", "0.2", "0.5", "1"]);
    }

    #[test]
    fn wide_logarithmic_axes_are_labelled_by_decade() {
        let ticks = Ticks::new(&Scale { low: 2e-6, high: 3e2, log: true, pixels: 1.0, flipped: false }, 5);
        let text: Vec<_> = ticks.major.iter().map(|(_, label)| label.as_str()).collect();
        assert_eq!(text, ["10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "1", "10¹", "10²"]);
    }
}
