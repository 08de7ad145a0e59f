//! The stack near one point: strain and reading of every row to first order in what moves away from it.
//!
//! Derivatives by a dozen parameters ask for as many responses a step apart. Strains, the capacitance integral and its logarithm are computed once, with their slopes. A
//! moved parameter or stage changes few of the columns that a reading follows from; only those are computed again, and each takes a product and a sum a row.
//!
//! Limits: stages act in full, on columns that differ by the step; a plate that touches only after the step is not seen.

use super::{
    device::{Described, Device},
    plates::{PICO, ends},
    point::{Kept, Point},
    sloped::{BESIDE, QUANTITIES, aspect_of, at},
};
use crate::equations::load::{BeadLaw, reduced_load};
use std::borrow::Cow;
use truegap_core::{
    Beside, Dielectric, Drive, GapReadings, Geometry, Inputs, PlateColumns, Readings, Readout, Refusal, RefusedRow,
    SimulationError, Stage, same_column, walk,
};

/// The stack at a point, every row with its slopes.
pub(super) struct Near<'s> {
    stack: &'s dyn Described,
    inputs: &'s Inputs,
    device: Device,
    point: Point,
}

impl<'s> Near<'s> {
    /// The point itself, with `stages` plugged in.
    pub fn at(
        stack: &'s dyn Described,
        values: &[f64],
        inputs: &'s Inputs,
        stages: &[&dyn Stage],
    ) -> Result<Self, SimulationError> {
        let device = stack.described(values);
        let kept = Kept::new(&device, values);
        walk(stack, &kept, values, inputs, stages)?;
        let point = kept.into_point();
        Ok(Self { stack, inputs, device, point })
    }
}

impl Beside for Near<'_> {
    fn respond(&self, values: &[f64], stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let device = self.stack.described(values);
        let same = Same::of(&self.device, &device);
        walk(self.stack, &Moved { point: &self.point, device: &device, values, same }, values, self.inputs, stages)
    }
}

/// What two devices have in common: whether they agree in what these quantities of a warm sensor follow from.
#[derive(Clone, Copy)]
struct Same {
    /// stiffness of the beads
    stiffness: bool,
    /// curvature for one kelvin of warp
    bend: bool,
    radius: bool,
    solid: bool,
    beads: bool,
    insulator: bool,
    /// thickness of the cold dielectric, of which an extra gap is a share
    cold: bool,
    /// permittivities of dielectric and insulator
    permittivities: [bool; 2],
}

impl Same {
    fn of(a: &Device, b: &Device) -> Self {
        let radius = a.radius == b.radius && a.conductor.expansion == b.conductor.expansion;
        let solid = radius && a.solid == b.solid && a.rubber.expansion == b.rubber.expansion;
        let cold = a.rubber.thickness == b.rubber.thickness;
        Self {
            stiffness: solid && a.rubber.young == b.rubber.young && a.softening == b.softening,
            bend: a.conductor == b.conductor && a.plating == b.plating,
            radius,
            solid,
            beads: cold && a.rubber.expansion == b.rubber.expansion,
            insulator: a.insulator.thickness == b.insulator.thickness && a.insulator.expansion == b.insulator.expansion,
            cold,
            permittivities: [
                a.rubber.permittivity == b.rubber.permittivity,
                a.insulator.permittivity == b.insulator.permittivity,
            ],
        }
    }
}

/// A device and stages near the point.
struct Moved<'a> {
    point: &'a Point,
    device: &'a Device,
    values: &'a [f64],
    same: Same,
}

