//! A simulator with every stage, and a recording that excites every effect: for tests and for the generated page of effects.
//!
//! Limits: not a sensor; its numbers are only of the right size.
#![allow(dead_code)]

pub mod page;

use std::sync::Arc;
use truegap_core::{
    Corrections, Curve, Dielectric, Drive, Driver, FieldView, Geometry, Inputs, Parameter, Readout, Role, SimulationError,
    Simulator, Stage, simulator::StageName,
};

/// Plates on a nonlinear dielectric, with a shield on an insulator and a bimetal electrode.
pub struct Plate {
    warps: Option<bool>,
    no_dielectric: bool,
    no_beads: bool,
    feeds_back: bool,
    stays: bool,
    parameters: Vec<Parameter>,
    corrections: Arc<Corrections>,
}

/// Curves of the right size, in closed form: what bonded beads, rims and held electrodes do to the plate.
fn corrections() -> Corrections {
    let curve = |id: &str, low: f64, high: f64, f: &dyn Fn(f64) -> f64| {
        let x = |i: usize| low + (high - low) * i as f64 / 64.0;
        Curve {
            id: id.into(),
            says: String::new(),
            argument: String::new(),
            argument_unit: "1".into(),
            value: String::new(),
            value_unit: "1".into(),
            points: (0..=64).map(|i| [x(i), f(x(i))]).collect(),
            accuracy: 1e-3,
        }
    };
    Corrections {
        sensor: "plate".into(),
        stiffening: curve("stiffening", 0.0, 0.3, &|e| 2.4 + 3.0 * e),
        bonded_strain: curve("bonded_strain", 0.0, 0.6, &|e| e / (2.4 + 1.5 * e)),
        mixing: curve("mixing", 0.0, 0.3, &|e| 0.98 - 0.1 * e),
        fringing: curve("fringing", 0.0, 0.1, &|aspect| 0.04 + 0.5 * aspect),
        warp: curve("warp", -20.0, 60.0, &|kelvin| 1.0 - 1e-4 * kelvin),
        warp_left: curve("warp_left", 0.0, 1.0, &|load| 0.2 + 0.8 / (1.0 + 20.0 * load)),
        tail_edge_pf: 4.0,
        held_growth_per_kelvin: 2.4e-4,
        insulator_growth_per_kelvin: 3.4e-6,
    }
}

impl Plate {
    pub fn new(warps: Option<bool>) -> Self {
        let parameters = vec![
            Parameter::normal("gain", "pF", 10.0, 1.0, "capacitance of the unloaded plates"),
            Parameter::log_normal("modulus", "full loads", 6.0, 0.3, "load that would close the gap"),
        ];
        Self {
            warps,
            no_dielectric: false,
            no_beads: false,
            feeds_back: false,
            stays: false,
            parameters,
            corrections: Arc::new(corrections()),
        }
    }

    /// The same plate as a base model that has no place for permittivity.
    #[allow(dead_code)]
    pub fn without_dielectric(self) -> Self {
        Self { no_dielectric: true, ..self }
    }

    /// The same plate as a base model whose load may depend on its own response.
    #[allow(dead_code)]
    pub fn with_feedback(self) -> Self {
        Self { feeds_back: true, ..self }
    }

    /// The same plate as a base model that has no place for memory of its own.
    #[allow(dead_code)]
    pub fn without_beads(self) -> Self {
        Self { no_beads: true, ..self }
    }

    /// The same as a value that should not move by itself.
    pub fn that_stays(self) -> Self {
        Self { stays: true, ..self }
    }

    pub fn centre(&self) -> Vec<f64> {
        self.parameters.iter().map(Parameter::centre).collect()
    }

