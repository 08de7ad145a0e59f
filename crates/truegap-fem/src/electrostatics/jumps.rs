//! Error of the boundary values where conductors of different potential touch.
//!
//! The exact potential jumps there; the element next to it blends over its edge. The blend meets the flux of the other
//! field: that product is the error it makes in a charge, of second order in the edge because both sides take the mean
//! at the common node. Charges that are infinite because their own conductor touches another are refused elsewhere.

use super::flux::flux;
use super::system::Solved;
use crate::space::{Element, edge_rule};

/// An edge that starts or ends where conductors touch.
struct Blend {
    triangle: usize,
    side: usize,
    /// The common node is the end (not the start) of the side.
    at_end: bool,
}

/// Adds the products of blends and fluxes of a pair of fields to the shares of the triangles beside them.
pub(super) fn add_jumps(solved: &Solved, fields: &[&[f64]], (a, b): (usize, usize), shares: &mut [f64]) {
    for &node in solved.junctions.keys() {
        let blends = blends(solved, node);
        let product = |blend: &Blend| half(solved, blend, fields[a], fields[b]) + half(solved, blend, fields[b], fields[a]);
        // The two sides nearly cancel: only their sum is an error.
        let sum: f64 = blends.iter().map(product).sum();
        blends.iter().for_each(|blend| shares[blend.triangle] += sum / blends.len() as f64);
    }
}

fn blends(solved: &Solved, node: u32) -> Vec<Blend> {
    let mut out = Vec::new();
    for (triangle, nodes) in solved.nodes.triangles.iter().enumerate() {
        for side in 0..3 {
            let on_conductor = (solved.owner[nodes[3 + side] as usize] as usize) < solved.units.len();
            if on_conductor && (nodes[side] == node || nodes[(side + 1) % 3] == node) {
                out.push(Blend { triangle, side, at_end: nodes[side] != node });
            }
        }
    }
    out
}

/// Integral of (prescribed value of `data` - its exact value) times the outward flux of `other` over the edge.
fn half(solved: &Solved, blend: &Blend, data: &[f64], other: &[f64]) -> f64 {
    let nodes = &solved.nodes.triangles[blend.triangle];
    let ends = [blend.side, (blend.side + 1) % 3].map(|k| nodes[k] as usize);
    let exact = data[ends[usize::from(!blend.at_end)]];
    // What the edge has above the exact value of its conductor, at start, end and middle.
    let above = [ends[0], ends[1], nodes[3 + blend.side] as usize].map(|i| data[i] - exact);
    if above == [0.0; 3] {
        return 0.0;
    }
    let element = solved.nodes.element(blend.triangle);
    let mut sum = 0.0;
    for &(t, w) in &edge_rule(5) {
        let p = element.edge_point(blend.side, t);
        let weight = w * p.speed * solved.problem.symmetry.weight(p.at[0]);
        let blended: f64 = above.iter().zip(p.value).map(|(a, n)| a * n).sum();
        let reference = Element::edge_reference(blend.side, t);
        sum += weight * blended * flux(solved, blend.triangle, &element, reference, p.normal, other);
    }
    sum
}
