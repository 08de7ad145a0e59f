//! The disc as an elastic problem: materials, supports, heat and load.
//!
//! Beads answer linearly with the modulus of [`BeadSpring`] and do not spread, or are rings of neo-Hookean rubber that do; metals and insulator bend by
//! small or large rotations. Air that is kept is a solid too soft to matter, so that it moves along.

use super::{
    bead_spring::BeadSpring,
    fineness::Fineness,
    laminate::{Laminate, Sheet},
    profile::Profile,
    rings::Gap,
    section::Section,
    submesh::part,
};
use crate::error::AuditError;
use truegap_fem::Symmetry;
use truegap_fem::elasticity::{
    Component, Condition, Formulation, LawKind, Material, Order, Place, Problem, Solution, Solver, Temperature,
};
use truegap_fem::mesh::{Mesh, Point};

/// Which rotations are taken into account.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strains {
    /// small ones: the plate theory that (9) belongs to
    Small,
    /// large ones: bending stretches the disc
    Large,
}

/// What presses on the disc.
#[derive(Clone, Debug, PartialEq)]
pub enum Loading {
    /// nothing
    None,
    /// a force (N) spread evenly, as by a fluid or a fingertip
    Even(f64),
    /// a rigid flat plate without friction
    Plate {
        /// how far it went down (m) from where it first touched the flat disc
        travel: f64,
        /// nodes of the top that it touches (m)
        touched: Vec<Point>,
    },
}

/// What the rings are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rings {
    /// springs with the modulus of [`BeadSpring`]
    Springs,
    /// nearly incompressible rubber that bulges
    Rubber {
        /// Young's modulus, Pa
        young: f64,
        /// Poisson's ratio
        poisson: f64,
    },
}

/// The insulator below the gap and what carries it.
#[derive(Clone, Debug, PartialEq)]
pub struct Facing {
    /// insulator
    pub sheet: Sheet,
    /// expansion of the shield that it is bonded to, 1/K: flat, and free to grow on what carries the sensor
    pub shield_expansion: f64,
}

/// Modulus of air, Pa: a millionth of the beads', so that it moves along and carries nothing.
const AIR: f64 = 1.0;

/// A disc to be solved.
#[derive(Clone, Debug)]
pub struct Disc {
    /// electrode and what is bonded to it
    pub plate: Laminate,
    /// its mesh
    pub section: Section,
    /// beads below; `None` for a free plate
    pub beads: Option<BeadSpring>,
    /// what rings are made of
    pub rings: Rings,
    /// insulator below the gap, on a shield
    pub facing: Option<Facing>,
    /// whether the air between the rings is part of the body
    pub air: bool,
    /// rotations
    pub strains: Strains,
}

impl Disc {
    /// A plate that nothing holds.
    ///
    /// # Errors
    /// A layer without thickness.
    pub fn free(plate: Laminate, strains: Strains, fineness: Fineness) -> Result<Self, AuditError> {
        let section = Section::new(&plate, &Gap::None, None, fineness)?;
        Ok(Self { plate, section, beads: None, rings: Rings::Springs, facing: None, air: false, strains })
    }

    /// A plate on a layer that stands for the beads.
    ///
    /// # Errors
    /// A layer without thickness.
    pub fn on_layer(plate: Laminate, beads: BeadSpring, strains: Strains, fineness: Fineness) -> Result<Self, AuditError> {
        let section = Section::new(&plate, &Gap::Layer(beads.height), None, fineness)?;
        Ok(Self { plate, section, beads: Some(beads), rings: Rings::Springs, facing: None, air: false, strains })
    }

    /// A plate on `zones` rings of beads.
    ///
    /// # Errors
    /// A layer without thickness.
    pub fn on_rings(
        plate: Laminate,
        beads: BeadSpring,
        zones: usize,
        strains: Strains,
        fineness: Fineness,
    ) -> Result<Self, AuditError> {
        let gap = Gap::Rings { height: beads.height, coverage: beads.coverage, zones };
        let section = Section::new(&plate, &gap, None, fineness)?;
        Ok(Self { plate, section, beads: Some(beads), rings: Rings::Springs, facing: None, air: false, strains })
    }

