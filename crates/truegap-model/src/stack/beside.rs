//! The stack near one point: strain and reading of every row to first order in what moves away from it.
//!
//! Derivatives by a dozen parameters ask for as many responses a step apart. Strains, the capacitance integral and its logarithm are computed once, with their slopes; a
//! moved parameter or stage then takes a few products a row.
//!
//! Limits: stages act in full, on columns that differ by the step; a plate that touches only after the step is not seen.

use super::{
    device::{Described, Device},
    plates::{PICO, ends, force_n},
    sloped::{QUANTITIES, Shape, Sloped, aspect, at, sloped},
};
use crate::equations::load::{BeadLaw, reduced_load, reduced_load_slope};
use std::cell::RefCell;
use truegap_core::{
    Beside, Dielectric, Drive, GapReading, Geometry, Inputs, PlateReading, Plates, Readout, Refusal, SimulationError, Stage,
    Stiffness, walk,
};

/// A row of the point: its strain, and its reading with slopes.
#[derive(Clone, Copy)]
struct Row {
    strained: Strained,
    /// curvature for one kelvin of warp
    bend: f64,
    sloped: Sloped,
}

impl Row {
    fn unloaded(&self) -> Unloaded {
        let shape = &self.sloped.shape;
        Unloaded {
            bend: self.bend,
            radius: shape[at::RADIUS],
            solid: shape[at::SOLID],
            beads: shape[at::BEADS],
            insulator: shape[at::INSULATOR],
        }
    }
}

/// The strain of a row and what it was computed from, but for the force.
#[derive(Clone, Copy)]
struct Strained {
    temperature_c: f64,
    modulus: f64,
    strain: f64,
    /// strain for one unit of reduced load
    yielding: f64,
}

/// The stack at a point, every row with its slopes.
pub(super) struct Near<'s> {
    stack: &'s dyn Described,
    inputs: &'s Inputs,
    device: Device,
    stiffening: [f64; 2],
    rows: Vec<Row>,
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
        let kept = Kept {
            device: &device,
            values,
            strained: RefCell::default(),
            rows: RefCell::default(),
            stiffening: RefCell::default(),
        };
        walk(stack, &kept, values, inputs, stages)?;
        let (rows, stiffening) = (kept.rows.into_inner(), kept.stiffening.into_inner());
        Ok(Self { stack, inputs, device, stiffening, rows })
    }
}

impl Beside for Near<'_> {
    fn respond(&self, values: &[f64], stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let device = self.stack.described(values);
        let same = Same::of(&self.device, &device);
        walk(self.stack, &Moved { near: self, device: &device, values, same }, values, self.inputs, stages)
    }
}

/// A warm sensor before load, as far as its capacitances go.
#[derive(Clone, Copy)]
struct Unloaded {
    /// curvature for one kelvin of warp
    bend: f64,
    radius: f64,
    solid: f64,
    beads: f64,
    insulator: f64,
}

impl Unloaded {
    fn of(device: &Device, temperature_c: f64) -> Self {
        let warm = device.at(temperature_c);
        let bend = device.bend(&warm, 1.0);
        Self { bend, radius: warm.radius, solid: warm.areas.solid, beads: warm.layers.beads, insulator: warm.layers.insulator }
    }

    /// What the capacitances of a row are computed from.
    fn shape(&self, device: &Device, (force_n, row): (f64, usize), geometry: &Geometry<'_>, factors: &Dielectric) -> Shape {
        let cold = device.rubber.thickness;
        let mut shape = [0.0; QUANTITIES];
        shape[at::CURVATURE] = geometry.warp_factor * geometry.warp_kelvin[row] * self.bend;
        shape[at::RADIUS] = self.radius;
        shape[at::SOLID] = self.solid;
        shape[at::BEADS] = self.beads;
        shape[at::INSULATOR] = self.insulator;
        shape[at::STRAIN] = geometry.strain[row];
        shape[at::FORCE] = force_n;
        shape[at::EXTRA] = geometry.gap[row] * cold;
        shape[at::TILT] = geometry.tilt[row];
        shape[at::SAG] = geometry.sag[row] * cold;
        shape[at::SOLID_PERMITTIVITY] = device.rubber.permittivity * factors.beads[row];
        shape[at::BEHIND] = device.insulator.permittivity * factors.insulator[row];
        shape
    }
}

/// Computes every row with its slopes, and keeps them.
struct Kept<'a> {
    device: &'a Device,
    values: &'a [f64],
    strained: RefCell<Vec<Strained>>,
    rows: RefCell<Vec<Row>>,
    stiffening: RefCell<[f64; 2]>,
}

