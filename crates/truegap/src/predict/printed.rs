//! What the paper's (12) and (17) give as printed, beside their corrected forms.
//!
//! Limits: (12) at the reference temperature; (17) for caps of a given half-angle, since for the angles of a real sensor the cubic drowns in rounding.

use serde::Serialize;
use truegap_core::Sensor;
use truegap_core::sensor::Filling;
use truegap_model::StackOptions;
use truegap_model::equations::load::{BeadLaw, compressive_strain, strain_as_printed};
use truegap_model::equations::warp::{Cap, settling_cubic_minimum, settling_plane};
use truegap_model::stack::Device;

/// (12) at one load.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Strains {
    /// force, N
    pub force_n: f64,
    /// strain by the corrected equation, negative in compression
    pub corrected: Option<f64>,
    /// root of the printed equation that starts at zero load: positive, so the load *opens* the gap
    pub printed: Option<f64>,
    /// per cent by which the printed root is larger in size
    pub size_difference_pct: Option<f64>,
}

/// (17) for one cap.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Planes {
    /// half-angle of the cap, rad
    pub half_angle_rad: f64,
    /// distance of the settled plane from the centre of the sphere, over its radius, corrected
    pub corrected: f64,
    /// least value of the printed cubic between the cap's rim and top, over the radius cubed; a root needs it to be 0 or less
    pub printed_least: f64,
}

/// (12) at five shares of the full load.
pub fn strains(sensor: &Sensor) -> Vec<Strains> {
    let shares = [0.1, 0.25, 0.5, 0.75, 1.0];
    shares.iter().map(|share| strains_at(sensor, share * sensor.full_scale)).collect()
}

fn strains_at(sensor: &Sensor, force_n: f64) -> Strains {
    let warm = Device::new(sensor, StackOptions::default()).at(sensor.reference_c);
    let reduced_load = force_n / (warm.young * warm.areas.solid);
    let poisson = match sensor.dielectric.filling {
        Filling::Beads { .. } => sensor.dielectric.layer.material.poisson,
        Filling::Solid { .. } => 0.0,
    };
    let corrected = compressive_strain(reduced_load, BeadLaw { poisson, stiffening: [0.0; 2] }).map(|e| -e);
    let printed = strain_as_printed(reduced_load, poisson);
    let size_difference_pct = corrected.zip(printed).map(|(c, p)| 100.0 * (p.abs() / c.abs() - 1.0));
    Strains { force_n, corrected, printed, size_difference_pct }
}

/// (17) for caps from nearly flat to deep.
pub fn planes() -> Vec<Planes> {
    [0.1, 0.3, 1.0].into_iter().map(planes_at).collect()
}

fn planes_at(half_angle: f64) -> Planes {
    let corrected = settling_plane(Cap { sphere_radius: 1.0, half_angle });
    Planes { half_angle_rad: half_angle, corrected, printed_least: settling_cubic_minimum(half_angle) }
}