impl<'a> Moved<'a> {
    /// What the capacitances are computed from: those columns that are as they were are those of the point.
    fn shape(&self, drive: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> [Cow<'a, [f64]>; QUANTITIES] {
        let Self { point, device, same, .. } = *self;
        let rows = 0..drive.load.len();
        let heated = !same_column(drive.temperature_c, &point.temperature_c);
        let warm = |row: usize| device.at(drive.temperature_c[row]);
        let mut shape: [Cow<'a, [f64]>; QUANTITIES] = std::array::from_fn(|k| Cow::Borrowed(point.shape[k].as_slice()));
        let bends = heated || !same.bend;
        if bends || geometry.warp_factor != point.warp_factor || !same_column(&geometry.warp_kelvin, &point.warp_kelvin) {
            let bend = |row: usize| if bends { device.bend(&warm(row), 1.0) } else { point.bend[row] };
            let curvature = |row: usize| geometry.warp_factor * geometry.warp_kelvin[row] * bend(row);
            shape[at::CURVATURE] = rows.clone().map(curvature).collect();
        }
        if heated || !same.radius {
            shape[at::RADIUS] = rows.clone().map(|row| warm(row).radius).collect();
        }
        if heated || !same.solid {
            shape[at::SOLID] = rows.clone().map(|row| warm(row).areas.solid).collect();
        }
        if heated || !same.beads {
            shape[at::BEADS] = rows.clone().map(|row| warm(row).layers.beads).collect();
        }
        if heated || !same.insulator {
            shape[at::INSULATOR] = rows.map(|row| warm(row).layers.insulator).collect();
        }
        let mut change = |place: usize, held: bool, column: &[f64], factor: f64| {
            if !held {
                shape[place] = column.iter().map(|value| value * factor).collect();
            }
        };
        let cold = device.rubber.thickness;
        change(at::STRAIN, same_column(geometry.strain, &point.shape[at::STRAIN]), geometry.strain, 1.0);
        change(at::FORCE, same_column(drive.load, &point.load), drive.load, drive.full_load);
        change(at::EXTRA, same.cold && same_column(&geometry.gap, &point.gap), &geometry.gap, cold);
        change(at::TILT, same_column(&geometry.tilt, &point.shape[at::TILT]), &geometry.tilt, 1.0);
        change(at::SAG, same.cold && same_column(&geometry.sag, &point.sag), &geometry.sag, cold);
        let [solid, behind] =
            [(&factors.beads, &point.beads), (&factors.insulator, &point.insulator)].map(|(a, b)| same_column(a, b));
        change(at::SOLID_PERMITTIVITY, same.permittivities[0] && solid, &factors.beads, device.rubber.permittivity);
        change(at::BEHIND, same.permittivities[1] && behind, &factors.insulator, device.insulator.permittivity);
        shape
    }
}

/// Adds what `slope` makes of the way from `here` to `there`.
fn follow(sum: &mut [f64], slope: &[f64], (here, there): (&[f64], &[f64])) {
    for (((sum, slope), here), there) in sum.iter_mut().zip(slope).zip(here).zip(there) {
        *sum += slope * (there - here);
    }
}

impl PlateColumns for Moved<'_> {
    fn strains(&self, drive: &Drive<'_>, modulus: &[f64], stiffening: [f64; 2]) -> Result<Vec<f64>, RefusedRow> {
        let Self { point, device, same, .. } = *self;
        let held = same.stiffness && stiffening == point.stiffening;
        let loaded = same_column(drive.load, &point.load);
        if held && loaded && same_column(drive.temperature_c, &point.temperature_c) && same_column(modulus, &point.modulus) {
            return Ok(point.elastic.clone());
        }
        let law = BeadLaw { poisson: device.poisson, stiffening };
        let stiffness = |row: usize| {
            let warm = device.at(drive.temperature_c[row]);
            warm.areas.solid * warm.young * modulus[row]
        };
        let strain = |row: usize| {
            let unmoved = drive.load[row] == point.load[row]
                && drive.temperature_c[row] == point.temperature_c[row]
                && modulus[row] == point.modulus[row];
            let here = point.elastic[row];
            let force_n = drive.load[row] * drive.full_load;
            let moved = here - (reduced_load(law, here) - force_n / stiffness(row)) * point.yielding[row];
            if held && unmoved { here } else { moved }
        };
        let strains = (0..modulus.len()).map(strain).collect();
        let refused = |row: usize| stiffness(row).is_nan() || stiffness(row) <= 0.0;
        // all rows at once, so that the common case has no branch
        if (0..modulus.len()).fold(false, |any, row| any | refused(row)) {
            let first = (0..modulus.len()).find(|row| refused(*row)).unwrap_or(0);
            return Err((first, Refusal::NoAnswer));
        }
        Ok(strains)
    }

    fn warp_factor(&self) -> f64 {
        self.device.warp_factor()
    }

    fn readings(&self, drive: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<Readings, RefusedRow> {
        let Self { point, device, .. } = *self;
        let shape = self.shape(drive, geometry, factors);
        let is_moved = |place: usize| matches!(shape[place], Cow::Owned(_));
        let way = |place: usize| (point.shape[place].as_slice(), &*shape[place]);
        let (mut main, mut beside) = (point.main.clone(), point.beside.clone());
        (0..QUANTITIES).filter(|place| is_moved(*place)).for_each(|place| follow(&mut main, &point.by[place], way(place)));
        for (slope, place) in point.beside_by.iter().zip(BESIDE).filter(|(_, place)| is_moved(*place)) {
            follow(&mut beside, slope, way(place));
        }
        let aspect = if ASPECT.iter().any(|place| is_moved(*place)) {
            let [radius, force, beads, strain, insulator, extra] = ASPECT.map(|place| &*shape[place]);
            let of = |k: usize| aspect_of(device, [radius[k], force[k], beads[k], strain[k], insulator[k], extra[k]]);
            (0..main.len()).map(of).collect()
        } else {
            point.aspect.clone()
        };
        let value = main.iter().zip(&beside).map(|(main, beside)| (main + beside + device.stray) * PICO).collect();
        main.iter_mut().for_each(|main| *main *= PICO);
        Ok(Readings { value, gap: Some(GapReadings { aspect, plates: main }) })
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        ends(self.device, self.values)
    }
}

/// What the mean separation over the radius follows from.
const ASPECT: [usize; 6] = [at::RADIUS, at::FORCE, at::BEADS, at::STRAIN, at::INSULATOR, at::EXTRA];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{SeriesOrder, Stack, StackOptions, cases};
    use truegap_core::{Sensor, Simulator};

    /// Acts at every place that the stack's physics sees, in proportion to its size.
    struct Everywhere(f64);

    impl Stage for Everywhere {
        fn load(&self, _: &Inputs, load: &mut [f64]) {
            load.iter_mut().for_each(|l| *l *= 1.0 - 0.1 * self.0);
        }
        fn thermal(&self, _: &Inputs, temperature_c: &mut [f64]) {
            temperature_c.iter_mut().for_each(|t| *t += 2.0 * self.0);
        }
        fn modulus(&self, _: &Drive<'_>, factor: &mut [f64]) {
            factor.iter_mut().for_each(|f| *f *= 1.0 + 0.2 * self.0);
        }
        fn stiffening(&self) -> [f64; 2] {
            [0.3 * self.0, 0.5 * self.0]
        }
        fn strain(&self, _: &Drive<'_>, strain: &mut [f64]) {
            strain.iter_mut().for_each(|e| *e *= 1.0 + 0.1 * self.0);
        }
        fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
            geometry.warp_factor *= 1.0 - 0.2 * self.0;
            for row in 0..geometry.gap.len() {
                geometry.gap[row] += 0.05 * self.0;
                geometry.warp_kelvin[row] += self.0;
                geometry.tilt[row] += 0.2 * self.0;
                geometry.sag[row] += 0.05 * self.0 * drive.load[row];
            }
        }
        fn dielectric(&self, _: &Drive<'_>, factors: &mut Dielectric) {
            factors.beads.iter_mut().for_each(|f| *f *= 1.0 + 0.1 * self.0);
            factors.insulator.iter_mut().for_each(|f| *f *= 1.0 - 0.1 * self.0);
        }
        fn field(&self, _: &Drive<'_>, view: &truegap_core::FieldView<'_>, extra: &mut [f64]) {
            for (row, extra) in extra.iter_mut().enumerate() {
                *extra += self.0 * view.aspect[row] * view.plates[row];
            }
        }
    }

