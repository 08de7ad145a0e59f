//! A base model with effects plugged in, as a function of coordinates in units of the prior's standard deviations.
//!
//! Limits: derivatives are difference quotients, of the base model's physics to first order where it offers that.

use crate::{
    data::{context::Context, problem::Problem},
    effects::effect::Effect,
    fit::prior::Prior,
    fit::remembered::Remembered,
    fit::tuning::DIFFERENCE_STEP,
    whitening::whitener::Whitener,
};
use nalgebra::DMatrix;
use rayon::prelude::*;
use truegap_core::{Beside, Parameter, SimulationError, Stage};

/// A base model with effects plugged in, as a function of prior-whitened coordinates z.
pub struct Model<'a> {
    /// recording and simulator
    pub problem: &'a Problem<'a>,
    /// effects, each with the number of its parameters
    pub effects: Vec<&'a dyn Effect>,
    /// base parameters, then those of each effect
    pub parameters: Vec<Parameter>,
    /// facts for the effects
    pub context: &'a Context<'a>,
    counts: Vec<usize>,
    base: usize,
    /// whether a parameter is held at 0, where its derivative is never asked for: what is known of it is all
    held: Vec<bool>,
}

impl<'a> Model<'a> {
    /// The base model with these effects.
    pub fn new(problem: &'a Problem<'a>, context: &'a Context<'a>, effects: Vec<&'a dyn Effect>) -> Self {
        let mut parameters = problem.simulator.parameters().to_vec();
        let base = parameters.len();
        let (mut counts, mut held) = (Vec::new(), vec![false; base]);
        for effect in &effects {
            let own = effect.parameters(context);
            held.extend(own.iter().map(|p| context.holds(effect.id(), &p.name)));
            let own: Vec<Parameter> = own.into_iter().map(|p| context.known(effect.id(), p)).collect();
            counts.push(own.len());
            parameters.extend(own);
        }
        Self { problem, effects, parameters, context, counts, base, held }
    }

    /// Number of base parameters.
    pub fn base_count(&self) -> usize {
        self.base
    }

    /// Index of the first parameter of effect `index`.
    pub fn first_of(&self, index: usize) -> usize {
        self.base + self.counts[..index].iter().sum::<usize>()
    }

    /// Parameter range of effect `index`.
    pub fn range_of(&self, index: usize) -> std::ops::Range<usize> {
        let first = self.first_of(index);
        first..first + self.counts[index]
    }

    /// Which of the parameters are of a kind of their own.
    pub(crate) fn kinds(&self) -> Kinds {
        let effects = || 0..self.effects.len();
        Kinds {
            open_sizes: effects().filter(|i| !self.effects[*i].foreseen()).map(|i| self.first_of(i)).collect(),
            known: self.base,
            free_form: effects().filter(|i| self.effects[*i].free_form()).map(|i| self.range_of(i)).collect(),
        }
    }

    /// What is known of the parameters beforehand, at `z`.
    pub(crate) fn prior(&self, z: &[f64]) -> Prior {
        Prior::at(z, self.base)
    }

    /// Values in the parameters' units.
    pub fn values(&self, z: &[f64]) -> Vec<f64> {
        self.parameters.iter().zip(z).map(|(p, z)| p.prior.at(*z)).collect()
    }

    /// Bounds in z.
    pub fn bounds(&self) -> Vec<(f64, f64)> {
        let to_z = |p: &Parameter, v: f64| if v.is_finite() { p.prior.z(v) } else { v };
        self.parameters.iter().map(|p| (to_z(p, p.bounds.0), to_z(p, p.bounds.1))).collect()
    }

    /// The stages at `z`.
    pub fn stages(&self, z: &[f64]) -> Vec<Box<dyn Stage>> {
        let values = self.values(z);
        self.effects.iter().enumerate().map(|(i, e)| e.with(&values[self.range_of(i)], self.context)).collect()
    }

    /// Response of every row.
    ///
    /// # Errors
    /// Those of the simulator.
    pub fn respond(&self, z: &[f64]) -> Result<Vec<f64>, SimulationError> {
        self.respond_through(&self.stages(z), z)
    }

    fn respond_through(&self, stages: &[Box<dyn Stage>], z: &[f64]) -> Result<Vec<f64>, SimulationError> {
        let borrowed: Vec<&dyn Stage> = stages.iter().map(AsRef::as_ref).collect();
        let values = self.values(&z[..self.base]);
        self.problem.simulator.respond(&values[..self.base], self.problem.inputs, &borrowed)
    }

    /// What it leaves over: recorded less simulated.
    ///
    /// # Errors
    /// Those of the simulator.
    pub fn misfit(&self, z: &[f64]) -> Result<Vec<f64>, SimulationError> {
        Ok(self.left_by(self.respond(z)?))
    }

    /// Recorded less this response.
    fn left_by(&self, mut response: Vec<f64>) -> Vec<f64> {
        response.iter_mut().zip(self.problem.response).for_each(|(r, y)| *r = y - *r);
        response
    }

