//! The physics of the stack in blocks of rows: every equation down a block before the next, so that rows are computed two or four at a time, as the processor has registers.
//!
//! Limits: neither wedge nor load sag, layers in series after the integral; [`Rows`] answers the others, row by row, and says which row has no answer. Equal to it to the
//! last bit.

use super::{
    device::{Device, Solid},
    options::SeriesOrder,
    plates::{PICO, Rows, force_n},
};
use crate::equations::{
    electrodes::{Fillings, mean_permittivity, series, tail_capacitance},
    integral::BentPlates,
    load::{BeadLaw, Layers, compressive_strains, loaded_height, loaded_thickness, mean_separation, spread_area},
    plates::{Compression, plate_capacitance},
    thermal::{Areas, expanded_area, expanded_length},
    warp::Dome,
};
use pulp::Arch;
use rayon::prelude::*;
use std::{borrow::Cow, f64::consts::PI};
use truegap_core::{
    Dielectric, Drive, GapReadings, Geometry, Inputs, PlateColumns, Plates, Readings, Readout, RefusedRow, SimulationError,
    check_finite,
};

/// Rows of a block: two dozen columns of it stay near the processor.
const BLOCK: usize = 32;

/// Rows that one processor computes at a time where another one is idle; whole blocks.
const SHARE: usize = 16 * BLOCK;

/// Value, aspect and plates of the rows of a share.
type Share<'a> = ((&'a mut [f64], &'a mut [f64]), &'a mut [f64]);

/// A column of a block.
type Rows32 = [f64; BLOCK];

/// A device and the parameter values that made it.
pub(super) struct Filled<'a>(pub Rows<'a>);

impl PlateColumns for Filled<'_> {
    fn strains(&self, drive: &Drive<'_>, modulus: &[f64], stiffening: [f64; 2]) -> Result<Vec<f64>, RefusedRow> {
        let device = self.0.device;
        let law = BeadLaw { poisson: device.poisson, stiffening };
        let stiffness: Vec<f64> = (0..modulus.len())
            .map(|row| {
                let warm = device.at(drive.temperature_c[row]);
                warm.areas.solid * warm.young * modulus[row]
            })
            .collect();
        let reduced: Vec<f64> = stiffness.iter().enumerate().map(|(row, stiffness)| force_n(drive, row) / stiffness).collect();
        let strains = compressive_strains(&reduced, law);
        let answered = stiffness.iter().zip(&strains).fold(true, |all, (s, e)| all & (*s > 0.0) & (*e < 1.0));
        if answered { Ok(strains) } else { PlateColumns::strains(&self.0, drive, modulus, stiffening) }
    }

    fn warp_factor(&self) -> f64 {
        self.0.device.warp_factor()
    }

    fn readings(&self, drive: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<Readings, RefusedRow> {
        let none = |column: &[f64]| column.iter().fold(true, |all, value| all & (*value == 0.0));
        let plain =
            self.0.device.options.series == SeriesOrder::IntegrateThenSeries && none(&geometry.tilt) && none(&geometry.sag);
        let found = if plain { in_blocks(self.0.device, drive, geometry, factors) } else { None };
        found.map_or_else(|| PlateColumns::readings(&self.0, drive, geometry, factors), Ok)
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        Plates::readout(&self.0)
    }
}

/// Response of each row, pF, nothing plugged in.
pub(super) fn plain(
    filled: &Filled<'_>,
    inputs: &Inputs,
    force: &[f64],
    temperature: Option<&[f64]>,
) -> Result<Vec<f64>, SimulationError> {
    let Rows { device, values } = filled.0;
    let (rows, reference_c) = (force.len(), device.reference_c);
    let temperature = temperature.map_or_else(|| Cow::Owned(vec![reference_c; rows]), Cow::Borrowed);
    // the force itself: through the share of the full load it would lose its last digit
    let drive = Drive { inputs, load: force, temperature_c: &temperature, reference_c, full_load: 1.0 };
    let refused = |(row, refusal): RefusedRow| refusal.at(row, force[row], values);
    let strain = filled.strains(&drive, &vec![1.0; rows], [0.0; 2]).map_err(refused)?;
    let geometry = Geometry {
        strain: &strain,
        gap: vec![0.0; rows],
        warp_kelvin: temperature.iter().map(|t| t - reference_c).collect(),
        warp_factor: filled.warp_factor(),
        tilt: vec![0.0; rows],
        sag: vec![0.0; rows],
    };
    let factors = Dielectric { beads: vec![1.0; rows], insulator: vec![1.0; rows] };
    check_finite(filled.readings(&drive, &geometry, &factors).map_err(refused)?.value, values)
}

