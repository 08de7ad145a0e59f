//! Each effect against a closed form of its equation, on an input that allows one.

#![allow(clippy::unwrap_used)]

mod common;

use approx::assert_abs_diff_eq;
use common::{Plate, flat};
use truegap_core::{Dielectric, Drive, FieldView, Geometry, Inputs, Readout, Stage};
use truegap_diagnose::{Context, library};

/// Rows on a clock with a load, a temperature and a humidity.
struct Bench {
    inputs: Inputs,
    load: Vec<f64>,
}

impl Bench {
    fn new(time_s: Vec<f64>, load: Vec<f64>, temperature_c: Vec<f64>) -> Self {
        let rows = time_s.len();
        let inputs = Inputs {
            time_s: Some(time_s),
            run: vec![1; rows],
            force_n: Some(load.iter().map(|l| 4.5 * l).collect()),
            temperature_c: Some(temperature_c),
            humidity_pct: Some((0..rows).map(|row| if row == 0 { 50.0 } else { 60.0 }).collect()),
            ..Inputs::default()
        };
        Self { inputs, load }
    }

    /// A hold of one load from the first row on, at 20 degrees Celsius, at these times.
    fn hold(load: f64, time_s: &[f64]) -> Self {
        Self::new(time_s.to_vec(), vec![load; time_s.len()], vec![20.0; time_s.len()])
    }

    fn stage(&self, id: &str, values: &[f64]) -> Box<dyn Stage> {
        let plate = Plate::new(Some(true));
        let context = Context::new(&self.inputs, &plate, 2.0, 0.004);
        library().iter().find(|effect| effect.id().0 == id).expect("in the library").with(values, &context)
    }

    fn drive(&self) -> Drive<'_> {
        let temperature_c = self.inputs.temperature_c.as_deref().unwrap();
        Drive { inputs: &self.inputs, load: &self.load, temperature_c, reference_c: 20.0, full_load: 4.5 }
    }

    fn loads(&self, id: &str, values: &[f64]) -> Vec<f64> {
        let mut load = self.load.clone();
        self.stage(id, values).load(&self.inputs, &mut load);
        load
    }

    fn strains(&self, id: &str, values: &[f64]) -> Vec<f64> {
        let mut strain: Vec<f64> = self.load.iter().map(|l| 0.2 * l).collect();
        self.stage(id, values).strain(&self.drive(), &mut strain);
        strain
    }

    fn moduli(&self, id: &str, values: &[f64]) -> Vec<f64> {
        let mut factor = vec![1.0; self.load.len()];
        self.stage(id, values).modulus(&self.drive(), &mut factor);
        factor
    }

    fn geometry<'a>(&self, id: &str, values: &[f64], strain: &'a [f64]) -> Geometry<'a> {
        let mut geometry = flat(strain, self.inputs.temperature_c.as_deref().unwrap(), 0.0);
        self.stage(id, values).geometry(&self.drive(), &mut geometry);
        geometry
    }

    fn dielectric(&self, id: &str, values: &[f64]) -> Dielectric {
        let ones = vec![1.0; self.load.len()];
        let mut factors = Dielectric { beads: ones.clone(), insulator: ones };
        self.stage(id, values).dielectric(&self.drive(), &mut factors);
        factors
    }

    /// Recorded values of a reading of zero 100 and span 10.
    fn readings(&self, id: &str, values: &[f64], reading: &[f64]) -> Vec<f64> {
        let mut value = reading.to_vec();
        self.stage(id, values).readout(&self.drive(), &Readout { zero: 100.0, span: 10.0 }, &mut value);
        value
    }
}

/// Strain of a full load on the plate of these tests: its modulus is 6 full loads, its curve straight.
const FULL_STRAIN: f64 = 1.0 / 6.0;

/// Rounding of a handful of operations on numbers near 1.
const ROUNDING: f64 = 1e-14;

