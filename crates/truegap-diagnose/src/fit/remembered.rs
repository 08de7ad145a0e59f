//! A stage that answers at once where it is asked the same again.
//!
//! A derivative asks every stage once more, most of them with the columns of before: a plate that is thicker changes no strain, and an amplifier that drifts changes no load.
//! Memory of the beads or a lag of the load is then not computed again.
//!
//! Limits: one set of inputs, one set of values of the effects. What the geometry, the field and the readout are given changes with every parameter, and is always computed.

use std::sync::OnceLock;
use truegap_core::{Dielectric, Drive, FieldView, Geometry, Inputs, Readout, Stage, same_column};

/// A stage with what it was asked first, a place each: at the point itself, or a step away by a parameter that changes nothing of it.
pub(crate) struct Remembered {
    inner: Box<dyn Stage>,
    load: Memo,
    thermal: Memo,
    modulus: Memo,
    strain: Memo,
}

impl Remembered {
    /// A stage that will be asked about the same inputs again.
    pub fn boxed(inner: Box<dyn Stage>) -> Box<dyn Stage> {
        Box::new(Self {
            inner,
            load: Memo::default(),
            thermal: Memo::default(),
            modulus: Memo::default(),
            strain: Memo::default(),
        })
    }
}

/// What was asked first, and the answer; nothing that is asked later takes its place, so that columns side by side find the same.
#[derive(Default)]
struct Memo(OnceLock<Known>);

/// What is known of a place.
enum Known {
    /// changed nothing when it was asked first, as a stage does at all places but its own: to ask again costs less than to compare
    Idle,
    /// what it was asked first
    Asked(Asked),
}

struct Asked {
    /// column that was changed, and those beside it
    given: Vec<Vec<f64>>,
    answer: Vec<f64>,
}

impl Memo {
    /// Changes `column` as `compute` does, which sees `beside` as well.
    fn change(&self, beside: [&[f64]; 2], column: &mut [f64], compute: impl Fn(&mut [f64])) {
        let known = self.0.get_or_init(|| {
            let mut answer = column.to_vec();
            compute(&mut answer);
            if same_column(column, &answer) {
                return Known::Idle;
            }
            Known::Asked(Asked { given: vec![column.to_vec(), beside[0].to_vec(), beside[1].to_vec()], answer })
        });
        let given = [&*column, beside[0], beside[1]];
        match known {
            Known::Asked(asked) if asked.given.iter().zip(given).all(|(a, b)| same_column(a, b)) => {
                column.copy_from_slice(&asked.answer);
            }
            Known::Idle | Known::Asked(_) => compute(column),
        }
    }
}