/// What the plates read, block by block; `None` where they touch in any row.
fn in_blocks(device: &Device, drive: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> Option<Readings> {
    let rows = drive.load.len();
    let [mut value, mut aspect, mut plates] = [(); 3].map(|()| vec![0.0; rows]);
    let shares = value.par_chunks_mut(SHARE).zip(aspect.par_chunks_mut(SHARE)).zip(plates.par_chunks_mut(SHARE)).enumerate();
    let fill = |(share, ((value, aspect), plates)): (usize, Share<'_>)| {
        // wide registers where there are any: the same operations, so the same digits
        Arch::new().dispatch(
            #[inline(always)]
            || {
                for start in (0..value.len()).step_by(BLOCK) {
                    let count = BLOCK.min(value.len() - start);
                    let read = block(device, &Given::of(device, (drive, geometry, factors), share * SHARE + start, count))?;
                    value[start..start + count].copy_from_slice(&read.value[..count]);
                    aspect[start..start + count].copy_from_slice(&read.aspect[..count]);
                    plates[start..start + count].copy_from_slice(&read.plates[..count]);
                }
                Some(())
            },
        )
    };
    shares.map(fill).collect::<Option<()>>()?;
    Some(Readings { value, gap: Some(GapReadings { aspect, plates }) })
}

/// What a block of rows is computed from.
struct Given {
    kelvin: Rows32,
    force_n: Rows32,
    strain: Rows32,
    gap: Rows32,
    warp_kelvin: Rows32,
    warp_factor: f64,
    beads: Rows32,
    insulator: Rows32,
}

impl Given {
    /// The rows from `start` on; what is missing at the end is the last of `count` rows once more.
    #[inline(always)]
    fn of(
        device: &Device,
        (drive, geometry, factors): (&Drive<'_>, &Geometry<'_>, &Dielectric),
        start: usize,
        count: usize,
    ) -> Self {
        let of = |column: &[f64]| -> Rows32 { std::array::from_fn(|k| column[start + k.min(count - 1)]) };
        Self {
            kelvin: of(drive.temperature_c).map(|t| t - device.reference_c),
            force_n: of(drive.load).map(|load| load * drive.full_load),
            strain: of(geometry.strain),
            gap: of(&geometry.gap),
            warp_kelvin: of(&geometry.warp_kelvin),
            warp_factor: geometry.warp_factor,
            beads: of(&factors.beads),
            insulator: of(&factors.insulator),
        }
    }
}

/// What a block of rows reads.
struct Read {
    value: Rows32,
    aspect: Rows32,
    plates: Rows32,
}

/// A column of a block, row by row.
#[inline(always)]
fn column(of: impl Fn(usize) -> f64) -> Rows32 {
    let mut column = [0.0; BLOCK];
    column.iter_mut().enumerate().for_each(|(k, value)| *value = of(k));
    column
}

/// The readings of a block: the equations of [`Device::capacitances`] in their order; `None` where the plates touch in any row.
#[inline(always)]
fn block(device: &Device, given: &Given) -> Option<Read> {
    let Given { kelvin, force_n, strain, .. } = given;
    let radius = column(|k| expanded_length(device.radius, device.conductor.expansion, kelvin[k]));
    let electrode = column(|k| PI * radius[k] * radius[k]);
    let solid = match device.solid {
        Solid::Beads(area) => column(|k| expanded_area(area, device.rubber.expansion, kelvin[k])),
        Solid::Share(share) => column(|k| share * electrode[k]),
    };
    let height = column(|k| expanded_length(device.rubber.thickness, device.rubber.expansion, kelvin[k]));
    let thickness = column(|k| expanded_length(device.insulator.thickness, device.insulator.expansion, kelvin[k]));
    let curvature = match device.plating.filter(|_| given.warp_factor != 0.0) {
        Some(plating) => column(|k| given.warp_factor * device.bent(plating, kelvin[k], given.warp_kelvin[k])),
        None => [given.warp_factor * 0.0; BLOCK],
    };
    let beads = column(|k| loaded_height(height[k], strain[k]));
    let insulator = column(|k| {
        loaded_thickness(thickness[k], Compression { pressure: force_n[k] / electrode[k], young: device.insulator.young })
    });
    let extra = column(|k| given.gap[k] * device.rubber.thickness);
    let dome = |k: usize| Dome { curvature: curvature[k], radius: radius[k] };
    let settled = column(|k| BentPlates::settled(beads[k], dome(k)).centre_gap);
    let permittivity = column(|k| {
        let fillings = Fillings { solid: device.rubber.permittivity * given.beads[k], surrounding: device.surrounding };
        let solid = spread_area(solid[k], device.poisson, strain[k]);
        mean_permittivity(fillings, Areas { electrode: electrode[k], solid })
    });
    // an extra gap counts as more of the beads
    let centre = column(|k| settled[k] + extra[k] * permittivity[k] / device.surrounding);
    let apart = |k: usize| {
        let [first, second] = [settled[k], centre[k]].map(|centre_gap| BentPlates { dome: dome(k), centre_gap }.apart());
        first & second & (insulator[k] > 0.0) & (beads[k] + extra[k] > 0.0)
    };
    if !(0..BLOCK).fold(true, |all, k| all & apart(k)) {
        return None;
    }
    let integral: Rows32 = BentPlates::integrals(|k| BentPlates { dome: dome(k), centre_gap: centre[k] });
    let behind = column(|k| device.insulator.permittivity * given.insulator[k]);
    let plate = column(|k| plate_capacitance(behind[k], electrode[k], insulator[k]));
    let main = column(|k| series([permittivity[k] * integral[k] * 1.0, plate[k]]));
    let beside = if device.shielded {
        column(|k| main[k] + plate[k] + tail_capacitance(behind[k], device.trace, thickness[k]))
    } else {
        column(|k| main[k] + 0.0 + 0.0)
    };
    Some(Read {
        value: column(|k| (beside[k] + device.stray) * PICO),
        aspect: column(|k| (mean_separation(Layers { beads: beads[k], insulator: insulator[k] }) + extra[k]) / radius[k]),
        plates: column(|k| main[k] * PICO),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Stack, StackOptions, cases};
    use truegap_core::{Simulator, Stage, walk};

    /// A gap, a warp and factors of their own.
    struct Acts(f64);

    impl Stage for Acts {
        fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
            factor.iter_mut().zip(drive.load).for_each(|(factor, load)| *factor += self.0 * load);
        }
        fn stiffening(&self) -> [f64; 2] {
            [self.0, 0.0]
        }
        fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
            geometry.gap.iter_mut().zip(drive.load).for_each(|(gap, load)| *gap += 0.1 * self.0 * load);
            geometry.warp_kelvin.iter_mut().for_each(|kelvin| *kelvin += 20.0 * self.0);
        }
        fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
            factors.beads.iter_mut().zip(drive.load).for_each(|(beads, load)| *beads += self.0 * load);
        }
    }

    fn responses(stack: &Stack, inputs: &Inputs, stages: &[&dyn Stage]) -> [Result<Vec<f64>, SimulationError>; 2] {
        let values: Vec<f64> = stack.parameters().iter().map(|p| p.prior.at(0.3)).collect();
        let device = stack.device(&values);
        let rows = Rows { device: &device, values: &values };
        [walk(stack, &rows, &values, inputs, stages), walk(stack, &Filled(rows), &values, inputs, stages)]
    }

    #[test]
    fn blocks_answer_as_rows_do_to_the_last_bit_and_refuse_the_same_row() {
        let beads = cases::default_sensor().unwrap();
        let mut mutual = beads.clone();
        mutual.layout = truegap_core::sensor::Layout::Mutual;
        mutual.plating = None;
        mutual.dielectric.filling = truegap_core::sensor::Filling::Solid { coverage: 0.6 };
        for sensor in [beads, mutual] {
            for warp in [true, false] {
                let stack = Stack::new(&sensor, StackOptions { warp, ..StackOptions::default() });
                // the last block is full, nearly empty, or the only one
                for rows in [96, 65, 7] {
                    let mut inputs = cases::staircase(rows, sensor.full_scale);
                    for stages in [&[][..], &[&Acts(0.3) as &dyn Stage][..]] {
                        let [rows, blocks] = responses(&stack, &inputs, stages);
                        assert_eq!(rows.unwrap(), blocks.unwrap());
                    }
                    inputs.force_n.as_mut().unwrap()[5] = 1e6;
                    let [rows, blocks] = responses(&stack, &inputs, &[]).map(|found| found.unwrap_err().to_string());
                    assert_eq!(rows, blocks);
                }
            }
        }
    }
}