    /// The response where this load and temperature have arrived.
    fn with_load(
        &self,
        values: &[f64],
        inputs: &Inputs,
        stages: &[&dyn Stage],
        load: &[f64],
        temperature_c: &[f64],
    ) -> Result<Vec<f64>, SimulationError> {
        let rows = inputs.len();
        let drive = Drive { inputs, load, temperature_c, reference_c: 20.0, full_load: 4.5 };
        let mut modulus: Vec<f64> = temperature_c.iter().map(|t| values[1] * (1.0 - 0.007 * (t - 20.0))).collect();
        stages.iter().for_each(|s| s.modulus(&drive, &mut modulus));
        let curve = stages.iter().map(|s| s.stiffening()).fold([0.0; 2], |sum, s| [sum[0] + s[0], sum[1] + s[1]]);
        let mut strains: Vec<f64> = (0..rows).map(|row| strain(load[row], modulus[row], curve)).collect();
        stages.iter().for_each(|s| s.strain(&drive, &mut strains));
        let mut geometry = flat(&strains, temperature_c, f64::from(u8::from(self.warps == Some(true))));
        stages.iter().for_each(|s| s.geometry(&drive, &mut geometry));
        let mut factors = Dielectric { beads: vec![1.0; rows], insulator: vec![1.0; rows] };
        stages.iter().for_each(|s| s.dielectric(&drive, &mut factors));
        let (plates, aspect): (Vec<f64>, Vec<f64>) =
            (0..rows).map(|row| self.row(values[0], &geometry, &factors, row)).map(|(plates, gap)| (plates, 0.024 * gap)).unzip();
        let mut value: Vec<f64> = plates.iter().zip(&factors.insulator).map(|(p, i)| p + 200.0 * i).collect();
        let mut extra = vec![0.0; rows];
        stages
            .iter()
            .for_each(|s| s.field(&drive, &FieldView { aspect: &aspect, strain: &strains, plates: &plates }, &mut extra));
        value.iter_mut().zip(&extra).for_each(|(value, extra)| *value += extra);
        let span = values[0] / (1.0 - 1.0 / values[1]) - values[0];
        stages.iter().for_each(|s| s.readout(&drive, &Readout { zero: values[0] + 200.0, span }, &mut value));
        match value.iter().position(|v| !v.is_finite()) {
            Some(row) => Err(SimulationError::NotFinite { row, parameters: values.to_vec() }),
            None => Ok(value),
        }
    }

    fn row(&self, gain: f64, geometry: &Geometry<'_>, factors: &Dielectric, row: usize) -> (f64, f64) {
        let solid = 1.0 - geometry.strain[row];
        let gap = 0.3 * solid / factors.beads[row] + 0.7 * solid + geometry.gap[row];
        let bent = geometry.warp_factor * geometry.warp_kelvin[row] * 1e-3 / gap;
        let wedge = 2.0 / (1.0 + (1.0 - geometry.tilt[row].powi(2)).sqrt());
        let dome = 1.0 + (0.5 * geometry.sag[row] / gap).powi(2) / 3.0;
        (gain * wedge * dome * (1.0 + bent + bent * bent) / gap, gap)
    }
}

/// Solves `modulus e (1 + a e + b e^2) = load`.
fn strain(load: f64, modulus: f64, [a, b]: [f64; 2]) -> f64 {
    let mut e = load / modulus;
    for _ in 0..60 {
        let residual = e * (1.0 + a * e + b * e * e) - load / modulus;
        let step = residual / (1.0 + 2.0 * a * e + 3.0 * b * e * e);
        e -= step;
        if step.abs() < 1e-16 {
            break;
        }
    }
    e
}

