//! Which words count as right for each cause: the one table of it, each row with its reason.
//!
//! A law has equivalent words: a lag of the temperature is, to first order, a share of its rate; what follows the load at once follows the reading at
//! once. Driver and kinetics are therefore pairs. Limits: places are those that the recording could tell at best; a cause without an entry has no words.

use serde_json::Value;
use std::collections::BTreeSet;

/// The words that count as right.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Words {
    /// Places.
    pub places: BTreeSet<String>,
    /// Driver and kinetics that belong together; empty where no words say the law.
    pub laws: BTreeSet<(String, String)>,
}

impl Words {
    /// From the `mechanism` of a shared recording's truth, where each driver goes with each kinetics.
    pub(super) fn of_shared(mechanism: &Value) -> Option<Self> {
        let list = |word: &str| Some(mechanism[word].as_array()?.iter().filter_map(Value::as_str).map(str::to_owned));
        let kinetics: Vec<String> = list("kinetics")?.collect();
        let laws = list("driver")?.flat_map(|d| kinetics.iter().map(move |k| (d.clone(), k.clone())));
        Some(Self { places: list("place")?.collect(), laws: laws.collect() })
    }

    /// Whether a driver is right with some kinetics.
    pub fn has_driver(&self, driver: &str) -> bool {
        self.laws.iter().any(|(d, _)| d == driver)
    }

    /// Whether a kinetics is right with some driver.
    pub fn has_kinetics(&self, kinetics: &str) -> bool {
        self.laws.iter().any(|(_, k)| k == kinetics)
    }
}

/// The words of a cause by its id.
pub fn words_of(id: &str) -> Option<Words> {
    let row = TABLE.iter().find(|row| row.0 == id)?;
    let split = |text: &'static str| text.split(' ').filter(|word| !word.is_empty());
    let law = |pair: &str| pair.split_once('+').map(|(d, k)| (d.to_owned(), k.to_owned()));
    Some(Words { places: split(row.1).map(str::to_owned).collect(), laws: split(row.2).filter_map(law).collect() })
}

/// Cause, places, driver+kinetics, why.
type RightWords = (&'static str, &'static str, &'static str, &'static str);

