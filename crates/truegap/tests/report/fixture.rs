//! A diagnosis with made-up numbers: a load that goes up and down in three runs while the temperature rises, and a sensor that lags.

use truegap::diagnosis::report::{Provenance, Subject};
use truegap_core::Inputs;
use truegap_diagnose::Library;
use truegap_diagnose::answer::*;

const ROWS: usize = 900;
const NOISE: f64 = 0.004;

pub struct Fixture {
    pub diagnosis: Diagnosis,
    pub traces: Traces,
    pub inputs: Inputs,
    pub response: Vec<f64>,
    pub provenance: Provenance,
    pub library: Library,
}

impl Fixture {
    pub fn subject(&self) -> Subject<'_> {
        Subject {
            diagnosis: &self.diagnosis,
            traces: &self.traces,
            inputs: &self.inputs,
            response: &self.response,
            provenance: &self.provenance,
            library: &self.library,
        }
    }
}

/// Something like noise, the same each time.
fn jitter(row: usize) -> f64 {
    ((row as f64 * 12.9898).sin() * 43_758.545_3).fract() * 1.7 * NOISE
}

pub fn thermal_lag() -> Fixture {
    let rows = 0..ROWS;
    let run = |row: usize| row / 300;
    let time: Vec<f64> = rows.clone().map(|r| r as f64 * 2.0 + run(r) as f64 * 900.0).collect();
    let within = |row: usize| (row % 300) as f64 / 300.0;
    let force: Vec<f64> = rows.clone().map(|r| 2.25 * (1.0 - (within(r) * 12.0).cos())).collect();
    let temperature: Vec<f64> =
        rows.clone().map(|r| 20.0 + 25.0 * (within(r) * std::f64::consts::PI).sin() * run(r) as f64 / 2.0).collect();
    let lagged: Vec<f64> =
        rows.clone().map(|r| 25.0 * run(r) as f64 / 2.0 * 0.15 * (within(r) * std::f64::consts::PI).cos()).collect();
    let model: Vec<f64> = force.iter().zip(&temperature).map(|(f, t)| 64.0 + 3.0 * f + 0.04 * (t - 20.0)).collect();
    let truth: Vec<f64> = model.iter().zip(&lagged).map(|(m, l)| m - 0.04 * l).collect();
    let response: Vec<f64> = truth.iter().enumerate().map(|(r, t)| t + jitter(r)).collect();
    let rms = |p: &[f64]| (response.iter().zip(p).map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / ROWS as f64).sqrt();
    let (before, after) = (rms(&model), rms(&truth));
    let inputs = Inputs {
        time_s: Some(time),
        run: rows.clone().map(|r| run(r) as u32 + 1).collect(),
        force_n: Some(force),
        temperature_c: Some(temperature),
        ..Inputs::default()
    };
    let traces = Traces {
        held_out_before: model.iter().map(|m| m + 0.002).collect(),
        held_out_after: truth.iter().map(|t| t - 0.001).collect(),
        before: model,
        after: truth,
        noise_sd: vec![NOISE; ROWS],
        map_before: Some(map(6.0)),
        map_after: Some(map(0.4)),
        course: None,
        flexible: Vec::new(),
        held_out_flexible: Vec::new(),
    };
    Fixture {
        diagnosis: diagnosis(before, after),
        traces,
        inputs,
        response,
        provenance: provenance(),
        library: Library::default(),
    }
}

fn provenance() -> Provenance {
    Provenance {
        command: "truegap diagnose recording.toml -o out".into(),
        made_at: "2026-01-02 03:04 UTC".into(),
        files: vec![("recording.csv".into(), "ab".repeat(32))],
        interrupted: false,
        has_model: true,
    }
}

fn map(size: f64) -> Map {
    let cell = |y: usize, x: usize| if x == 4 && y == 3 { f64::NAN } else { size * (y as f64 - 1.5) * (1.0 - 0.1 * x as f64) };
    Map {
        x_label: "force (N)".into(),
        y_label: "temperature (°C)".into(),
        x_edges: (0..6).map(|x| 0.9 * f64::from(x)).collect(),
        y_edges: (0..5).map(|y| 20.0 + 6.25 * f64::from(y)).collect(),
        values: (0..4).map(|y| (0..5).map(|x| cell(y, x)).collect()).collect(),
    }
}

