//! Which unknowns a mesh has, which conductor fixes each of them, and the permittivity of every region.

use super::error::ElectrostaticsError;
use super::exterior::{Exterior, POWERS, UNKNOWNS};
use super::problem::Problem;
use crate::error::FemError;
use crate::mesh::{Mesh, NONE, Topology};
use crate::space::{ElementDofs, Nodes};
use std::collections::BTreeMap;

/// Owner of unknowns that are zero in every solution.
const ZERO: u16 = u16::MAX - 1;

pub(super) fn permittivities(problem: &Problem, mesh: &Mesh) -> Result<Vec<f64>, ElectrostaticsError> {
    mesh.region_names
        .iter()
        .map(|name| {
            let found = problem.permittivity.iter().find(|(region, _)| region == name).map_or(f64::NAN, |(_, e)| *e);
            let good = found > 0.0 && found.is_finite();
            good.then_some(found)
                .ok_or_else(|| ElectrostaticsError::BadPermittivity { region: name.clone(), permittivity: found })
        })
        .collect()
}

/// Unknowns of all triangles and infinite elements, and the first exterior unknown of every open node.
pub(super) fn unknowns(nodes: &Nodes, topology: &Topology, exterior: Option<&Exterior>) -> (ElementDofs, Option<Vec<u32>>) {
    let mut dofs = ElementDofs::quadratic(nodes);
    let Some(exterior) = exterior else { return (dofs, None) };
    let mut sites = vec![NONE; nodes.points.len()];
    let mut next = nodes.points.len() as u32;
    let open: Vec<[u32; 3]> = exterior.edges.iter().filter_map(|&e| nodes.edge(topology, e)).collect();
    for &node in open.iter().flatten() {
        if sites[node as usize] == NONE {
            sites[node as usize] = next;
            next += (POWERS - 1) as u32;
        }
    }
    for edge in open {
        let mut local = Vec::with_capacity(UNKNOWNS);
        for node in edge {
            local.push(node);
            local.extend((0..POWERS as u32 - 1).map(|k| sites[node as usize] + k));
        }
        local.push(next);
        dofs.push(&local);
    }
    dofs.count = next as usize + 1;
    (dofs, Some(sites))
}

/// Conductors that touch at a node, for every such node.
pub(super) type Junctions = BTreeMap<u32, Vec<u16>>;

/// Conductor that fixes each unknown, `u16::MAX` where it is free; and the nodes that several conductors share.
pub(super) fn owners(
    problem: &Problem,
    mesh: &Mesh,
    nodes: &Nodes,
    topology: &Topology,
    dofs: &ElementDofs,
    sites: Option<&Vec<u32>>,
) -> Result<(Vec<u16>, Junctions), FemError> {
    if problem.conductors.is_empty() {
        return Err(ElectrostaticsError::NoConductor.into());
    }
    let mut owner = vec![u16::MAX; dofs.count];
    let mut junctions = Junctions::new();
    for (c, conductor) in problem.conductors.iter().enumerate() {
        if !conductor.potential.is_finite() {
            return Err(ElectrostaticsError::BadPotential {
                boundary: conductor.boundary.clone(),
                potential: conductor.potential,
            }
            .into());
        }
        for edge in mesh.edges_of(mesh.boundary(&conductor.boundary)?) {
            for node in nodes.edge(topology, edge).into_iter().flatten() {
                let slot = &mut owner[node as usize];
                if *slot == u16::MAX {
                    *slot = c as u16;
                } else if *slot != c as u16 {
                    let touching = junctions.entry(node).or_insert_with(|| vec![*slot]);
                    if !touching.contains(&(c as u16)) {
                        touching.push(c as u16);
                    }
                }
            }
        }
    }
    let Some(sites) = sites else { return Ok((owner, junctions)) };
    // A conductor that reaches the open boundary goes on to infinity along the ray.
    for (node, &site) in sites.iter().enumerate().filter(|(_, s)| **s != NONE) {
        let c = owner[node];
        if c == u16::MAX {
            continue;
        }
        // Constant along the ray: trace and infinity at the conductor's potential, higher powers zero.
        owner[site as usize..site as usize + POWERS - 1].fill(ZERO);
        let far = &mut owner[dofs.count - 1];
        if *far != u16::MAX && *far != c {
            let remedy = "let at most one conductor reach the open boundary";
            return Err(
                ElectrostaticsError::OpenBoundary { reason: "two conductors reach it", at: nodes.points[node], remedy }.into()
            );
        }
        *far = c;
    }
    Ok((owner, junctions))
}
