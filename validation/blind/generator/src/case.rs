//! One blind case: a drawn sensor, protocol and noise, with causes sized to be as detectable as drawn.
//!
//! Limits: causes that a protocol cannot show at a believable size are drawn again, so poor protocols hold fewer kinds of cause.

use crate::answer::Answer;
use crate::bath::bath;
use crate::causes::{Bench, DrawShape, LIBRARY, STRANGERS, SizeError, WILD, left_out};
use crate::chain::{Act, simulate};
use crate::detectability::input_error;
use crate::draws::Draws;
use crate::history::History;
use crate::logger::Logger;
use crate::mechanism::{Mechanism, Needs};
use crate::noise::Noise;
use crate::protocol::Kind;
use crate::recording::{Declared, Recording};
use crate::score::family::family;
use crate::sensor::Sensor;
use crate::settings::{Only, Settings, Shares};
use crate::state::{PlatesTouch, Scene};
use serde_json::Value;
use std::collections::BTreeMap;

/// Draws of causes before less is asked of them.
const ATTEMPTS: usize = 12;
/// Least detectability at which an effect that is left out is still posed.
const LEAST: f64 = 0.5;

/// A case: what the tool gets, and what is concealed.
#[derive(Debug, Clone)]
pub struct BlindCase {
    /// What the tool gets.
    pub recording: Recording,
    /// What is sealed.
    pub answer: Answer,
    /// Causes at their sizes.
    pub acts: Vec<Act>,
    /// Noise-free readings, pF.
    pub truth_pf: Vec<f64>,
    /// Readings of the declared base model with the true sensor, pF.
    pub base_pf: Vec<f64>,
    pub(crate) seed: u64,
}

/// Why a case could not be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CaseError {
    /// The sensor drawn closes under its load.
    #[error("{case}: {source}")]
    Closed {
        /// Case.
        case: String,
        /// Where.
        source: PlatesTouch,
    },
    /// Nothing drawn could be seen.
    #[error("{case}: no cause reaches detectability {asked:.1} on a {protocol:?} protocol; widen the protocols or ask for less")]
    NothingToShow {
        /// Case.
        case: String,
        /// Detectability asked last.
        asked: f64,
        /// Protocol.
        protocol: Kind,
    },
}

/// How many causes and of which sort.
#[derive(Debug, Clone, Copy)]
enum Makeup {
    Library(usize),
    Stranger,
    /// Of those that words describe.
    Wild,
    /// One that the diagnosis is to do without.
    LeftOut(DrawShape),
}

impl Makeup {
    fn drawn(settings: &Settings, index: usize, draws: &mut Draws) -> Self {
        match (settings.options.only, draws.weighted(&settings.shares.makeup)) {
            (Only::WithoutEach, _) => Self::LeftOut(left_out(index).1),
            (Only::Wild, 4) => Self::Wild,
            (_, 4) => Self::Stranger,
            (_, count) => Self::Library(count),
        }
    }

    /// Whether it is in no library, or in none that the diagnosis has.
    fn is_outside(self) -> bool {
        !matches!(self, Self::Library(_))
    }
}

/// What is fixed before the causes are drawn.
struct Setting {
    case: String,
    sensor: Sensor,
    kind: Kind,
    history: History,
    noise: Noise,
    logger: Option<Logger>,
}

/// Causes with the base model they are posed in.
struct Posed {
    acts: Vec<Act>,
    bath: Vec<Act>,
    declared: Declared,
}

impl BlindCase {
    pub(crate) fn draw(settings: &Settings, index: usize) -> Result<Self, CaseError> {
        let case = format!("case-{:03}", index + 1);
        let stream = |purpose: &str| Draws::of(settings.seed, &format!("{case}/{purpose}"));
        let shares = &settings.shares;
        let logger = match settings.options.only {
            Only::Loggers => Some(Logger::ALL[index % Logger::ALL.len()]),
            Only::Wild => Some(Logger::WILD[stream("logger").index(Logger::WILD.len())]),
            _ => None,
        };
        let setting = Setting::drawn(case.clone(), shares, stream).with_logger(logger);
        let draws = &mut stream("causes");
        let makeup = Makeup::drawn(settings, index, draws);
        let asked = draws.log_between(settings.options.detectability_from, settings.options.detectability_to);
        let mut posed = setting.pose(makeup, asked, settings, draws)?;
        if settings.options.only == Only::Wild {
            posed.bath = bath(&setting.bench(posed.declared.warp)?, &posed.acts, posed.declared, &mut stream("bath"));
        }
        let salt = format!("{:016x}{:016x}", stream("salt").bits(), stream("more salt").bits());
        setting.finish(posed, makeup, salt, settings.seed, &mut stream("noise"))
    }
}