    /// The same, whitened.
    ///
    /// # Errors
    /// Those of the simulator.
    pub fn residual(&self, z: &[f64], whitener: &Whitener) -> Result<Vec<f64>, SimulationError> {
        let mut r = self.misfit(z)?;
        whitener.apply(&mut r);
        Ok(r)
    }

    /// The same with other stages in place of the effects' own.
    ///
    /// # Errors
    /// Those of the simulator.
    pub(crate) fn residual_through(
        &self,
        stages: &[Box<dyn Stage>],
        z: &[f64],
        whitener: &Whitener,
    ) -> Result<Vec<f64>, SimulationError> {
        let mut r = self.left_by(self.respond_through(stages, z)?);
        whitener.apply(&mut r);
        Ok(r)
    }

    /// Whitened change of the response per unit of z, for the columns asked, as an n x p matrix.
    ///
    /// # Errors
    /// Those of the simulator.
    pub fn jacobian(&self, z: &[f64], at: &[f64], whitener: &Whitener) -> Result<DMatrix<f64>, SimulationError> {
        let mut jacobian = DMatrix::zeros(at.len(), z.len());
        self.refresh(&mut jacobian, 0..z.len(), z, at, whitener, &self.bounds())?;
        Ok(jacobian)
    }

    /// Computes these columns of a Jacobian anew; a parameter held between equal bounds has none.
    pub(crate) fn refresh(
        &self,
        jacobian: &mut DMatrix<f64>,
        columns: std::ops::Range<usize>,
        z: &[f64],
        at: &[f64],
        whitener: &Whitener,
        bounds: &[(f64, f64)],
    ) -> Result<(), SimulationError> {
        let (free, near) = self.near(columns, z, bounds);
        let of = |group: &[usize]| {
            let moved = group.iter().map(|i| near.moved(*i, bounds[*i])).collect::<Result<Vec<_>, _>>()?;
            Ok(whitened(moved, whitener))
        };
        let groups: Vec<Vec<Stepped>> = free.par_chunks(ABREAST).map(of).collect::<Result<_, SimulationError>>()?;
        groups.iter().flatten().for_each(|stepped| stepped.fill(jacobian, at));
        Ok(())
    }

    /// Which of these columns are free, and the model near `z`.
    fn near<'m>(&'m self, columns: std::ops::Range<usize>, z: &'m [f64], bounds: &[(f64, f64)]) -> (Vec<usize>, Near<'m, 'a>) {
        let free: Vec<usize> = columns.filter(|i| bounds[*i].0 < bounds[*i].1 && !self.held[*i]).collect();
        let near = Near::of(self, z, free.len() >= WORTH_SLOPES);
        (free, near)
    }

    /// What is left over at `z` and a step away from it along every coordinate, for as many noises as are to be tried from there.
    ///
    /// # Errors
    /// Those of the simulator.
    pub(crate) fn around(&self, z: &[f64]) -> Result<Around, SimulationError> {
        let bounds = self.bounds();
        let here = self.misfit(z)?;
        let (free, near) = self.near(0..z.len(), z, &bounds);
        let moved = free.par_iter().map(|i| near.moved(*i, bounds[*i])).collect::<Result<Vec<_>, _>>()?;
        Ok(Around { z: z.to_vec(), here, moved })
    }
}

/// A model at a point and a step away from it along every coordinate: what its derivatives are made of under any noise.
pub(crate) struct Around {
    pub(crate) z: Vec<f64>,
    here: Vec<f64>,
    moved: Vec<Stepped>,
}

impl Around {
    /// What is left over at the point, whitened, and the Jacobian there: as [`Model::residual`] and [`Model::jacobian`] have them, to the last bit.
    pub(crate) fn whitened(&self, whitener: &Whitener) -> (Vec<f64>, DMatrix<f64>) {
        let mut residual = self.here.clone();
        whitener.apply(&mut residual);
        let mut jacobian = DMatrix::zeros(residual.len(), self.z.len());
        for group in self.moved.chunks(ABREAST) {
            whitened(group.to_vec(), whitener).iter().for_each(|stepped| stepped.fill(&mut jacobian, &residual));
        }
        (residual, jacobian)
    }
}

/// What is left over a step away.
#[derive(Clone)]
struct Stepped {
    /// coordinate that has moved
    index: usize,
    left: Vec<f64>,
    /// one over the step
    scale: f64,
}

impl Stepped {
    /// Puts the difference of what was `at` the point over the step into the Jacobian; both are whitened.
    fn fill(&self, jacobian: &mut DMatrix<f64>, at: &[f64]) {
        let mut column = jacobian.column_mut(self.index);
        let both = self.left.iter().zip(at);
        column.iter_mut().zip(both).for_each(|(column, (there, here))| *column = (here - there) * self.scale);
    }
}