#[test]
fn half_of_the_missing_contacts_are_made_at_the_load_times_ln_2() {
    let bench = Bench::hold(0.1 * std::f64::consts::LN_2, &[0.0]);
    assert_abs_diff_eq!(bench.loads("contact_toe_in", &[0.4, 0.1])[0], bench.load[0] / 0.8, epsilon = ROUNDING);
}

#[test]
fn a_load_at_a_third_of_the_radius_tilts_by_a_third_at_a_fifth_of_strain() {
    let tilt = |bed: f64, load: f64| Bench::hold(load, &[0.0]).geometry("eccentric_load", &[1.0 / 9.0, bed], &[0.2]).tilt[0];
    // 4 x 1/3 x 0.2 / 0.8
    assert_abs_diff_eq!(tilt(1.0, 1.0), 1.0 / 3.0, epsilon = ROUNDING);
    // in proportion to the load: 4 x 1/3 x the strain of a full load x the share of it
    assert_abs_diff_eq!(tilt(0.0, 0.5), 4.0 / 3.0 * FULL_STRAIN * 0.5, epsilon = ROUNDING);
}

#[test]
fn a_sensor_behind_its_thermometer_follows_a_ramp_tau_later() {
    let time: Vec<f64> = (0..400).map(|row| 5.0 * f64::from(row)).collect();
    let ramp: Vec<f64> = time.iter().map(|t| 20.0 + 0.02 * t).collect();
    let bench = Bench::new(time, vec![0.0; 400], ramp.clone());
    let mut sensor = ramp.clone();
    bench.stage("thermal_lag", &[40.0, 0.5, 2.0]).thermal(&bench.inputs, &mut sensor);
    assert_eq!(sensor[0], 20.0);
    // after 37 of the slower time constants the start is forgotten; rounding of 400 steps
    assert_abs_diff_eq!(sensor[399], ramp[399] - 0.02 * 40.0, epsilon = 1e-11);
}

#[test]
fn creep_adds_its_size_in_the_first_minute_of_a_hold() {
    let strain = Bench::hold(1.0, &[0.0, 1.0, 60.0]).strains("viscoelastic_creep", &[0.05, 0.25, 1.0]);
    assert_eq!(strain[0], 0.2);
    assert_abs_diff_eq!(strain[2], 0.2 * 1.05, epsilon = ROUNDING);
    let share = (strain[1] / 0.2 - 1.0) / 0.05;
    // (2^0.25 - 1) / (61^0.25 - 1), to the ripple of two relaxation times a decade
    assert_abs_diff_eq!(share, 0.105_43, epsilon = 5e-4);
}

#[test]
fn friction_holds_back_its_size_on_a_long_rise_and_a_long_fall() {
    let bench = Bench::new(vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 0.2], vec![20.0; 3]);
    let strain = bench.strains("rate_independent_hysteresis", &[0.02, 0.1, 0.0]);
    let plain = bench.strains("time_offset", &[0.0]);
    // two hundredths of the strain of a full load, less on the way up and more on the way down
    for (strain, (plain, held)) in strain.iter().zip(plain.iter().zip([0.0, -0.02, 0.02])) {
        assert_abs_diff_eq!(*strain, plain + held * FULL_STRAIN, epsilon = ROUNDING);
    }
    // one play with a half width of 0.3 goes from -0.3 to 0.2 as the strain falls by half of that of a full load; of three with 0.12, 0.24 and 0.54 two have turned over, and the third stands at -0.04
    let half = Bench::new(vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 1.0 - 0.5 * FULL_STRAIN / 0.2], vec![20.0; 3]);
    let back =
        |sudden| half.strains("rate_independent_hysteresis", &[0.03, 0.3, sudden])[2] - half.strains("time_offset", &[0.0])[2];
    assert_abs_diff_eq!(back(1.0), 0.03 * 0.2 / 0.3 * FULL_STRAIN, epsilon = ROUNDING);
    assert_abs_diff_eq!(back(0.0), 0.03 * (0.12 + 0.24 - 0.04) / 0.9 * FULL_STRAIN, epsilon = ROUNDING);
    // a bow of 0.01 at half load, its zero half and its gain a quarter of that
    let errs = bench.loads("load_cell_error", &[0.01, 0.0, 0.5, 0.25]);
    for (load, exact) in errs.iter().zip([0.005, 1.0075, 0.2 + 0.0064 + 0.005 + 0.0005]) {
        assert_abs_diff_eq!(*load, exact, epsilon = ROUNDING);
    }
}

