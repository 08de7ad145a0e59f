//! Polygons and paths of a case, to metres.

use super::error::CaseError;
use super::raw::{RawArc, RawCase, RawStep};
use crate::mesh::{Boundary, BoundaryPath, Geometry, Outline, Region, Step};

pub(super) fn geometry(file: &str, raw: &RawCase, unit: f64) -> Result<Geometry, CaseError> {
    let mut out = Geometry::default();
    for region in &raw.region {
        let place = format!("region `{}`", region.name);
        if out.regions.iter().any(|r| r.name == region.name) {
            return Err(CaseError::Invalid {
                file: file.into(),
                place,
                what: "the name is used twice; name every region differently".into(),
            });
        }
        out.regions.push(Region { name: region.name.clone(), outline: outline(file, &place, &region.polygon, unit)? });
    }
    for boundary in &raw.boundary {
        let place = format!("boundary `{}`", boundary.name);
        let path = match (&boundary.path, &boundary.region) {
            (Some(steps), None) => match (steps.as_slice(), boundary.fix.is_empty() && boundary.displace.is_empty()) {
                // A single point may be held: it pins an elastic body.
                ([RawStep::Point(p)], false) => BoundaryPath::Path(Outline { start: p.map(|x| x * unit), steps: Vec::new() }),
                _ => BoundaryPath::Path(outline(file, &place, steps, unit)?),
            },
            (None, Some(region)) => BoundaryPath::OutlineOf(region.clone()),
            _ => {
                let what = "give it either a path or a region".into();
                return Err(CaseError::Invalid { file: file.into(), place, what });
            }
        };
        out.boundaries.push(Boundary { name: boundary.name.clone(), path });
    }
    Ok(out)
}

fn outline(file: &str, place: &str, steps: &[RawStep], unit: f64) -> Result<Outline, CaseError> {
    let metres = |p: &[f64; 2]| p.map(|x| x * unit);
    let Some((RawStep::Point(start), rest)) = steps.split_first() else {
        let what = "the outline must start with a point [first, second]; an arc needs a point before it".into();
        return Err(CaseError::Invalid { file: file.into(), place: place.into(), what });
    };
    if rest.is_empty() {
        let what = "the outline has a single point; give at least two for a path, three for a region".into();
        return Err(CaseError::Invalid { file: file.into(), place: place.into(), what });
    }
    let step = |s: &RawStep| match s {
        RawStep::Point(p) => Step::Line(metres(p)),
        RawStep::Arc(RawArc { via, to }) => Step::Arc { via: metres(via), to: metres(to) },
    };
    Ok(Outline { start: metres(start), steps: rest.iter().map(step).collect() })
}
