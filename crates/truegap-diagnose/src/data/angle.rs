//! Drivers that are angles: a turn further they are the same again.
//!
//! Limits: known by their unit alone; a column in another unit is no angle.

use truegap_core::{Driver, ends};

/// Share of a turn that an angle must cover, so that laws of the whole turn can be seen.
const COVERED: f64 = 0.5;

/// Share of a turn beyond which a column that jumps back has gone on counting.
const ONE_TURN: f64 = 1.02;

/// A whole turn in this unit; `None` where it is no unit of an angle.
pub(crate) fn turn(unit: &str) -> Option<f64> {
    match unit.trim().to_lowercase().as_str() {
        "deg" | "°" | "degree" | "degrees" => Some(360.0),
        "rad" | "radian" | "radians" => Some(std::f64::consts::TAU),
        "gon" => Some(400.0),
        "turn" | "turns" | "rev" | "revolution" | "revolutions" => Some(1.0),
        _ => None,
    }
}

/// A whole turn of a driver that covers enough of one.
pub(crate) fn turning(unit: &str, low: f64, high: f64) -> Option<f64> {
    turn(unit).filter(|turn| high - low > COVERED * turn)
}

/// Whether a driver is an angle that begins anew after each turn: its number goes from one end to the other where nothing has moved far.
pub(crate) fn begins_anew(driver: &Driver) -> bool {
    let values = &driver.values;
    let (low, high) = ends(values.iter().copied());
    let Some(turn) = turning(&driver.unit, low, high).filter(|turn| high - low <= ONE_TURN * turn) else { return false };
    values.windows(2).any(|w| (w[1] - w[0]).abs() > 0.5 * turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn driver(unit: &str, values: impl Iterator<Item = f64>) -> Driver {
        Driver { name: "direction".into(), unit: unit.into(), values: values.collect() }
    }

    #[test]
    fn a_wind_vane_begins_anew_and_a_valve_does_not() {
        assert!(begins_anew(&driver("deg", (0..400).map(|k| (7.0 * f64::from(k)) % 360.0))));
        assert!(begins_anew(&driver("rad", (0..400).map(|k| f64::from(k) % std::f64::consts::TAU))));
        // a shaft whose turns are counted, a sweep of one turn, a valve, another unit
        assert!(!begins_anew(&driver("deg", (0..400).map(|k| 7.0 * f64::from(k)))));
        assert!(!begins_anew(&driver("deg", (0..360).map(f64::from))));
        assert!(!begins_anew(&driver("deg", (0..400).map(|k| f64::from(k % 90)))));
        assert!(!begins_anew(&driver("mm", (0..400).map(|k| (7.0 * f64::from(k)) % 360.0))));
    }
}