    fn sensors() -> Vec<Sensor> {
        let beads = cases::default_sensor().unwrap();
        let mut mutual = beads.clone();
        mutual.layout = truegap_core::sensor::Layout::Mutual;
        mutual.dielectric.filling = truegap_core::sensor::Filling::Solid { coverage: 0.6 };
        vec![beads, mutual]
    }

    /// Central difference quotients of the whole response, by every parameter and by the size of the stage, against those beside the point.
    fn same_derivatives(stack: &Stack, size: f64) {
        let inputs = cases::staircase(60, stack.full_load().unwrap());
        let centre: Vec<f64> = stack.parameters().iter().map(|p| p.prior.at(0.3)).collect();
        let here = [&Everywhere(size) as &dyn Stage];
        let near = stack.beside(&centre, &inputs, &here).unwrap().unwrap();
        let response = stack.respond(&centre, &inputs, &here).unwrap();
        let unmoved = near.respond(&centre, &here).unwrap();
        unmoved.iter().zip(&response).for_each(|(a, b)| approx::assert_relative_eq!(a, b, max_relative = 1e-12));
        let compare = |name: &str, way: &dyn Fn(&dyn Fn(&[f64], f64) -> Vec<f64>, f64) -> Vec<f64>| {
            let full = |values: &[f64], size: f64| stack.respond(values, &inputs, &[&Everywhere(size)]).unwrap();
            let short = |values: &[f64], size: f64| near.respond(values, &[&Everywhere(size)]).unwrap();
            let quotient = |respond: &dyn Fn(&[f64], f64) -> Vec<f64>| -> Vec<f64> {
                way(respond, 1e-4).iter().zip(way(respond, -1e-4)).map(|(a, b)| a - b).collect()
            };
            let (expected, found) = (quotient(&full), quotient(&short));
            let largest = expected.iter().fold(0.0, |m: f64, d| m.max(d.abs()));
            assert!(largest > 0.0, "{name} does nothing");
            // third order in a step of 1e-4, and rounding
            for (e, f) in expected.iter().zip(&found) {
                assert!((e - f).abs() < 1e-6 * largest, "{name}: {e} {f}");
            }
        };
        for (index, parameter) in stack.parameters().iter().enumerate() {
            compare(&parameter.name, &|respond, step| {
                let mut values = centre.clone();
                values[index] = parameter.prior.at(0.3 + step);
                respond(&values, size)
            });
        }
        compare("stage", &|respond, step| respond(&centre, size + step));
    }

