//! Families as a reader of a diagnosis is told them: the groups of `docs/effects.md`, by which "the family was named" is scored.
//!
//! Limits: a copy, because the generator shares nothing with the program that it tests; `crates/truegap/tests/families.rs` compares the two. Recordings with several
//! causes are still drawn from the groups of [`super::family`], so that seeds keep their cases.

/// Family of the effect `id`, as `docs/effects.md` has it; `None` for what is in no library.
pub fn told_family(id: &str) -> Option<&'static str> {
    Some(match id {
        "load_cell_error" | "contact_toe_in" | "eccentric_load" | "inner_stiffening" | "strain_stiffening" | "bonded_layers" => {
            "static_mechanics"
        }
        "viscoelastic_creep"
        | "rate_independent_hysteresis"
        | "mullins_softening"
        | "trapped_air_stiffness"
        | "ageing"
        | "friction"
        | "friction_of_second_driver"
        | "saturating_loop"
        | "permanent_set"
        | "stress_relaxation" => "mechanical_memory",
        "thermal_lag"
        | "thermal_hysteresis"
        | "electrode_warp"
        | "held_warp"
        | "permittivity_temperature"
        | "temperature_coefficient" => "thermal",
        "fringing_field" | "parasitic_capacitance" | "dead_gap" | "plate_bending" | "rim_field" => "field",
        "gain_ageing" | "gain_drift" | "gain_error" | "rate_limit" | "saturation" | "readout_lag" | "time_offset"
        | "clock_rate" | "offset_drift" | "offset_steps" | "settling" | "slow_response" | "regime_change" | "gain_change"
        | "nonlinearity" => "readout",
        "humidity_uptake"
        | "driver_coefficient"
        | "second_driver_coefficient"
        | "driver_gain"
        | "second_driver_gain"
        | "late_driver"
        | "late_second_driver"
        | "daily_cycle"
        | "yearly_cycle" => "environment",
        _ => return None,
    })
}
