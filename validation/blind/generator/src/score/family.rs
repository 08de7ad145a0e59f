//! Families of effects: those that act at the same place and show in the same way, so that taking one for the other is a near miss.
//!
//! Reason for the grouping: an experimenter who is told the family knows where to look next. Memory of the beads (creep, friction,
//! damage, leaking air) is met by dwell and cycling; static mechanics by geometry of loading; everything that follows temperature by a
//! thermal sweep; field and gap by guarding and by a second gap; drift by waiting; timing by the clocks; range and reference by the
//! instruments. Limits: an effect is in one family only; `gain_drift` is thermal because gain is made to follow temperature here.
//!
//! Cases with several causes are drawn from these groups. Answers are scored by the families that a reader is told ([`super::told`]).

/// Families.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// Beads and load path without memory.
    StaticMechanics,
    /// Beads with memory.
    BeadMemory,
    /// Follows temperature.
    Thermal,
    /// Gap and field that do not follow the load.
    Field,
    /// Follows humidity.
    Moisture,
    /// Follows the clock.
    Drift,
    /// Delays.
    Timing,
    /// Range of the readout, error of the reference.
    Instruments,
    /// An id outside the table of effects.
    Unknown,
}

/// Family of the effect `id`.
pub fn family(id: &str) -> Family {
    match id {
        "contact_toe_in" | "eccentric_load" | "strain_stiffening" | "plate_bending" => Family::StaticMechanics,
        "viscoelastic_creep" | "rate_independent_hysteresis" | "mullins_softening" | "trapped_air_stiffness" => {
            Family::BeadMemory
        }
        "thermal_lag" | "thermal_hysteresis" | "electrode_warp" | "permittivity_temperature" | "gain_drift" => Family::Thermal,
        "fringing_field" | "parasitic_capacitance" | "dead_gap" => Family::Field,
        "humidity_uptake" => Family::Moisture,
        "offset_drift" | "offset_steps" | "ageing" => Family::Drift,
        "readout_lag" | "time_offset" | "clock_rate" => Family::Timing,
        "saturation" | "load_cell_error" => Family::Instruments,
        _ => Family::Unknown,
    }
}
