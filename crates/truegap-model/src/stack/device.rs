//! One set of parameter values turned into the numbers that every row shares, and the equations walked for one row.
//!
//! Limits: one temperature through the whole sensor; tilt, warp and load sag act on the bead gap only.

use super::options::{SeriesOrder, StackOptions};
use crate::equations::{
    curvature::{Bimetal, ExpansionPair, Lamina, bimetal_curvature, mismatch_strain},
    electrodes::{
        Fillings, SeriesLayer, Shares, Trace, mean_permittivity, series, series_then_integrated, tail_capacitance,
        total_capacitance,
    },
    integral::BentPlates,
    load::{BeadLaw, Layers, compressive_strain, loaded_height, loaded_thickness, mean_separation, spread_area},
    plates::{Compression, plate_capacitance},
    thermal::{Areas, expanded_area, expanded_length, total_bead_area, young_at},
    warp::{Dome, RimSag, rim_sag},
};
use crate::wedge::shape_factor;
use std::f64::consts::PI;
use truegap_core::{
    Refusal, Sensor, Simulator, VACUUM_PERMITTIVITY,
    sensor::{Filling, Layer, Layout},
};

/// A simulator whose parameter values describe a device.
pub(super) trait Described: Simulator {
    /// The numbers of one set of parameter values, ready for any row.
    fn described(&self, values: &[f64]) -> Device;
}

/// A layer's constants without its name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sheet {
    pub(super) young: f64,
    pub(super) expansion: f64,
    pub(super) thickness: f64,
    pub(super) permittivity: f64,
}

impl Sheet {
    fn of(layer: &Layer) -> Self {
        let m = &layer.material;
        Self {
            young: m.young.value,
            expansion: m.expansion,
            thickness: layer.thickness.value,
            permittivity: VACUUM_PERMITTIVITY * m.permittivity,
        }
    }

    fn lamina(self, kelvin: f64) -> Lamina {
        Lamina { young: self.young, thickness: expanded_length(self.thickness, self.expansion, kelvin) }
    }
}

/// The numbers of one sensor that every row shares.
#[derive(Clone, Debug)]
pub struct Device {
    pub(super) rubber: Sheet,
    pub(super) softening: f64,
    pub(super) poisson: f64,
    pub(super) solid: Solid,
    pub(super) surrounding: f64,
    pub(super) radius: f64,
    pub(super) conductor: Sheet,
    pub(super) plating: Option<Sheet>,
    pub(super) insulator: Sheet,
    pub(super) trace: Trace,
    pub(super) stray: f64,
    pub(super) shielded: bool,
    pub(super) options: StackOptions,
    /// temperature of the dimensions, degrees Celsius
    pub reference_c: f64,
    /// load at full scale, N
    pub full_scale: f64,
}

/// Area of the solid part of the dielectric.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Solid {
    /// beads: area at the reference temperature, m²
    Beads(f64),
    /// share of the electrode
    Share(f64),
}

/// A sensor at one temperature, before load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Warm {
    /// difference to the reference temperature, K
    pub kelvin: f64,
    /// radius of the electrode, m
    pub radius: f64,
    /// electrode and beads, m²
    pub areas: Areas,
    /// Young's modulus of the beads, Pa
    pub young: f64,
    /// beads and insulator, m
    pub layers: Layers,
}

/// What a row does to a warm sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Squeeze {
    /// force on the sensor, N
    pub force_n: f64,
    /// compressive strain of the beads
    pub strain: f64,
    /// temperature difference that bends the electrode, K
    pub warp_kelvin: f64,
    /// factor on the curvature
    pub warp_factor: f64,
    /// extra gap in series with the beads, share of the unloaded gap at the reference temperature
    pub gap: f64,
    /// wedge: difference between rim and centre over the mean gap
    pub tilt: f64,
    /// rim sag that the load adds, share of the unloaded gap at the reference temperature
    pub sag: f64,
    /// factor on the permittivity of the beads
    pub beads: f64,
    /// factor on the permittivity of the insulator
    pub insulator: f64,
}

/// Capacitances of one row, F.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capacitances {
    /// bead layer
    pub beads: f64,
    /// insulator in series with it
    pub insulator: f64,
    /// what is added up
    pub shares: Shares,
    /// mean separation of the electrodes over their radius
    pub aspect: f64,
    /// curvature of the electrode, 1/m
    pub curvature: f64,
}

