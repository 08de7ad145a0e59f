//! Which of several designs no other beats.
//!
//! Limits: linear scans; meant for fronts of some thousand points.

/// Whether `a` is nowhere worse than `b` and somewhere better; all objectives are minimised.
pub fn dominates<const M: usize>(a: &[f64; M], b: &[f64; M]) -> bool {
    a.iter().zip(b).all(|(a, b)| a <= b) && a != b
}

/// Puts a design into a front unless the front beats or holds it already; what it beats goes.
pub fn insert<T, const M: usize>(front: &mut Vec<([f64; M], T)>, objectives: [f64; M], design: T) {
    if front.iter().any(|(old, _)| dominates(old, &objectives) || *old == objectives) {
        return;
    }
    front.retain(|(old, _)| !dominates(&objectives, old));
    front.push((objectives, design));
}
