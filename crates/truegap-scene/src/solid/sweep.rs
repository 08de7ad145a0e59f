//! How far around the axis a section is turned.

use super::error::SolidError;

/// Angle and fineness of a turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sweep {
    /// Angle turned through, degrees: 360 for a full solid, 270 to cut a quarter out.
    pub degrees: f64,
    /// Segments of a full turn.
    pub segments: usize,
}

impl Sweep {
    /// A full turn in 96 segments.
    pub const FULL: Self = Self { degrees: 360.0, segments: 96 };
    /// A quarter cut out, open towards the viewer (+Z).
    pub const CUT_AWAY: Self = Self { degrees: 270.0, segments: 96 };

    /// Whether the solid closes on itself.
    pub(crate) fn is_full(self) -> bool {
        self.degrees == 360.0
    }

    pub(super) fn check(self) -> Result<(), SolidError> {
        let fine = self.degrees > 0.0 && self.degrees <= 360.0 && self.segments >= 8;
        fine.then_some(()).ok_or(SolidError::Sweep { degrees: self.degrees, segments: self.segments })
    }

    /// Angles of the rings, radians about +Y from +X; a full turn does not repeat its first. The gap is centred on +Z.
    pub(super) fn angles(self) -> Vec<f64> {
        let sweep = self.degrees.to_radians();
        let steps = ((self.segments as f64 * self.degrees / 360.0).ceil() as usize).max(1);
        // +Z, where the viewer stands, is at -90 degrees.
        let start = -std::f64::consts::FRAC_PI_2 + (std::f64::consts::TAU - sweep) / 2.0;
        let rings = if self.is_full() { steps } else { steps + 1 };
        (0..rings).map(|i| start + sweep * i as f64 / steps as f64).collect()
    }
}
