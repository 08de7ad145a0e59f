//! From the text of a case file to a checked `Case`.

use super::description::{Case, Condition, Drive, Law, Material, MeshRequest, Method, Output, OutputKind, Physics, Plate};
use super::error::CaseError;
use super::geometry::geometry;
use super::raw::{RawBoundary, RawCase, RawMaterial, RawOutput, RawPlate, RawRadial};
use super::temperature::{RadialTerm, Temperature};
use super::units::{Dimension, parse_quantity, unit_factor};
use crate::elasticity::PressureLoad;
use crate::symmetry::Symmetry;
use std::collections::BTreeMap;
use truegap_limits::count;

const KINDS: &[(&str, OutputKind)] = &[
    ("capacitance", OutputKind::Capacitance),
    ("capacitance_matrix", OutputKind::CapacitanceMatrix),
    ("energy", OutputKind::Energy),
    ("reaction", OutputKind::Reaction),
    ("displacement", OutputKind::Displacement),
    ("stress", OutputKind::Stress),
    ("strain", OutputKind::Strain),
    ("contact_force", OutputKind::ContactForce),
    ("contact_radius", OutputKind::ContactRadius),
    ("peak_pressure", OutputKind::PeakPressure),
    ("plate_travel", OutputKind::PlateTravel),
    ("potential", OutputKind::Potential),
    ("field", OutputKind::Field),
];

/// Reads a case from text; `file` is its name in messages.
pub fn read_case(text: &str, file: &str) -> Result<Case, CaseError> {
    let raw: RawCase = toml::from_str(text).map_err(|e| CaseError::Syntax { file: file.into(), message: e.to_string() })?;
    Reader { file, raw: &raw }.case()
}

/// Most corners of a drawing: every pair of its lines is looked at.
const MOST_CORNERS: usize = 20_000;

/// Least relative error that can be asked for: below it the rounding of 64-bit numbers is larger.
const LEAST_TARGET: f64 = 1e-12;

/// Longest name, characters.
const LONGEST_NAME: usize = 200;

struct Reader<'a> {
    file: &'a str,
    raw: &'a RawCase,
}

