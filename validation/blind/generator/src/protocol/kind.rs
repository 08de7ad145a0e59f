//! The ideas of a protocol.
//!
//! Limits: names only; what each does is its plan.

use serde::{Deserialize, Serialize};

/// The ideas of a protocol; the first three are those of the open recordings, the others are poorer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Rest, staircases at three temperatures, triangles at four rates, thermal sweeps at two loads, the first staircase again.
    Full,
    /// Rest, thermal sweeps at three loads, staircases cold and hot, one again.
    Thermal,
    /// Rest, long staircase, triangles at several rates and heights, the staircase again; one temperature.
    Mechanical,
    /// Two short runs, about 200 rows, no rest record.
    Short,
    /// Staircases at two temperatures and one triangle, no rest record, nothing repeated.
    Bench,
    /// As full, shorter, at random moments with gaps.
    Uneven,
    /// Worn: load and temperature wander; no staircase, nothing repeated.
    Worn,
    /// Presses by hand.
    Hand,
    /// Grasps of a gripper.
    Grasps,
    /// Three days on a shelf.
    Shelf,
    /// An oven that is set again and again.
    Oven,
    /// A shaker.
    Shaker,
    /// Points of a technician's table, in no order.
    Table,
}

impl Kind {
    /// Those that nobody planned.
    pub const WILD: [Self; 6] = [Self::Hand, Self::Grasps, Self::Shelf, Self::Oven, Self::Shaker, Self::Table];
    /// Those with a plan.
    pub const ALL: [Self; 7] = [Self::Full, Self::Thermal, Self::Mechanical, Self::Short, Self::Bench, Self::Uneven, Self::Worn];
}
