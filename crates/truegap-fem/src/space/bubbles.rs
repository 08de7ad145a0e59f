//! Polynomials one degree above the elements that vanish at the nodes of the elements.
//!
//! They span the space in which the local (Bank-Weiser) error problems are solved; the middle of an edge may not be
//! moved by them, so they measure what the elements cannot represent.

/// Value and reference slopes of one bubble.
pub(crate) type Bubble = (f64, [f64; 2]);

const SLOPES: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

fn barycentric([x, y]: [f64; 2]) -> [f64; 3] {
    [1.0 - x - y, x, y]
}

/// Number of bubbles above quadratic elements.
pub(crate) const ABOVE_QUADRATIC: usize = 9;

/// For quadratic elements, up to degree four: for each edge 0-1, 1-2, 2-0 the odd cubic, then for each the even quartic,
/// then three bubbles of the interior.
pub(crate) fn bubbles_above_quadratic(at: [f64; 2]) -> [Bubble; ABOVE_QUADRATIC] {
    let l = barycentric(at);
    let product = |(f, df): Bubble, (g, dg): Bubble| (f * g, std::array::from_fn(|i| f * dg[i] + g * df[i]));
    let difference = |a: usize, b: usize| (l[b] - l[a], std::array::from_fn(|i| SLOPES[b][i] - SLOPES[a][i]));
    let edge = |k: usize| {
        let (a, b) = (k, (k + 1) % 3);
        // a b (b - a); derivatives b (b - 2a) by a, and a (2b - a) by b.
        let (da, db) = (l[b] * (l[b] - 2.0 * l[a]), l[a] * (2.0 * l[b] - l[a]));
        (l[a] * l[b] * (l[b] - l[a]), std::array::from_fn(|i| da * SLOPES[a][i] + db * SLOPES[b][i]))
    };
    let even = |k: usize| product(edge(k), difference(k, (k + 1) % 3));
    let inner: [f64; 2] =
        std::array::from_fn(|i| l[1] * l[2] * SLOPES[0][i] + l[2] * l[0] * SLOPES[1][i] + l[0] * l[1] * SLOPES[2][i]);
    let inner = (l[0] * l[1] * l[2], inner);
    let inner_a = product(inner, difference(0, 1));
    let inner_b = product(inner, difference(0, 2));
    [edge(0), edge(1), edge(2), even(0), even(1), even(2), inner, inner_a, inner_b]
}

/// For linear elements: the quadratic of each edge 0-1, 1-2, 2-0.
pub(crate) fn bubbles_above_linear(at: [f64; 2]) -> [Bubble; 3] {
    let l = barycentric(at);
    std::array::from_fn(|k| {
        let (a, b) = (k, (k + 1) % 3);
        (4.0 * l[a] * l[b], std::array::from_fn(|i| 4.0 * (l[b] * SLOPES[a][i] + l[a] * SLOPES[b][i])))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bubbles_vanish_at_the_nodes_and_slopes_are_their_differences() {
        for at in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]] {
            assert!(bubbles_above_quadratic(at).iter().all(|b| b.0.abs() < 1e-15));
        }
        let (at, h) = ([0.2, 0.35], 1e-6);
        for k in 0..ABOVE_QUADRATIC {
            for i in 0..2 {
                let shifted = |s: f64| {
                    let mut p = at;
                    p[i] += s * h;
                    bubbles_above_quadratic(p)[k].0
                };
                // Central differences of cubics: h^2 / 6 times the third derivative, and rounding / h.
                assert!((bubbles_above_quadratic(at)[k].1[i] - (shifted(1.0) - shifted(-1.0)) / (2.0 * h)).abs() < 1e-9);
            }
        }
    }
}
