//! Draws what a recording of the bank conceals, and simulates it.
//!
//! Limits: sizes are drawn by detectability; an effect that cannot reach it within three prior standard deviations is as large as that.

use crate::{
    data::problem::Problem,
    effects::effect::Effect,
    fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit, model::Model, optimum::Fit},
    seeds::SEEDS,
    selection::{candidates::Search, detectability::left_over, start::zero_size},
    validation::recovery::case::Truth,
    validation::tuning::{BELIEVABLE, CONCEALED_DETECTABILITY, MOST_DRAWS, SIZE_FOUND, STILL_SEEN},
    whitening::whitener::Whitener,
};
use rand::{RngExt, SeedableRng, seq::IndexedRandom};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use truegap_core::Stage;

/// Makes recordings of the bank.
pub(crate) struct Maker<'a> {
    pub(crate) search: &'a Search<'a>,
    /// inputs and simulator, with a blank response
    pub(crate) template: &'a Problem<'a>,
    pub(crate) whitener: &'a Whitener,
    /// effects that get a larger share
    pub(crate) likely: &'a [usize],
}

enum Kind {
    Nothing,
    Effects { which: Vec<usize>, sibling: bool },
    Unmodelled,
}

impl Maker<'_> {
    /// Recording number `index`: what it conceals, and its response; `None` where no sensor drawn has an answer.
    pub(crate) fn make(&self, index: usize) -> Option<(Truth, Vec<f64>)> {
        let random = &mut ChaCha8Rng::seed_from_u64(SEEDS.bank + index as u64);
        let kind = self.kind(index, random);
        (0..MOST_DRAWS).find_map(|_| self.draw(&kind, random))
    }

    /// A third nothing; of the rest, of every ten: six single effects (half of them in sibling equations), three pairs, one unmodelled cause.
    fn kind(&self, index: usize, random: &mut ChaCha8Rng) -> Kind {
        if index.is_multiple_of(3) || self.search.library.is_empty() {
            return Kind::Nothing;
        }
        let place = (index - index / 3 - 1) % 10;
        match place {
            0..6 => Kind::Effects { which: vec![self.one(random)], sibling: place % 2 == 1 },
            6..9 => {
                let first = self.one(random);
                let family = self.search.library[first].family();
                let others: Vec<usize> =
                    (0..self.search.library.len()).filter(|e| self.search.library[*e].family() != family).collect();
                let second = others.choose(random).copied();
                Kind::Effects { which: std::iter::once(first).chain(second).collect(), sibling: false }
            }
            _ => Kind::Unmodelled,
        }
    }

    fn one(&self, random: &mut ChaCha8Rng) -> usize {
        let all: Vec<usize> = (0..self.search.library.len()).collect();
        let pool = if random.random::<bool>() && !self.likely.is_empty() { self.likely } else { &all };
        pool.choose(random).copied().unwrap_or(0)
    }

    fn draw(&self, kind: &Kind, random: &mut ChaCha8Rng) -> Option<(Truth, Vec<f64>)> {
        let base = Model::new(self.template, self.search.context, Vec::new());
        let sensor = within(&base.bounds(), (0..base.base_count()).map(|_| StandardNormal.sample(random)).collect());
        let clean = base.respond(&sensor).ok()?;
        let wanted = (CONCEALED_DETECTABILITY.0.ln()
            + random.random::<f64>() * (CONCEALED_DETECTABILITY.1 / CONCEALED_DETECTABILITY.0).ln())
        .exp();
        let at = self.calibrated(&base, &sensor, &clean)?;
        let (truth, mut response) = match kind {
            Kind::Nothing => (Truth::default(), clean),
            Kind::Effects { which, sibling } => self.with_effects(which, *sibling, &sensor, (&clean, &at), wanted, random)?,
            Kind::Unmodelled => self.with_unmodelled((&clean, &at), wanted, random)?,
        };
        let mut noise: Vec<f64> = response.iter().map(|_| StandardNormal.sample(random)).collect();
        self.whitener.colour(&mut noise);
        response.iter_mut().zip(&noise).for_each(|(r, n)| *r += n);
        Some((truth, response))
    }

    /// The base model at the sensor drawn: its derivatives say what calibration can absorb.
    fn calibrated(&self, base: &Model<'_>, sensor: &[f64], clean: &[f64]) -> Option<Fit> {
        let problem = Problem { inputs: self.template.inputs, response: clean, simulator: self.template.simulator };
        let model = Model::new(&problem, base.context, Vec::new());
        fit(&model, self.whitener, sensor, &FitOptions { iterations: 0, tolerance: 0.0 }).ok()
    }

    fn with_effects(
        &self,
        which: &[usize],
        sibling: bool,
        sensor: &[f64],
        (clean, at): (&[f64], &Fit),
        wanted: f64,
        random: &mut ChaCha8Rng,
    ) -> Option<(Truth, Vec<f64>)> {
        let each = wanted / (which.len() as f64).sqrt();
        let mut sized = Vec::new();
        for index in which {
            let effect = self.search.library[*index];
            let shape: Vec<f64> = (1..effect.parameters(self.search.context).len())
                .map(|_| {
                    let z: f64 = StandardNormal.sample(random);
                    z.clamp(-2.0, 2.0)
                })
                .collect();
            let sign = if random.random::<bool>() { 1.0 } else { -1.0 };
            let one = One { maker: self, effect, sibling, shape, sensor };
            sized.push((one.sized(sign, each, clean, at).or_else(|| one.sized(-sign, each, clean, at))?, one));
        }
        let stages: Vec<Box<dyn Stage>> = sized.iter().filter_map(|(size, one)| one.stage(*size)).collect();
        if stages.len() < which.len() {
            return None;
        }
        let response = self.respond(sensor, &stages)?;
        let truth = Truth {
            effects: which.iter().map(|e| self.search.library[*e].id().to_string()).collect(),
            sibling: sibling && sized.iter().all(|(size, one)| one.sibling_stage(*size).is_some()),
            unmodelled: None,
            detectability: self.seen(clean, &response, at),
        };
        (truth.detectability > STILL_SEEN * CONCEALED_DETECTABILITY.0).then_some((truth, response))
    }

    fn respond(&self, sensor: &[f64], stages: &[Box<dyn Stage>]) -> Option<Vec<f64>> {
        let base = Model::new(self.template, self.search.context, Vec::new());
        let borrowed: Vec<&dyn Stage> = stages.iter().map(AsRef::as_ref).collect();
        self.template.simulator.respond(&base.values(sensor), self.template.inputs, &borrowed).ok()
    }

    /// What calibration leaves of a change of the response, in units of the noise.
    fn seen(&self, clean: &[f64], response: &[f64], at: &Fit) -> f64 {
        let mut change: Vec<f64> = response.iter().zip(clean).map(|(a, b)| a - b).collect();
        self.whitener.apply(&mut change);
        left_over(at, &(0..at.z.len()).collect::<Vec<_>>(), &change).sqrt()
    }

    /// A tone of random period, a random walk, or a tone that the load modulates: nothing of the kind is in the library.
    fn with_unmodelled(&self, (clean, at): (&[f64], &Fit), wanted: f64, random: &mut ChaCha8Rng) -> Option<(Truth, Vec<f64>)> {
        let rows = clean.len();
        let name = *["tone", "random walk", "tone with load"].choose(random)?;
        let period = (5f64.ln() + random.random::<f64>() * (rows as f64 / 15.0).max(1.5).ln()).exp();
        let phase: f64 = random.random::<f64>() * std::f64::consts::TAU;
        let tone = |row: usize| (std::f64::consts::TAU * row as f64 / period + phase).sin();
        let load = self.template.simulator.load(self.template.inputs);
        let mut walk = 0.0;
        let column: Vec<f64> = (0..rows)
            .map(|row| match name {
                "tone" => tone(row),
                "random walk" => {
                    let step: f64 = StandardNormal.sample(random);
                    walk += step;
                    walk
                }
                _ => tone(row) * load.as_ref().map_or(1.0, |l| l[row]),
            })
            .collect();
        let shifted = |size: f64| clean.iter().zip(&column).map(|(c, s)| c + size * s).collect::<Vec<f64>>();
        let unit = self.seen(clean, &shifted(1.0), at);
        let response = shifted(wanted / unit);
        let truth = Truth { unmodelled: Some(name.into()), detectability: wanted, ..Truth::default() };
        (unit > 0.0 && unit.is_finite()).then_some((truth, response))
    }
}

