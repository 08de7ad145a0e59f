//! Quantities as text: a number and a unit, to SI.

/// Kinds of quantity that a case holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dimension {
    /// Length (m).
    Length,
    /// Electric potential (V).
    Potential,
    /// Pressure or modulus (Pa).
    Pressure,
    /// Temperature difference (K).
    Temperature,
    /// Thermal expansion (1/K).
    Expansion,
    /// Temperature gradient (K/m).
    Gradient,
    /// Force (N).
    Force,
    /// Force per metre of depth (N/m).
    ForcePerDepth,
}

type Unit = (&'static str, f64);

const LENGTH: &[Unit] = &[("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("µm", 1e-6), ("μm", 1e-6), ("nm", 1e-9)];
const POTENTIAL: &[Unit] = &[("V", 1.0), ("kV", 1e3), ("mV", 1e-3), ("uV", 1e-6)];
const PRESSURE: &[Unit] = &[
    ("Pa", 1.0),
    ("kPa", 1e3),
    ("MPa", 1e6),
    ("GPa", 1e9),
    ("bar", 1e5),
    ("N/m2", 1.0),
    ("N/m^2", 1.0),
    ("N/mm2", 1e6),
    ("N/mm^2", 1e6),
];
const TEMPERATURE: &[Unit] = &[("K", 1.0), ("degC", 1.0), ("°C", 1.0), ("mK", 1e-3)];
const EXPANSION: &[Unit] = &[("/K", 1.0), ("1/K", 1.0), ("ppm/K", 1e-6), ("um/m/K", 1e-6), ("%/K", 1e-2)];
const GRADIENT: &[Unit] = &[("K/m", 1.0), ("K/cm", 1e2), ("K/mm", 1e3), ("K/um", 1e6), ("K/µm", 1e6)];
const FORCE: &[Unit] = &[("N", 1.0), ("kN", 1e3), ("mN", 1e-3), ("uN", 1e-6), ("µN", 1e-6)];
const FORCE_PER_DEPTH: &[Unit] = &[("N/m", 1.0), ("N/mm", 1e3), ("kN/m", 1e3), ("mN/m", 1e-3)];

impl Dimension {
    fn units(self) -> &'static [Unit] {
        match self {
            Dimension::Length => LENGTH,
            Dimension::Potential => POTENTIAL,
            Dimension::Pressure => PRESSURE,
            Dimension::Temperature => TEMPERATURE,
            Dimension::Expansion => EXPANSION,
            Dimension::Gradient => GRADIENT,
            Dimension::Force => FORCE,
            Dimension::ForcePerDepth => FORCE_PER_DEPTH,
        }
    }

    /// What it is called in messages.
    pub fn name(self) -> &'static str {
        match self {
            Dimension::Length => "a length with a unit",
            Dimension::Potential => "a potential with a unit",
            Dimension::Pressure => "a pressure or modulus with a unit",
            Dimension::Temperature => "a temperature difference with a unit",
            Dimension::Expansion => "a thermal expansion with a unit",
            Dimension::Gradient => "a temperature gradient with a unit",
            Dimension::Force => "a force with a unit",
            Dimension::ForcePerDepth => "a force per metre of depth with a unit",
        }
    }

    /// A good example.
    pub fn example(self) -> &'static str {
        match self {
            Dimension::Length => "5 um",
            Dimension::Potential => "1 V",
            Dimension::Pressure => "25 kPa",
            Dimension::Temperature => "30 K",
            Dimension::Expansion => "200 ppm/K",
            Dimension::Gradient => "1 K/m",
            Dimension::Force => "2 N",
            Dimension::ForcePerDepth => "2 N/m",
        }
    }
}

/// SI value of a text such as `"25 kPa"`, or `None` where it is not a finite number with a unit of that dimension.
pub(super) fn parse_quantity(text: &str, dimension: Dimension) -> Option<f64> {
    let text = text.trim();
    // The longest prefix that reads as a number: "5e-6 m", "1.43MPa", "-5 um".
    let number = text.char_indices().map(|(i, c)| i + c.len_utf8()).rev().find_map(|end| {
        let value = text[..end].trim_end().parse::<f64>().ok()?;
        Some((value, text[end..].trim()))
    });
    let (value, unit) = number.filter(|n| n.0.is_finite())?;
    // Dividing by the whole number rounds once: "-5 um" is -5e-6 to the last bit.
    unit_factor(unit, dimension).map(|factor| if factor < 1.0 { value / (1.0 / factor).round() } else { value * factor })
}

/// SI value of one `unit`.
pub(super) fn unit_factor(unit: &str, dimension: Dimension) -> Option<f64> {
    dimension.units().iter().find(|u| u.0 == unit).map(|u| u.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_need_their_unit() {
        assert_eq!(parse_quantity("25 kPa", Dimension::Pressure), Some(25e3));
        assert_eq!(parse_quantity("-5um", Dimension::Length), Some(-5e-6));
        assert_eq!(parse_quantity("200 ppm/K", Dimension::Expansion), Some(200e-6));
        assert_eq!(parse_quantity("1e-5 1/K", Dimension::Expansion), Some(1e-5));
        assert_eq!(parse_quantity("1.7e-5 /K", Dimension::Expansion), Some(1.7e-5));
        for bad in ["25", "kPa", "25 kp", "nan Pa", "inf Pa", "25 V", ""] {
            assert_eq!(parse_quantity(bad, Dimension::Pressure), None, "{bad}");
        }
    }
}