#[test]
fn a_loop_that_saturates_turns_over_half_a_width_past_the_middle() {
    let load = vec![0.5, 1.0, 0.5, 0.4, 0.0];
    let bench = Bench::new((0..5).map(f64::from).collect(), load, vec![20.0; 5]);
    // 3 high, flanks 0.1 to either side of 0.02 above the middle of the load, half of the way to an end within 0.05; the run starts at the end of a way down
    let value = bench.readings("saturating_loop", &[3.0, 0.1, 0.05, 0.02, 1.0], &[100.0; 5]);
    // the play stands at 0.6, is pushed to 0.9, stays there until the load has come back by 0.2, and then follows 0.1 above it
    let arc = |play: f64| 100.0 + 3.0 * std::f64::consts::FRAC_2_PI * ((play - 0.52) / 0.05).atan();
    for (value, play) in value.iter().zip([0.6, 0.9, 0.6, 0.5, 0.1]) {
        assert_abs_diff_eq!(*value, arc(play), epsilon = 100.0 * ROUNDING);
    }
}

#[test]
fn a_set_grows_with_the_greatest_load_so_far_and_stays() {
    let bench = Bench::new((0..5).map(f64::from).collect(), vec![0.0, 0.5, 0.25, 1.0, 0.0], vec![20.0; 5]);
    let value = bench.readings("permanent_set", &[3.0, 2.0], &[100.0; 5]);
    // 3 for the whole range, by the square of the greatest load
    for (value, left) in value.iter().zip([0.0, 0.75, 0.75, 3.0, 3.0]) {
        assert_abs_diff_eq!(*value, 100.0 + left, epsilon = 100.0 * ROUNDING);
    }
}

#[test]
fn a_zero_that_settles_goes_by_as_much_in_every_tenfold_of_the_time() {
    let bench = Bench::hold(0.0, &[0.0, 9.0, 99.0, 999.0]);
    // a knee of a second: 1 + t is 1, 10, 100, 1000
    let value = bench.readings("settling", &[0.4, 1.0], &[100.0; 4]);
    for (value, decades) in value.iter().zip([0.0, 1.0, 2.0, 3.0]) {
        assert_abs_diff_eq!(*value, 100.0 + 0.4 * decades, epsilon = 100.0 * ROUNDING);
    }
}

#[test]
fn a_modulus_that_ages_by_a_tenth_in_an_hour_has_done_so_after_an_hour() {
    let factor = Bench::hold(1.0, &[0.0, 3600.0, 3.0 * 3600.0]).moduli("ageing", &[0.1, 3600.0]);
    // ln 4 / ln 2 = 2: with a knee of an hour, three hours do twice what one does
    for (f, exact) in factor.iter().zip([1.0, 1.1, 1.2]) {
        assert_abs_diff_eq!(*f, exact, epsilon = ROUNDING);
    }
}

#[test]
fn softening_is_that_of_the_greatest_load_so_far() {
    let bench = Bench::new(vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 0.5], vec![20.0; 3]);
    let factor = bench.moduli("mullins_softening", &[0.2, 1.0 / std::f64::consts::LN_2, 0.0]);
    for (f, exact) in factor.iter().zip([1.0, 0.9, 0.9]) {
        assert_abs_diff_eq!(*f, exact, epsilon = ROUNDING);
    }
}

