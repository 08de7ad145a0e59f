//! Lines and shaded spans that explain a panel.

use super::panel::Panel;
use super::series::Guide;
use super::svg::{Anchor, Area, Svg, px, text_width};

impl Panel<'_> {
    pub(super) fn draw_span(&self, svg: &mut Svg, area: Area, guide: &Guide) {
        if let Some(place) = self.span(area, guide) {
            svg.rect(place, r#"fill="currentColor" fill-opacity="0.08""#);
        }
    }

    fn span(&self, area: Area, guide: &Guide) -> Option<Area> {
        match guide {
            Guide::SpanX(from, to, _) => {
                let (a, b) = (self.x.at(*from), self.x.at(*to));
                Some(Area { left: a.min(b), top: 0.0, width: (b - a).abs(), height: area.height })
            }
            Guide::SpanY(from, to, _) => {
                let (a, b) = (self.y.at(*from), self.y.at(*to));
                Some(Area { left: 0.0, top: a.min(b), width: area.width, height: (b - a).abs() })
            }
            _ => None,
        }
    }

    /// A group that says where along its axis the guide sits, so that it moves when a page zooms.
    pub(super) fn draw_guide(&self, svg: &mut Svg, area: Area, guide: &Guide) {
        let (axis, at) = match guide {
            Guide::AtX(at, _) | Guide::SpanX(at, ..) => ("x", self.x.at(*at)),
            Guide::AtY(at, _) | Guide::SpanY(_, at, _) => ("y", self.y.at(*at)),
        };
        svg.open_group(&format!(r#"data-{axis}="{}""#, px(at)));
        match guide {
            Guide::AtX(_, label) => vertical(svg, area, at, label),
            Guide::AtY(_, label) => horizontal(svg, area, at, label),
            Guide::SpanX(_, _, label) | Guide::SpanY(_, _, label) => {
                if let Some(place) = self.span(area, guide) {
                    svg.note(place.left.max(0.0) + 5.0, place.top.max(0.0) + 14.0, Anchor::Start, label);
                }
            }
        }
        svg.close_group();
    }
}

const STYLE: &str = r#"stroke="currentColor" stroke-opacity="0.7" stroke-dasharray="2 3""#;

fn vertical(svg: &mut Svg, area: Area, x: f64, label: &str) {
    svg.line((x, 0.0), (x, area.height), STYLE);
    let near_end = x + text_width(label, 11.0) + 8.0 > area.width;
    let (x, anchor) = if near_end { (x - 4.0, Anchor::End) } else { (x + 4.0, Anchor::Start) };
    svg.note(x, 14.0, anchor, label);
}

fn horizontal(svg: &mut Svg, area: Area, y: f64, label: &str) {
    svg.line((0.0, y), (area.width, y), STYLE);
    svg.note(area.width - 6.0, if y < 18.0 { y + 13.0 } else { y - 5.0 }, Anchor::End, label);
}
