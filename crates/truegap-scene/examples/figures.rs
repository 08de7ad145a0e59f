//! Writes one page with every kind of figure: `cargo run -p truegap-scene --example figures -- DIR`.

use std::f64::consts::TAU;
use truegap_scene::figure::{Bars, Figure, HeatMap, Matrix, Stack};
use truegap_scene::page::{Page, Table, Tone};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::path::PathBuf::from(std::env::args().nth(1).ok_or("name the folder to write to")?);
    std::fs::create_dir_all(&folder)?;
    let figures = [
        ("recording", recording()?),
        ("loop", hysteresis()?),
        ("convergence", convergence()?),
        ("ranking", ranking()?),
        ("tornado", tornado()?),
        ("residual", residual_map()?),
        ("confusion", confusion()?),
        ("offset", offset()?),
    ];
    let mut page = Page::new("Every kind of figure")
        .callout(Tone::Good, "agrees: no mismatch found.")
        .callout(Tone::Watch, "ambiguous: viscoelastic_creep or thermal_lag.")
        .callout(Tone::Bad, "unexplained: structure remains at 38 to 50 °C.")
        .section("Numbers")
        .table(
            &Table::new(&["assumption", "analytic", "FEM", "verdict"])
                .row(&["NO-FRINGING", "63.91 pF", "64.20 ± 0.01 pF", "strained"])
                .row(&["RIGID-PLATES", "63.91 pF", "63.90 ± 0.01 pF", "holds"])
                .caption("Made-up numbers that show the layout."),
        )
        .section("Figures");
    for (name, svg) in &figures {
        std::fs::write(folder.join(format!("{name}.svg")), svg)?;
        page = page.figure(svg, &format!("Figure `{name}`."));
    }
    page = page.details("Details").text("Folded.").code("truegap diagnose recording.toml -o out").end_details();
    std::fs::write(folder.join("index.html"), page.to_html())?;
    Ok(())
}

type Drawn = Result<String, truegap_scene::figure::FigureError>;

fn recording() -> Drawn {
    let n = 1_000_000;
    let t: Vec<f64> = (0..n).map(|i| f64::from(i) * 1e-3).collect();
    let noise = |i: usize| ((i as f64 * 12.9898).sin() * 43758.5453).fract();
    let load: Vec<f64> = t.iter().map(|t| if (*t / 100.0) as i64 % 2 == 0 { 0.5 } else { 4.0 }).collect();
    let truth: Vec<f64> = t.iter().map(|t| 64.0 + 2.0 * (TAU * t / 400.0).sin()).collect();
    let read: Vec<f64> = truth
        .iter()
        .enumerate()
        .map(|(i, c)| if (300_000..350_000).contains(&i) { f64::NAN } else { c + 0.3 * noise(i) })
        .collect();
    let residual: Vec<f64> = read.iter().zip(&truth).map(|(a, b)| (a - b) * 1e3).collect();
    let coarse: Vec<f64> = t.iter().copied().step_by(5000).collect();
    let model: Vec<f64> = truth.iter().copied().step_by(5000).collect();
    let shifted = |by: f64| model.iter().map(|c| c + by).collect::<Vec<_>>();
    Stack::new("Recording and prediction, one million rows")
        .panel(Figure::new("").x("time", "s").y("load", "N").height(80.0).steps("load", &t, &load))
        .panel(
            Figure::new("")
                .x("time", "s")
                .y("capacitance", "pF")
                .height(190.0)
                .line("measured", &t, &read)
                .band("model", &coarse, &shifted(-0.6), &shifted(0.6))
                .line("model", &coarse, &model)
                .shade_x(400.0, 520.0, "mismatch 62 %")
                .mark_x(800.0, "held out from here"),
        )
        .panel(
            Figure::new("")
                .x("time", "s")
                .y("residual", "fF")
                .height(110.0)
                .points("residual", &t, &residual)
                .shade_y(-100.0, 100.0, "noise")
                .mark_y(0.0, ""),
        )
        .to_svg()
}