impl Reader<'_> {
    fn case(&self) -> Result<Case, CaseError> {
        if self.raw.schema != "truegap.case/1" {
            return Err(CaseError::Schema { file: self.file.into(), found: self.raw.schema.clone() });
        }
        self.check_size()?;
        self.check_names()?;
        let physics = [("electrostatics", Physics::Electrostatics), ("elasticity", Physics::Elasticity)];
        let physics = self.word("physics", &self.raw.physics, &physics)?;
        let symmetry = [("axisymmetric", Symmetry::Axisymmetric), ("planar", Symmetry::Planar)];
        let symmetry = self.word("symmetry", &self.raw.symmetry, &symmetry)?;
        let unit = self.raw.length_unit.as_deref().unwrap_or("m");
        let unit =
            unit_factor(unit, Dimension::Length).ok_or_else(|| self.quantity_error("length_unit", unit, Dimension::Length))?;
        let materials = self.raw.material.iter().map(|(name, m)| self.material(name, m)).collect::<Result<Vec<_>, _>>()?;
        let case = Case {
            file: self.file.into(),
            physics,
            symmetry,
            geometry: geometry(self.file, self.raw, unit)?,
            region_materials: self.region_materials(&materials)?,
            materials,
            conditions: self.conditions(symmetry)?,
            temperature: self.temperature(symmetry)?,
            mesh: self.mesh()?,
            outputs: self.raw.output.iter().map(|o| self.output(o, unit)).collect::<Result<_, _>>()?,
        };
        self.check_outputs(&case)?;
        Ok(case)
    }

    /// Before anything is compared with anything.
    fn check_size(&self) -> Result<(), CaseError> {
        let of_region = |r: &super::raw::RawRegion| r.polygon.len().max(1);
        let of_boundary = |b: &RawBoundary| b.path.as_ref().map_or(1, Vec::len);
        let corners =
            self.raw.region.iter().map(of_region).sum::<usize>() + self.raw.boundary.iter().map(of_boundary).sum::<usize>();
        let (place, things) = (format!("{}, the drawing", self.file), "corners of regions and boundaries");
        count(&place, corners, things, MOST_CORNERS, "draw round parts with arcs { via, to }, or leave detail out")?;
        count(&format!("{}, output", self.file), self.raw.output.len(), "outputs", 1000, "ask for fewer, in several cases")?;
        Ok(())
    }

    /// Names stand in tables, in mesh files between quotes, and on terminals.
    fn check_names(&self) -> Result<(), CaseError> {
        let named = |kind: &'static str, name: &str| (kind, name.to_owned());
        let raw = self.raw;
        let names = raw.material.keys().map(|n| named("material", n));
        let names = names.chain(raw.region.iter().map(|r| named("region", &r.name)));
        let names = names.chain(raw.boundary.iter().map(|b| named("boundary", &b.name)));
        let mut names = names.chain(raw.output.iter().map(|o| named("output", &o.name)));
        let refused = |name: &str| {
            name.trim().is_empty() || name.chars().count() > LONGEST_NAME || name.chars().any(|c| c.is_control() || c == '"')
        };
        let Some((kind, name)) = names.find(|(_, name)| refused(name)) else { return Ok(()) };
        let shown: String = name.escape_debug().to_string().chars().take(LONGEST_NAME).collect();
        let what = "a name has 1 to 200 characters on one line, without quotes and control characters";
        Err(self.invalid(format!("{kind} `{shown}`"), what))
    }

    fn word<T: Copy>(&self, place: &str, found: &str, known: &[(&str, T)]) -> Result<T, CaseError> {
        known.iter().find(|k| k.0 == found).map(|k| k.1).ok_or_else(|| CaseError::UnknownWord {
            file: self.file.into(),
            place: place.into(),
            found: found.into(),
            known: known.iter().map(|k| k.0).collect::<Vec<_>>().join(", "),
        })
    }

    fn quantity_error(&self, place: &str, found: &str, dimension: Dimension) -> CaseError {
        CaseError::Quantity {
            file: self.file.into(),
            place: place.into(),
            found: found.into(),
            wanted: dimension.name(),
            example: dimension.example(),
        }
    }

    fn quantity(&self, place: &str, value: &toml::Value, dimension: Dimension) -> Result<f64, CaseError> {
        let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        let parsed = value.as_str().and_then(|t| parse_quantity(t, dimension));
        parsed.ok_or_else(|| self.quantity_error(place, &text, dimension))
    }

    fn optional(&self, place: &str, value: Option<&toml::Value>, dimension: Dimension) -> Result<Option<f64>, CaseError> {
        value.map(|v| self.quantity(place, v, dimension)).transpose()
    }

    fn invalid(&self, place: String, what: &str) -> CaseError {
        CaseError::Invalid { file: self.file.into(), place, what: what.into() }
    }

    fn material(&self, name: &str, raw: &RawMaterial) -> Result<Material, CaseError> {
        let place = |key: &str| format!("material `{name}`, {key}");
        let laws = [
            ("linear", Law::Linear),
            ("neo-hookean", Law::NeoHookean),
            ("svk", Law::StVenantKirchhoff),
            ("st-venant-kirchhoff", Law::StVenantKirchhoff),
        ];
        if raw.relative_permittivity.is_some_and(|e| !(e > 0.0 && e.is_finite())) {
            return Err(self.invalid(place("relative_permittivity"), "must be positive and finite; vacuum is 1.0"));
        }
        let young = self.optional(&place("young"), raw.young.as_ref(), Dimension::Pressure)?;
        if young.is_some_and(|e| !(e > 0.0)) {
            return Err(self.invalid(place("young"), "must be positive"));
        }
        if raw.poisson.is_some_and(|nu| !(nu > -1.0 && nu <= 0.5)) {
            return Err(self.invalid(place("poisson"), "must lie above -1 and at most at 0.5"));
        }
        Ok(Material {
            name: name.into(),
            relative_permittivity: raw.relative_permittivity,
            young,
            poisson: raw.poisson,
            expansion: self.optional(&place("expansion"), raw.expansion.as_ref(), Dimension::Expansion)?.unwrap_or(0.0),
            law: raw.law.as_deref().map_or(Ok(Law::Linear), |law| self.word(&place("law"), law, &laws))?,
        })
    }

    fn region_materials(&self, materials: &[Material]) -> Result<Vec<usize>, CaseError> {
        let find = |region: &super::raw::RawRegion| {
            let place = format!("region `{}`", region.name);
            let Some(name) = &region.material else {
                let remedy = "name one of the [material.*] tables";
                return Err(CaseError::Missing { file: self.file.into(), place, what: "its material", remedy });
            };
            materials.iter().position(|m| m.name == *name).ok_or_else(|| CaseError::UnknownWord {
                file: self.file.into(),
                place,
                found: name.clone(),
                known: materials.iter().map(|m| m.name.as_str()).collect::<Vec<_>>().join(", "),
            })
        };
        self.raw.region.iter().map(find).collect()
    }

    fn component(&self, place: &str, found: &str, symmetry: Symmetry) -> Result<usize, CaseError> {
        let known: [(&str, usize); 2] = match symmetry {
            Symmetry::Axisymmetric => [("r", 0), ("z", 1)],
            Symmetry::Planar => [("x", 0), ("y", 1)],
        };
        self.word(place, found, &known)
    }

    /// One condition a boundary name; several paths of one name may repeat what holds, not contradict it.
    fn conditions(&self, symmetry: Symmetry) -> Result<Vec<Condition>, CaseError> {
        let mut out: Vec<Condition> = Vec::new();
        for raw in &self.raw.boundary {
            let condition = self.condition(raw, symmetry)?;
            match out.iter().find(|c| c.boundary == condition.boundary) {
                None => out.push(condition),
                Some(earlier) if *earlier == condition => {}
                Some(_) => {
                    let what = "the paths of this name carry different conditions; name them differently";
                    return Err(self.invalid(format!("boundary `{}`", raw.name), what));
                }
            }
        }
        Ok(out)
    }

    fn condition(&self, raw: &RawBoundary, symmetry: Symmetry) -> Result<Condition, CaseError> {
        let place = |key: &str| format!("boundary `{}`, {key}", raw.name);
        let mut fix = [false; 2];
        for c in &raw.fix {
            fix[self.component(&place("fix"), c, symmetry)?] = true;
        }
        let mut displace = [None; 2];
        for (c, value) in &raw.displace {
            displace[self.component(&place("displace"), c, symmetry)?] =
                Some(self.quantity(&place("displace"), value, Dimension::Length)?);
        }
        let pressure = self.optional(&place("pressure"), raw.pressure.as_ref(), Dimension::Pressure)?;
        if raw.pressure_load.is_some() && pressure.is_none() {
            return Err(
                self.invalid(place("pressure_load"), "says on which surface a pressure acts, and there is none; add pressure")
            );
        }
        let loads = [("following", PressureLoad::Following), ("dead", PressureLoad::Dead)];
        let pressure_load = raw.pressure_load.as_deref().map(|w| self.word(&place("pressure_load"), w, &loads)).transpose()?;
        Ok(Condition {
            boundary: raw.name.clone(),
            potential: self.optional(&place("potential"), raw.potential.as_ref(), Dimension::Potential)?,
            open: raw.open,
            fix,
            displace,
            pressure,
            pressure_load,
            plate: raw.plate.as_ref().map(|p| self.plate(&place("plate"), p, symmetry)).transpose()?,
        })
    }

    fn plate(&self, place: &str, raw: &RawPlate, symmetry: Symmetry) -> Result<Plate, CaseError> {
        let positions: &[(usize, &Option<toml::Value>)] = match symmetry {
            Symmetry::Axisymmetric => &[(1, &raw.z)],
            Symmetry::Planar => &[(0, &raw.x), (1, &raw.y)],
        };
        let given = [&raw.x, &raw.y, &raw.z].iter().filter(|v| v.is_some()).count();
        let found = positions.iter().find_map(|(c, v)| v.as_ref().map(|v| (*c, v)));
        let (Some((component, position)), 1) = (found, given) else {
            let what = "give the plate one place: z in an axisymmetric case, x or y in a planar one, for example { z = \"0 mm\", travel = \"5 um\" }";
            return Err(self.invalid(place.into(), what));
        };
        let drive = match (&raw.travel, &raw.force) {
            (Some(travel), None) => Drive::Travel(self.quantity(&format!("{place}, travel"), travel, Dimension::Length)?),
            (None, Some(force)) => {
                let unit = if symmetry == Symmetry::Axisymmetric { Dimension::Force } else { Dimension::ForcePerDepth };
                let force = self.quantity(&format!("{place}, force"), force, unit)?;
                if !(force > 0.0) {
                    return Err(self.invalid(format!("{place}, force"), "must be positive: the plate presses against the body"));
                }
                Drive::Force(force)
            }
            _ => return Err(self.invalid(place.into(), "give the plate either a travel towards the body or a force against it")),
        };
        Ok(Plate { component, position: self.quantity(&format!("{place}, position"), position, Dimension::Length)?, drive })
    }

    fn temperature(&self, symmetry: Symmetry) -> Result<Temperature, CaseError> {
        let Some(raw) = &self.raw.temperature else { return Ok(Temperature::default()) };
        let base = self.optional("temperature, base", raw.base.as_ref(), Dimension::Temperature)?.unwrap_or(0.0);
        if raw.inverse.is_some() && symmetry == Symmetry::Planar {
            let what = "1 / R is the field of a sphere; a planar case has `logarithm` for heat flow through a round wall";
            return Err(self.invalid("temperature, inverse".into(), what));
        }
        Ok(Temperature {
            base,
            gradient: self.gradient(&raw.gradient, symmetry)?,
            logarithm: self.radial("temperature, logarithm", raw.logarithm.as_ref())?,
            inverse: self.radial("temperature, inverse", raw.inverse.as_ref())?,
        })
    }

    fn radial(&self, place: &str, raw: Option<&RawRadial>) -> Result<Option<RadialTerm>, CaseError> {
        let Some(raw) = raw else { return Ok(None) };
        let amplitude = self.quantity(&format!("{place}, amplitude"), &raw.amplitude, Dimension::Temperature)?;
        let radius = self.quantity(&format!("{place}, radius"), &raw.radius, Dimension::Length)?;
        if !(radius > 0.0) {
            return Err(self.invalid(format!("{place}, radius"), "must be positive"));
        }
        Ok(Some(RadialTerm { amplitude, radius }))
    }

    fn gradient(&self, raw: &BTreeMap<String, toml::Value>, symmetry: Symmetry) -> Result<[f64; 2], CaseError> {
        let mut gradient = [0.0; 2];
        for (c, value) in raw {
            gradient[self.component("temperature, gradient", c, symmetry)?] =
                self.quantity("temperature, gradient", value, Dimension::Gradient)?;
        }
        Ok(gradient)
    }

    fn mesh(&self) -> Result<MeshRequest, CaseError> {
        let raw = &self.raw.mesh;
        let max_edge = self.optional("mesh, max_edge", raw.max_edge.as_ref(), Dimension::Length)?;
        if raw.target_error.is_some_and(|t| !(LEAST_TARGET..1.0).contains(&t)) {
            let what = "must lie between 1e-12, the rounding of numbers, and 1; it is relative, for example 1e-4";
            return Err(self.invalid("mesh, target_error".into(), what));
        }
        if max_edge.is_some_and(|h| !(h > 0.0)) {
            return Err(self.invalid("mesh, max_edge".into(), "must be positive"));
        }
        let order = raw.order.unwrap_or(2);
        if !(1..=2).contains(&order) {
            return Err(self.invalid("mesh, order".into(), "must be 1 or 2"));
        }
        let methods = [("refine", Method::Refine), ("hp", Method::Hp)];
        let method = raw.method.as_deref().map_or(Ok(Method::Refine), |m| self.word("mesh, method", m, &methods))?;
        if method == Method::Hp && raw.order.is_some() {
            return Err(self.invalid("mesh, order".into(), "method = \"hp\" chooses its own; remove one of the two"));
        }
        // The end of a contact lies between two nodes: a hundredth of its radius takes a hundred of them.
        let usual = if self.raw.boundary.iter().any(|b| b.plate.is_some()) { 1e-2 } else { 1e-4 };
        let target_error = if max_edge.is_none() { Some(raw.target_error.unwrap_or(usual)) } else { raw.target_error };
        Ok(MeshRequest { target_error, max_edge, order, method })
    }

    fn output(&self, raw: &RawOutput, unit: f64) -> Result<Output, CaseError> {
        let kind = self.word(&format!("output `{}`, kind", raw.name), &raw.kind, KINDS)?;
        Ok(Output {
            name: raw.name.clone(),
            kind,
            boundary: raw.boundary.clone(),
            at: raw.at.map(|p| p.map(|x| x * unit)),
            component: raw.component.clone(),
        })
    }

    fn check_outputs(&self, case: &Case) -> Result<(), CaseError> {
        if case.outputs.is_empty() {
            let remedy = "add at least one [[output]] with a name and a kind";
            return Err(CaseError::Missing { file: self.file.into(), place: "the case".into(), what: "an output", remedy });
        }
        for (i, o) in case.outputs.iter().enumerate() {
            let place = || format!("output `{}`", o.name);
            if case.outputs[..i].iter().any(|p| p.name == o.name) {
                return Err(self.invalid(place(), "the name is used twice; name every output differently"));
            }
            let needs_boundary = matches!(o.kind, OutputKind::Capacitance | OutputKind::Reaction) || o.kind.is_of_a_plate();
            let needs_point = matches!(
                o.kind,
                OutputKind::Displacement | OutputKind::Stress | OutputKind::Strain | OutputKind::Potential | OutputKind::Field
            );
            if needs_boundary && o.boundary.is_none() {
                return Err(CaseError::Missing {
                    file: self.file.into(),
                    place: place(),
                    what: "its boundary",
                    remedy: "add boundary = \"NAME\"",
                });
            }
            if needs_point && o.at.is_none() {
                return Err(CaseError::Missing {
                    file: self.file.into(),
                    place: place(),
                    what: "its point",
                    remedy: "add at = [first, second] in the length unit of the case",
                });
            }
        }
        Ok(())
    }
}
