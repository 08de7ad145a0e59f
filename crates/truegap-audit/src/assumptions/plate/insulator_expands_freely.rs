//! `INSULATOR-EXPANDS-FREELY`: a film bonded to metal cannot spread by itself, so its thickness takes what is left.
//!
//! Limits: small strain; the film on the shield is taken to behave like the one behind the electrode.

use crate::disc::{Disc, Fineness, Laminate, Loading, Sheet, Strains, refined};
use crate::{
    assumption::Assumption,
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_fem::elasticity::{Component, Condition, Place, Solver};
use truegap_fem::mesh::Point;

/// The insulator thickens with temperature as if it were free.
pub(super) struct InsulatorExpandsFreely;

impl Assumption for InsulatorExpandsFreely {
    fn id(&self) -> &'static str {
        "INSULATOR-EXPANDS-FREELY"
    }

    fn says(&self) -> &'static str {
        "the insulator's thickness grows by its own expansion, although it is bonded to metal that grows less"
    }

    fn source(&self) -> &'static str {
        "(3) for the insulator against finite elements of the insulator bonded to flat metal, far from the rim"
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let film = &study.sensor.insulator;
        let (own, nu) = (film.material.expansion, film.material.poisson);
        let metal = study.sensor.conductor.material.expansion;
        let radius = 0.5 * study.sensor.diameter.value;
        let fem =
            refined(|fineness| growth(Laminate { sheets: vec![Sheet::of("film", film)], radius }, metal, fineness), |g| 1e6 * g)?;
        let growth = fem.result;
        let mut finding = Measured {
            unit: "ppm/K",
            analytic: 1e6 * own,
            fem: fem.value,
            error_estimate: fem.error,
            measure: Measure {
                name: "2 nu / (1 - nu) |own - metal's expansion| / own".into(),
                value: 2.0 * nu / (1.0 - nu) * (1.0 - metal / own).abs(),
                limit: 0.02,
            },
            effect_on: study.effect(Swap::none().warm(move |warm| {
                warm.layers.insulator *= (1.0 + growth * warm.kelvin) / (1.0 + own * warm.kelvin);
                Ok(())
            }))?,
            figure: None,
        }
        .finding(self);
        let bonded = own + 2.0 * nu / (1.0 - nu) * (own - metal);
        finding.reason += &format!("; in plane stress by hand: {:.2} ppm/K", 1e6 * bonded);
        Ok(finding)
    }
}

/// Growth of a film's thickness per kelvin on flat metal that grows by `metal` (1/K), half-way to the rim.
fn growth(film: Laminate, metal: f64, fineness: Fineness) -> Result<f64, AuditError> {
    let named = || AuditError::fem("heated insulator");
    let disc = Disc::free(film, Strains::Small, fineness)?;
    let mut problem = disc.problem(1.0, &Loading::None, &[]);
    let carried =
        |at: Point| Condition::Displacement { place: Place::Point(at), component: Component::First, value: metal * at[0] };
    problem.conditions = disc.section.level(0.0).into_iter().filter(|p| p[0] > 0.0).map(carried).collect();
    problem.conditions.push(Condition::fix("bottom", Component::Second));
    let solution = Solver::new(problem).and_then(|mut solver| solver.solve()).map_err(named())?;
    let top = disc.section.top;
    Ok(solution.displacement_at([0.5 * disc.plate.radius, top]).map_err(named())?[1] / top)
}
