//! Thinning of long series to what a screen can show, without losing an extreme.
//!
//! Works in pixels. Series that run forward in x keep the first, lowest, highest and last point of every half pixel;
//! others (loops) drop strokes that would be drawn again within a fraction of a pixel. Gaps narrower than half a pixel vanish.

use std::collections::{HashMap, HashSet};

/// A polyline; `None` lifts the pen.
pub(super) type Stroke = Vec<Option<(f64, f64)>>;

/// Half-pixel columns.
const PER_PIXEL: f64 = 2.0;
/// Series up to this length are drawn as they are.
const FEW: usize = 4000;
/// A loop is thinned until at most this many strokes are left.
const STROKES: usize = 20_000;
/// Dots are thinned (to touching ones) above this number.
const DOTS: usize = 5000;

/// Thinned polyline of pixel points in a window from 0 to `width`; points with a NaN lift the pen.
pub(super) fn polyline(points: &[(f64, f64)], width: f64) -> Stroke {
    if points.len() <= FEW {
        return points.iter().map(|&p| drawable(p).then_some(p)).collect();
    }
    if is_forward(points) { columns(&points[visible(points.iter().map(|p| p.0), width)]) } else { loops(points) }
}

/// Points of a forward series inside the window, and one more on either side.
fn visible(x: impl DoubleEndedIterator<Item = f64> + ExactSizeIterator + Clone, width: f64) -> std::ops::Range<usize> {
    let start = x.clone().position(|x| x >= 0.0).unwrap_or(0).saturating_sub(1);
    let end = x.clone().rposition(|x| x <= width).map_or(x.len(), |last| (last + 2).min(x.len()));
    start..end.max(start)
}

/// Points of which no two share a cell: as fine as `finest` pixels, coarser (to `dot`) where that leaves too many.
/// The lowest and highest point of every dot-wide column stay in any case.
pub(super) fn scatter(points: &[(f64, f64)], width: f64, (finest, dot): (f64, f64)) -> Vec<(f64, f64)> {
    let inside = |p: &(f64, f64)| drawable(*p) && (-dot..=width + dot).contains(&p.0);
    let points: Vec<_> = points.iter().copied().filter(inside).collect();
    let mut size = finest;
    loop {
        let mut seen = HashSet::new();
        let mut kept: Vec<_> = points.iter().copied().filter(|&p| seen.insert(cell(p, size))).collect();
        if kept.len() <= DOTS || size >= dot {
            if size > finest {
                kept.extend(edges(&points, dot));
            }
            return kept;
        }
        size = (2.0 * size).min(dot);
    }
}

/// Lowest and highest point of every column of `width` pixels.
fn edges(points: &[(f64, f64)], width: f64) -> impl Iterator<Item = (f64, f64)> {
    let mut columns: HashMap<i64, [(f64, f64); 2]> = HashMap::new();
    for &point in points {
        let [low, high] = columns.entry((point.0 / width).floor() as i64).or_insert([point; 2]);
        if point.1 < low.1 {
            *low = point;
        }
        if point.1 > high.1 {
            *high = point;
        }
    }
    let mut sorted: Vec<_> = columns.into_iter().collect();
    sorted.sort_by_key(|(column, _)| *column);
    sorted.into_iter().flat_map(|(_, pair)| pair)
}

/// Thinned band: `(x, lower, upper)` in data units with `column(x)` the pixel; keeps the widest of every half pixel.
pub(super) fn band(points: &[(f64, f64, f64)], width: f64) -> Vec<Option<(f64, f64, f64)>> {
    let finite = |p: &(f64, f64, f64)| p.0.is_finite() && p.1.is_finite() && p.2.is_finite();
    if points.len() <= FEW {
        return points.iter().map(|p| finite(p).then_some(*p)).collect();
    }
    let mut out: Vec<Option<(f64, f64, f64)>> = Vec::new();
    let (mut gap, mut last_x) = (false, f64::NEG_INFINITY);
    for point in &points[visible(points.iter().map(|p| p.0), width)] {
        if !finite(point) {
            gap = true;
            continue;
        }
        match out.last_mut() {
            Some(Some(last)) if column(last.0) == column(point.0) => {
                // Pixels count downwards: the lower edge of the band has the larger pixel.
                (last.1, last.2) = (last.1.max(point.1), last.2.min(point.2));
            }
            _ => {
                if gap && !out.is_empty() && is_visible(last_x, point.0) {
                    out.push(None);
                }
                out.push(Some(*point));
            }
        }
        (gap, last_x) = (false, point.0);
    }
    out
}

fn drawable((x, y): (f64, f64)) -> bool {
    x.is_finite() && y.is_finite()
}

fn column(x: f64) -> i64 {
    (x * PER_PIXEL).floor() as i64
}

fn cell((x, y): (f64, f64), size: f64) -> (i64, i64) {
    ((x / size).round() as i64, (y / size).round() as i64)
}

fn is_forward(points: &[(f64, f64)]) -> bool {
    let mut last = f64::NEG_INFINITY;
    points.iter().filter(|p| p.0.is_finite()).all(|p| {
        let fine = p.0 >= last;
        last = p.0;
        fine
    })
}