impl Setting {
    fn drawn(case: String, shares: &Shares, stream: impl Fn(&str) -> Draws) -> Self {
        let draws = &mut stream("setting");
        let weights: Vec<f64> = shares.protocols.iter().map(|(_, weight)| *weight).collect();
        let kind = shares.protocols[draws.weighted(&weights)].0;
        let vary = draws.chance(0.7);
        let sd = [0.003, 0.004, 0.004, 0.006][draws.index(4)];
        let coloured = draws.chance(shares.coloured);
        let noise = if coloured { Noise::coloured(sd, draws.between(0.55, 0.7)) } else { Noise::white(sd) };
        Self {
            case,
            sensor: Sensor::singletact_s15().drawn(&mut stream("sensor")),
            kind,
            history: kind.history(vary, &mut stream("protocol")),
            noise,
            logger: None,
        }
    }

    fn with_logger(self, logger: Option<Logger>) -> Self {
        Self { noise: logger.map_or(self.noise, Logger::noise), logger, ..self }
    }

    fn scene(&self) -> Scene<'_> {
        Scene { sensor: &self.sensor, history: &self.history }
    }

    fn bench(&self, warp: bool) -> Result<Bench<'_>, CaseError> {
        Bench::new(self.scene(), warp, self.noise.sd_pf).map_err(|source| CaseError::Closed { case: self.case.clone(), source })
    }

    /// Draws causes until they can be seen; asks for less after [`ATTEMPTS`] draws.
    fn pose(&self, makeup: Makeup, asked: f64, settings: &Settings, draws: &mut Draws) -> Result<Posed, CaseError> {
        let shares = &settings.shares;
        let humidity = draws.chance(shares.humidity);
        let flat = draws.chance(shares.flat);
        let mut benches: [Option<Bench>; 2] = [None, None];
        let mut asked = asked;
        // what is left out is posed as large as it can be believed, however little that is: it has no substitute
        let least = if matches!(makeup, Makeup::LeftOut(_)) { LEAST } else { 0.99 * settings.options.detectability_from };
        while asked >= least {
            for _ in 0..ATTEMPTS {
                let causes = drawn_causes(makeup, shares, draws);
                let Some(needs) = together(&causes) else { continue };
                let warp = if needs.warp { true } else { !(needs.no_warp || flat) };
                let slot = usize::from(warp);
                if benches[slot].is_none() {
                    benches[slot] = Some(self.bench(warp)?);
                }
                let Some(bench) = &benches[slot] else { continue };
                if let Ok(acts) = sized(bench, causes, asked, draws) {
                    return Ok(Posed {
                        acts,
                        bath: Vec::new(),
                        declared: Declared { warp, humidity: humidity || needs.humidity },
                    });
                }
            }
            asked *= 0.7;
        }
        Err(CaseError::NothingToShow { case: self.case.clone(), asked, protocol: self.kind })
    }

    fn finish(self, posed: Posed, makeup: Makeup, salt: String, seed: u64, noise: &mut Draws) -> Result<BlindCase, CaseError> {
        let closed = |source| CaseError::Closed { case: self.case.clone(), source };
        let Posed { acts, bath, declared } = posed;
        let bench = self.bench(declared.warp)?;
        let all: Vec<Act> = acts.iter().chain(&bath).cloned().collect();
        let truth_pf = simulate(self.scene(), declared.warp, &all).map_err(closed)?;
        let base_pf = simulate(self.scene(), declared.warp, &[]).map_err(closed)?;
        let left = bench.leftover(&acts).map_err(closed)?;
        let noisy = input_error(self.scene(), declared.warp, &self.noise).map_err(closed)?;
        let noisy = Bench::with_noise(self.scene(), declared.warp, noisy).map_err(closed)?;
        let beside_input_noise = noisy.leftover(&acts).map_err(closed)?.detectability;
        let alone = |act: &Act| bench.leftover(std::slice::from_ref(act)).map(|left| left.detectability).map_err(closed);
        let each = acts.iter().map(alone).collect::<Result<Vec<f64>, _>>()?;
        let weak = bath.iter().map(|act| Ok((act.mechanism.id().to_owned(), alone(act)?)));
        let weak = weak.collect::<Result<BTreeMap<_, _>, _>>()?;
        let names: Vec<String> = acts.iter().map(|act| act.mechanism.id().to_owned()).collect();
        let numbers = |act: &Act| (act.mechanism.id().to_owned(), Value::from(act.mechanism.numbers(act.size)));
        let stranger = makeup.is_outside();
        let answer = Answer {
            case: self.case.clone(),
            salt,
            effects: if stranger { Vec::new() } else { names.clone() },
            stranger: names.first().filter(|_| stranger).cloned(),
            bath: weak,
            without: names.first().filter(|_| matches!(makeup, Makeup::LeftOut(_))).cloned(),
            detectability: left.detectability,
            detectability_beside_input_noise: Some(beside_input_noise),
            apart: bench.apart(&acts).map_err(closed)?,
            each,
            residual_share: if left.detectability > 0.0 { left.residual / left.detectability } else { 0.0 },
            rms_before_calibration_over_noise: left.before,
            rms_after_calibration_over_noise: left.after,
            protocol: self.kind,
            noise: self.noise,
            logger: self.logger,
            warp_declared: declared.warp,
            humidity_column: declared.humidity,
            parameters: all.iter().map(numbers).collect(),
            sensor: self.sensor,
        };
        let recording = Recording::noisy(&self.history, &truth_pf, &self.noise, declared, noise);
        let driver = acts.iter().find_map(|act| act.mechanism.records(&self.history));
        let recording = Recording { driver, ..recording };
        let recording = match self.logger {
            Some(logger) => logger.written(recording, &truth_pf, noise),
            None => recording,
        };
        Ok(BlindCase { recording, answer, acts: all, truth_pf, base_pf, seed })
    }
}

