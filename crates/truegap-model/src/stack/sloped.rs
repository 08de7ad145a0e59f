//! Capacitances of one row together with how fast they change with what they are computed from.
//!
//! Limits: first order; the equations are those of [`super::device`], whose tests hold them together.

use super::{device::Device, options::SeriesOrder};
use crate::{
    equations::{
        integral::BentPlates,
        slopes::{integral_slopes, mean_sag_slopes, rim_sag_slopes},
        warp::{Dome, RimSag, rim_sag},
    },
    wedge::shape_factor,
};
use std::f64::consts::PI;

/// Number of quantities in [`Shape`].
pub(super) const QUANTITIES: usize = 12;

/// Step of the difference quotients of the wedge, which is in closed form to 1e-12.
const WEDGE_STEP: f64 = 1e-5;

/// What the capacitances of a row are computed from, in the order of [`at`].
pub(super) type Shape = [f64; QUANTITIES];

/// Places of the quantities in a [`Shape`].
pub(super) mod at {
    /// curvature of the electrode before any load sag, 1/m
    pub const CURVATURE: usize = 0;
    /// radius of the electrode, m
    pub const RADIUS: usize = 1;
    /// solid area of the dielectric before load, m²
    pub const SOLID: usize = 2;
    /// height of the dielectric before load, m
    pub const BEADS: usize = 3;
    /// thickness of the insulator before load, m
    pub const INSULATOR: usize = 4;
    /// compressive strain of the dielectric
    pub const STRAIN: usize = 5;
    /// force, N
    pub const FORCE: usize = 6;
    /// extra gap in series, m
    pub const EXTRA: usize = 7;
    /// wedge over the mean gap
    pub const TILT: usize = 8;
    /// rim sag that the load adds, m
    pub const SAG: usize = 9;
    /// permittivity of the solid, F/m
    pub const SOLID_PERMITTIVITY: usize = 10;
    /// permittivity of the insulator, F/m
    pub const BEHIND: usize = 11;
}

/// Places of the quantities that the insulator behind the electrode and the tail follow.
pub(super) const BESIDE: [usize; 4] = [at::RADIUS, at::INSULATOR, at::FORCE, at::BEHIND];

/// Capacitances of a row, and their slopes by each quantity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sloped {
    /// main gap, F
    pub main: f64,
    pub by: Shape,
    /// insulator behind the electrode with the tail, F
    pub beside: f64,
    /// by the quantities of [`BESIDE`]
    pub beside_by: [f64; BESIDE.len()],
}

/// Mean separation of the electrodes over their radius.
#[inline]
pub(super) fn aspect(device: &Device, shape: &Shape) -> f64 {
    aspect_of(device, [at::RADIUS, at::FORCE, at::BEADS, at::STRAIN, at::INSULATOR, at::EXTRA].map(|place| shape[place]))
}

/// The same, from these of the quantities: radius, force, height, strain, insulator, extra gap.
#[inline]
pub(super) fn aspect_of(device: &Device, [radius, force, beads, strain, insulator, extra]: [f64; 6]) -> f64 {
    let squeezed = 1.0 - force / (PI * radius * radius * device.insulator.young);
    let separation = beads * (1.0 - strain) + insulator * squeezed + extra;
    separation / radius
}

/// What the main gap is computed from.
struct MainGap {
    dome: Dome,
    tilt: f64,
    /// height of the dielectric under load, m
    mean: f64,
    /// extra gap, m
    extra: f64,
    /// of the dielectric, F/m
    permittivity: f64,
    /// of the insulator, F/m
    behind: f64,
    /// thickness of the insulator under load, m
    insulator: f64,
    /// capacitance of the insulator over the whole plate, F
    plate: f64,
}

/// The main gap, F, and its slopes by what it is computed from.
#[derive(Default)]
struct MainSlopes {
    value: f64,
    curvature: f64,
    radius: f64,
    tilt: f64,
    mean: f64,
    extra: f64,
    permittivity: f64,
    behind: f64,
    insulator: f64,
    plate: f64,
}