impl Simulator for Plate {
    fn name(&self) -> &str {
        "stack"
    }
    fn moves(&self) -> bool {
        !self.stays
    }
    fn unit(&self) -> &str {
        "pF"
    }
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }
    fn needs(&self) -> &[Role] {
        &[Role::Force]
    }
    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        match stage {
            StageName::Dielectric => self.no_dielectric.then_some("this plate has no dielectric of its own"),
            StageName::Beads => self.no_beads.then_some("this plate has no beads"),
            _ => None,
        }
    }
    fn full_load(&self) -> Option<f64> {
        Some(4.5)
    }
    fn warps(&self) -> Option<bool> {
        self.warps
    }
    fn feeds_back(&self) -> bool {
        self.feeds_back
    }
    fn has_insulator(&self) -> bool {
        true
    }
    fn knows_its_level(&self) -> bool {
        true
    }
    fn corrections(&self) -> Option<&Arc<Corrections>> {
        Some(&self.corrections)
    }
    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        inputs.force_n.as_ref().map(|force| force.iter().map(|f| f / 4.5).collect())
    }
    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let inputs = &shifted(inputs, |elapsed| stages.iter().map(|s| s.late_s(elapsed)).sum());
        let rows = inputs.len();
        let mut load = self.load(inputs).unwrap_or_else(|| vec![0.0; rows]);
        stages.iter().for_each(|s| s.load(inputs, &mut load));
        let mut temperature_c = inputs.temperature_c.clone().unwrap_or_else(|| vec![20.0; rows]);
        stages.iter().for_each(|s| s.thermal(inputs, &mut temperature_c));
        let acting = load.clone();
        let mut value = self.with_load(values, inputs, stages, &load, &temperature_c)?;
        // repetition in short steps: a plate has no resonance, but may answer strongly
        for _ in 0..if stages.iter().any(|s| s.feeds_back()) { 400 } else { 0 } {
            let mut asked = acting.clone();
            let drive = Drive { inputs, load: &acting, temperature_c: &temperature_c, reference_c: 20.0, full_load: 4.5 };
            stages.iter().for_each(|s| s.feedback(&drive, &value, &mut asked));
            load.iter_mut().zip(&asked).for_each(|(load, asked)| *load += 0.1 * (asked - *load));
            value = self.with_load(values, inputs, stages, &load, &temperature_c)?;
        }
        Ok(value)
    }
}

/// Flat plates at a strain.
pub fn flat<'a>(strain: &'a [f64], temperature_c: &[f64], warp_factor: f64) -> Geometry<'a> {
    let rows = strain.len();
    let warp_kelvin = temperature_c.iter().map(|t| t - 20.0).collect();
    Geometry { strain, gap: vec![0.0; rows], warp_kelvin, warp_factor, tilt: vec![0.0; rows], sag: vec![0.0; rows] }
}

/// The force column read `late(seconds since the first row)` seconds further on.
fn shifted(inputs: &Inputs, late: impl Fn(f64) -> f64) -> Inputs {
    let (mut moved, Some(time), Some(force)) = (inputs.clone(), &inputs.time_s, &inputs.force_n) else { return inputs.clone() };
    let column = time.iter().map(|t| (t, late(t - time[0]))).zip(force);
    moved.force_n = Some(column.map(|((t, late), f)| if late == 0.0 { *f } else { at(time, force, t + late) }).collect());
    moved
}

/// Linear between rows, held beyond the ends.
pub fn at(time: &[f64], column: &[f64], t: f64) -> f64 {
    let after = time.partition_point(|x| *x < t).clamp(1, time.len() - 1);
    let share = ((t - time[after - 1]) / (time[after] - time[after - 1])).clamp(0.0, 1.0);
    column[after - 1] + share * (column[after] - column[after - 1])
}

/// Zigzag between `low` and `high` with a period of `period` seconds, at `low` where t = 0.
fn zigzag(t: f64, period: f64, low: f64, high: f64) -> f64 {
    let phase = (t / period).fract();
    low + (high - low) * (1.0 - (2.0 * phase - 1.0).abs())
}