    /// The elastic problem with the rings that `attached` tells (all of them where there are none to tell apart).
    pub(crate) fn problem(&self, kelvin: f64, loading: &Loading, attached: &[bool]) -> Problem {
        let bodies = |name: &str| match name.strip_prefix("ring ") {
            Some(number) => number.parse().ok().and_then(|j: usize| attached.get(j - 1)).copied().unwrap_or(true),
            None => self.air || name != "air",
        };
        let mesh = part(&self.section.mesh, bodies).mesh;
        let materials = mesh.region_names.iter().map(|name| self.material(name)).collect();
        let mut conditions = match &self.beads {
            None => vec![Condition::pin([0.0, 0.0], Component::Second)],
            Some(_) => vec![Condition::fix("bottom", Component::Second)],
        };
        match (&self.beads, &self.facing) {
            (Some(_), Some(facing)) => conditions.extend(self.grown(facing.shield_expansion * kelvin)),
            (Some(_), None) => conditions.push(Condition::fix("bottom", Component::First)),
            (None, _) => {}
        }
        conditions.extend(self.load(loading, &mesh));
        Problem {
            mesh,
            symmetry: Symmetry::Axisymmetric,
            materials,
            conditions,
            temperature: Temperature::uniform(kelvin),
            body_force: None,
            order: Order::Quadratic,
        }
    }

    /// Equilibrium with the rings that `attached` tells.
    ///
    /// # Errors
    /// Where Newton's method finds none.
    pub fn solve(&self, kelvin: f64, loading: &Loading, attached: &[bool]) -> Result<Solution, AuditError> {
        let mut solver = Solver::new(self.problem(kelvin, loading, attached)).map_err(AuditError::fem("heated disc"))?;
        solver.solve().map_err(AuditError::fem("heated disc"))
    }

    /// Shape of the electrode's face.
    ///
    /// # Errors
    /// A section without a face, which the meshes here do not have.
    pub fn profile(&self, bent: &Solution) -> Result<Profile, AuditError> {
        Profile::of_face(bent)
    }

    fn load(&self, loading: &Loading, mesh: &Mesh) -> Vec<Condition> {
        match loading {
            Loading::None => Vec::new(),
            Loading::Even(force) => {
                let radius = mesh.points.iter().map(|p| p[0]).fold(0.0, f64::max);
                // The force is what is given, and it stays along the axis.
                vec![Condition::dead_pressure("top", force / (std::f64::consts::PI * radius * radius))]
            }
            Loading::Plate { travel, touched } => {
                let held = |&at: &Point| Condition::Displacement {
                    place: Place::Point(at),
                    component: Component::Second,
                    value: -travel,
                };
                touched.iter().map(held).collect()
            }
        }
    }

    /// Radial displacements of the bottom that grows by a strain.
    fn grown(&self, strain: f64) -> Vec<Condition> {
        let level = self.section.level(0.0);
        // The axis is held by symmetry.
        let moved =
            |at: Point| Condition::Displacement { place: Place::Point(at), component: Component::First, value: strain * at[0] };
        level.into_iter().filter(|p| p[0] > 0.0).map(moved).collect()
    }

    fn material(&self, region: &str) -> Material {
        let law = match self.strains {
            Strains::Small => LawKind::Linear,
            Strains::Large => LawKind::SaintVenantKirchhoff,
        };
        if region == "air" {
            return Material {
                young: AIR,
                poisson: 0.0,
                expansion: 0.0,
                law: LawKind::Linear,
                formulation: Formulation::Displacement,
            };
        }
        if let Some(s) = self.plate.sheets.iter().chain(self.facing.as_ref().map(|f| &f.sheet)).find(|s| s.name == region) {
            let (young, poisson, expansion) = (s.young, s.poisson, s.expansion);
            return Material { young, poisson, expansion, law, formulation: Formulation::suited(poisson) };
        }
        // Bead material: what is neither sheet nor ring is the layer that stands for all beads.
        let (young, coverage, expansion) = self.beads.map_or((f64::NAN, 1.0, 0.0), |b| (b.young, b.coverage, b.expansion));
        let ring = region.starts_with("ring ");
        if let (Rings::Rubber { young, poisson }, true) = (self.rings, ring) {
            let formulation = Formulation::suited(poisson);
            return Material { young, poisson, expansion, law: LawKind::NeoHookean, formulation };
        }
        let share = if ring { 1.0 } else { coverage };
        Material { young: share * young, poisson: 0.0, expansion, law: LawKind::Linear, formulation: Formulation::Displacement }
    }
}