/// Coordinates moved inside their bounds.
fn within(bounds: &[(f64, f64)], z: Vec<f64>) -> Vec<f64> {
    z.into_iter().zip(bounds).map(|(z, b): (f64, _)| z.clamp(b.0, b.1)).collect()
}

/// One effect on its way to a size.
struct One<'a> {
    maker: &'a Maker<'a>,
    effect: &'a dyn Effect,
    sibling: bool,
    shape: Vec<f64>,
    sensor: &'a [f64],
}

impl One<'_> {
    /// Size, in prior standard deviations from none, at which the effect is seen as wanted or at the end of what is believable; `None` where a bound
    /// forbids the sign, or the simulator has no answer.
    fn sized(&self, sign: f64, wanted: f64, clean: &[f64], at: &Fit) -> Option<f64> {
        let model = Model::new(self.maker.template, self.maker.search.context, vec![self.effect]);
        let bounds = model.bounds()[model.first_of(0)];
        let zero = zero_size(&model, 0);
        if self.effect.foreseen() {
            return Some(-zero);
        }
        let end = (zero + sign * BELIEVABLE).clamp(bounds.0, bounds.1) - zero;
        if end == 0.0 {
            return None;
        }
        let seen = |size: f64| Some(self.maker.seen(clean, &self.maker.respond(self.sensor, &[self.stage(size)?])?, at));
        let mut size = 0.02 * end;
        for _ in 0..6 {
            let now = seen(size)?;
            if now <= 0.0 || !now.is_finite() {
                return None;
            }
            let ratio = (wanted / now).clamp(0.1, 10.0);
            let next = if sign * size * ratio > sign * end { end } else { size * ratio };
            if (next - size).abs() < SIZE_FOUND * size.abs() {
                return Some(next);
            }
            size = next;
        }
        Some(size)
    }

    fn values(&self, size: f64) -> Vec<f64> {
        let model = Model::new(self.maker.template, self.maker.search.context, vec![self.effect]);
        let first = model.first_of(0);
        let mut z = vec![0.0; first];
        z.push(zero_size(&model, 0) + size);
        z.extend_from_slice(&self.shape);
        let z = within(&model.bounds(), z);
        model.values(&z)[model.range_of(0)].to_vec()
    }

    fn sibling_stage(&self, size: f64) -> Option<Box<dyn Stage>> {
        self.effect.sibling(&self.values(size), self.maker.search.context)
    }

    fn stage(&self, size: f64) -> Option<Box<dyn Stage>> {
        let own = || self.effect.with(&self.values(size), self.maker.search.context);
        Some(if self.sibling { self.sibling_stage(size).unwrap_or_else(own) } else { own() })
    }
}
