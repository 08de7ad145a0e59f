//! The paper's claims, one by one, for both reconstructions of its lost table of defaults: `cargo run -p truegap-design --example claims`.
//!
//! Prints a page in Markdown with nothing but computed numbers; the verdict of each row follows from them by the rule that the row states.

use truegap_core::{Sensor, sensor::builtin_sensor};
use truegap_design::optimise::{DesignProblem, OBJECTIVES, SearchOptions, Space, Useful, search};
use truegap_design::sensitivity::{PAPER_QUANTITIES, one_at_a_time, ranked};
use truegap_design::tolerance::{BatchOptions, batch};
use truegap_design::{Metric, MetricOptions, Metrics, Quantity, metrics};
use truegap_model::{Point, StackOptions, states};

type Failure = Box<dyn std::error::Error>;

/// A reconstruction and the optimised design with the same sign of softening.
struct Pair {
    name: &'static str,
    before: Sensor,
    after: Sensor,
}

fn main() -> Result<(), Failure> {
    let optimised = sensor("singletact-s8-optimised")?;
    let mut stiffening = optimised.clone();
    stiffening.dielectric.layer.material.softening.value *= -1.0;
    let pairs = [
        Pair { name: "softening", before: sensor("singletact-s15-4.5n")?, after: optimised },
        Pair { name: "stiffening", before: sensor("singletact-s15-4.5n-stiffening")?, after: stiffening },
    ];
    println!("| claim of the paper | reconstruction | what we get | verdict | rule of the verdict |\n|---|---|---|---|---|");
    for pair in &pairs {
        reductions(pair)?;
    }
    for pair in &pairs {
        dominant(pair)?;
        needs_warp(pair)?;
        straight(pair)?;
        flips(pair)?;
        worse_third(pair)?;
        close_to_optimal(pair)?;
        same_leaders(pair)?;
        repeatable(pair)?;
        calibrated(pair)?;
    }
    Ok(())
}

fn sensor(name: &str) -> Result<Sensor, Failure> {
    Ok(builtin_sensor(name).ok_or("no such built-in sensor")??)
}

fn row(claim: &str, pair: &Pair, found: &str, verdict: &str, rule: &str) {
    println!("| {claim} | {} | {found} | {verdict} | {rule} |", pair.name);
}

fn agrees(holds: bool) -> &'static str {
    if holds { "agrees" } else { "differs" }
}

fn both(pair: &Pair) -> Result<[Metrics; 2], Failure> {
    let options = MetricOptions::default();
    Ok([metrics(&pair.before, options)?, metrics(&pair.after, options)?])
}

fn reductions(pair: &Pair) -> Result<(), Failure> {
    let [before, after] = both(pair)?;
    let known = [16.16, 16.47, 14.74];
    for (metric, known) in OBJECTIVES.into_iter().zip(known) {
        let found = 100.0 * (1.0 - (after.of(metric) / before.of(metric)).abs());
        let claim = format!("{metric} in size falls by {known} %");
        row(&claim, pair, &format!("{found:.2} %"), agrees((found - known).abs() < 2.0), "within 2 points");
    }
    let found = 100.0 * (1.0 - (after.of(Metric::KBaselineShare) / before.of(Metric::KBaselineShare)).abs());
    row(
        "the same for K_baseline in % of span/K, the unit in which the text of (24) gives it",
        pair,
        &format!("{found:.2} %"),
        "not stated by the paper",
        "-",
    );
    Ok(())
}

fn leaders(sensor: &Sensor, metric: Metric, count: usize) -> Result<Vec<Quantity>, Failure> {
    let rows = one_at_a_time(sensor, &PAPER_QUANTITIES, 0.1, MetricOptions::default())?;
    Ok(ranked(&rows, metric).into_iter().take(count).map(|(quantity, _)| quantity).collect())
}

fn names(quantities: &[Quantity]) -> String {
    quantities.iter().map(|q| q.symbol()).collect::<Vec<_>>().join(", ")
}

fn dominant(pair: &Pair) -> Result<(), Failure> {
    let known = [Quantity::BeadCount, Quantity::Conductor, Quantity::Height];
    for metric in OBJECTIVES {
        let found = leaders(&pair.before, metric, 4)?;
        let three = found[..3].iter().all(|q| known.contains(q));
        let claim = format!("{metric} is dominated by N, h_Cu, h_RTV (+-10 %)");
        row(&claim, pair, &names(&found), agrees(three), "the first three are these, in any order");
    }
    Ok(())
}

fn needs_warp(pair: &Pair) -> Result<(), Failure> {
    let flat = MetricOptions { stack: StackOptions { warp: false, ..Default::default() }, ..Default::default() };
    let warped = metrics(&pair.before, MetricOptions::default())?.of(Metric::KBaselineShare);
    let flat = metrics(&pair.before, flat)?.of(Metric::KBaselineShare);
    let nearer = (warped - 0.2).abs() < (flat - 0.2).abs();
    let found = format!("{warped:.3} with warp, {flat:.3} without, % of span/K");
    row(
        "a parallel-plate model is a poor predictor (Fig 5); data sheet 0.2 % of span/K",
        pair,
        &found,
        agrees(nearer),
        "the warped model is nearer to 0.2",
    );
    Ok(())
}

fn straight(pair: &Pair) -> Result<(), Failure> {
    let found = metrics(&pair.before, MetricOptions::default())?.of(Metric::Linearity);
    row(
        "the response is close to linear at 20 degC (Fig 6)",
        pair,
        &format!("largest deviation {found:.2} % of span"),
        "cannot be decided",
        "the figure's points are not in the text",
    );
    Ok(())
}