impl Stage for Remembered {
    fn late_s(&self, elapsed_s: f64) -> f64 {
        self.inner.late_s(elapsed_s)
    }
    fn driver_late_s(&self, driver: usize, elapsed_s: f64) -> f64 {
        self.inner.driver_late_s(driver, elapsed_s)
    }
    fn after_runs(&self, runs: usize) -> Option<Box<dyn Stage>> {
        self.inner.after_runs(runs)
    }
    fn load(&self, inputs: &Inputs, load: &mut [f64]) {
        self.load.change([&[], &[]], load, |load| self.inner.load(inputs, load));
    }
    fn feeds_back(&self) -> bool {
        self.inner.feeds_back()
    }
    fn feedback(&self, drive: &Drive<'_>, response: &[f64], load: &mut [f64]) {
        self.inner.feedback(drive, response, load);
    }
    fn thermal(&self, inputs: &Inputs, temperature_c: &mut [f64]) {
        self.thermal.change([&[], &[]], temperature_c, |temperature| self.inner.thermal(inputs, temperature));
    }
    fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
        self.modulus.change([drive.load, drive.temperature_c], factor, |factor| self.inner.modulus(drive, factor));
    }
    fn stiffening(&self) -> [f64; 2] {
        self.inner.stiffening()
    }
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        self.strain.change([drive.load, drive.temperature_c], strain, |strain| self.inner.strain(drive, strain));
    }
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        self.inner.geometry(drive, geometry);
    }
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
        self.inner.dielectric(drive, factors);
    }
    fn field(&self, drive: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        self.inner.field(drive, view, extra);
    }
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.inner.readout(drive, readout, value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::{Arc, atomic::AtomicUsize, atomic::Ordering};

    /// Acts at every place, each in its own way, and counts how often the strain is asked for.
    struct Everywhere(Arc<AtomicUsize>);

    impl Stage for Everywhere {
        fn late_s(&self, elapsed_s: f64) -> f64 {
            0.5 + elapsed_s
        }
        fn driver_late_s(&self, driver: usize, elapsed_s: f64) -> f64 {
            if driver == 0 { 0.25 } else { elapsed_s }
        }
        fn after_runs(&self, runs: usize) -> Option<Box<dyn Stage>> {
            (runs > 1).then(|| Box::new(Everywhere(Arc::default())) as Box<dyn Stage>)
        }
        fn load(&self, _: &Inputs, load: &mut [f64]) {
            load.iter_mut().for_each(|l| *l *= 2.0);
        }
        fn feeds_back(&self) -> bool {
            true
        }
        fn feedback(&self, _: &Drive<'_>, response: &[f64], load: &mut [f64]) {
            load.iter_mut().zip(response).for_each(|(l, r)| *l -= 0.1 * r);
        }
        fn thermal(&self, _: &Inputs, temperature_c: &mut [f64]) {
            temperature_c.iter_mut().for_each(|t| *t += 3.0);
        }
        fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
            factor.iter_mut().zip(drive.load).for_each(|(f, l)| *f += l);
        }
        fn stiffening(&self) -> [f64; 2] {
            [0.3, 0.7]
        }
        fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
            self.0.fetch_add(1, Ordering::Relaxed);
            strain.iter_mut().zip(drive.load).for_each(|(e, l)| *e += 10.0 * l);
        }
        fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
            geometry.gap.iter_mut().for_each(|g| *g += 0.2);
        }
        fn dielectric(&self, _: &Drive<'_>, factors: &mut Dielectric) {
            factors.beads.iter_mut().for_each(|b| *b *= 1.5);
        }
        fn field(&self, _: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
            extra.iter_mut().zip(view.plates).for_each(|(e, p)| *e += p);
        }
        fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
            value.iter_mut().for_each(|v| *v += readout.span);
        }
    }

    fn drive<'a>(inputs: &'a Inputs, load: &'a [f64]) -> Drive<'a> {
        Drive { inputs, load, temperature_c: &[20.0, 21.0], reference_c: 20.0, full_load: 1.0 }
    }

    /// What a stage makes of a column.
    type Changes<'a> = dyn Fn(&mut [f64]) + 'a;

    /// What a stage makes of everything, asked in this order.
    fn everything(stage: &dyn Stage, load: &[f64]) -> Vec<f64> {
        let inputs = Inputs { run: vec![1; 2], ..Inputs::default() };
        let drive = drive(&inputs, load);
        let columns: [&Changes<'_>; 6] = [
            &|c| stage.load(&inputs, c),
            &|c| stage.feedback(&drive, &[1.0, 2.0], c),
            &|c| stage.thermal(&inputs, c),
            &|c| stage.modulus(&drive, c),
            &|c| stage.strain(&drive, c),
            &|c| stage.readout(&drive, &Readout { zero: 0.0, span: 4.0 }, c),
        ];
        let mut found = vec![
            stage.late_s(2.0),
            stage.driver_late_s(0, 2.0),
            f64::from(u8::from(stage.feeds_back())),
            stage.stiffening()[0],
            stage.stiffening()[1],
        ];
        found.extend([0, 2].map(|runs| f64::from(u8::from(stage.after_runs(runs).is_some()))));
        for change in columns {
            let mut column = vec![0.25, 0.5];
            change(&mut column);
            found.extend(column);
        }
        let none = || vec![0.0; 2];
        let strain = none();
        let mut geometry =
            Geometry { strain: &strain, gap: none(), warp_kelvin: none(), warp_factor: 1.0, tilt: none(), sag: none() };
        stage.geometry(&drive, &mut geometry);
        let mut factors = Dielectric { beads: vec![1.0; 2], insulator: vec![1.0; 2] };
        stage.dielectric(&drive, &mut factors);
        let mut extra = none();
        stage.field(&drive, &FieldView { aspect: &[0.1; 2], strain: &strain, plates: &[5.0, 6.0] }, &mut extra);
        found.extend(geometry.gap.iter().chain(&factors.beads).chain(&extra));
        found
    }

    #[test]
    fn it_answers_as_the_stage_inside_does_at_every_place_and_again() {
        let (inner, wrapped) = (Everywhere(Arc::default()), Remembered::boxed(Box::new(Everywhere(Arc::default()))));
        for load in [[0.1, 0.2], [0.1, 0.2], [0.3, 0.2]] {
            assert_eq!(everything(wrapped.as_ref(), &load), everything(&inner, &load));
        }
    }

    #[test]
    fn the_same_is_not_computed_again() {
        let count = Arc::<AtomicUsize>::default();
        let wrapped = Remembered::boxed(Box::new(Everywhere(Arc::clone(&count))));
        let inputs = Inputs { run: vec![1; 2], ..Inputs::default() };
        let ask = |load: &[f64], strain: f64| {
            let mut column = vec![strain; 2];
            wrapped.strain(&drive(&inputs, load), &mut column);
            (column, count.load(Ordering::Relaxed))
        };
        let first = ask(&[0.1, 0.2], 0.0);
        assert_eq!(ask(&[0.1, 0.2], 0.0), first);
        assert_eq!(ask(&[0.1, 0.2], 1.0).1, 2);
        // the same strain under another load
        assert_eq!(ask(&[0.1, 0.3], 1.0), (vec![2.0, 4.0], 3));
        // and what was asked first is still known
        assert_eq!(ask(&[0.1, 0.2], 0.0), (first.0, 3));
    }
}
