//! Words and symbols that people call a quantity by: one table for all languages.
//!
//! Limits: whole words of a name, without accents; a word tells a role only where no unit tells another.

use crate::inputs::Role;

/// Words in small letters without accents, and symbols as they are written.
const WORDS: [(Role, &[&str], &[&str]); 7] = [
    (
        Role::Time,
        &["time", "elapsed", "timestamp", "datetime", "clock", "zeit", "zeitstempel", "uhrzeit", "temps", "tiempo", "tempo"],
        &["t"],
    ),
    (
        Role::Force,
        &["force", "load", "weight", "loadcell", "kraft", "last", "gewicht", "kraftmessdose", "charge", "fuerza", "forza"],
        &["F", "Fz", "Fn", "FZ", "FN", "fz"],
    ),
    (Role::Pressure, &["pressure", "press", "druck", "pression", "presion", "pressione"], &["p"]),
    (Role::Gap, &["gap", "separation", "spalt", "plattenabstand", "entrefer"], &[]),
    (
        Role::Temperature,
        &["temperature", "temp", "thermometer", "thermocouple", "temperatur", "temperatura"],
        &["T", "TC", "ϑ", "θ"],
    ),
    (
        Role::Humidity,
        &["humidity", "feuchte", "luftfeuchte", "luftfeuchtigkeit", "humidite", "humedad", "umidita"],
        &["RH", "rh", "rF", "rH"],
    ),
    (
        Role::Response,
        &[
            "response",
            "capacitance",
            "capacitor",
            "cap",
            "reading",
            "signal",
            "output",
            "counts",
            "kapazitat",
            "kapazitaet",
            "messwert",
            "ausgang",
            "capacite",
            "capacidad",
            "capacita",
            "capacitancia",
        ],
        &["C", "Cx", "Cp", "Cs", "CX", "CP", "CS"],
    ),
];

/// Words by which people call the column of a simulation of their own.
const SIMULATIONS: [&str; 14] = [
    "model",
    "modell",
    "modele",
    "modelo",
    "modello",
    "sim",
    "simulated",
    "simulation",
    "simuliert",
    "simulacion",
    "simulazione",
    "predicted",
    "prediction",
    "fem",
];

/// Whether a word of `name` says that its column was computed; such a column is proposed as a simulation, never taken for one.
pub(super) fn is_called_simulation(name: &str) -> bool {
    words(name).iter().any(|word| SIMULATIONS.contains(&without_accents(word).as_str()))
}

/// Whether a word of `name` is one of the role's.
pub(super) fn told(role: Role, name: &str) -> bool {
    let words: Vec<String> = words(name);
    WORDS.iter().filter(|(of, ..)| *of == role).any(|(_, known, symbols)| {
        words.iter().any(|word| symbols.contains(&word.as_str()) || known.contains(&without_accents(word).as_str()))
    })
}

/// The words of a name: what stands between signs, digits and humps (`T_chamber`, `Temp1`, `forceZ`).
fn words(name: &str) -> Vec<String> {
    let (mut words, mut before) = (vec![String::new()], ' ');
    for c in name.chars() {
        let hump = before.is_lowercase() && c.is_uppercase();
        if !c.is_alphabetic() || hump {
            words.push(String::new());
        }
        if let (true, Some(word)) = (c.is_alphabetic(), words.last_mut()) {
            word.push(c);
        }
        before = c;
    }
    words.retain(|word| !word.is_empty());
    words
}

/// In small letters, without the accents of German and Romance languages.
pub(super) fn without_accents(word: &str) -> String {
    let plain = |c: char| match c {
        'à' | 'á' | 'â' | 'ä' => 'a',
        'è' | 'é' | 'ê' | 'ë' => 'e',
        'ì' | 'í' | 'î' | 'ï' => 'i',
        'ò' | 'ó' | 'ô' | 'ö' => 'o',
        'ù' | 'ú' | 'û' | 'ü' => 'u',
        other => other,
    };
    word.to_lowercase().chars().map(plain).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_of_the_name_tells_what_is_measured() {
        let cases = [
            (Role::Time, "Elapsed Time (sec)"),
            (Role::Time, "t_ms"),
            (Role::Time, "Zeit [s]"),
            (Role::Force, "Fz/N"),
            (Role::Force, "loadCell"),
            (Role::Force, "Kraft"),
            (Role::Pressure, "Druck in kPa"),
            (Role::Temperature, "T_chamber [K]"),
            (Role::Temperature, "Temp1"),
            (Role::Temperature, "Température (°C)"),
            (Role::Humidity, "rel. Feuchte in %"),
            (Role::Response, "Kapazität [pF]"),
            (Role::Response, "C_meas/pF"),
        ];
        for (role, name) in cases {
            assert!(told(role, name), "{name}");
        }
    }

    #[test]
    fn part_of_a_word_and_a_symbol_in_another_case_tell_nothing() {
        assert!(!told(Role::Temperature, "attempt") && !told(Role::Time, "T") && !told(Role::Temperature, "t"));
        assert!(!told(Role::Response, "escape") && !told(Role::Time, "sometimes"));
    }
}
