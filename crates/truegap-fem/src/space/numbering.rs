//! Which unknowns an element has, and which of all unknowns are free.

use super::element::Nodes;

/// The unknowns of every element, elements of different sizes allowed.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ElementDofs {
    offsets: Vec<u32>,
    dofs: Vec<u32>,
    /// Number of unknowns, fixed ones included.
    pub count: usize,
}

impl ElementDofs {
    /// No elements over `count` unknowns.
    pub fn empty(count: usize) -> ElementDofs {
        ElementDofs { offsets: vec![0], dofs: Vec::new(), count }
    }

    /// Adds an element.
    pub fn push(&mut self, dofs: &[u32]) {
        self.dofs.extend_from_slice(dofs);
        self.offsets.push(self.dofs.len() as u32);
    }

    /// Scalar quadratic space: one unknown a node.
    pub fn quadratic(nodes: &Nodes) -> ElementDofs {
        ElementDofs::per_node(nodes, nodes.points.len(), 1, 6)
    }

    /// Scalar linear space: one unknown a corner.
    pub fn linear(nodes: &Nodes) -> ElementDofs {
        ElementDofs::per_node(nodes, nodes.corners, 1, 3)
    }

    /// Vector quadratic space: unknown `2 node + component`; an element's are node by node.
    pub fn quadratic_vector(nodes: &Nodes) -> ElementDofs {
        ElementDofs::per_node(nodes, nodes.points.len(), 2, 6)
    }

    fn per_node(nodes: &Nodes, points: usize, components: u32, local: usize) -> ElementDofs {
        let mut out = ElementDofs::empty(points * components as usize);
        for t in &nodes.triangles {
            for &node in &t[..local] {
                out.dofs.extend((0..components).map(|c| components * node + c));
            }
            out.offsets.push(out.dofs.len() as u32);
        }
        out
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Unknowns of an element.
    #[inline]
    pub fn of(&self, element: usize) -> &[u32] {
        &self.dofs[self.offsets[element] as usize..self.offsets[element + 1] as usize]
    }
}

/// Free unknowns numbered 0, 1, ... and fixed ones with their values.
#[derive(Debug, Clone, PartialEq)]
pub struct Numbering {
    /// Row of every unknown in the system, `mesh::NONE` where it is fixed.
    pub rows: Vec<u32>,
    /// Unknown of every row.
    pub free: Vec<u32>,
}

impl Numbering {
    /// Everything is free except the unknowns marked `true`.
    pub fn new(fixed: &[bool]) -> Numbering {
        let mut rows = vec![crate::mesh::NONE; fixed.len()];
        let mut free = Vec::with_capacity(fixed.len());
        for (i, _) in fixed.iter().enumerate().filter(|(_, f)| !**f) {
            rows[i] = free.len() as u32;
            free.push(i as u32);
        }
        Numbering { rows, free }
    }

    /// The free entries of a vector over all unknowns.
    pub fn restrict(&self, all: &[f64]) -> Vec<f64> {
        self.free.iter().map(|&i| all[i as usize]).collect()
    }

    /// Writes the free entries into a vector over all unknowns; fixed entries stay.
    pub fn scatter(&self, free: &[f64], all: &mut [f64]) {
        self.free.iter().zip(free).for_each(|(&i, &x)| all[i as usize] = x);
    }

    /// Adds the free entries to a vector over all unknowns.
    pub(crate) fn scatter_add(&self, free: &[f64], all: &mut [f64]) {
        self.free.iter().zip(free).for_each(|(&i, &x)| all[i as usize] += x);
    }
}