    #[test]
    fn derivatives_beside_a_point_are_those_of_the_whole_response() {
        for sensor in sensors() {
            for series in [SeriesOrder::IntegrateThenSeries, SeriesOrder::SeriesThenIntegrate] {
                for warp in [true, false] {
                    let stack = Stack::new(&sensor, StackOptions { warp, series });
                    // with the stage in the middle of its range, and with nothing plugged in but a stage of size 0
                    [0.4, 0.0].iter().for_each(|size| same_derivatives(&stack, *size));
                }
            }
        }
    }

    #[test]
    fn a_parameter_that_stiffens_nothing_leaves_the_strain_to_the_last_bit() {
        let sensor = cases::default_sensor().unwrap();
        let stack = Stack::new(&sensor, StackOptions::default());
        let inputs = cases::staircase(40, sensor.full_scale);
        let centre = stack.centre();
        let near = Near::at(&stack, &centre, &inputs, &[]).unwrap();
        let mut thicker = centre.clone();
        let height = stack.parameters().iter().position(|p| p.name == "height_rtv").unwrap();
        thicker[height] *= 1.001;
        let device = stack.device(&thicker);
        assert!(Same::of(&near.device, &device).stiffness && !Same::of(&near.device, &device).beads);
        let moved = near.respond(&thicker, &[]).unwrap();
        let whole = stack.respond(&thicker, &inputs, &[]).unwrap();
        // second order in a thousandth
        moved.iter().zip(&whole).for_each(|(a, b)| approx::assert_relative_eq!(a, b, max_relative = 1e-5));
    }
}
