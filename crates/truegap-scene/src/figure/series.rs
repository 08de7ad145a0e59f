//! What a panel holds before it is drawn: series, marks beside them, and their colours.

use super::error::FigureError;
use crate::colour::{PALETTE, Rgb};

/// How a series is drawn.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Mark {
    Line {
        dashed: bool,
    },
    Steps,
    Points,
    /// `y` is the lower edge.
    Band {
        upper: Vec<f64>,
    },
    /// Vertical bars from `y - below` to `y + above`, with a dot.
    Errors {
        below: Vec<f64>,
        above: Vec<f64>,
    },
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Series {
    pub label: String,
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    pub mark: Mark,
    pub colour: Option<Rgb>,
}

impl Series {
    pub fn check(&self, figure: &str) -> Result<(), FigureError> {
        let same = |left: usize, right: usize, names: [&'static str; 2]| {
            (left == right).then_some(()).ok_or_else(|| FigureError::Lengths {
                figure: figure.into(),
                series: self.label.clone(),
                left,
                left_name: names[0],
                right,
                right_name: names[1],
            })
        };
        same(self.x.len(), self.y.len(), ["x values", "y values"])?;
        match &self.mark {
            Mark::Band { upper } => {
                same(self.x.len(), upper.len(), ["x values", "upper limits"])?;
                self.check_order(figure)
            }
            Mark::Errors { below, above } => {
                same(self.x.len(), below.len(), ["x values", "lower errors"])?;
                same(self.x.len(), above.len(), ["x values", "upper errors"])
            }
            _ => Ok(()),
        }
    }

    fn check_order(&self, figure: &str) -> Result<(), FigureError> {
        match self.x.windows(2).position(|pair| pair[1] < pair[0]) {
            Some(index) => Err(FigureError::NotOrdered { figure: figure.into(), series: self.label.clone(), index: index + 1 }),
            None => Ok(()),
        }
    }

    /// Every y value between two x that the axis should show.
    pub fn heights(&self, low: f64, high: f64) -> impl Iterator<Item = f64> + '_ {
        let outside = move |x: f64| x < low || x > high;
        let values = move |i: usize| {
            let y = self.y[i];
            match &self.mark {
                Mark::Band { upper } => [y, upper[i], y],
                Mark::Errors { below, above } => [y, y - below[i], y + above[i]],
                _ => [y; 3],
            }
        };
        (0..self.x.len()).filter(move |&i| !outside(self.x[i])).flat_map(values)
    }
}

/// Lines and shaded spans that explain the plot.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Guide {
    AtX(f64, String),
    AtY(f64, String),
    SpanX(f64, f64, String),
    SpanY(f64, f64, String),
}

/// Colour of every series: series of one label share it, chosen colours count as used for their label.
pub(super) fn colours<'a>(series: impl Iterator<Item = &'a Series>) -> Vec<(String, Rgb)> {
    let mut known: Vec<(String, Rgb)> = Vec::new();
    let mut automatic = 0;
    for one in series {
        if known.iter().any(|(label, _)| *label == one.label) {
            continue;
        }
        let colour = one.colour.unwrap_or_else(|| {
            automatic += 1;
            PALETTE[(automatic - 1) % PALETTE.len()]
        });
        known.push((one.label.clone(), colour));
    }
    known
}

/// The colour of `label` among `known`.
pub(super) fn colour_of(known: &[(String, Rgb)], label: &str) -> Rgb {
    known.iter().find(|(name, _)| name == label).map_or(PALETTE[0], |(_, colour)| *colour)
}