pub fn parameter(name: &str, unit: &str, prior: [f64; 2], value: f64, sd: f64) -> ParameterFacts {
    ParameterFacts {
        name: name.into(),
        unit: unit.into(),
        prior,
        value,
        sd,
        sd_of_fit: sd,
        at_limit: false,
        meaning: format!("what {name} means"),
    }
}

fn plain(name: &'static str, rmse: f64, held_out: f64) -> Reference {
    Reference { name, inputs: vec!["force".into(), "temperature".into()], rmse, held_out: Some(held_out) }
}

fn diagnosis(before: f64, after: f64) -> Diagnosis {
    Diagnosis {
        schema: SCHEMA,
        version: "0.0.0",
        recording: RecordingFacts {
            rows: ROWS,
            runs: 3,
            sha256: "ab".repeat(32),
            source: "recording.csv".into(),
            ..RecordingFacts::default()
        },
        base: BaseFacts {
            model: "stack".into(),
            sensor: Some("singletact-s15-4.5n".into()),
            parameters: vec![
                parameter("young_rtv", "Pa", [1.075e6, 0.054e6], 0.821e6, 0.006e6),
                parameter("height_rtv", "m", [162e-6, 5e-6], 160.2e-6, 1.1e-6),
                parameter("stray", "F", [0.0, 0.3e-12], 0.11e-12, 0.04e-12),
            ],
            parameters_after: vec![
                parameter("young_rtv", "Pa", [1.075e6, 0.054e6], 1.062e6, 0.007e6),
                parameter("height_rtv", "m", [162e-6, 5e-6], 161.3e-6, 1.2e-6),
                parameter("stray", "F", [0.0, 0.3e-12], 0.05e-12, 0.05e-12),
            ],
        },
        noise: NoiseFacts {
            says: "white noise of 4 fF from 60 rows at rest".into(),
            white_sd: NOISE,
            ar_sd: 0.001,
            ar_correlation: 0.6,
            lasting_sd: 0.0,
            load_sd: 0.005,
            temperature_sd: 0.05,
            measured: true,
            recordings: Vec::new(),
        },
        verdict: Verdict::Explained,
        probability_agrees: 1e-9,
        says: "missing: thermal_lag; nothing else is needed".into(),
        concealed: true,
        conflicts: vec![Conflict {
            says: "to fit, young_rtv must fall 24 %, 4.7 prior sd".into(),
            parameter: "young_rtv".into(),
            z: -4.7,
            between_parts: false,
        }],
        mismatch: vec![Mismatch {
            says: "the reading is behind while the temperature moves, 60 fF at 1 K/min".into(),
            driver: "temperature_c".into(),
            along: "with the time since the temperature changed".into(),
            interval: [38.0, 45.0],
            runs: vec![2, 3],
            share: 0.81,
            p_value: 1e-30,
        }],
        remains: Vec::new(),
        discovered: Vec::new(),
        findings: vec![Finding {
            effect: "thermal_lag".into(),
            probability: 0.91,
            probability_among_models: 0.98,
            says: "the sensor follows the thermometer with a time constant of 120 s (sd 6)".into(),
            detectability: Some(31.0),
            parameters: vec![parameter("tau", "s", [0.0, 120.0], 120.0, 6.0)],
            held_out: BeforeAfterUnit { rmse_before: Some(before), rmse_after: Some(after), unit: "pF".into() },
            rivals: vec!["readout_lag".into()],
            words: Default::default(),
        }],
        carried: Vec::new(),
        candidates: vec![
            Candidate { effect: "thermal_lag".into(), probability: 0.98, score: 480.0, chi2_drop: 970.0, freedom: 1 },
            Candidate { effect: "viscoelastic_creep".into(), probability: 0.01, score: 120.0, chi2_drop: 250.0, freedom: 2 },
            Candidate { effect: "offset_drift".into(), probability: 0.002, score: -3.0, chi2_drop: 2.0, freedom: 2 },
        ],
        unmodelled: Vec::new(),
        ambiguity: Vec::new(),
        fit: FitFacts {
            in_sample: BeforeAfter { rmse_before: before, rmse_after: after },
            held_out: HeldOut {
                how: "each run in turn".into(),
                rmse_before: Some(before * 1.1),
                rmse_after: Some(after * 1.1),
                misfit_removed: Some(0.97),
                permutation_control: Some(0.01),
                recordings: Vec::new(),
                selected_again: None,
                parts: vec![("run 1".into(), 0.005, 0.0042), ("run 2".into(), 0.05, 0.0043), ("run 3".into(), 0.1, 0.0045)],
            },
            noise_floor: NOISE,
            unit: "pF".into(),
        },
        reference: vec![plain("straight_line", 0.0213, 0.0241), plain("smooth_curve", 0.0187, 0.0305)],
        reference_says: None,
        prediction_only: None,
        permuted_searches: None,
        confirmation: None,
        not_testable: vec![NotTestable { effect: "humidity_uptake".into(), says: "no humidity column".into() }],
        smallest_visible: vec![SmallestVisible {
            effect: "viscoelastic_creep".into(),
            parameter: "size".into(),
            unit: "1".into(),
            size: 0.0021,
        }],
        next_experiment: NextExperiment {
            says: "heat at two rates under constant load".into(),
            separates: vec!["thermal_lag".into(), "readout_lag".into()],
            options: vec![ExperimentOption {
                says: "heat from 20 to 45 °C in 5 min, hold 20 min".into(),
                separation: 14.0,
                error_left: None,
                hours: 0.5,
                profile: Some("thermal-steps".into()),
            }],
        },
        bank: None,
        notices: Vec::new(),
        concealed_column: None,
        adequacy: adequacy(),
        evidence_check: Default::default(),
        recording_issues: vec!["12 rows repeat the value before them".into()],
        seeds: Some(truegap_diagnose::SEEDS),
        seconds: 3.2,
    }
}