/// Load cycles to growing peaks, holds, a slow and a fast zigzag and sweeps of temperature, with humidity on its own course.
pub fn recording() -> Inputs {
    let mut inputs = Inputs {
        time_s: Some(vec![]),
        force_n: Some(vec![]),
        temperature_c: Some(vec![]),
        humidity_pct: Some(vec![]),
        drivers: [("position", "mm"), ("pump", "V")]
            .map(|(name, unit)| Driver { name: name.into(), unit: unit.into(), values: vec![] })
            .to_vec(),
        ..Inputs::default()
    };
    let mut start = 0.0;
    let mut run = |rows: u32, step: f64, drive: &dyn Fn(f64) -> (f64, f64)| {
        for row in 0..rows {
            let t = f64::from(row) * step;
            let (force, temperature) = drive(t);
            inputs.run.push(start as u32);
            inputs.time_s.iter_mut().for_each(|c| c.push(start + t));
            inputs.force_n.iter_mut().for_each(|c| c.push(force));
            inputs.temperature_c.iter_mut().for_each(|c| c.push(temperature));
            inputs.humidity_pct.iter_mut().for_each(|c| c.push(50.0 + 15.0 * ((start + t) / 700.0).sin()));
            inputs.drivers[0].values.push(zigzag(t, 40.0, 0.0, 30.0));
            inputs.drivers[1].values.push(zigzag(t, 170.0, 2.0, 6.0));
        }
        start += f64::from(rows) * step + 900.0;
    };
    run(300, 0.2, &|t| (zigzag(t, 20.0, 0.0, 1.5 * (1.0 + (t / 20.0).floor())), 22.0));
    run(240, 0.5, &|t| (4.5 * (t / 5.0).clamp(0.0, 1.0) * ((115.0 - t) / 5.0).clamp(0.0, 1.0), 25.0));
    run(300, 0.05, &|t| (zigzag(t, 2.0, 0.0, 4.5 * (1.0 - t / 18.0)), 22.0));
    run(150, 0.5, &|t| (zigzag(t, 30.0, 0.0, 4.5), 50.0));
    run(300, 4.0, &|t| (0.0, zigzag(t, 1200.0, 20.0, 50.0)));
    run(300, 4.0, &|t| (2.2, 20.0 + 30.0 * (t / 300.0).clamp(0.0, 1.0) - 15.0 * ((t - 700.0) / 200.0).clamp(0.0, 1.0)));
    run(240, 0.5, &|t| (4.5 * (t / 5.0).clamp(0.0, 1.0) * ((115.0 - t) / 5.0).clamp(0.0, 1.0), 20.0));
    inputs
}

/// A load that never rests, a row a second, at one temperature.
pub fn without_rest(rows: usize) -> Inputs {
    let time: Vec<f64> = (0..rows).map(|row| row as f64).collect();
    Inputs {
        run: vec![1; rows],
        force_n: Some(time.iter().map(|t| 2.0 + 1.5 * (t / 37.0).sin()).collect()),
        temperature_c: Some(vec![24.0; rows]),
        time_s: Some(time),
        ..Inputs::default()
    }
}

/// A reading in proportion to the force: somebody's own simulator, of which plates and stages are not known.
pub struct Line {
    pub parameters: Vec<Parameter>,
}

impl Simulator for Line {
    fn name(&self) -> &str {
        "line"
    }
    fn unit(&self) -> &str {
        "V"
    }
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }
    fn needs(&self) -> &[Role] {
        &[Role::Force]
    }
    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        (stage != StageName::Readout).then_some("nothing is known of it")
    }
    fn full_load(&self) -> Option<f64> {
        Some(3.0)
    }
    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        Some(inputs.force_n.as_ref()?.iter().map(|force| force / 3.0).collect())
    }
    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let force = inputs.force_n.clone().unwrap_or_default();
        let load: Vec<f64> = force.iter().map(|force| force / 3.0).collect();
        let temperature = vec![20.0; inputs.len()];
        let mut value: Vec<f64> = force.iter().map(|force| values[0] * force).collect();
        let drive = Drive { inputs, load: &load, temperature_c: &temperature, reference_c: 20.0, full_load: 3.0 };
        stages.iter().for_each(|stage| stage.readout(&drive, &Readout { zero: 0.0, span: 3.0 * values[0] }, &mut value));
        Ok(value)
    }
}