/// The row with its slopes; `None` where the plates touch.
pub(super) fn sloped(device: &Device, shape: &Shape) -> Option<Sloped> {
    let [curvature, radius, area, height, thickness, strain, force, extra, tilt, sag, solid, behind] = *shape;
    let inverse_area = (PI * radius * radius).recip();
    let spread = 1.0 + device.poisson * strain;
    let excess = solid - device.surrounding;
    let squeezed = 1.0 - force * inverse_area / device.insulator.young;
    let (unbent, insulator) = (Dome { curvature, radius }, thickness * squeezed);
    let plate = behind / (inverse_area * insulator);
    let gap = MainGap {
        dome: bent_further(unbent, sag),
        tilt,
        mean: height * (1.0 - strain),
        extra,
        permittivity: device.surrounding + excess * area * spread * spread * inverse_area,
        behind,
        insulator,
        plate,
    };
    let by = main_gap(device, &gap)?;

    // slopes by the insulator's thickness under load and by one over the electrode's area, back to what these come from
    let through = |by_insulator: f64, by_inverse: f64| {
        let mut slopes = [0.0; QUANTITIES];
        let pressed = by_insulator * thickness / device.insulator.young;
        slopes[at::INSULATOR] = by_insulator * squeezed;
        slopes[at::FORCE] = -pressed * inverse_area;
        slopes[at::RADIUS] = -2.0 * inverse_area / radius * (by_inverse - pressed * force);
        slopes
    };
    let by_solid = by.permittivity * excess * spread;
    let mut main =
        through(by.insulator - by.plate * plate / insulator, by_solid * area * spread - by.plate * plate / inverse_area);
    main[at::SOLID] = by_solid * spread * inverse_area;
    main[at::BEADS] = by.mean * (1.0 - strain);
    main[at::STRAIN] = 2.0 * by_solid * area * inverse_area * device.poisson - by.mean * height;
    main[at::EXTRA] = by.extra;
    main[at::TILT] = by.tilt;
    main[at::SOLID_PERMITTIVITY] = by.permittivity * area * spread * spread * inverse_area;
    main[at::BEHIND] = by.behind + by.plate * plate / behind;
    through_sag(&mut main, &by, unbent, sag);

    let (mut beside, mut capacitance) = ([0.0; QUANTITIES], 0.0);
    if device.shielded {
        let tail = 2.0 * behind * device.trace.length * device.trace.width / thickness;
        capacitance = plate + tail;
        beside = through(-plate / insulator, -plate / inverse_area);
        beside[at::INSULATOR] -= tail / thickness;
        beside[at::BEHIND] = capacitance / behind;
    }

    Some(Sloped { main: by.value, by: main, beside: capacitance, beside_by: BESIDE.map(|place| beside[place]) })
}

