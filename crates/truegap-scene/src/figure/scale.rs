//! Data units to pixels along one axis.

/// A linear or logarithmic axis over `pixels` user units.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    pub low: f64,
    pub high: f64,
    pub log: bool,
    pub pixels: f64,
    /// Pixels count from the far end (y axes).
    pub flipped: bool,
}

impl Scale {
    /// Pixel of `value`; NaN where the value has no place on the axis.
    pub fn at(&self, value: f64) -> f64 {
        let t = if self.log {
            if value <= 0.0 {
                return f64::NAN;
            }
            (value / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        };
        self.pixels * if self.flipped { 1.0 - t } else { t }
    }
}

/// Smallest and largest drawable value: finite, and positive on a logarithmic axis.
pub(super) fn extent(values: impl Iterator<Item = f64>, log: bool) -> Option<(f64, f64)> {
    values
        .filter(|v| v.is_finite() && (!log || *v > 0.0))
        .fold(None, |range, v| Some(range.map_or((v, v), |(low, high): (f64, f64)| (low.min(v), high.max(v)))))
}

/// `range` widened by `share` on both sides, and made an interval where it is a single value.
pub(super) fn padded((low, high): (f64, f64), share: f64, log: bool) -> (f64, f64) {
    if log {
        let factor = if low < high { (high / low).powf(share) } else { 2.0 };
        return (low / factor, high * factor);
    }
    let margin = if low < high {
        share * (high - low)
    } else if low == 0.0 {
        1.0
    } else {
        0.01 * low.abs()
    };
    (low - margin, high + margin)
}
