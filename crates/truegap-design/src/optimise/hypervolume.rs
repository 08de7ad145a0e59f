//! Area and volume that a front dominates: one number to compare fronts by.
//!
//! Limits: two or three objectives, all minimised; points beyond the reference count for nothing.

/// Area between a front and a reference point.
pub fn hypervolume_2d(front: &[[f64; 2]], reference: [f64; 2]) -> f64 {
    let mut points: Vec<_> = front.iter().filter(|p| p[0] < reference[0] && p[1] < reference[1]).copied().collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let (mut area, mut level) = (0.0, reference[1]);
    for [x, y] in points {
        if y < level {
            area += (reference[0] - x) * (level - y);
            level = y;
        }
    }
    area
}

/// Volume between a front and a reference point, by slices along the third objective.
pub fn hypervolume_3d(front: &[[f64; 3]], reference: [f64; 3]) -> f64 {
    let mut points: Vec<_> = front.iter().filter(|p| p.iter().zip(&reference).all(|(p, r)| p < r)).copied().collect();
    points.sort_by(|a, b| a[2].total_cmp(&b[2]));
    let flat: Vec<[f64; 2]> = points.iter().map(|p| [p[0], p[1]]).collect();
    let slice = |i: usize| {
        let top = points.get(i + 1).map_or(reference[2], |p| p[2]);
        (top - points[i][2]) * hypervolume_2d(&flat[..=i], [reference[0], reference[1]])
    };
    (0..points.len()).map(slice).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_are_counted_once() {
        // a 1 x 1 box and a 2 x 0.5 box that share 1 x 0.5
        assert_eq!(hypervolume_2d(&[[1.0, 1.0], [0.0, 1.5], [3.0, 0.0]], [2.0, 2.0]), 1.5);
        let cube = [[0.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 0.0]];
        // three 1 x 1 x 2 bars that share a unit cube: 3 x 2 - 2
        assert_eq!(hypervolume_3d(&cube, [2.0; 3]), 4.0);
    }
}