impl Fixture {
    /// The same mismatch where nothing may be named, and a flexible term serves prediction.
    pub fn without_cause(&mut self) {
        let diagnosis = &mut self.diagnosis;
        diagnosis.verdict = Verdict::Unexplained;
        let found = std::mem::take(&mut diagnosis.findings).remove(0);
        let mut remains = diagnosis.mismatch[0].clone();
        remains.says = "what is left here".into();
        diagnosis.prediction_only = Some(PredictionOnly {
            says: "for prediction only, without a claim about the cause: a flexible term".into(),
            terms: vec![FlexibleTerm { shaped_like: found.effect, says: found.says, parameters: found.parameters }],
            in_sample: diagnosis.fit.in_sample,
            held_out: BeforeAfter { rmse_before: 0.05, rmse_after: 0.02 },
            misfit_removed: Some(0.64),
            permutation_control: Some(0.1),
            remains: vec![remains],
        });
        self.traces.flexible = self.traces.after.clone();
        self.traces.held_out_flexible = self.traces.held_out_after.clone();
    }
}

/// Tests that reject the base model and not what is named.
fn adequacy() -> AdequacyFacts {
    let test = |statistic: f64, p_value: f64| JointTest { statistic, freedom: 12, p_value };
    let of = |smooth: JointTest| Adequacy {
        smooth,
        stretches: test(11.0, 0.5),
        line_p_value: 0.4,
        line_at: (0, 0.1),
        left_over_noise: 1.0,
    };
    AdequacyFacts { before: Some(of(test(300.0, 1e-40))), after: Some(of(test(12.0, 0.4))), ..AdequacyFacts::default() }
}

/// A mechanism of words.
pub fn mechanism() -> DiscoveredFacts {
    let text = "schema = \"truegap.mechanism/1\"\nid = \"gap_follows_heating\"\nquantity = \"gap\"\naction = \"adds\"\ndriver = \"temperature_rate\"\n\
                kinetics = \"first_order\"\nform = \"linear\"\nsize = { sd = 0.5, unit = \"1\" }\ntau = { value = 30.0, sd = 20.0, unit = \"s\" }\n";
    let file: truegap_diagnose::mechanism::MechanismFile = toml::from_str(text).unwrap();
    let word = String::new;
    DiscoveredFacts {
        place: word(),
        driver: word(),
        kinetics: word(),
        form: word(),
        action: word(),
        sentence: file.sentence.clone(),
        named: true,
        carried: false,
        in_other_words: false,
        log_odds: Some(10.0),
        probability: Default::default(),
        clause: word(),
        says: word(),
        could_be: Vec::new(),
        parameters: Vec::new(),
        held_out: BeforeAfterUnit { rmse_before: None, rmse_after: None, unit: "pF".into() },
        control_p_value: 0.01,
        weighed: 100,
        file,
    }
}
