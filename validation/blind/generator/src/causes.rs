//! The register of causes, and the size that makes one as detectable as asked.
//!
//! Limits: a cause that cannot reach what is asked below its `size_limit` is refused; a study then poses another.

use crate::chain::{Act, simulate};
use crate::detectability::{Calibration, Leftover};
use crate::draws::Draws;
use crate::mechanism::{self as m, Mechanism};
use crate::state::{PlatesTouch, Scene};
use crate::stranger as s;
use crate::wild as w;

/// Draws a cause's shape.
pub type DrawShape = fn(&mut Draws) -> Box<dyn Mechanism>;

/// Every effect of the table in `design.md`.
pub const LIBRARY: [(&str, DrawShape); 24] = [
    ("contact_toe_in", m::contact_toe_in::draw),
    ("eccentric_load", m::eccentric_load::draw),
    ("thermal_lag", m::thermal_lag::draw),
    ("viscoelastic_creep", m::viscoelastic_creep::draw),
    ("rate_independent_hysteresis", m::rate_independent_hysteresis::draw),
    ("mullins_softening", m::mullins_softening::draw),
    ("strain_stiffening", m::strain_stiffening::draw),
    ("electrode_warp", m::electrode_warp::draw),
    ("thermal_hysteresis", m::thermal_hysteresis::draw),
    ("permittivity_temperature", m::permittivity_temperature::draw),
    ("humidity_uptake", m::humidity_uptake::draw),
    ("fringing_field", m::fringing_field::draw),
    ("parasitic_capacitance", m::parasitic_capacitance::draw),
    ("dead_gap", m::dead_gap::draw),
    ("trapped_air_stiffness", m::trapped_air_stiffness::draw),
    ("ageing", m::ageing::draw),
    ("plate_bending", m::plate_bending::draw),
    ("readout_lag", m::readout_lag::draw),
    ("offset_drift", m::offset_drift::draw),
    ("offset_steps", m::offset_steps::draw),
    ("gain_drift", m::gain_drift::draw),
    ("saturation", m::saturation::draw),
    ("time_offset", m::time_offset::draw),
    ("load_cell_error", m::load_cell_error::draw),
];

/// Causes that no library holds.
pub const STRANGERS: [(&str, DrawShape); 9] = [
    ("hum", s::hum::draw),
    ("beat", s::beat::draw),
    ("thermal_rate", s::thermal_rate::draw),
    ("force_rate_squared", s::force_rate_squared::draw),
    ("bursts", s::bursts::draw),
    ("random_walk", s::random_walk::draw),
    ("telegraph", s::telegraph::draw),
    ("slips", s::slips::draw),
    ("converter_ripple", s::converter_ripple::draw),
];

/// Effects of the library that came later; no study draws them but that which leaves one effect out at a time, so that seeds keep their cases.
pub const FURTHER: [(&str, DrawShape); 5] = [
    ("clock_rate", m::clock_rate::draw),
    ("held_warp", m::held_warp::draw),
    ("bonded_layers", m::bonded_layers::draw),
    ("rim_field", m::rim_field::draw),
    ("driver_coefficient", m::driver_coefficient::draw),
];

/// Causes that no library holds and that words describe; the last four are strangers as well.
pub const WILD: [(&str, DrawShape); 15] = [
    ("bottoming", w::bottoming::draw),
    ("cold_flow", w::cold_flow::draw),
    ("cycle_fatigue", w::cycle_fatigue::draw),
    ("glass_knee", w::glass_knee::draw),
    ("heating_gradient", w::heating_gradient::draw),
    ("motor_pickup", w::motor_pickup::draw),
    ("converter_memory", w::converter_memory::draw),
    ("latch", w::latch::draw),
    ("thixotropy", w::thixotropy::draw),
    ("thermal_ratchet", w::thermal_ratchet::draw),
    ("compressor", w::compressor::draw),
    ("hum", s::hum::draw),
    ("thermal_rate", s::thermal_rate::draw),
    ("force_rate_squared", s::force_rate_squared::draw),
    ("converter_ripple", s::converter_ripple::draw),
];

/// Effect number `index` of those that are left out one at a time, starting again after the last.
pub fn left_out(index: usize) -> (&'static str, DrawShape) {
    let place = index % (LIBRARY.len() + FURTHER.len());
    LIBRARY.get(place).or_else(|| FURTHER.get(place - LIBRARY.len())).copied().unwrap_or(LIBRARY[0])
}

/// Why a cause cannot be posed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SizeError {
    /// Even the largest believable size is not seen well enough.
    #[error(
        "{cause}: detectability {asked:.1} asked, {reached:.1} at its largest believable size; ask for less or take a richer protocol"
    )]
    OutOfReach {
        /// Id of the cause.
        cause: &'static str,
        /// Detectability asked for.
        asked: f64,
        /// Detectability at the limit.
        reached: f64,
    },
    /// The search did not settle: detectability jumps with the size.
    #[error("{cause}: no size gives detectability {asked:.1} to 1 %; the effect jumps with its size here")]
    NotSettled {
        /// Id of the cause.
        cause: &'static str,
        /// Detectability asked for.
        asked: f64,
    },
}