fn hysteresis() -> Drawn {
    let a: Vec<f64> = (0..200_000).map(|i| f64::from(i) * TAU / 1000.0).collect();
    let x: Vec<f64> = a.iter().map(|a| 2.25 - 2.25 * a.cos()).collect();
    let y: Vec<f64> = a.iter().zip(&x).map(|(a, x)| 64.0 + 3.0 * x + 0.05 * x * x - 0.6 * a.sin()).collect();
    let mean: Vec<f64> = (0..10).map(|i| f64::from(i) * 0.5).collect();
    let line: Vec<f64> = mean.iter().map(|x| 64.0 + 3.0 * x + 0.05 * x * x).collect();
    Figure::new("Loop, 200 cycles")
        .x("force", "N")
        .y("capacitance", "pF")
        .line("measured", &x, &y)
        .dashed_line("analytic", &mean, &line)
        .error_bars("finite elements", &mean, &line, &[0.4; 10])
        .to_svg()
}

fn convergence() -> Drawn {
    let h: Vec<f64> = (0..7).map(|i| 0.5f64.powi(i)).collect();
    let e = |order: i32| h.iter().map(|h| 0.02 * h.powi(order)).collect::<Vec<_>>();
    Figure::new("Convergence")
        .x("edge length", "mm")
        .y("relative error", "")
        .log_x()
        .log_y()
        .points("linear", &h, &e(2))
        .line("linear", &h, &e(2))
        .points("quadratic", &h, &e(4))
        .line("quadratic", &h, &e(4))
        .mark_y(1e-6, "target")
        .to_svg()
}

fn ranking() -> Drawn {
    let labels = ["N beads", "copper thickness", "RTV modulus", "bead radius", "polyimide permittivity", "electrode radius <1>"];
    Bars::new("Total Sobol index of the baseline", &labels)
        .x("total index", "")
        .series_with_interval(
            "before",
            &[0.41, 0.22, 0.19, 0.05, 0.3, 0.02],
            &[0.38, 0.2, 0.15, 0.03, 0.27, 0.01],
            &[0.44, 0.24, 0.23, 0.07, 0.33, 0.03],
        )
        .series("after", &[0.2, 0.3, 0.11, f64::NAN, 0.1, 0.07])
        .ranked()
        .to_svg()
}

fn tornado() -> Drawn {
    Bars::new(
        "Effect of each broken assumption on K_baseline",
        &["NO-FRINGING", "BIMETAL-STRIP", "RIGID-PLATES", "BEADS-DO-NOT-HOLD"],
    )
    .x("change of K_baseline", "%")
    .series("change", &[1.2, -14.8, 0.021, -41.0])
    .mark(-5.0, "limit")
    .ranked()
    .to_svg()
}

fn residual_map() -> Drawn {
    let (columns, rows) = (60, 40);
    let x: Vec<f64> = (0..=columns).map(|i| 4.5 * f64::from(i) / f64::from(columns)).collect();
    let y: Vec<f64> = (0..=rows).map(|j| 20.0 + 30.0 * f64::from(j) / f64::from(rows)).collect();
    let cells: Vec<f64> = (0..rows * columns)
        .map(|k| (f64::from(k % columns) / 60.0, f64::from(k / columns) / 40.0))
        .map(|(u, v)| if u > 0.8 && v < 0.2 { f64::NAN } else { 40.0 * (u - 0.5) * (v - 0.2) + 3.0 * (9.0 * u).sin() })
        .collect();
    HeatMap::new("Where the residual sits", &x, &y, &cells)
        .x("force", "N")
        .y("temperature", "°C")
        .value("mean residual", "fF")
        .diverging()
        .to_svg()
}

fn confusion() -> Drawn {
    let names = ["viscoelastic_creep", "thermal_lag", "dead_gap", "offset_drift", "unexplained"];
    let values: Vec<f64> = (0..25).map(|k| if k % 6 == 0 { 0.91 } else { 0.002 * f64::from(k) }).collect();
    Matrix::new("Confusion on the bank", &names, &names, &values).axes("true cause", "named cause").to_svg()
}

fn offset() -> Drawn {
    let x: Vec<f64> = (0..200).map(|i| f64::from(i) * 1e-7).collect();
    let y: Vec<f64> = x.iter().map(|x| 64.000_123 + 2e-6 * (x * 1e6).cos()).collect();
    Figure::new("A tiny change of a large value").x("time", "s").y("capacitance", "pF").line("C", &x, &y).to_svg()
}