impl Device {
    /// The numbers of a sensor.
    pub fn new(sensor: &Sensor, options: StackOptions) -> Self {
        let rubber = &sensor.dielectric.layer;
        let (solid, poisson) = match sensor.dielectric.filling {
            Filling::Beads { count, diameter } => {
                let bead = 0.25 * PI * diameter.value * diameter.value;
                (Solid::Beads(total_bead_area(count, bead)), rubber.material.poisson)
            }
            // held sideways by the electrodes: no spreading, and the area follows the electrode
            Filling::Solid { coverage } => (Solid::Share(coverage), 0.0),
        };
        Self {
            rubber: Sheet::of(rubber),
            softening: rubber.material.softening.value,
            poisson,
            solid,
            surrounding: VACUUM_PERMITTIVITY * sensor.dielectric.surrounding_permittivity,
            radius: 0.5 * sensor.diameter.value,
            conductor: Sheet::of(&sensor.conductor),
            plating: sensor.plating.as_ref().map(Sheet::of),
            insulator: Sheet::of(&sensor.insulator),
            trace: Trace { length: sensor.tail.0, width: sensor.tail.1 },
            stray: sensor.stray.value,
            shielded: sensor.layout == Layout::Shielded,
            options,
            reference_c: sensor.reference_c,
            full_scale: sensor.full_scale,
        }
    }

    /// Factor on the curvature of the base model: 1 where it warps, else 0.
    pub fn warp_factor(&self) -> f64 {
        f64::from(u8::from(self.options.warp && self.plating.is_some()))
    }

    /// The sensor at a temperature.
    #[inline]
    pub fn at(&self, temperature_c: f64) -> Warm {
        self.warmed_by(temperature_c - self.reference_c)
    }

    /// The sensor so many kelvin above its reference temperature.
    #[inline]
    pub fn warmed_by(&self, kelvin: f64) -> Warm {
        let radius = expanded_length(self.radius, self.conductor.expansion, kelvin);
        let electrode = PI * radius * radius;
        let solid = match self.solid {
            Solid::Beads(area) => expanded_area(area, self.rubber.expansion, kelvin),
            Solid::Share(share) => share * electrode,
        };
        Warm {
            kelvin,
            radius,
            areas: Areas { electrode, solid },
            young: young_at(self.rubber.young, self.softening, kelvin),
            layers: Layers {
                beads: expanded_length(self.rubber.thickness, self.rubber.expansion, kelvin),
                insulator: expanded_length(self.insulator.thickness, self.insulator.expansion, kelvin),
            },
        }
    }

    /// Compressive strain of the beads under a force; `modulus` is a factor on their Young's modulus, `stiffening` as in [`BeadLaw`].
    ///
    /// # Errors
    /// [`Refusal`] where there is no strain, or one that closes the gap.
    pub fn strain(&self, warm: &Warm, force_n: f64, modulus: f64, stiffening: [f64; 2]) -> Result<f64, Refusal> {
        let stiffness = warm.areas.solid * warm.young * modulus;
        if stiffness.is_nan() || stiffness <= 0.0 {
            return Err(Refusal::NoAnswer);
        }
        let law = BeadLaw { poisson: self.poisson, stiffening };
        match compressive_strain(force_n / stiffness, law) {
            Some(strain) if strain < 1.0 => Ok(strain),
            Some(strain) => Err(Refusal::Touches { strain }),
            None if force_n > 0.0 => Err(Refusal::Touches { strain: 1.0 }),
            None => Err(Refusal::NoAnswer),
        }
    }

    /// The paper's row: load and temperature, nothing else.
    pub fn plain(&self, warm: &Warm, force_n: f64, strain: f64) -> Squeeze {
        Squeeze {
            force_n,
            strain,
            warp_kelvin: warm.kelvin,
            warp_factor: self.warp_factor(),
            gap: 0.0,
            tilt: 0.0,
            sag: 0.0,
            beads: 1.0,
            insulator: 1.0,
        }
    }

    /// Curvature of the electrode, 1/m; 0 where nothing warps it.
    fn curvature(&self, warm: &Warm, row: &Squeeze) -> f64 {
        if row.warp_factor == 0.0 { 0.0 } else { row.warp_factor * self.bend(warm, row.warp_kelvin) }
    }

    /// Curvature that a temperature difference gives the electrode, 1/m; 0 where it is of one metal.
    pub(super) fn bend(&self, warm: &Warm, warp_kelvin: f64) -> f64 {
        self.plating.map_or(0.0, |plating| self.bent(plating, warm.kelvin, warp_kelvin))
    }