/// Shapes of as many causes as `makeup` says, of different families.
fn drawn_causes(makeup: Makeup, shares: &Shares, draws: &mut Draws) -> Vec<Box<dyn Mechanism>> {
    let count = match makeup {
        Makeup::Library(count) => count,
        Makeup::Stranger => return vec![STRANGERS[draws.weighted(&shares.strangers)].1(draws)],
        Makeup::Wild => return vec![WILD[draws.weighted(&shares.wild)].1(draws)],
        Makeup::LeftOut(shape) => return vec![shape(draws)],
    };
    let mut causes: Vec<Box<dyn Mechanism>> = Vec::new();
    while causes.len() < count {
        let (id, shape) = LIBRARY[draws.weighted(&shares.library)];
        if causes.iter().all(|cause| family(cause.id()) != family(id)) {
            causes.push(shape(draws));
        }
    }
    causes
}

/// What all of them need; `None` where they contradict each other.
fn together(causes: &[Box<dyn Mechanism>]) -> Option<Needs> {
    let mut all = Needs::default();
    for needs in causes.iter().map(|cause| cause.needs()) {
        all.warp |= needs.warp;
        all.no_warp |= needs.no_warp;
        all.humidity |= needs.humidity;
    }
    (!(all.warp && all.no_warp)).then_some(all)
}

/// Each cause alone at about the detectability asked for (several: within a factor 1.4 of each other).
fn sized(bench: &Bench, causes: Vec<Box<dyn Mechanism>>, asked: f64, draws: &mut Draws) -> Result<Vec<Act>, SizeError> {
    let several = causes.len() > 1;
    let mut acts = Vec::new();
    for cause in causes {
        let share = if several { draws.log_between(0.85, 1.18) } else { 1.0 };
        acts.push(bench.sized(cause, asked * share)?);
    }
    // Together they may close the plates even where each alone does not.
    match bench.leftover(&acts) {
        Ok(_) => Ok(acts),
        Err(PlatesTouch { .. }) => Err(SizeError::NotSettled { cause: "several", asked }),
    }
}
