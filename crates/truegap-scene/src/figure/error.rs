//! What makes a figure impossible to draw.

/// A figure that cannot be drawn as asked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// Nothing finite (or, on a logarithmic axis, positive) to draw.
    #[error("figure `{figure}` has no finite value on its {axis} axis (positive, if logarithmic); leave the figure out")]
    Empty {
        /// Title of the figure.
        figure: String,
        /// `x` or `y`, or what takes its place.
        axis: &'static str,
    },
    /// Two arrays that belong together differ in length.
    #[error(
        "figure `{figure}`, series `{series}`: {left} {left_name} but {right} {right_name}; give as many of one as of the other"
    )]
    Lengths {
        /// Title of the figure.
        figure: String,
        /// Label of the series.
        series: String,
        /// Length of the first array.
        left: usize,
        /// What the first array holds.
        left_name: &'static str,
        /// Length of the second array.
        right: usize,
        /// What the second array holds.
        right_name: &'static str,
    },
    /// An axis range that is empty, or reaches zero on a logarithmic axis.
    #[error("figure `{figure}`: the {axis} range {low} to {high} is empty or not finite (or not positive on a logarithmic axis)")]
    Range {
        /// Title of the figure.
        figure: String,
        /// `x` or `y`.
        axis: &'static str,
        /// Lower limit asked for.
        low: f64,
        /// Upper limit asked for.
        high: f64,
    },
    /// Values that must rise do not.
    #[error("figure `{figure}`, `{series}`: the x values must not fall (they do at index {index}); sort them first")]
    NotOrdered {
        /// Title of the figure.
        figure: String,
        /// Label of the band or the grid.
        series: String,
        /// Where the values fall.
        index: usize,
    },
}