/// Words that count, cause by cause.
#[rustfmt::skip]
pub const TABLE: [RightWords; 44] = [
    // the library
    ("contact_toe_in", "inputs mechanics geometry", "load+static reading+static", "a static law of the load; the reading rises with the load alone"),
    ("eccentric_load", "inputs mechanics geometry", "load+static reading+static", "the tilt follows the load at once; a static law of the load fits each of the three places"),
    ("thermal_lag", "inputs geometry", "temperature+first_order temperature_rate+static temperature_rate+first_order", "T - tau dT/dt; temperature acts through the warp for the most part"),
    ("viscoelastic_creep", "mechanics geometry", "load+first_order load_rate+first_order reading+first_order", "a spectrum of times on the strain, which closes the gap"),
    ("rate_independent_hysteresis", "inputs mechanics geometry", "load+rate_independent reading+rate_independent", "plays on the strain, which the load moves"),
    ("mullins_softening", "mechanics geometry inputs", "load_history+accumulating reading+accumulating", "the greatest load so far"),
    ("strain_stiffening", "mechanics inputs geometry", "load+static reading+static", "a static law of the load"),
    ("electrode_warp", "geometry", "temperature+static", "the curvature follows the temperature"),
    ("thermal_hysteresis", "geometry inputs", "temperature+rate_independent", "plays on the temperature that bends"),
    ("permittivity_temperature", "dielectric readout", "temperature+static", "the insulator's share is a constant capacitance beside the gap: a reading that follows the temperature"),
    ("humidity_uptake", "dielectric readout", "humidity+static humidity+first_order", "as above, with the recorded humidity; some films take seconds"),
    ("fringing_field", "geometry dielectric readout", "load+static reading+static", "a slow function of the gap, which the load closes"),
    ("parasitic_capacitance", "readout", "", "a constant follows nothing: no words say it"),
    ("dead_gap", "geometry dielectric mechanics", "load+static reading+static", "what air in series takes away depends on the gap beside it"),
    ("trapped_air_stiffness", "mechanics inputs", "load+first_order load_rate+first_order load_rate+static", "air carries what comes faster than it leaks"),
    ("ageing", "mechanics inputs", "time+static time+first_order time+accumulating", "a modulus by the clock: a load that is scaled"),
    ("plate_bending", "geometry mechanics inputs", "load+static reading+static", "the bow follows the load at once"),
    ("readout_lag", "readout inputs", "reading+first_order load+first_order load_rate+static load_rate+first_order", "y - tau dy/dt; what moves fast is the load"),
    ("offset_drift", "readout", "time+static time+first_order time+accumulating", "a course of the clock"),
    ("offset_steps", "readout", "time+event", "jumps at moments"),
    ("gain_drift", "readout dielectric", "temperature+static", "a gain by the temperature; a permittivity scales the plates as well"),
    ("saturation", "readout", "reading+static load+static", "a knee in the reading, hence in the load"),
    ("time_offset", "inputs readout", "load_rate+static load+first_order load_rate+first_order reading+first_order", "y - s dy/dt; what moves fast is the load"),
    ("load_cell_error", "inputs mechanics", "load+static reading+static", "a static law of the load"),
    ("clock_rate", "inputs readout", "load_rate+static load+first_order load_rate+first_order reading+first_order", "a time offset that grows: no single driver says the growth, the rate of the load says the rest"),
    ("held_warp", "geometry", "temperature+static", "a share of the curvature, which follows the temperature"),
    ("bonded_layers", "mechanics inputs geometry", "load+static reading+static temperature+static", "stiffer with load, pushed up with temperature: either is half of it"),
    ("rim_field", "geometry dielectric readout", "load+static reading+static", "a slow function of the gap"),
    ("driver_coefficient", "readout", "supply+static", "the recorded supply"),
    // outside any library
    ("bottoming", "mechanics geometry", "load+static reading+static", "a stop that the load reaches"),
    ("cold_flow", "geometry mechanics", "load_history+accumulating load+accumulating reading+accumulating", "a power of load times time"),
    ("cycle_fatigue", "mechanics", "load_history+accumulating reading+accumulating", "the way of the load"),
    ("glass_knee", "mechanics", "temperature+static", "a knee of the modulus"),
    ("heating_gradient", "geometry readout", "temperature_rate+static temperature_rate+first_order temperature+first_order", "settles within seconds; T less its lag is its rate"),
    ("motor_pickup", "readout geometry", "load_rate+static load_rate+first_order", "even in the speed of the load"),
    ("converter_memory", "readout", "reading+first_order reading+static load_rate+static load+first_order", "the reading before; a share of its change from row to row"),
    ("latch", "geometry mechanics readout", "load+event load+rate_independent load_history+event reading+event reading+rate_independent load+static", "a relay in the load, nearly a step of it"),
    ("thixotropy", "mechanics", "load_rate+first_order load_history+accumulating load_rate+static", "the recent speed of the load"),
    ("thermal_ratchet", "geometry readout", "temperature+accumulating", "the way of the temperature"),
    ("compressor", "readout", "time+periodic", "a period in time"),
    ("hum", "readout", "time+periodic", "a tone"),
    ("thermal_rate", "readout geometry", "temperature_rate+static temperature_rate+first_order", "even in the rate of temperature"),
    ("force_rate_squared", "readout geometry", "load_rate+static load_rate+first_order", "even in the rate of the load"),
    ("converter_ripple", "readout", "reading+periodic", "periodic in the reading"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::causes::{FURTHER, LIBRARY, WILD};

    #[test]
    fn every_cause_that_can_be_left_out_and_every_wild_one_has_words_and_a_reason() {
        for (id, _) in LIBRARY.iter().chain(&FURTHER).chain(&WILD) {
            let words = words_of(id).unwrap_or_else(|| panic!("{id} has no words"));
            assert!(!words.places.is_empty(), "{id}");
        }
        assert_eq!(TABLE.len(), LIBRARY.len() + FURTHER.len() + WILD.len());
        assert!(TABLE.iter().all(|row| !row.3.is_empty()));
    }

    #[test]
    fn only_words_of_the_grammar_stand_in_the_table() {
        let places = ["inputs", "mechanics", "geometry", "dielectric", "readout"];
        let kinetics = ["static", "first_order", "rate_independent", "accumulating", "event", "periodic"];
        for words in TABLE.iter().filter_map(|row| words_of(row.0)) {
            assert!(words.places.iter().all(|p| places.contains(&p.as_str())));
            assert!(words.laws.iter().all(|(_, k)| kinetics.contains(&k.as_str())), "{words:?}");
        }
    }
}