/// A base model and its calibration, ready to be given causes.
#[derive(Debug)]
pub struct Bench<'a> {
    /// Sensor and history.
    pub scene: Scene<'a>,
    /// Whether the electrode bends with temperature, in the truth before causes and in the declared base.
    pub warp: bool,
    base: Vec<f64>,
    calibration: Calibration,
}

impl<'a> Bench<'a> {
    /// Simulates the base model and its Jacobian.
    pub fn new(scene: Scene<'a>, warp: bool, noise_pf: f64) -> Result<Self, PlatesTouch> {
        Self::with_noise(scene, warp, vec![noise_pf; scene.history.rows()])
    }

    /// As [`Bench::new`], with the noise of each row, pF.
    pub fn with_noise(scene: Scene<'a>, warp: bool, noise_pf: Vec<f64>) -> Result<Self, PlatesTouch> {
        let nominal = crate::sensor::Sensor::singletact_s15();
        Ok(Self {
            scene,
            warp,
            base: simulate(scene, warp, &[])?,
            calibration: Calibration::new(scene, &nominal, warp, noise_pf)?,
        })
    }

    /// What calibration leaves of `acts` together.
    pub fn leftover(&self, acts: &[Act]) -> Result<Leftover, PlatesTouch> {
        let truth = simulate(self.scene, self.warp, acts)?;
        let effect: Vec<f64> = truth.iter().zip(&self.base).map(|(t, b)| t - b).collect();
        Ok(self.calibration.leftover(&effect))
    }

    /// Detectability of any `effect` (pF, one entry a row).
    pub fn detectability_of(&self, effect: &[f64]) -> f64 {
        self.calibration.leftover(effect).detectability
    }

    /// Detectability of each of `acts` once the others are known but for their size.
    ///
    /// Little of it is left where two causes look alike: no tool can then tell both from one.
    pub fn apart(&self, acts: &[Act]) -> Result<Vec<f64>, PlatesTouch> {
        let mut effects = Vec::new();
        for act in acts {
            let truth = simulate(self.scene, self.warp, std::slice::from_ref(act))?;
            effects.push(truth.iter().zip(&self.base).map(|(t, b)| t - b).collect::<Vec<f64>>());
        }
        let left = |chosen: &[usize]| -> Vec<Vec<f64>> {
            let row = |i: &usize| chosen.iter().map(|j| self.calibration.in_common(&effects[*i], &effects[*j])).collect();
            chosen.iter().map(row).collect()
        };
        Ok((0..acts.len())
            .map(|which| {
                // Schur complement: the cause asked for goes last, the others are eliminated.
                let order: Vec<usize> = (0..acts.len()).filter(|other| *other != which).chain([which]).collect();
                last_pivot(left(&order)).max(0.0).sqrt()
            })
            .collect())
    }

    /// Detectability of one cause at `size`; closed plates count as endlessly detectable.
    fn seen(&self, mechanism: &dyn Mechanism, size: f64) -> f64 {
        let act = Act { mechanism: mechanism.boxed(), size };
        self.leftover(std::slice::from_ref(&act)).map_or(f64::INFINITY, |left| left.detectability)
    }

    /// `mechanism` at the size that gives detectability `asked`, to 0.5 %.
    pub fn sized(&self, mechanism: Box<dyn Mechanism>, asked: f64) -> Result<Act, SizeError> {
        let cause = mechanism.id();
        let seen = |size: f64| self.seen(mechanism.as_ref(), size);
        let (mut low, mut high) = (mechanism.size_start(), mechanism.size_start());
        let (mut at_low, mut at_high) = (seen(low), seen(high));
        for _ in 0..30 {
            if at_low <= asked {
                break;
            }
            (high, at_high) = (low, at_low);
            low *= 0.25;
            at_low = seen(low);
        }
        while at_high < asked {
            if high >= mechanism.size_limit() {
                return Err(SizeError::OutOfReach { cause, asked, reached: at_high });
            }
            (low, at_low) = (high, at_high);
            high = (high * 4.0).min(mechanism.size_limit());
            at_high = seen(high);
        }
        for turn in 0..60 {
            let straight = (asked / at_low).ln() / (at_high / at_low).ln();
            let share = if turn % 3 == 2 || !straight.is_finite() { 0.5 } else { straight.clamp(0.02, 0.98) };
            let size = low * (high / low).powf(share);
            let now = seen(size);
            if (now / asked - 1.0).abs() < 0.005 {
                return Ok(Act { mechanism, size });
            }
            if now < asked { (low, at_low) = (size, now) } else { (high, at_high) = (size, now) }
        }
        Err(SizeError::NotSettled { cause, asked })
    }
}

/// Last pivot of a positive semi-definite matrix under elimination.
fn last_pivot(mut matrix: Vec<Vec<f64>>) -> f64 {
    let n = matrix.len();
    for k in 0..n - 1 {
        let pivot = matrix[k].clone();
        for row in matrix.iter_mut().skip(k + 1) {
            let share = if pivot[k] > 0.0 { row[k] / pivot[k] } else { 0.0 };
            row.iter_mut().zip(&pivot).for_each(|(entry, above)| *entry -= share * above);
        }
    }
    matrix[n - 1][n - 1]
}