    /// The same with this plating, in a sensor so many kelvin above its reference temperature.
    #[inline]
    pub(super) fn bent(&self, plating: Sheet, kelvin: f64, warp_kelvin: f64) -> f64 {
        let expansions = ExpansionPair { first: plating.expansion, second: self.conductor.expansion };
        let layers = Bimetal { first: plating.lamina(kelvin), second: self.conductor.lamina(kelvin) };
        bimetal_curvature(layers, mismatch_strain(expansions, warp_kelvin))
    }

    /// Capacitances of a row.
    ///
    /// # Errors
    /// [`Refusal::Touches`] where the plates touch somewhere.
    pub fn capacitances(&self, warm: &Warm, row: &Squeeze) -> Result<Capacitances, Refusal> {
        let touches = Refusal::Touches { strain: row.strain };
        let curvature = self.curvature(warm, row);
        // what is added to the gap does not grow with the silicone
        let cold = self.rubber.thickness;
        let mut dome = Dome { curvature, radius: warm.radius };
        if row.sag != 0.0 {
            dome = Dome::from_rim_sag(RimSag { sag: rim_sag(dome) + row.sag * cold, radius: warm.radius });
        }
        let pressure = Compression { pressure: row.force_n / warm.areas.electrode, young: self.insulator.young };
        let layers = Layers {
            beads: loaded_height(warm.layers.beads, row.strain),
            insulator: loaded_thickness(warm.layers.insulator, pressure),
        };
        let extra = row.gap * cold;
        let plates = BentPlates::settled(layers.beads, dome);
        if !(plates.apart() && layers.insulator > 0.0 && layers.beads + extra > 0.0) {
            return Err(touches);
        }
        let gap = Gap { plates, extra, mean: layers.beads, tilt: row.tilt };
        let Some((beads, main, insulator)) = self.main_gap(warm, row, gap, layers.insulator) else {
            return Err(touches);
        };
        let behind = self.insulator.permittivity * row.insulator;
        let (backing, tail) =
            if self.shielded { (insulator, tail_capacitance(behind, self.trace, warm.layers.insulator)) } else { (0.0, 0.0) };
        let shares = Shares { main, backing, tail };
        let aspect = (mean_separation(layers) + extra) / warm.radius;
        Ok(Capacitances { beads, insulator, shares, aspect, curvature })
    }

    /// Bead layer, main gap and insulator, F; `None` where the plates touch.
    fn main_gap(&self, warm: &Warm, row: &Squeeze, gap: Gap, insulator_m: f64) -> Option<(f64, f64, f64)> {
        let solid = spread_area(warm.areas.solid, self.poisson, row.strain);
        let fillings = Fillings { solid: self.rubber.permittivity * row.beads, surrounding: self.surrounding };
        let permittivity = mean_permittivity(fillings, Areas { solid, ..warm.areas });
        let behind = self.insulator.permittivity * row.insulator;
        let insulator = plate_capacitance(behind, warm.areas.electrode, insulator_m);
        // an extra gap lies in series with the beads at every point of the plate: so much more of them, or less
        let air = gap.extra * permittivity / self.surrounding;
        let plates = BentPlates { centre_gap: gap.plates.centre_gap + air, ..gap.plates };
        if !plates.apart() {
            return None;
        }
        let beads = permittivity * plates.integral() * gap.wedge(gap.mean + air)?;
        let main = match self.options.series {
            SeriesOrder::IntegrateThenSeries => series([beads, insulator]),
            SeriesOrder::SeriesThenIntegrate => {
                let layer = SeriesLayer { thickness: insulator_m, permittivity: behind };
                let deeper = gap.mean + air + insulator_m * permittivity / behind;
                series_then_integrated(permittivity, plates, layer) * gap.wedge(deeper)?
            }
        };
        Some((beads, main, insulator))
    }

    /// Everything beside the main gap, F.
    pub fn beside(&self, shares: &Shares) -> f64 {
        shares.backing + shares.tail + self.stray
    }

    /// What is read, F: (23) and the stray capacitance.
    pub fn total(&self, shares: Shares) -> f64 {
        total_capacitance(shares) + self.stray
    }
}

/// The bead gap of a row.
#[derive(Clone, Copy)]
struct Gap {
    plates: BentPlates,
    extra: f64,
    mean: f64,
    tilt: f64,
}

impl Gap {
    /// Factor of the wedge on the capacitance of the dome, where the mean gap counts as `depth`; `None` where the plates touch.
    fn wedge(&self, depth: f64) -> Option<f64> {
        if self.tilt == 0.0 {
            return Some(1.0);
        }
        let sag = rim_sag(self.plates.dome) / depth;
        Some(shape_factor(self.tilt * self.mean / depth, sag)? / shape_factor(0.0, sag)?)
    }
}
