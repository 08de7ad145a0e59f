//! The paper's design problem and what truegap's search makes of it, as JSON for a peer: `cargo run -p truegap-design --example front -- SEEDS`.
//!
//! Prints the starting design's constants, the axes, the constraints and, for each front and each seed, time, evaluations and all designs found.

use serde_json::{Value, json};
use std::time::Instant;
use truegap_core::{Sensor, sensor::Filling, sensor::builtin_sensors};
use truegap_design::MetricOptions;
use truegap_design::optimise::{DesignProblem, OBJECTIVES, SearchOptions, Space, Useful};

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let seeds: u64 = std::env::args().nth(1).map_or(Ok(1), |text| text.parse())?;
    let sensor = builtin_sensors()[0].sensor()?;
    let useful = Useful::default();
    let problem = DesignProblem::new(Space::paper(sensor.clone())?, useful, MetricOptions::default())?;
    let mut fronts = Vec::new();
    for seed in 1..=seeds {
        let search = SearchOptions { seed, ..Default::default() };
        for pair in [[0, 1], [0, 2], [1, 2]] {
            fronts.push(searched(&problem, pair, search)?);
        }
        // a lattice of 91 directions: as many sweeps as the budget of the pairs allows
        fronts.push(searched(&problem, [0, 1, 2], SearchOptions { sweeps: 197, ..search })?);
    }
    let axes: Vec<Value> =
        problem.space().axes().iter().map(|a| json!({"quantity": a.quantity.name(), "choice": a.choice})).collect();
    let threads = rayon::current_num_threads();
    let base = problem.base();
    let answer = json!({
        "sensor": constants(&sensor), "axes": axes, "useful": useful, "base": base, "threads": threads,
        "objectives": OBJECTIVES.map(|o| o.name()), "fronts": fronts,
    });
    println!("{answer}");
    Ok(())
}

fn searched<const M: usize>(problem: &DesignProblem, objectives: [usize; M], search: SearchOptions) -> Result<Value, Failure> {
    let begin = Instant::now();
    let front = problem.front(objectives, search)?;
    let seconds = begin.elapsed().as_secs_f64();
    let designs: Vec<Value> = front
        .points
        .iter()
        .map(|p| {
            let design = problem.candidate(&p.unit);
            json!({"values": design.values, "ratios": design.ratios})
        })
        .collect();
    Ok(json!({
        "objectives": objectives.to_vec(), "seed": search.seed, "seconds": seconds, "evaluations": front.evaluations, "designs": designs,
    }))
}

/// Everything that the equations need, SI.
fn constants(sensor: &Sensor) -> Value {
    let rubber = &sensor.dielectric.layer;
    let (count, bead) = match sensor.dielectric.filling {
        Filling::Beads { count, diameter } => (count, diameter.value),
        Filling::Solid { .. } => (0, 0.0),
    };
    let layer = |l: &truegap_core::sensor::Layer| {
        let m = &l.material;
        json!({"young": m.young.value, "expansion": m.expansion, "permittivity": m.permittivity, "thickness": l.thickness.value})
    };
    json!({
        "name": sensor.name, "full_scale": sensor.full_scale, "reference_c": sensor.reference_c, "diameter": sensor.diameter.value,
        "rubber": layer(rubber), "softening": rubber.material.softening.value, "poisson": rubber.material.poisson,
        "bead_count": count, "bead_diameter": bead, "surrounding": sensor.dielectric.surrounding_permittivity,
        "conductor": layer(&sensor.conductor), "plating": sensor.plating.as_ref().map(layer), "insulator": layer(&sensor.insulator),
        "tail": [sensor.tail.0, sensor.tail.1], "stray": sensor.stray.value,
    })
}
