//! The open field at the rim of flat layers of one radius: shield, insulator, electrode, insulator, beads, shield.
//!
//! Limits: beads and air as one medium; shields end where the electrode ends.

use super::heat::Estimated;
use crate::error::AuditError;
use truegap_core::VACUUM_PERMITTIVITY;
use truegap_fem::{
    FemError, Symmetry,
    electrostatics::{Accuracy, Conductor, Goal, Problem, Quantity, solve_adaptive},
    mesh::{Geometry, MeshOptions, Outline, SizeField, SizeSource, mesh_geometry},
};

/// Flat layers, from the lower shield upwards, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layered {
    /// radius of all of them
    pub radius: f64,
    /// insulator between lower shield and electrode; without one there is no lower shield
    pub backing: Option<f64>,
    /// electrode; 0 for one without thickness
    pub electrode: f64,
    /// insulator on the electrode
    pub film: f64,
    /// beads and air
    pub beads: f64,
    /// permittivity of both insulators, F/m
    pub film_permittivity: f64,
    /// permittivity of beads and air, F/m
    pub bead_permittivity: f64,
}

impl Layered {
    /// Capacitance of the parallel plates, F.
    pub(crate) fn plates(&self) -> f64 {
        let area = std::f64::consts::PI * self.radius * self.radius;
        let main = area / (self.beads / self.bead_permittivity + self.film / self.film_permittivity);
        main + self.backing.map_or(0.0, |thickness| self.film_permittivity * area / thickness)
    }

    /// Capacitance that the open field adds to the plates, F.
    ///
    /// **Accuracy:** against Love's equation in `the_rim_of_two_discs_is_that_of_love`.
    ///
    /// # Errors
    /// [`AuditError::Fem`] where the relative target is not reached.
    pub fn rim(&self, target: f64) -> Result<Estimated, AuditError> {
        let whole = self.solve(target).map_err(AuditError::fem("field at the rim"))?;
        Ok(Estimated { value: whole.value - self.plates(), ..whole })
    }

    /// Charge on the electrode per volt: against grounded shields, or against the other plate.
    fn solve(&self, target: f64) -> Result<Estimated, FemError> {
        let r = self.radius;
        let heights = [0.0, self.electrode, self.electrode + self.film, self.electrode + self.film + self.beads];
        let mut sources = heights.map(|z| SizeSource { at: [r, z], size: 0.1 * self.film }).to_vec();
        let layer = |low: f64, high: f64| Outline::rectangle([0.0, low], [r, high]);
        let far = 2.0 * r;
        let mut drawing = Geometry::default()
            .region("space", Outline::rectangle([0.0, -far], [far, far]))
            .region("film", layer(heights[1], heights[2]))
            .region("beads", layer(heights[2], heights[3]))
            .boundary("upper", &[[0.0, heights[3]], [r, heights[3]]])
            .boundary("far", &[[0.0, -far], [far, -far], [far, far], [0.0, far]]);
        let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
        // shields are at ground like infinity; two plates alone are measured against each other
        let potentials = if self.backing.is_some() { [1.0, 0.0] } else { [0.5, -0.5] };
        let mut conductors = vec![conductor("electrode", potentials[0]), conductor("upper", potentials[1])];
        let regions = [("space", VACUUM_PERMITTIVITY), ("film", self.film_permittivity), ("beads", self.bead_permittivity)];
        let mut permittivity: Vec<(String, f64)> = regions.map(|(name, value)| (name.to_owned(), value)).to_vec();
        if self.electrode > 0.0 {
            drawing = drawing.region("electrode", layer(heights[0], heights[1])).boundary_of("electrode", "electrode");
            permittivity.push(("electrode".into(), VACUUM_PERMITTIVITY));
        } else {
            drawing = drawing.boundary("electrode", &[[0.0, 0.0], [r, 0.0]]);
        }
        if let Some(backing) = self.backing {
            drawing = drawing.region("backing", layer(-backing, 0.0)).boundary("lower", &[[0.0, -backing], [r, -backing]]);
            conductors.push(conductor("lower", 0.0));
            permittivity.push(("backing".into(), self.film_permittivity));
            sources.push(SizeSource { at: [r, -backing], size: 0.1 * backing });
        }
        let size = SizeField { max_edge: 0.3 * r, growth: 0.35, sources };
        let mut mesh = mesh_geometry(&drawing, &MeshOptions { size, ..MeshOptions::default() })?;
        let problem = Problem { symmetry: Symmetry::Axisymmetric, permittivity, conductors, open: vec!["far".into()] };
        let goal = Quantity { name: "C".into(), goal: Goal::Capacitance { boundary: "electrode".into() } };
        let accuracy = Accuracy { target, max_unknowns: 400_000, ..Accuracy::default() };
        let answer = solve_adaptive(&problem, &[goal], &mut mesh, &accuracy)?.answers[0].clone();
        Ok(Estimated { value: answer.value, error_estimate: answer.error_estimate })
    }
}
