//! Refining where it pays: newest-vertex bisection, marking, and the bubble functions of local error estimates.

mod bisect;
mod bubbles;
mod mark;

pub use bisect::{bisect, bisect_repeatedly, longest_edge_first};
pub use bubbles::{ABOVE_QUADRATIC, Bubble, bubbles_above_linear, bubbles_above_quadratic};
pub use mark::mark_largest;
