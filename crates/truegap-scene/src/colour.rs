//! Colours that people with any colour vision can tell apart, as sRGB for figures and as linear light for glTF.
//!
//! A colour map is a short list of stops with sRGB interpolation between them; it is meant for reading values to about one
//! part in twenty, not for measuring them.

/// An opaque sRGB colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rgb {
    /// Red, sRGB-encoded, 0 to 255.
    pub red: u8,
    /// Green, sRGB-encoded, 0 to 255.
    pub green: u8,
    /// Blue, sRGB-encoded, 0 to 255.
    pub blue: u8,
}

impl Rgb {
    /// The colour written `0xRRGGBB`.
    pub const fn hex(code: u32) -> Self {
        let [_, red, green, blue] = code.to_be_bytes();
        Self { red, green, blue }
    }

    /// `#rrggbb`, as CSS and SVG write it.
    pub(crate) fn css(self) -> String {
        format!("#{:02x}{:02x}{:02x}", self.red, self.green, self.blue)
    }

    /// Linear-light components in 0 to 1, as glTF wants them for factors and vertex colours.
    ///
    /// **Source:** IEC 61966-2-1 transfer function.
    pub fn linear(self) -> [f32; 3] {
        [self.red, self.green, self.blue].map(|c| {
            let c = f64::from(c) / 255.0;
            let light = if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
            light as f32
        })
    }

    /// Whether dark text reads better than white text on this colour (relative luminance above 0.30).
    pub(crate) fn wants_dark_text(self) -> bool {
        let [r, g, b] = self.linear();
        0.2126 * r + 0.7152 * g + 0.0722 * b > 0.30
    }

    fn mix(self, other: Self, t: f64) -> Self {
        let blend = |a: u8, b: u8| (f64::from(a) + t * (f64::from(b) - f64::from(a))).round() as u8;
        Self { red: blend(self.red, other.red), green: blend(self.green, other.green), blue: blend(self.blue, other.blue) }
    }
}

/// Series colours: the Okabe-Ito set without yellow (unreadable on white) and with grey for black, most distinct first.
///
/// **Source:** M. Okabe, K. Ito, "Color universal design" (2008).
pub const PALETTE: [Rgb; 7] = [
    Rgb::hex(0x0072B2),
    Rgb::hex(0xD55E00),
    Rgb::hex(0x009E73),
    Rgb::hex(0xCC79A7),
    Rgb::hex(0x56B4E9),
    Rgb::hex(0xE69F00),
    Rgb::hex(0x767676),
];

/// How a number becomes a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColourMap {
    /// Dark violet to yellow, evenly rising lightness: for amounts.
    Sequential,
    /// Blue through near-white to brown, centred on zero: for differences.
    Diverging,
}

/// Viridis at 0, 0.1, ..., 1. **Source:** S. van der Walt, N. Smith, matplotlib's viridis (CC0).
const VIRIDIS: [u32; 11] =
    [0x440154, 0x482475, 0x414487, 0x355F8D, 0x2A788E, 0x21918C, 0x22A884, 0x44BF70, 0x7AD151, 0xBDDF26, 0xFDE725];
/// Blue and orange-brown arms of matching lightness.
const BLUE_BROWN: [u32; 9] = [0x0B2F5B, 0x22619E, 0x5B9BCB, 0xADD0E6, 0xF5F5F3, 0xF8C39B, 0xE08A45, 0xAF5310, 0x662C05];

impl ColourMap {
    /// The stops, evenly spaced from 0 to 1.
    pub fn stops(self) -> Vec<Rgb> {
        match self {
            Self::Sequential => VIRIDIS.iter().map(|&code| Rgb::hex(code)).collect(),
            Self::Diverging => BLUE_BROWN.iter().map(|&code| Rgb::hex(code)).collect(),
        }
    }

    /// The colour at `t` in 0 to 1; outside of it the end colours, which callers have to name in their legend.
    pub fn at(self, t: f64) -> Rgb {
        let stops = self.stops();
        let place = t.clamp(0.0, 1.0) * (stops.len() - 1) as f64;
        let below = (place.floor() as usize).min(stops.len() - 2);
        stops[below].mix(stops[below + 1], place - below as f64)
    }

    /// The interval that the map spans for data from `low` to `high`: symmetric about zero for [`ColourMap::Diverging`].
    pub fn span(self, low: f64, high: f64) -> (f64, f64) {
        let (low, high) = match self {
            Self::Sequential => (low, high),
            Self::Diverging => (-low.abs().max(high.abs()), low.abs().max(high.abs())),
        };
        if low < high { (low, high) } else { (low - 0.5, high + 0.5) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_light_agrees_with_tabulated_srgb_values() {
        // Middle grey 188 has the linear value 0.5029 (IEC 61966-2-1); four digits are tabulated.
        assert!((Rgb::hex(0xBCBCBC).linear()[0] - 0.5029).abs() < 1e-4);
        assert_eq!(Rgb::hex(0xFF0000).linear(), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn the_sequential_map_gets_lighter_all_the_way() {
        let lightness = |t: f64| {
            let [r, g, b] = ColourMap::Sequential.at(t).linear();
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let steps: Vec<f32> = (0..=50).map(|i| lightness(f64::from(i) / 50.0)).collect();
        assert!(steps.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn the_diverging_map_is_symmetric_about_zero() {
        assert_eq!(ColourMap::Diverging.span(-1.0, 3.0), (-3.0, 3.0));
        assert_eq!(ColourMap::Diverging.at(0.5), Rgb::hex(0xF5F5F3));
    }
}