fn columns(points: &[(f64, f64)]) -> Stroke {
    let mut out = Stroke::new();
    let mut bin: Vec<(f64, f64)> = Vec::new();
    let mut gap = false;
    for &point in points {
        if !drawable(point) {
            gap = true;
            continue;
        }
        if let Some(&last) = bin.last()
            && column(bin[0].0) != column(point.0)
        {
            flush(&mut bin, &mut out);
            if gap && is_visible(last.0, point.0) {
                out.push(None);
            }
        }
        gap = false;
        bin.push(point);
    }
    flush(&mut bin, &mut out);
    out
}

/// Whether the space from `left` to `right` is wider than a column.
fn is_visible(left: f64, right: f64) -> bool {
    (right - left) * PER_PIXEL > 1.0
}

/// Moves first, lowest, highest and last of `bin`, in their order, to `out`.
fn flush(bin: &mut Vec<(f64, f64)>, out: &mut Stroke) {
    let by_y = |i: &usize, j: &usize| bin[*i].1.total_cmp(&bin[*j].1);
    let all = 0..bin.len();
    if let (Some(low), Some(high)) = (all.clone().min_by(by_y), all.clone().max_by(by_y)) {
        let mut keep = [0, low, high, bin.len() - 1];
        keep.sort_unstable();
        for (n, &index) in keep.iter().enumerate() {
            if n == 0 || keep[n - 1] != index {
                out.push(Some(bin[index]));
            }
        }
    }
    bin.clear();
}

fn loops(points: &[(f64, f64)]) -> Stroke {
    let mut size = 0.25;
    loop {
        let stroke = without_repeats(points, size);
        if stroke.len() <= STROKES || size > 4.0 {
            return stroke;
        }
        size *= 2.0;
    }
}

fn without_repeats(points: &[(f64, f64)], size: f64) -> Stroke {
    let mut out = Stroke::new();
    let mut drawn = HashSet::new();
    let mut last: Option<(f64, f64)> = None;
    let mut pen_at: Option<(i64, i64)> = None;
    for &point in points {
        if !drawable(point) {
            last = None;
            continue;
        }
        let to = cell(point, size);
        match last {
            Some(from) if cell(from, size) == to => continue,
            Some(from) => {
                let from_cell = cell(from, size);
                if drawn.insert((from_cell.min(to), from_cell.max(to))) {
                    if pen_at != Some(from_cell) {
                        out.extend([None, Some(from)]);
                    }
                    out.push(Some(point));
                    pen_at = Some(to);
                }
            }
            None => {}
        }
        last = Some(point);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noisy(n: usize) -> Vec<(f64, f64)> {
        (0..n).map(|i| (700.0 * i as f64 / n as f64, 100.0 + 20.0 * (i as f64 * 12.9898).sin())).collect()
    }

    #[test]
    fn a_million_points_become_thousands_and_keep_a_single_spike() {
        let mut points = noisy(1_000_000);
        points[654_321].1 = 3.0;
        points[123_456].1 = 290.0;
        let thin = polyline(&points, 700.0);
        assert!(thin.len() <= 4 * 1401, "{}", thin.len());
        let y = || thin.iter().flatten().map(|p| p.1);
        assert_eq!(y().fold(f64::INFINITY, f64::min), 3.0);
        assert_eq!(y().fold(0.0, f64::max), 290.0);
    }

    #[test]
    fn every_half_pixel_keeps_its_own_extremes() {
        let points = noisy(50_000);
        let thin = polyline(&points, 700.0);
        for k in [0, 333, 1200] {
            let range = |all: &mut dyn Iterator<Item = (f64, f64)>| {
                all.filter(|p| column(p.0) == k).fold((f64::MAX, f64::MIN), |(a, b), p| (a.min(p.1), b.max(p.1)))
            };
            assert_eq!(range(&mut points.iter().copied()), range(&mut thin.iter().flatten().copied()));
        }
    }

    #[test]
    fn wide_gaps_stay_and_invisible_gaps_go() {
        let mut points = noisy(100_000);
        points[500].1 = f64::NAN;
        for p in &mut points[40_000..45_000] {
            p.1 = f64::NAN;
        }
        let gaps = polyline(&points, 700.0).iter().filter(|p| p.is_none()).count();
        assert_eq!(gaps, 1);
    }

    #[test]
    fn a_loop_drawn_a_thousand_times_is_drawn_about_once() {
        let points: Vec<_> = (0..1_000_000)
            .map(|i| f64::from(i % 1000) / 1000.0 * std::f64::consts::TAU)
            .map(|a| (350.0 + 300.0 * a.cos(), 150.0 + 100.0 * a.sin()))
            .collect();
        let thin = polyline(&points, 700.0);
        assert!((900..2100).contains(&thin.len()), "{}", thin.len());
        let right = thin.iter().flatten().map(|p| p.0).fold(0.0, f64::max);
        assert_eq!(right, 650.0);
    }
}
