//! Numbers that are none, and numbers that cannot be.

use super::material::{HEADER, SENSOR, csv, sensor};
use crate::attack::Attack;

pub fn all() -> Vec<Attack> {
    let of_sensor = |class, name: &str, from: &str, to: &str| {
        Attack::new(class, name, &["coefficients", "--sensor", "./s.toml"]).file("s.toml", sensor(from, to)).says(&["s.toml"])
    };
    let (scale, reference) = ("full_scale = \"4.5 N\"", "reference_temperature = \"20 degC\"");
    let simulate = |name: &str, typed: &[&str]| Attack::new("17", name, typed);
    let mut all = vec![
        // nothing to draw is no reason to lose the report
        Attack::new("15", "a space in which no design has an answer", &["-q", "audit", "--space", "space.toml", "-o", "out"])
            .file(
                "space.toml",
                format!(
                    "schema = \"truegap.space/1\"\nsensor = \"{SENSOR}\"\ndesigns = 1\nseed = 1\nonly = [\"BIMETAL-STRIP\"]\n"
                ),
            )
            .ends(1, &["out"])
            .says(&["1 without an answer"]),
        Attack::new("15", "a full scale that is lost in rounding", &["coefficients", "--sensor", "./s.toml"])
            .file("s.toml", sensor(scale, "full_scale = \"1e-300 N\""))
            .says(&["1e-300 N", "not finite", "full_scale"]),
        Attack::new("15", "the same as JSON", &["--json", "coefficients", "--sensor", "./s.toml"])
            .file("s.toml", sensor(scale, "full_scale = \"1e-300 N\""))
            .says(&["not finite"]),
        of_sensor("15", "a full scale that SI cannot hold", scale, "full_scale = \"1e308 kN\"").says(&["too large"]),
        of_sensor("15", "a full scale of nothing", scale, "full_scale = \"0 N\"").says(&["greater than 0"]),
        of_sensor("17", "a spread below zero", "162 um +- 5 um", "162 um +- -5 um").says(&["-5 um", "standard deviation"]),
        of_sensor("17", "a reference below absolute zero", reference, "reference_temperature = \"-300 degC\"")
            .says(&["absolute zero"]),
        of_sensor("17", "a reference hotter than the sun", reference, "reference_temperature = \"1e300 degC\"").says(&["1e300"]),
        simulate("a temperature below absolute zero", &["simulate", "--load", "1 N", "--temperature", "-300 degC"])
            .says(&["absolute zero"]),
        simulate("a temperature of 1e300", &["simulate", "--load", "1 N", "--temperature", "1e300 degC"])
            .says(&["1e300 degC", "no finite response"]),
        simulate("a load of -1e300", &["simulate", "--load", "-1e300 N"]).says(&["-1e300 N"]),
        Attack::new(
            "16",
            "an export at -270 degC",
            &["-q", "export", "--load", "1 N", "--temperature", "-270 degC", "-o", "e.vtu"],
        )
        .says(&["-40 to 125"]),
    ];
    let recorded = |class, name: &str, text: String| {
        Attack::new(class, name, &["-q", "diagnose", "r.csv", "--sensor", SENSOR, "-o", "out"])
            .file("r.csv", text)
            .says(&["r.csv"])
    };
    let column = |value: &str| {
        csv(HEADER)
            .lines()
            .enumerate()
            .map(|(k, line)| format!("{line},{}\n", if k == 0 { "humidity_pct" } else { value }))
            .collect()
    };
    let warm: String = csv(HEADER)
        .lines()
        .enumerate()
        .map(|(k, line)| {
            let cells: Vec<&str> = line.split(',').collect();
            let kelvin = cells[2].parse::<f64>().map_or_else(|_| cells[2].to_owned(), |t| (t + 273.15).to_string());
            if k == 0 { format!("{line}\n") } else { format!("{},{},{kelvin},{}\n", cells[0], cells[1], cells[3]) }
        })
        .collect();
    all.extend([
        recorded("17", "humidity of -40 %", column("-40")).says(&["line 2", "-40 %", "between 0 and 100 %"]),
        recorded("17", "humidity of 400 %", column("400")).says(&["line 2", "400 %"]),
        recorded("17", "kelvin in a column of degrees", warm).says(&["temperature", "check the unit"]),
        recorded("17", "a temperature below absolute zero", csv(HEADER).replace(",20.000000,", ",-400,"))
            .says(&["absolute zero"]),
        recorded("15", "a reading that is no number", csv(HEADER).replace("234.6", "nan234.6")).says(&["not a number"]),
        recorded("15", "a reading without an end", csv(HEADER).replace(",234.6", ",1e999")).says(&["not a number"]),
        recorded(
            "17",
            "a dead channel",
            format!("{HEADER}\n{}", (0..200).map(|t| format!("{t},{},20,234\n", t % 5)).collect::<String>()),
        )
        .says(&["dead channel"]),
    ]);
    for (header, unit) in [("force_pa", "pa"), ("force_xyz", "xyz"), ("Force [pF]", "pF"), ("force (furlong)", "furlong")] {
        let text = csv(&HEADER.replace("force_n", header));
        all.push(recorded("10", &format!("a column `{header}`"), text).says(&[header, &format!("`{unit}`"), "no unit of force"]));
    }
    all
}
