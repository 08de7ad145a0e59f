//! Series of a panel: lines, steps, points, error bars, bands.

use super::decimate;
use super::panel::Panel;
use super::series::{Mark, Series};
use super::svg::{Svg, px};

impl Panel<'_> {
    fn pixels(&self, series: &Series) -> Vec<(f64, f64)> {
        series.x.iter().zip(&series.y).map(|(&x, &y)| (self.x.at(x), self.y.at(y))).collect()
    }

    pub(super) fn draw_series(&self, svg: &mut Svg, series: &Series, colour: &str) {
        let points = self.pixels(series);
        let wide = format!(r#"fill="none" stroke="{colour}" stroke-width="1.7" stroke-linejoin="round""#);
        match &series.mark {
            Mark::Line { dashed } => {
                let dash = if *dashed { r#" stroke-dasharray="6 4""# } else { "" };
                svg.path(&stroke(&decimate::polyline(&points, self.x.pixels)), &series.label, &format!("{wide}{dash}"));
            }
            Mark::Steps => svg.path(&stroke(&decimate::polyline(&stairs(&points), self.x.pixels)), &series.label, &wide),
            Mark::Points => self.draw_points(svg, series, &points, colour),
            Mark::Errors { below, above } => {
                self.draw_error_bars(svg, series, (below, above), colour);
                self.draw_points(svg, series, &points, colour);
            }
            Mark::Band { .. } => {}
        }
    }

    fn draw_points(&self, svg: &mut Svg, series: &Series, points: &[(f64, f64)], colour: &str) {
        let few = points.len() <= 200;
        let (size, cell) = if few { (6.0, 0.1) } else { (3.2, 0.8) };
        let data: String = decimate::scatter(points, self.x.pixels, (cell, size))
            .iter()
            .map(|p| format!("M{} {}h0", px(p.0), px(p.1)))
            .collect();
        let opacity = if few { "0.95" } else { "0.7" };
        let style =
            format!(r#"fill="none" stroke="{colour}" stroke-width="{size}" stroke-linecap="round" stroke-opacity="{opacity}""#);
        svg.path(&data, &series.label, &style);
    }

    fn draw_error_bars(&self, svg: &mut Svg, series: &Series, (below, above): (&[f64], &[f64]), colour: &str) {
        let mut data = String::new();
        for (i, (&x, &y)) in series.x.iter().zip(&series.y).enumerate() {
            let (x, low, high) = (self.x.at(x), self.lower_end(y - below[i]), self.y.at(y + above[i]));
            if x.is_finite() && low.is_finite() && high.is_finite() {
                data += &format!("M{} {}V{}m-3.5 0h7M{} {}h7", px(x), px(low), px(high), px(x - 3.5), px(low));
            }
        }
        svg.path(&data, &series.label, &format!(r#"fill="none" stroke="{colour}" stroke-width="1.4""#));
    }

    /// Pixel of the lower end of a bar or band: on a logarithmic axis one that reaches zero runs to the bottom.
    fn lower_end(&self, value: f64) -> f64 {
        if self.y.log && value <= 0.0 { self.y.pixels } else { self.y.at(value) }
    }

    pub(super) fn draw_band(&self, svg: &mut Svg, series: &Series, colour: &str) {
        let Mark::Band { upper } = &series.mark else {
            return;
        };
        let points: Vec<(f64, f64, f64)> = series
            .x
            .iter()
            .zip(series.y.iter().zip(upper))
            .map(|(&x, (&low, &high))| (self.x.at(x), self.lower_end(low), self.y.at(high)))
            .collect();
        let mut data = String::new();
        for piece in decimate::band(&points, self.x.pixels).split(Option::is_none) {
            let piece: Vec<_> = piece.iter().flatten().collect();
            let there = piece.iter().map(|p| format!("{} {}", px(p.0), px(p.2)));
            let back = piece.iter().rev().map(|p| format!("{} {}", px(p.0), px(p.1)));
            let corners: Vec<String> = there.chain(back).collect();
            if piece.len() > 1 {
                data += &format!("M{}Z", corners.join("L"));
            }
        }
        svg.path(&data, &series.label, &format!(r#"fill="{colour}" fill-opacity="0.22" stroke="none""#));
    }
}

fn stairs(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut out = Vec::with_capacity(2 * points.len());
    for (i, &point) in points.iter().enumerate() {
        if i > 0 {
            out.push((point.0, points[i - 1].1));
        }
        out.push(point);
    }
    out
}

fn stroke(points: &decimate::Stroke) -> String {
    let mut data = String::new();
    let mut down = false;
    for point in points {
        match point {
            None => down = false,
            Some((x, y)) => {
                data += if down { "L" } else { "M" };
                data += &format!("{} {}", px(*x), px(*y));
                // A lone point is drawn as a dot by the round cap of a zero-length stroke.
                down = true;
            }
        }
    }
    data
}
