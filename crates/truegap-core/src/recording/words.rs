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
const SIMULATIONS: [&str; 18] = [
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
    "expected",
    "erwartet",
    "computed",
    "calculated",
    "fem",
];

/// Words by which people call a column that an instrument has written.
const INSTRUMENTS: [&str; 26] = [
    "meas",
    "measured",
    "measurement",
    "measuring",
    "observed",
    "sensor",
    "probe",
    "loadcell",
    "thermocouple",
    "thermometer",
    "thermistor",
    "gemessen",
    "messung",
    "messwert",
    "mess",
    "fuhler",
    "fuehler",
    "sonde",
    "kraftmessdose",
    "thermoelement",
    "capteur",
    "mesure",
    "mesuree",
    "medido",
    "medida",
    "misurato",
];

/// Words by which people call what an instrument is held against.
const REFERENCES: [&str; 7] = ["ref", "reference", "referenz", "bath", "bad", "bain", "true"];

/// Whether a word of `name` says that its column was computed; such a column is proposed as a simulation, never taken for one.
pub(super) fn is_called_simulation(name: &str) -> bool {
    is_any_of(name, &SIMULATIONS)
}

/// Whether a word of `name`, or two that stand side by side, say that an instrument has written its column.
pub(super) fn is_called_instrument(name: &str) -> bool {
    let words = words(name);
    let pairs = words.windows(2).any(|pair| INSTRUMENTS.contains(&without_accents(&pair.concat()).as_str()));
    pairs || is_any_of(name, &INSTRUMENTS)
}

/// Whether a word of `name` says that its column is what others are held against.
pub(super) fn is_called_reference(name: &str) -> bool {
    is_any_of(name, &REFERENCES)
}

/// The words of `name` that are left without those that say who has written its column, in small letters.
pub(super) fn subject(name: &str) -> Vec<String> {
    let words = words(name).into_iter().map(|word| without_accents(&word));
    words
        .filter(|word| ![&SIMULATIONS[..], &INSTRUMENTS, &REFERENCES].iter().any(|known| known.contains(&word.as_str())))
        .collect()
}

/// Whether a word of `name` says that a torque is measured.
pub(super) fn is_torque(name: &str) -> bool {
    is_any_of(name, &["torque", "moment", "drehmoment", "couple", "momento", "coppia"])
}

fn is_any_of(name: &str, known: &[&str]) -> bool {
    words(name).iter().any(|word| known.contains(&without_accents(word).as_str()))
}

/// Whether a word of `name` is one of the role's.
pub(super) fn told(role: Role, name: &str) -> bool {
    let words: Vec<String> = words(name);
    WORDS.iter().filter(|(of, ..)| *of == role).any(|(_, known, symbols)| {
        words.iter().any(|word| symbols.contains(&word.as_str()) || known.contains(&without_accents(word).as_str()))
    })
}

/// The words of a name: what stands between signs, digits and humps (`T_chamber`, `Temp1`, `forceZ`); `pH` is one, and no pressure.
fn words(name: &str) -> Vec<String> {
    let (mut words, mut before) = (vec![String::new()], ' ');
    for c in name.chars() {
        let acidity = c == 'H' && words.last().is_some_and(|word| word == "p");
        let hump = before.is_lowercase() && c.is_uppercase() && !acidity;
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

    /// The set point of a buffer was read as a pressure.
    #[test]
    fn acidity_is_no_pressure() {
        for name in ["pH", "pH set", "pH_set", "buffer pH"] {
            assert!(!told(Role::Pressure, name), "{name}");
        }
        assert!(told(Role::Pressure, "p_set") && told(Role::Pressure, "p [hPa]"));
    }

    #[test]
    fn who_has_written_a_column_is_told_by_its_name() {
        for name in ["F_meas", "Load cell (N)", "loadCell", "Thermocouple", "Fühler [°C]", "Torque sensor"] {
            assert!(is_called_instrument(name) && !is_called_reference(name), "{name}");
        }
        for name in ["Bath", "T_ref", "true force"] {
            assert!(is_called_reference(name) && !is_called_instrument(name), "{name}");
        }
        assert!(is_called_simulation("expected [N]") && !is_called_simulation("setpoint"));
        assert_eq!((subject("F_sim"), subject("F_meas")), (vec!["f".to_owned()], vec!["f".to_owned()]));
    }

    #[test]
    fn part_of_a_word_and_a_symbol_in_another_case_tell_nothing() {
        assert!(!told(Role::Temperature, "attempt") && !told(Role::Time, "T") && !told(Role::Temperature, "t"));
        assert!(!told(Role::Response, "escape") && !told(Role::Time, "sometimes"));
    }
}