#[test]
fn the_excess_of_stress_is_the_size_at_a_strain_of_a_fifth_whatever_the_curve() {
    for curved in [0.0, 0.3, 1.0] {
        let [a, b] = Bench::hold(1.0, &[0.0]).stage("strain_stiffening", &[0.7, curved]).stiffening();
        assert_abs_diff_eq!(0.2 * a + 0.04 * b, 0.7, epsilon = ROUNDING);
        assert_abs_diff_eq!(0.04 * b, 0.7 * curved, epsilon = ROUNDING);
    }
}

#[test]
fn air_gives_back_the_load_it_took_as_an_exponential() {
    let load = Bench::hold(0.8, &[0.0, 3.0, 30.0]).loads("trapped_air_stiffness", &[0.25, 10.0]);
    for (load, t) in load.iter().zip([0.0_f64, 3.0, 30.0]) {
        assert_abs_diff_eq!(*load, 0.8 * (1.0 - 0.25 * (-t / 10.0).exp()), epsilon = ROUNDING);
    }
}

#[test]
fn gap_sag_and_warp_are_what_the_equations_say() {
    let bench = Bench::new(vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 0.5], vec![20.0, 50.0, 30.0]);
    let strain = [0.0, 0.2, 0.1];
    assert_eq!(bench.geometry("dead_gap", &[0.05], &strain).gap, vec![0.05; 3]);
    assert_eq!(bench.geometry("electrode_warp", &[0.9], &strain).warp_factor, 0.9);
    let bent = bench.geometry("plate_bending", &[0.2, 0.5], &strain);
    assert_eq!(bent.gap, vec![0.0, -0.1, -0.05]);
    assert_eq!(bent.sag, vec![0.0, 0.2, 0.1]);
    let stuck = bench.geometry("thermal_hysteresis", &[3.0, 5.0, 0.0], &strain).warp_kelvin;
    for (kelvin, exact) in stuck.iter().zip([0.0, 27.0, 13.0]) {
        // 3 K behind on a long rise and on a long fall
        assert_abs_diff_eq!(*kelvin, exact, epsilon = 1e-13);
    }
}

#[test]
fn permittivities_follow_temperature_and_water() {
    let bench = Bench::new(vec![0.0, 10.0], vec![0.0; 2], vec![20.0, 30.0]);
    let warm = bench.dielectric("permittivity_temperature", &[1e-5, 0.25]);
    assert_abs_diff_eq!(warm.insulator[1], 1.0 + 1e-5 * 0.75 * 10.0, epsilon = ROUNDING);
    assert_abs_diff_eq!(warm.beads[1], 1.0 + 30.0 * 1e-5 * 0.25 * 10.0, epsilon = ROUNDING);
    let wet = bench.dielectric("humidity_uptake", &[1e-3, 0.0]);
    assert_abs_diff_eq!(wet.insulator[1], 1.01, epsilon = ROUNDING);
    let slowly = bench.dielectric("humidity_uptake", &[1e-3, 10.0]);
    // a ramp of one time constant: 10 % x (1 - (1 - 1/e))
    assert_abs_diff_eq!(slowly.insulator[1], 1.0 + 0.01 * (-1.0_f64).exp(), epsilon = ROUNDING);
}

#[test]
fn the_field_beside_the_plates_is_kirchhoffs_or_a_constant() {
    let bench = Bench::hold(0.0, &[0.0]);
    let extra = |id: &str, values: &[f64]| {
        let mut extra = vec![0.0];
        bench.stage(id, values).field(
            &bench.drive(),
            &FieldView { aspect: &[0.02], strain: &[0.1], plates: &[50.0] },
            &mut extra,
        );
        extra[0]
    };
    // 50 x 0.02 / pi x (ln(800 pi) - 1), by hand: ln(2513.274) = 7.829341
    assert_abs_diff_eq!(extra("fringing_field", &[1.0]), 6.829_341 / std::f64::consts::PI, epsilon = 1e-6);
    assert_eq!(extra("parasitic_capacitance", &[0.3]), 0.3);
}