impl Plates for Kept<'_> {
    fn strain(&self, drive: &Drive<'_>, row: usize, Stiffness { modulus, stiffening }: Stiffness) -> Result<f64, Refusal> {
        let temperature_c = drive.temperature_c[row];
        let strain = self.device.strain(&self.device.at(temperature_c), force_n(drive, row), modulus, stiffening)?;
        let law = BeadLaw { poisson: self.device.poisson, stiffening };
        let yielding = reduced_load_slope(law, strain).recip();
        self.strained.borrow_mut().push(Strained { temperature_c, modulus, strain, yielding });
        *self.stiffening.borrow_mut() = stiffening;
        Ok(strain)
    }

    fn warp_factor(&self) -> f64 {
        self.device.warp_factor()
    }

    fn reading(
        &self,
        drive: &Drive<'_>,
        row: usize,
        geometry: &Geometry<'_>,
        factors: &Dielectric,
    ) -> Result<PlateReading, Refusal> {
        let unloaded = Unloaded::of(self.device, drive.temperature_c[row]);
        let shape = unloaded.shape(self.device, (force_n(drive, row), row), geometry, factors);
        let sloped = sloped(self.device, &shape).ok_or(Refusal::Touches { strain: geometry.strain[row] })?;
        self.rows.borrow_mut().push(Row { strained: self.strained.borrow()[row], bend: unloaded.bend, sloped });
        Ok(read(self.device, &sloped, &shape))
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        ends(self.device, self.values)
    }
}

/// The reading of a row where its capacitances are computed from `there`.
#[inline]
fn read(device: &Device, sloped: &Sloped, there: &Shape) -> PlateReading {
    let moved: Shape = std::array::from_fn(|k| there[k] - sloped.shape[k]);
    let [main, beside] = sloped.after(&moved);
    let gap = GapReading { aspect: aspect(device, there), plates: main * PICO };
    PlateReading { value: (main + beside + device.stray) * PICO, gap: Some(gap) }
}

/// What two devices have in common.
#[derive(Clone, Copy)]
struct Same {
    /// what the strain of a row follows from
    stiffness: bool,
    /// what a warm sensor is computed from, but for the stiffness of its beads
    shape: bool,
}

impl Same {
    fn of(a: &Device, b: &Device) -> Self {
        let solid = a.solid == b.solid && a.radius == b.radius;
        let sheets = a.conductor == b.conductor && a.plating == b.plating && a.insulator == b.insulator;
        Self {
            stiffness: solid && a.rubber.young == b.rubber.young && a.softening == b.softening,
            shape: solid && sheets && a.rubber.thickness == b.rubber.thickness,
        }
    }
}

/// A device and stages near the point.
struct Moved<'a> {
    near: &'a Near<'a>,
    device: &'a Device,
    values: &'a [f64],
    same: Same,
}

impl Plates for Moved<'_> {
    #[inline]
    fn strain(&self, drive: &Drive<'_>, row: usize, Stiffness { modulus, stiffening }: Stiffness) -> Result<f64, Refusal> {
        let (force_n, temperature_c) = (force_n(drive, row), drive.temperature_c[row]);
        let Row { strained: here, sloped, .. } = &self.near.rows[row];
        let unmoved = force_n == sloped.shape[at::FORCE] && temperature_c == here.temperature_c && modulus == here.modulus;
        if unmoved && self.same.stiffness && stiffening == self.near.stiffening {
            return Ok(here.strain);
        }
        let warm = self.device.at(temperature_c);
        let stiffness = warm.areas.solid * warm.young * modulus;
        if stiffness.is_nan() || stiffness <= 0.0 {
            return Err(Refusal::NoAnswer);
        }
        let law = BeadLaw { poisson: self.device.poisson, stiffening };
        Ok(here.strain - (reduced_load(law, here.strain) - force_n / stiffness) * here.yielding)
    }

    fn warp_factor(&self) -> f64 {
        self.device.warp_factor()
    }

    // inlined, a row is handed on in registers and not through memory
    #[inline]
    fn reading(
        &self,
        drive: &Drive<'_>,
        row: usize,
        geometry: &Geometry<'_>,
        factors: &Dielectric,
    ) -> Result<PlateReading, Refusal> {
        let here = &self.near.rows[row];
        let unmoved = self.same.shape && drive.temperature_c[row] == here.strained.temperature_c;
        let unloaded = if unmoved { here.unloaded() } else { Unloaded::of(self.device, drive.temperature_c[row]) };
        Ok(read(self.device, &here.sloped, &unloaded.shape(self.device, (force_n(drive, row), row), geometry, factors)))
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        ends(self.device, self.values)
    }
}

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
        assert!(Same::of(&near.device, &device).stiffness && !Same::of(&near.device, &device).shape);
        let moved = near.respond(&thicker, &[]).unwrap();
        let whole = stack.respond(&thicker, &inputs, &[]).unwrap();
        // second order in a thousandth
        moved.iter().zip(&whole).for_each(|(a, b)| approx::assert_relative_eq!(a, b, max_relative = 1e-5));
    }
}
