//! How large every cause has to be to be seen at d = 10, 30 and 120 on a protocol, and what calibration hides of it.
//!
//! Run: `cargo run -p truegap-generator --example sizes -- full`

use truegap_generator::causes::{Bench, LIBRARY, STRANGERS};
use truegap_generator::draws::Draws;
use truegap_generator::protocol::Kind;
use truegap_generator::sensor::Sensor;
use truegap_generator::state::Scene;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let name = std::env::args().nth(1).unwrap_or_else(|| "full".to_owned());
    let kind: Kind = serde_json::from_value(serde_json::Value::from(name))?;
    let history = kind.history(false, &mut Draws::of(1, "history"));
    let sensor = Sensor::singletact_s15();
    let scene = Scene { sensor: &sensor, history: &history };
    let benches = [Bench::new(scene, false, 0.004)?, Bench::new(scene, true, 0.004)?];
    println!("{:<28} {:>4} {:>8} {:>8}  shape and size", "cause", "d", "before", "residual");
    for (id, shape) in LIBRARY.iter().chain(&STRANGERS) {
        for asked in [10.0, 30.0, 120.0] {
            let mechanism = shape(&mut Draws::of(1, id));
            let bench = &benches[usize::from(!mechanism.needs().no_warp)];
            match bench.sized(mechanism, asked) {
                Err(error) => println!("{error}"),
                Ok(act) => {
                    let left = bench.leftover(std::slice::from_ref(&act))?;
                    let numbers = serde_json::Value::from(act.mechanism.numbers(act.size));
                    println!("{id:<28} {asked:>4} {:>8.2} {:>8.2}  {numbers}", left.before, left.residual);
                }
            }
        }
    }
    Ok(())
}