#[test]
fn the_electronics_lag_drift_jump_and_clip_as_they_should() {
    let bench = Bench::new(vec![0.0, 1800.0, 3600.0], vec![0.0, 1.0, 2.0], vec![20.0, 20.0, 30.0]);
    let reading = [100.0, 110.0, 120.0];
    assert_eq!(bench.readings("offset_drift", &[0.02, 0.0], &reading), vec![100.0, 110.01, 120.02]);
    let fading = bench.readings("offset_drift", &[0.02, 1.0], &reading);
    assert_abs_diff_eq!(fading[2], 120.0 + 0.02 * (1.0 - (-1.0_f64).exp()), epsilon = 1e-13);
    // 10 K above the reference, 20 above zero
    assert_abs_diff_eq!(bench.readings("gain_drift", &[1e-3], &reading)[2], 120.2, epsilon = 1e-13);
    let lagging = bench.readings("readout_lag", &[60.0], &reading);
    // slope of 10 in 1800 s, thirty time constants gone
    assert_abs_diff_eq!(lagging[2], 120.0 - 60.0 * 10.0 / 1800.0, epsilon = 1e-11);
    let clipped = bench.readings("saturation", &[1.0, 0.5], &reading);
    // half a span above zero, less what the rounding of 1 % of the span takes off well above it: w^2 / x
    assert_abs_diff_eq!(clipped[2], 105.0, epsilon = 10.0 * 1e-4 / 1.4);
    let mut two = Bench::new(vec![0.0, 1.0, 2.0], vec![0.0; 3], vec![20.0; 3]);
    two.inputs.run = vec![1, 2, 3];
    assert_eq!(two.readings("offset_steps", &[0.5, 1.0, -3.0], &[100.0; 3]), vec![100.0, 100.5, 99.0]);
    assert_eq!(bench.stage("time_offset", &[0.25]).late_s(7.0), 0.25);
    assert_eq!(bench.stage("clock_rate", &[0.25, 3.0]).late_s(7.0), 1.0);
}

#[test]
fn what_was_computed_beforehand_is_put_in_its_share() {
    // the plate's own curves: strain e / (2.4 + 1.5 e), growth 2.4e-4 and 3.4e-6 per kelvin, rims 0.04 + 0.5 aspect and 4 pF, mixing 0.98 - 0.1 e
    let bench = Bench::new(vec![0.0, 10.0], vec![0.0, 1.0], vec![20.0, 30.0]);
    let whole = 0.2 / (2.4 + 1.5 * 0.2) - 2.4e-3;
    assert_abs_diff_eq!(bench.strains("bonded_layers", &[1.0])[1], whole, epsilon = 1e-7);
    assert_abs_diff_eq!(bench.strains("bonded_layers", &[0.5])[1], 0.5 * (0.2 + whole), epsilon = 1e-7);
    assert_abs_diff_eq!(bench.dielectric("bonded_layers", &[1.0]).insulator[1], 1.0 / (1.0 + 3.4e-5), epsilon = ROUNDING);
    let view = FieldView { aspect: &[0.02, 0.02], strain: &[0.0, 0.0976], plates: &[50.0, 50.0] };
    let extra = |id: &str| {
        let mut extra = vec![0.0; 2];
        bench.stage(id, &[1.0]).field(&bench.drive(), &view, &mut extra);
        extra[1]
    };
    // heat has taken 0.0024 off the strain that the load makes
    assert_abs_diff_eq!(extra("bonded_layers"), 50.0 * (0.98 - 0.01 - 1.0), epsilon = 1e-7);
    assert_abs_diff_eq!(extra("rim_field"), 50.0 * 0.05 + 4.0, epsilon = 1e-7);
    // 1 - 1e-4 per kelvin without load; under full load 0.2 + 0.8 / 21 of it
    assert_abs_diff_eq!(extra("held_warp"), -50.0 * 1e-3 * (0.2 + 0.8 / 21.0), epsilon = 1e-6);
    assert_eq!(bench.geometry("held_warp", &[1.0], &[0.0, 0.2]).warp_factor, -1.0);
}
