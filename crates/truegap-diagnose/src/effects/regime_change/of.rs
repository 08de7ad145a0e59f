//! What moves the reading while something is switched: of that a coefficient may change.

use crate::{data::context::Context, effects::course::Course, stats::spread};

/// What the coefficient is of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Of {
    Temperature,
    Driver(Course),
    /// the reading itself: a gain
    Reading,
    /// nothing moves: only the zero changes
    Nothing,
}

/// Share of its range by which what goes one way ends from where it began.
const ONE_WAY: f64 = 0.9;

/// Temperature range from which on a coefficient can be told, K.
const WARMS: f64 = 2.0;

impl Of {
    pub(super) fn what_moves(context: &Context<'_>) -> Self {
        if context.moved.temperature_k >= WARMS {
            return Self::Temperature;
        }
        match Course::of(context, 0) {
            Some(Course::Driver(index)) => Self::Driver(Course::Driver(index)),
            Some(_) => Self::Reading,
            None => Self::Nothing,
        }
    }

    /// What moves the reading or its coefficient, where that is no temperature.
    pub(super) fn course(self, context: &Context<'_>) -> Option<Course> {
        match self {
            Self::Driver(course) => Some(course),
            Self::Reading => Course::of(context, 0),
            Self::Temperature | Self::Nothing => None,
        }
    }

    /// Whether what moves, where that is no temperature, ends about as far from where it began as it ever is, and does not come again.
    pub(super) fn goes_one_way(self, context: &Context<'_>) -> bool {
        let Some(course) = self.course(context) else { return false };
        let column = course.recorded(context).unwrap_or_default();
        let far = |(first, last): (&f64, &f64)| (last - first).abs() >= ONE_WAY * spread(&column);
        column.first().zip(column.last()).is_some_and(far) && !course.comes_again(context)
    }

    /// Range of what the coefficient is of, in its unit.
    pub(super) fn span(self, context: &Context<'_>) -> f64 {
        match self {
            Self::Temperature => context.temperature_span(),
            Self::Driver(course) => course.span(context),
            Self::Reading | Self::Nothing => context.response_span.abs(),
        }
    }

    /// Unit of the coefficient.
    pub(super) fn unit(self, context: &Context<'_>) -> String {
        let reading = context.simulator.unit();
        match self {
            Self::Temperature => format!("{reading}/K"),
            Self::Driver(course) => format!("{reading}/{}", course.unit(context)),
            Self::Reading => "1".into(),
            Self::Nothing => reading.into(),
        }
    }

    /// Mean of the column over the recording, and half its range: from there, and in that unit, the coefficient of a change counts.
    pub(super) fn middle_and_half(self, context: &Context<'_>) -> (f64, f64) {
        let mean = |column: &[f64]| column.iter().sum::<f64>() / column.len().max(1) as f64;
        let half = (0.5 * self.span(context)).max(f64::MIN_POSITIVE);
        let middle = match self {
            Self::Temperature => context.inputs.temperature_c.as_deref().map_or(0.0, mean) - context.reference_c,
            Self::Driver(Course::Driver(index)) => context.inputs.drivers.get(index).map_or(0.0, |d| mean(&d.values)),
            Self::Reading => half,
            _ => 0.0,
        };
        (middle, half)
    }
}
