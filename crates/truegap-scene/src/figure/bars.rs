//! Horizontal bars: rankings, tornado charts, indices with intervals.

use super::error::FigureError;
use super::scale::{Scale, extent};
use super::svg::{Anchor, Area, Svg, TEXT, WIDTH, fit, px, text_width};
use super::ticks::{Ticks, short};
use crate::colour::PALETTE;

const LABEL_ROOM: f64 = 250.0;
const BETWEEN_GROUPS: f64 = 9.0;

/// A horizontal bar chart: one group of bars a label, one bar a series in it.
///
/// A value that is not finite is written as "not computed". Bars start at zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Bars {
    title: String,
    axis: (String, String),
    labels: Vec<String>,
    series: Vec<BarSeries>,
    guides: Vec<(f64, String)>,
    ranked: bool,
    overlaid: bool,
}

#[derive(Debug, Clone, PartialEq)]
struct BarSeries {
    label: String,
    values: Vec<f64>,
    interval: Option<(Vec<f64>, Vec<f64>)>,
}

impl Bars {
    /// A chart with a group of bars for each label, top to bottom.
    pub fn new(title: &str, labels: &[&str]) -> Self {
        Self {
            title: title.into(),
            axis: Default::default(),
            labels: labels.iter().map(|&l| l.into()).collect(),
            series: Vec::new(),
            guides: Vec::new(),
            ranked: false,
            overlaid: false,
        }
    }

    /// Names the value axis and its unit.
    pub fn x(mut self, label: &str, unit: &str) -> Self {
        self.axis = (label.into(), unit.into());
        self
    }

    /// One bar in every group.
    pub fn series(mut self, label: &str, values: &[f64]) -> Self {
        self.series.push(BarSeries { label: label.into(), values: values.to_vec(), interval: None });
        self
    }

    /// One bar in every group, with an interval from `low` to `high` drawn across its end.
    pub fn series_with_interval(mut self, label: &str, values: &[f64], low: &[f64], high: &[f64]) -> Self {
        let interval = Some((low.to_vec(), high.to_vec()));
        self.series.push(BarSeries { label: label.into(), values: values.to_vec(), interval });
        self
    }

    /// Sorts the groups by the largest magnitude in them, largest first.
    pub fn ranked(mut self) -> Self {
        self.ranked = true;
        self
    }

    /// Draws the series of a group on one line (a tornado: what -10 % does to the left, what +10 % does to the right).
    pub fn overlaid(mut self) -> Self {
        self.overlaid = true;
        self
    }

    /// A vertical line, for instance a limit.
    pub fn mark(mut self, at: f64, label: &str) -> Self {
        self.guides.push((at, label.into()));
        self
    }

    /// Draws the chart.
    ///
    /// # Errors
    /// A series with more or fewer values than there are labels; no finite value at all.
    pub fn to_svg(&self) -> Result<String, FigureError> {
        self.check()?;
        let mut svg = Svg::default();
        let mut top = svg.heading(&self.title);
        let bar = if self.overlaid || self.series.len() == 1 { 15.0 } else { 11.0 };
        let lanes = if self.overlaid { 1 } else { self.series.len() };
        let pitch = bar * lanes as f64 + BETWEEN_GROUPS;
        let widest = self.labels.iter().map(|l| text_width(l, TEXT)).fold(0.0, f64::max);
        let left = widest.min(LABEL_ROOM) + 20.0;
        top += self.draw_legend(&mut svg, left, top) + if self.guides.is_empty() { 6.0 } else { 20.0 };
        let height = pitch * self.labels.len() as f64 + BETWEEN_GROUPS;
        let area = Area { left, top, width: WIDTH - left - 24.0, height };
        let scale = self.scale(area.width)?;
        self.draw_axis(&mut svg, area, &scale);
        for (row, &index) in self.order().iter().enumerate() {
            let y = area.top + BETWEEN_GROUPS + pitch * row as f64;
            let middle = y + bar * lanes as f64 / 2.0 + 4.0;
            svg.text(left - 8.0, middle, Anchor::End, &fit(&self.labels[index], TEXT, LABEL_ROOM));
            for (n, series) in self.series.iter().enumerate() {
                let lane = if self.overlaid { 0.0 } else { bar * n as f64 };
                let place = Area { left, top: y + lane, width: area.width, height: bar - 1.0 };
                self.draw_bar(&mut svg, place, &scale, (n, series, index));
            }
        }
        Ok(svg.finish(&self.title, area.bottom() + 46.0))
    }

    fn check(&self) -> Result<(), FigureError> {
        for series in &self.series {
            let interval = series.interval.iter().flat_map(|(low, high)| [low, high]);
            let uneven = interval.chain([&series.values]).find(|values| values.len() != self.labels.len());
            if let Some(values) = uneven {
                return Err(FigureError::Lengths {
                    figure: self.title.clone(),
                    series: series.label.clone(),
                    left: self.labels.len(),
                    left_name: "labels",
                    right: values.len(),
                    right_name: "values",
                });
            }
        }
        Ok(())
    }

