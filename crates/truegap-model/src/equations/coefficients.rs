//! Temperature coefficients and linearity of a response: (24)-(28).
//!
//! Limits: two temperatures; any unit of response, as long as it is one.

/// A quantity at two temperatures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// at T0
    pub cold: f64,
    /// at T1
    pub hot: f64,
}

/// Response without and with full load at one temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// without load
    pub unloaded: f64,
    /// at full load
    pub loaded: f64,
}

impl Range {
    /// Full-scale range of the response.
    pub fn span(self) -> f64 {
        self.loaded - self.unloaded
    }
}

/// Drift of the unloaded response, in the response's unit per kelvin.
///
/// $$ K = \frac{C_0(T_1) - C_0(T_0)}{T_1 - T_0} $$
///
/// | symbol | argument   | unit |
/// |--------|------------|------|
/// | C0     | `baseline` | pF   |
/// | T1-T0  | `kelvin`   | K    |
///
/// **Source:** \[hampson2023\] (24), as printed: pF/K, not the %FSR/K that the text says.
pub fn baseline_drift(baseline: Pair, kelvin: f64) -> f64 {
    (baseline.hot - baseline.cold) / kelvin
}

/// Drift of the unloaded response, per cent of the full-scale range per kelvin.
///
/// $$ K_{baseline} = \frac{100}{C_L(T_0) - C_0(T_0)} \cdot \frac{C_0(T_1) - C_0(T_0)}{T_1 - T_0} $$
///
/// | symbol | argument   | unit |
/// |--------|------------|------|
/// | C0     | `baseline` | pF   |
/// | T1-T0  | `kelvin`   | K    |
/// | C_L-C0 | `span` at T0 | pF |
///
/// **Source:** \[hampson2023\] (24), corrected by the capacitance span that its unit asks for; see `docs/errata.md`.
pub fn baseline_coefficient(baseline: Pair, kelvin: f64, span: f64) -> f64 {
    100.0 * baseline_drift(baseline, kelvin) / span
}

/// Response per unit of load.
///
/// $$ S = \frac{C_L - C_0}{F_{full}} $$
///
/// | symbol  | argument    | unit |
/// |---------|-------------|------|
/// | C_L, C0 | `range`     | pF   |
/// | F_full  | `full_load` | N    |
///
/// **Source:** \[hampson2023\] (25); its FSR is the load at full scale.
pub fn sensitivity(range: Range, full_load: f64) -> f64 {
    range.span() / full_load
}

/// Change of sensitivity, per cent per kelvin.
///
/// $$ K_{sensitivity} = 100\,\frac{S(T_1) / S(T_0) - 1}{T_1 - T_0} $$
///
/// | symbol | argument        | unit |
/// |--------|-----------------|------|
/// | S      | `sensitivities` | pF/N |
/// | T1-T0  | `kelvin`        | K    |
///
/// **Source:** \[hampson2023\] (26), in per cent.
pub fn sensitivity_coefficient(sensitivities: Pair, kelvin: f64) -> f64 {
    100.0 * (sensitivities.hot / sensitivities.cold - 1.0) / kelvin
}

/// Greatest distance of a response from the straight line through its ends, per cent of its span.
///
/// $$ \mu = 100\,\frac{\max_F |C(F) - C_{linear}(F)|}{C_L - C_0} $$
///
/// | symbol   | argument    | unit |
/// |----------|-------------|------|
/// | C_L, C0  | `range`     | pF   |
/// | C(F)     | `responses`, as (share of the full load, response) | -, pF |
///
/// **Source:** \[hampson2023\] (27), against the end-point line; its FSR is the span of the response. **Accuracy:** that of the sampling of `responses`.
pub fn linearity(range: Range, responses: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    let off = |(share, response): (f64, f64)| (response - (range.unloaded + share * range.span())).abs();
    100.0 * responses.into_iter().map(off).fold(0.0, f64::max) / range.span().abs()
}

/// Change of linearity, per cent per kelvin.
///
/// $$ K_{linearity} = \frac{\mu(T_1) - \mu(T_0)}{T_1 - T_0} $$
///
/// | symbol | argument      | unit |
/// |--------|---------------|------|
/// | μ      | `linearities` | %    |
/// | T1-T0  | `kelvin`      | K    |
///
/// **Source:** \[hampson2023\] (28).
pub fn linearity_coefficient(linearities: Pair, kelvin: f64) -> f64 {
    (linearities.hot - linearities.cold) / kelvin
}