/// The main gap with its slopes; `None` where the plates touch.
fn main_gap(device: &Device, gap: &MainGap) -> Option<MainSlopes> {
    let pointwise = device.options.series == SeriesOrder::SeriesThenIntegrate;
    // an extra gap counts as more of the dielectric, and so does the insulator where the layers are added point by point
    let air = gap.permittivity / device.surrounding;
    let layer = if pointwise { gap.permittivity / gap.behind } else { 0.0 };
    let depth = gap.mean + gap.extra * air + gap.insulator * layer;
    let settled = mean_sag_slopes(gap.dome);
    let plates = BentPlates { dome: gap.dome, centre_gap: depth - settled.height };
    if !plates.apart() {
        return None;
    }
    let integral = integral_slopes(plates);
    let wedge = Wedge::of(gap, depth)?;
    let value = gap.permittivity * integral.integral * wedge.factor;
    let share = if pointwise { 1.0 } else { gap.plate / (value + gap.plate) };
    let (own, other) = (share * share, if pointwise { 0.0 } else { (1.0 - share) * (1.0 - share) });

    let scale = own * gap.permittivity * wedge.factor;
    let turned = own * gap.permittivity * integral.integral;
    let by_depth = scale * integral.by_gap + turned * wedge.by_depth;
    Some(MainSlopes {
        value: if pointwise { value } else { share * value },
        curvature: scale * (integral.by_curvature - integral.by_gap * settled.by_curvature) + turned * wedge.by_curvature,
        radius: scale * (integral.by_radius - integral.by_gap * settled.by_radius) + turned * wedge.by_radius,
        tilt: turned * wedge.by_tilt,
        mean: by_depth + turned * wedge.by_mean,
        extra: by_depth * air,
        permittivity: own * integral.integral * wedge.factor
            + by_depth * (gap.extra / device.surrounding + if pointwise { gap.insulator / gap.behind } else { 0.0 }),
        behind: -by_depth * gap.insulator * layer / gap.behind,
        insulator: by_depth * layer,
        plate: other,
    })
}

/// The dome with the sag that the load adds at its rim.
fn bent_further(dome: Dome, sag: f64) -> Dome {
    if sag == 0.0 { dome } else { Dome::from_rim_sag(RimSag { sag: rim_sag(dome) + sag, radius: dome.radius }) }
}

/// Slopes by curvature and radius of the bent dome, back to the dome before the load and the sag that the load adds.
fn through_sag(slopes: &mut Shape, by: &MainSlopes, unbent: Dome, sag: f64) {
    let rim = rim_sag_slopes(unbent);
    let (s, r) = (rim.height + sag, unbent.radius);
    let squares = r * r + s * s;
    let by_sag = by.curvature * 2.0 * (r * r - s * s) / (squares * squares);
    slopes[at::SAG] = by_sag;
    if sag == 0.0 {
        slopes[at::CURVATURE] = by.curvature;
        slopes[at::RADIUS] += by.radius;
    } else {
        slopes[at::CURVATURE] = by_sag * rim.by_curvature;
        slopes[at::RADIUS] += by.radius - by.curvature * 4.0 * s * r / (squares * squares) + by_sag * rim.by_radius;
    }
}

/// Factor of a wedge on the capacitance of a dome, with its slopes.
#[derive(Default)]
struct Wedge {
    factor: f64,
    by_tilt: f64,
    by_mean: f64,
    by_depth: f64,
    by_curvature: f64,
    by_radius: f64,
}

impl Wedge {
    /// The wedge of a gap that counts as `depth`; `None` where the plates touch.
    fn of(gap: &MainGap, depth: f64) -> Option<Self> {
        if gap.tilt == 0.0 {
            return Some(Self { factor: 1.0, ..Self::default() });
        }
        let rim = rim_sag_slopes(gap.dome);
        let (tilt, sag) = (gap.tilt * gap.mean / depth, rim.height / depth);
        let factor = |tilt: f64, sag: f64| Some(shape_factor(tilt, sag)? / shape_factor(0.0, sag)?);
        let quotient = |more: Option<f64>, less: Option<f64>| Some((more? - less?) / (2.0 * WEDGE_STEP));
        let by_tilt = quotient(factor(tilt + WEDGE_STEP, sag), factor(tilt - WEDGE_STEP, sag))?;
        let by_sag = quotient(factor(tilt, sag + WEDGE_STEP), factor(tilt, sag - WEDGE_STEP))?;
        Some(Self {
            factor: factor(tilt, sag)?,
            by_tilt: by_tilt * gap.mean / depth,
            by_mean: by_tilt * gap.tilt / depth,
            by_depth: -(by_tilt * tilt + by_sag * sag) / depth,
            by_curvature: by_sag * rim.by_curvature / depth,
            by_radius: by_sag * rim.by_radius / depth,
        })
    }
}