fn flips(pair: &Pair) -> Result<(), Failure> {
    let [before, after] = both(pair)?.map(|m| m.of(Metric::KLinearity));
    let [straight, bent] = both(pair)?.map(|m| m.of(Metric::Linearity));
    row(
        "K_linearity changes its sign",
        pair,
        &format!("{before:.5} to {after:.5} %/K"),
        agrees(before * after < 0.0),
        "the product is negative",
    );
    row(
        "linearity is slightly worse after optimisation",
        pair,
        &format!("{straight:.3} to {bent:.3} % of span"),
        agrees(bent > straight && bent < 2.0 * straight),
        "greater, by less than a factor of 2",
    );
    Ok(())
}

fn problem(pair: &Pair) -> Result<DesignProblem, Failure> {
    Ok(DesignProblem::new(Space::paper(pair.before.clone())?, Useful::default(), MetricOptions::default())?)
}

fn worse_third(pair: &Pair) -> Result<(), Failure> {
    let problem = problem(pair)?;
    let search = SearchOptions::default();
    for (two, third) in [([0, 1], 2), ([0, 2], 1), ([1, 2], 0)] {
        let front = problem.front(two, search)?;
        let count = front.points.len();
        let thirds = front.points.iter().map(|p| problem.candidate(&p.unit).ratios[third]);
        let worse = thirds.filter(|&r| r > 1.0).count();
        let claim = format!("optimising {} and {} makes {} worse", OBJECTIVES[two[0]], OBJECTIVES[two[1]], OBJECTIVES[third]);
        row(&claim, pair, &format!("on {worse} of {count} points of the front"), agrees(worse == count), "on every point");
    }
    Ok(())
}

fn close_to_optimal(pair: &Pair) -> Result<(), Failure> {
    let problem = problem(pair)?;
    let front = search(&problem, &[0, 1, 2], SearchOptions::default())?.designs;
    let best = problem.along_vector(&front).ok_or("the front is empty")?.0;
    let best = problem.candidate(&best);
    let least = best.ratios.iter().map(|r| 100.0 * (1.0 - r)).fold(f64::INFINITY, f64::min);
    let parts: Vec<String> = problem
        .space()
        .axes()
        .iter()
        .zip(&best.values)
        .map(|(axis, value)| {
            format!("{} {:.3} {}", axis.quantity.symbol(), value * axis.quantity.unit().1, axis.quantity.unit().0)
        })
        .collect();
    let found = format!("all three can fall by {least:.1} % or more: {}", parts.join(", "));
    row(
        "along the vector only about 16 % can be gained: the design is close to optimal",
        pair,
        &found,
        agrees(least < 25.0),
        "less than 25 %; with our constraints, the paper's are not given",
    );
    Ok(())
}

fn same_leaders(pair: &Pair) -> Result<(), Failure> {
    for metric in OBJECTIVES {
        let [mut before, mut after] = [leaders(&pair.before, metric, 2)?, leaders(&pair.after, metric, 2)?];
        let found = format!("{} before, {} after", names(&before), names(&after));
        before.sort_by_key(|q| q.name());
        after.sort_by_key(|q| q.name());
        row(
            &format!("the two dominant factors of {metric} stay after optimisation"),
            pair,
            &found,
            agrees(before == after),
            "the same two, in any order",
        );
    }
    Ok(())
}

fn repeatable(pair: &Pair) -> Result<(), Failure> {
    let options = BatchOptions { samples: 131_072, ..Default::default() };
    let [before, after] = [batch(&pair.before, options)?.scatter(), batch(&pair.after, options)?.scatter()];
    for metric in [Metric::Baseline, Metric::Span, Metric::KBaseline, Metric::KSensitivity, Metric::KLinearity] {
        let [a, b] =
            [&before, &after].map(|s| s.iter().find(|s| s.metric == metric).map_or((f64::NAN, f64::NAN), |s| (s.sd, s.sd_pct)));
        let found = format!("sd {:.3e} to {:.3e} {}; relative {:.2} to {:.2} %", a.0, b.0, metric.unit(), a.1, b.1);
        let verdict = if (b.0 < a.0) == (b.1 < a.1) { agrees(b.0 < a.0) } else { "depends on absolute or relative" };
        row(
            &format!("batch repeatability of {metric} improves"),
            pair,
            &found,
            verdict,
            "smaller in absolute and in relative terms",
        );
    }
    Ok(())
}

/// Error in % of full scale at the hot end after a two-point calibration when cold, at no load and full load.
fn hot_errors(sensor: &Sensor) -> Result<[f64; 2], Failure> {
    let full = sensor.full_scale;
    let points =
        [(0.0, 20.0), (full, 20.0), (0.0, 50.0), (full, 50.0)].map(|(force_n, temperature_c)| Point { force_n, temperature_c });
    let c: Vec<f64> = states(sensor, StackOptions::default(), &points)?.iter().map(|s| s.c_total_pf).collect();
    let span = c[1] - c[0];
    Ok([100.0 * (c[2] - c[0]) / span, 100.0 * (c[3] - c[1]) / span])
}

fn calibrated(pair: &Pair) -> Result<(), Failure> {
    let [before, after] = [hot_errors(&pair.before)?, hot_errors(&pair.after)?];
    let found = format!(
        "error at 50 degC without and with full load: {:.1} and {:.1} % of span before, {:.1} and {:.1} % after",
        before[0], before[1], after[0], after[1]
    );
    let smaller = before.iter().zip(after).all(|(b, a)| a.abs() < b.abs());
    row(
        "with a two-point calibration the output depends less on temperature, slightly (Fig 10)",
        pair,
        &found,
        agrees(smaller),
        "smaller at both ends",
    );
    Ok(())
}