/// The same, whitened side by side.
fn whitened(moved: Vec<Stepped>, whitener: &Whitener) -> Vec<Stepped> {
    let (places, mut columns): (Vec<_>, Vec<_>) = moved.into_iter().map(|m| ((m.index, m.scale), m.left)).unzip();
    whitener.apply_each(&mut columns);
    places.into_iter().zip(columns).map(|((index, scale), left)| Stepped { index, left, scale }).collect()
}

/// Columns that are whitened side by side.
const ABREAST: usize = 4;

/// Columns from which the slopes of the base model are worth their cost, that of about two responses.
const WORTH_SLOPES: usize = 3;

/// A model near one point: its stages remember what they were asked there, and the base model answers to first order where it can.
struct Near<'m, 'a> {
    model: &'m Model<'a>,
    z: &'m [f64],
    stages: Vec<Box<dyn Stage>>,
    beside: Option<Box<dyn Beside + 'm>>,
}

impl<'m, 'a> Near<'m, 'a> {
    fn of(model: &'m Model<'a>, z: &'m [f64], slopes: bool) -> Self {
        let mut stages = model.stages(z);
        // each of several recordings has inputs of its own, and may have the same columns on another clock: nothing to remember
        if model.problem.simulator.joined().is_none() {
            stages = stages.into_iter().map(Remembered::boxed).collect();
        }
        let borrowed: Vec<&dyn Stage> = stages.iter().map(AsRef::as_ref).collect();
        let values = model.values(&z[..model.base]);
        let beside = || model.problem.simulator.beside(&values[..model.base], model.problem.inputs, &borrowed);
        // where a row has no answer at the point itself, there may be one a step away
        let beside = if slopes { beside().unwrap_or_default() } else { None };
        Self { model, z, stages, beside }
    }

    /// What is left over, not whitened, a step along coordinate `index`, and one over that step: away from the nearer bound, or where there is no answer
    /// the other way.
    fn moved(&self, index: usize, bound: (f64, f64)) -> Result<Stepped, SimulationError> {
        let mut moved = self.z.to_vec();
        let room = bound.1 - self.z[index];
        let mut step = if room > DIFFERENCE_STEP { DIFFERENCE_STEP } else { -DIFFERENCE_STEP };
        moved[index] = self.z[index] + step;
        let left = self.misfit(&moved, index).or_else(|_| {
            step = -step;
            moved[index] = (self.z[index] + step).max(bound.0);
            self.misfit(&moved, index)
        })?;
        Ok(Stepped { index, left, scale: (moved[index] - self.z[index]).recip() })
    }

    /// What is left over at a point that differs in coordinate `index` only.
    fn misfit(&self, moved: &[f64], index: usize) -> Result<Vec<f64>, SimulationError> {
        let fresh = self.fresh(moved, index);
        let stages: Vec<&dyn Stage> = match &fresh {
            Fresh::None => self.stages.iter().map(AsRef::as_ref).collect(),
            Fresh::One(own, stage) => {
                self.stages.iter().enumerate().map(|(i, kept)| if i == *own { stage.as_ref() } else { kept.as_ref() }).collect()
            }
            Fresh::All(stages) => stages.iter().map(AsRef::as_ref).collect(),
        };
        let Model { base, problem, .. } = self.model;
        let values = self.model.values(&moved[..*base]);
        let whole = || problem.simulator.respond(&values[..*base], problem.inputs, &stages);
        let response = match &self.beside {
            Some(beside) => beside.respond(&values[..*base], &stages).or_else(|_| whole())?,
            None => whole()?,
        };
        Ok(self.model.left_by(response))
    }

    /// The stages that are others where coordinate `index` has moved: that of one effect, or all where it moves the clock of the inputs, on which the others remember.
    fn fresh(&self, moved: &[f64], index: usize) -> Fresh {
        let Some(own) = (0..self.model.effects.len()).find(|i| self.model.range_of(*i).contains(&index)) else {
            return Fresh::None;
        };
        let values = self.model.values(moved);
        let stage = self.model.effects[own].with(&values[self.model.range_of(own)], self.model.context);
        // a stage of its own in each recording may shift any of them
        let shifts = |stage: &dyn Stage| stage.shifts() || stage.after_runs(0).is_some();
        if shifts(stage.as_ref()) || shifts(self.stages[own].as_ref()) {
            return Fresh::All(self.model.stages(moved));
        }
        Fresh::One(own, stage)
    }
}

/// Stages that differ from those at a point.
enum Fresh {
    /// none
    None,
    /// that of one effect
    One(usize, Box<dyn Stage>),
    /// all
    All(Vec<Box<dyn Stage>>),
}

/// Indices of the parameters of a model that are of a kind of their own.
#[derive(Default)]
pub(crate) struct Kinds {
    /// sizes whose order of magnitude is not known: of all effects that nobody has computed beforehand
    pub(crate) open_sizes: Vec<usize>,
    /// parameters of each effect without an equation: a size, and jumps in sizes
    pub(crate) free_form: Vec<std::ops::Range<usize>>,
    /// number of parameters of the base model, the first ones
    pub(crate) known: usize,
}