    fn order(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.labels.len()).collect();
        if self.ranked {
            let size = |i: usize| self.series.iter().map(|s| s.values[i].abs()).filter(|v| v.is_finite()).fold(-1.0, f64::max);
            order.sort_by(|&a, &b| size(b).total_cmp(&size(a)));
        }
        order
    }

    fn scale(&self, pixels: f64) -> Result<Scale, FigureError> {
        let values = self.series.iter().flat_map(|s| {
            let (low, high) = s.interval.as_ref().map_or((&[][..], &[][..]), |(l, h)| (&l[..], &h[..]));
            s.values.iter().chain(low).chain(high).copied()
        });
        let found = extent(values, false).ok_or(FigureError::Empty { figure: self.title.clone(), axis: "x" })?;
        let (low, high) = self.guides.iter().fold(found, |(l, h), g| (l.min(g.0), h.max(g.0)));
        let (low, high) = (low.min(0.0), high.max(0.0));
        let (low, high) = if low < high { (low, high) } else { (0.0, 1.0) };
        // Room for the numbers at the ends of the bars.
        let room = if self.numbers_shown() { 0.10 } else { 0.03 } * (high - low);
        let widened = |end: f64, by: f64| if end == 0.0 { end } else { end + by };
        Ok(Scale { low: widened(low, -room), high: widened(high, room), log: false, pixels, flipped: false })
    }

    fn numbers_shown(&self) -> bool {
        !self.overlaid && self.series.iter().all(|s| s.interval.is_none())
    }

    fn draw_legend(&self, svg: &mut Svg, left: f64, top: f64) -> f64 {
        if self.series.len() < 2 {
            return 0.0;
        }
        let mut x = left;
        for (n, series) in self.series.iter().enumerate() {
            let key = Area { left: x, top: top + 4.0, width: 18.0, height: 11.0 };
            svg.rect(key, &format!(r#"fill="{}""#, PALETTE[n % PALETTE.len()].css()));
            svg.text(x + 24.0, top + 14.0, Anchor::Start, &series.label);
            x += 24.0 + text_width(&series.label, TEXT) + 16.0;
        }
        24.0
    }

    fn draw_axis(&self, svg: &mut Svg, area: Area, scale: &Scale) {
        let ticks = Ticks::new(scale, (area.width / 85.0) as usize);
        for (value, label) in &ticks.major {
            let x = area.left + scale.at(*value);
            svg.line((x, area.top), (x, area.bottom()), r#"stroke="currentColor" stroke-opacity="0.12""#);
            svg.text(x, area.bottom() + 16.0, Anchor::Middle, label);
        }
        let zero = area.left + scale.at(0.0);
        svg.line((zero, area.top), (zero, area.bottom()), r#"stroke="currentColor" stroke-opacity="0.7""#);
        let title = ticks.title(&self.axis.0, &self.axis.1);
        svg.text(area.left + area.width / 2.0, area.bottom() + 35.0, Anchor::Middle, &title);
        for (at, label) in &self.guides {
            let x = area.left + scale.at(*at);
            let style = r#"stroke="currentColor" stroke-opacity="0.7" stroke-dasharray="2 3""#;
            svg.line((x, area.top - 2.0), (x, area.bottom()), style);
            svg.styled_text(x, area.top - 6.0, Anchor::Middle, label, r#"font-size="11""#);
        }
    }

    fn draw_bar(&self, svg: &mut Svg, place: Area, scale: &Scale, (n, series, index): (usize, &BarSeries, usize)) {
        let value = series.values[index];
        let zero = place.left + scale.at(0.0);
        let middle = place.top + place.height / 2.0;
        if !value.is_finite() {
            svg.styled_text(zero + 6.0, middle + 4.0, Anchor::Start, "not computed", r#"font-size="11" font-style="italic""#);
            return;
        }
        let end = place.left + scale.at(value);
        let outline = format!("M{} {}H{}v{}H{}Z", px(zero), px(place.top), px(end), px(place.height), px(zero));
        let hint = format!("{}, {}: {} {}", self.labels[index], series.label, short(value), self.axis.1);
        svg.path(&outline, &hint, &format!(r#"fill="{}""#, PALETTE[n % PALETTE.len()].css()));
        if let Some((low, high)) = &series.interval {
            let (low, high) = (place.left + scale.at(low[index]), place.left + scale.at(high[index]));
            if low.is_finite() && high.is_finite() {
                let whisker = format!(
                    "M{} {}H{}M{} {}v6M{} {}v6",
                    px(low),
                    px(middle),
                    px(high),
                    px(low),
                    px(middle - 3.0),
                    px(high),
                    px(middle - 3.0)
                );
                svg.path(&whisker, &hint, r#"stroke="currentColor" stroke-width="1.3" fill="none""#);
            }
        }
        if self.numbers_shown() {
            let (x, anchor) = if value < 0.0 { (end - 5.0, Anchor::End) } else { (end + 5.0, Anchor::Start) };
            svg.note(x, middle + 4.0, anchor, &short(value));
        }
    }
}
