//! The paper's printed equations against the corrected ones, as numbers.
//!
//! Limits: the built-in sensors, 20 and 50 degrees Celsius; `docs/errata.md` says in words what each line means.

use crate::{
    CoefficientOptions, Point, SeriesOrder, StackOptions, coefficients,
    equations::{
        integral::BentPlates,
        load::{BeadLaw, reduced_load, strain_as_printed},
        quadrature::plate_integral_by_quadrature,
        warp::{Cap, Dome, sag, settling_cubic_minimum, settling_plane},
    },
    states,
};
use truegap_core::{Sensor, SimulationError, sensor::builtin_sensors};

/// One comparison.
#[derive(Clone, Debug, PartialEq)]
struct Erratum {
    /// equation of the paper
    equation: &'static str,
    /// what is compared, and where
    quantity: String,
    /// with the printed equation
    printed: String,
    /// with the corrected one
    corrected: String,
}

fn row(equation: &'static str, quantity: impl Into<String>, printed: String, corrected: String) -> Erratum {
    Erratum { equation, quantity: quantity.into(), printed, corrected }
}

/// Every comparison.
fn errata() -> Result<Vec<Erratum>, SimulationError> {
    let sensors: Vec<Sensor> = builtin_sensors().iter().take(3).filter_map(|s| s.sensor().ok()).collect();
    let mut rows = Vec::new();
    for sensor in &sensors {
        rows.push(softening(sensor)?);
    }
    rows.extend([0.05, 0.13, 0.3].map(strain));
    rows.extend([0.0108, 0.1, 0.5].map(plane));
    rows.push(cancellation());
    rows.push(integral());
    for sensor in &sensors {
        rows.push(order(sensor)?);
    }
    for sensor in &sensors {
        let k = coefficients(sensor, CoefficientOptions::default())?;
        let quantity = format!("K_baseline, {}", sensor.name);
        rows.push(row(
            "24",
            quantity,
            format!("{:.5} pF/K", k.k_baseline_pf_per_k),
            format!("{:.3} %FSR/K", k.k_baseline_pct_fsr_per_k),
        ));
    }
    Ok(rows)
}

/// The comparisons as a Markdown table.
///
/// # Errors
/// [`SimulationError`] where a built-in sensor has no answer, which the tests rule out.
pub fn errata_table() -> Result<String, SimulationError> {
    let mut text = "| eq. | quantity | printed | corrected |\n|---|---|---|---|\n".to_owned();
    for Erratum { equation, quantity, printed, corrected } in errata()? {
        text += &format!("| {equation} | {quantity} | {printed} | {corrected} |\n");
    }
    Ok(text)
}

/// (7): K_sensitivity with the sign that stiffens on warming, as the equation reads, and with the one that softens, as the text says.
fn softening(sensor: &Sensor) -> Result<Erratum, SimulationError> {
    let with = |sign: f64| {
        let mut sensor = sensor.clone();
        let softening = &mut sensor.dielectric.layer.material.softening.value;
        *softening = sign * softening.abs();
        coefficients(&sensor, CoefficientOptions::default()).map(|k| format!("{:.3} %/K", k.k_sensitivity_pct_per_k))
    };
    let quantity = format!("K_sensitivity, {}: silicone stiffens (printed sign), softens (the word)", sensor.name);
    Ok(row("7", quantity, with(1.0)?, with(-1.0)?))
}

/// (12): the strain that the printed cubic gives for the load of a known strain.
fn strain(strain: f64) -> Erratum {
    let law = BeadLaw { poisson: 0.49, stiffening: [0.0; 2] };
    let load = reduced_load(law, strain);
    let printed = strain_as_printed(load, law.poisson).map_or("no root".to_owned(), |e| format!("+{e:.6} (gap opens)"));
    row("12", format!("strain at F/(E A) = {load:.6}, Poisson's ratio 0.49"), printed, format!("{:.6}", -strain))
}

/// (17): whether the printed cubic has a root inside the cap, and where the plane is.
fn plane(half_angle: f64) -> Erratum {
    let lowest = settling_cubic_minimum(half_angle);
    let printed = if lowest > 0.0 { format!("no root: cubic >= {lowest:.2e} R^3") } else { "a root".to_owned() };
    let below = 1.0 - settling_plane(Cap { sphere_radius: 1.0, half_angle });
    row("17", format!("plane of a cap of half-angle {half_angle} rad"), printed, format!("{below:.4e} R below the top"))
}

/// (18): sag 5 mm off the axis of a plate that is nearly flat.
fn cancellation() -> Erratum {
    let (curvature, distance) = (4.788_573e-5, 5e-3);
    let radius: f64 = 1.0 / curvature;
    let printed = radius - (radius * radius - distance * distance).sqrt();
    let corrected = sag(Dome { curvature, radius: 7.5e-3 }, distance);
    row(
        "18",
        "sag at 5 mm, default sensor 1 mK above reference, in doubles",
        format!("{printed:.4e} m"),
        format!("{corrected:.4e} m"),
    )
}

/// (19): the integral by the paper's double integral and in closed form.
fn integral() -> Erratum {
    let plates = BentPlates::settled(162e-6, Dome { curvature: 1.436_068, radius: 7.5e-3 });
    let (slow, closed) = (plate_integral_by_quadrature(plates, 1e-12), plates.integral());
    row(
        "19",
        "integral of dA/d, default sensor unloaded at 50 degC",
        format!("{slow:.12} m (quadrature)"),
        format!("{closed:.12} m (closed form)"),
    )
}

/// (21): main capacitance in both orders.
fn order(sensor: &Sensor) -> Result<Erratum, SimulationError> {
    let main = |series| {
        let options = StackOptions { series, ..StackOptions::default() };
        let point = Point { force_n: sensor.full_scale, temperature_c: 50.0 };
        states(sensor, options, &[point]).map(|s| format!("{:.4} pF", s.iter().map(|s| s.c_main_pf).sum::<f64>()))
    };
    let quantity = format!("C_main, {}, full load at 50 degC: integrate then series, series then integrate", sensor.name);
    Ok(row("21", quantity, main(SeriesOrder::IntegrateThenSeries)?, main(SeriesOrder::SeriesThenIntegrate)?))
}
