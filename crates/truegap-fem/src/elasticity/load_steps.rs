//! Equilibria under load: linear ones at once, others in load steps that are cut where Newton's method fails.

use super::error::ElasticityError;
use super::newton::NewtonOptions;
use super::solution::Solution;
use super::solver::Solver;
use super::vector::add;

impl Solver {
    /// Equilibrium under the whole load (factor 1).
    pub fn solve(&mut self) -> Result<Solution, ElasticityError> {
        self.advance(1.0, &NewtonOptions::default())
    }

    /// Equilibrium at a load factor, reached from the last one in as many steps as it takes.
    ///
    /// # Errors
    /// `NotConverged` where load steps shrink below the least; the solver then stays at the last equilibrium. Rubber
    /// bonded at a sharp rim ends so when its bulging side would fold through the plate (a disc of shape factor 0.7 at
    /// 11 % with elements of h / 100 at the rim): give the side obstacles at the plates.
    pub fn advance(&mut self, target: f64, options: &NewtonOptions) -> Result<Solution, ElasticityError> {
        if self.linear {
            self.solve_linear(target)?;
            return Ok(self.solution());
        }
        let way = target - self.load;
        let mut step = options.first_step;
        let mut done = 0.0;
        while done < 1.0 {
            let next = (done + step).min(1.0);
            let (start, from, held) = (self.state.clone(), self.load, self.multipliers.clone());
            let to = if next == 1.0 { target } else { target - way * (1.0 - next) };
            self.load = to;
            match self.newton(to, options) {
                Ok(iterations) => {
                    done = next;
                    self.counters.steps += 1;
                    if iterations < 8 {
                        step *= 1.5;
                    }
                }
                Err(error) => {
                    self.state = start;
                    self.load = from;
                    self.multipliers = held;
                    self.counters.cuts += 1;
                    step *= 0.5;
                    if step < options.least_step {
                        return Err(match error {
                            ElasticityError::NotConverged { correction, advice, .. } => {
                                ElasticityError::NotConverged { reached: from, wanted: to, correction, advice }
                            }
                            other => other,
                        });
                    }
                }
            }
        }
        Ok(self.solution())
    }

    fn solve_linear(&mut self, load: f64) -> Result<(), ElasticityError> {
        const ALLOWED: f64 = 1e-7;
        if self.direct.is_none() {
            self.factorise(load)?;
        }
        self.load = load;
        self.prescribe(load);
        let mut last = f64::INFINITY;
        for _ in 0..8 {
            let residual = self.residual(&self.state, load);
            let step = self.descend(&residual);
            add(&mut self.state, &step, 1.0);
            let correction = self.relative(&step);
            let converged = correction < 1e-14 || (correction < 1e-9 && correction > 0.3 * last);
            last = correction;
            if converged {
                break;
            }
        }
        self.correction = last;
        if !(last < ALLOWED) {
            return Err(ElasticityError::IllConditioned { correction: last });
        }
        Ok(())
    }
}
