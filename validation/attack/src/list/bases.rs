//! Base models with nothing to fit, and recordings in which hardly anything was recorded.

use crate::attack::Attack;
use std::fmt::Write;

pub fn all() -> Vec<Attack> {
    let manifest = "schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n[base]\nmodel = \"external\"\n";
    let diagnose = ["-q", "diagnose", "r.toml", "-o", "out"];
    let external = |class, name: &str, free: &str, slope: f64| {
        Attack::new(class, name, &diagnose)
            .file("r.toml", format!("{manifest}{free}"))
            .file("r.csv", simulated(slope))
            .ends(i32::from(slope > 0.0), &["out"])
    };
    vec![
        external("2", "a simulation that nothing may adjust", "free = []\n", 0.0),
        external("2", "a simulation that nothing may adjust, beside which the reading rises", "free = []\n", 2e-3),
        external("2", "a simulation with a gain and an offset", "gain = true\noffset = true\n", 0.0),
    ]
}

/// Two hundred rows: a clock, a simulation and a reading that leaves it by `slope` a second.
fn simulated(slope: f64) -> String {
    let mut text = "time_s,simulated,response_v\n".to_owned();
    for row in 0..200 {
        let t = f64::from(row);
        let simulated = 5.0 + (t / 40.0).sin();
        // of either sign: the sign of a fraction is that of the sine, and that has a period
        let noise = 0.01 * (((t * 12.9898).sin() * 43_758.545_3).fract().abs() - 0.5);
        // a String takes everything
        let _ = writeln!(text, "{t},{simulated:.5},{:.5}", simulated + slope * t + noise);
    }
    text
}
