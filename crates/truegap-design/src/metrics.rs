//! What a data sheet says about a sensor, fast enough to be asked a million times.
//!
//! Limits: two temperatures; linearity against the end-point line, its greatest deviation by parabolas instead of a fine scan.

use crate::{error::DesignError, metric::Metrics};
use truegap_core::Sensor;
use truegap_model::stack::{Device, Refusal, StackOptions, Warm};

/// Where the metrics are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetricOptions {
    /// model
    pub stack: StackOptions,
    /// lower temperature, degrees Celsius
    pub cold_c: f64,
    /// upper temperature, degrees Celsius
    pub hot_c: f64,
}

impl Default for MetricOptions {
    fn default() -> Self {
        Self { stack: StackOptions::default(), cold_c: 20.0, hot_c: 50.0 }
    }
}

/// The metrics of a sensor between no load and its full scale.
///
/// **Source:** \[hampson2023\] (24)-(28). **Accuracy:** agrees with `truegap_model::coefficients`, which scans and sections, to 1e-7 of the linearity and to rounding
/// otherwise: `the_fast_metrics_are_those_of_the_slow_route`.
///
/// # Errors
/// [`DesignError::Touches`] where the plates meet between no load and full load at either temperature.
pub fn metrics(sensor: &Sensor, options: MetricOptions) -> Result<Metrics, DesignError> {
    let device = Device::new(sensor, options.stack);
    let curve = |temperature_c: f64| Curve::new(&device, temperature_c).map_err(|refused| refused.told(sensor));
    let (cold, hot) = (curve(options.cold_c)?, curve(options.hot_c)?);
    let kelvin = options.hot_c - options.cold_c;
    let linearity = |curve: &Curve<'_>| curve.linearity().map_err(|refused| refused.told(sensor));
    let (bent, bent_hot) = (linearity(&cold)?, linearity(&hot)?);
    let drift = (hot.unloaded - cold.unloaded) / kelvin;
    Ok(Metrics([
        cold.unloaded,
        cold.span,
        bent,
        drift,
        100.0 * drift / cold.span,
        100.0 * (hot.span / cold.span - 1.0) / kelvin,
        (bent_hot - bent) / kelvin,
    ]))
}

/// Why a point of a curve has no answer.
struct Refused {
    refusal: Refusal,
    temperature_c: f64,
    force_n: f64,
}

impl Refused {
    fn told(self, sensor: &Sensor) -> DesignError {
        let (sensor, temperature_c, force_n) = (sensor.name.clone(), self.temperature_c, self.force_n);
        match self.refusal {
            Refusal::Touches { strain } => DesignError::Touches { sensor, temperature_c, force_n, strain },
            Refusal::NoAnswer => DesignError::NoAnswer { sensor, temperature_c, force_n },
        }
    }
}

/// Response against load at one temperature, pF.
struct Curve<'a> {
    device: &'a Device,
    warm: Warm,
    temperature_c: f64,
    unloaded: f64,
    span: f64,
}

/// Equal load steps on which the greatest deviation is first sought.
const STEPS: u32 = 8;
/// Half-width of the second parabola, share of the full load.
const NARROW: f64 = 0.02;
/// A peak whose nearest step is lower than this share of the other side's is not looked at: a step misses a peak by at most half an eighth of the load.
const RIVAL: f64 = 0.7;

impl<'a> Curve<'a> {
    fn new(device: &'a Device, temperature_c: f64) -> Result<Self, Refused> {
        let mut curve = Self { device, warm: device.at(temperature_c), temperature_c, unloaded: 0.0, span: 0.0 };
        curve.unloaded = curve.response(0.0)?;
        curve.span = curve.response(1.0)? - curve.unloaded;
        if curve.span.is_nan() || curve.span <= 0.0 {
            return Err(curve.refused(Refusal::NoAnswer, device.full_scale));
        }
        Ok(curve)
    }

    fn refused(&self, refusal: Refusal, force_n: f64) -> Refused {
        Refused { refusal, temperature_c: self.temperature_c, force_n }
    }

    /// Response at a share of the full load.
    fn response(&self, share: f64) -> Result<f64, Refused> {
        let force = share * self.device.full_scale;
        let strain = self.device.strain(&self.warm, force, 1.0, [0.0; 2]);
        let parts = strain.and_then(|e| self.device.capacitances(&self.warm, &self.device.plain(&self.warm, force, e)));
        parts.map(|parts| self.device.total(parts.shares) * 1e12).map_err(|refusal| self.refused(refusal, force))
    }

    /// Distance from the line through the ends, with its sign, % of the span.
    fn deviation(&self, share: f64) -> Result<f64, Refused> {
        Ok(100.0 * ((self.response(share)? - self.unloaded) / self.span - share))
    }

    /// Greatest distance from the line through the ends, on either side of it: the outermost of equal steps, then the vertices of two parabolas.
    fn linearity(&self) -> Result<f64, Refused> {
        let mut scan = [0.0; STEPS as usize + 1];
        for i in 1..STEPS {
            scan[i as usize] = self.deviation(f64::from(i) / f64::from(STEPS))?;
        }
        let outermost =
            |side: f64| (1..STEPS as usize).max_by(|&a, &b| (side * scan[a]).total_cmp(&(side * scan[b]))).unwrap_or(1);
        let sides = [1.0, -1.0].map(outermost);
        let worst = sides.map(|i| scan[i].abs()).into_iter().fold(0.0, f64::max);
        let mut greatest = worst;
        for side in sides.into_iter().filter(|&i| scan[i].abs() >= RIVAL * worst) {
            greatest = greatest.max(self.peak(&scan, side)?);
        }
        Ok(greatest)
    }

    /// Size of the deviation's peak near a step of the scan.
    fn peak(&self, scan: &[f64], step: usize) -> Result<f64, Refused> {
        let near = (step as f64 + vertex([scan[step - 1], scan[step], scan[step + 1]])) / f64::from(STEPS);
        let near = near.clamp(NARROW, 1.0 - NARROW);
        let close = [self.deviation(near - NARROW)?, self.deviation(near)?, self.deviation(near + NARROW)?];
        let top = self.deviation(near + NARROW * vertex(close))?;
        Ok(close[1].abs().max(top.abs()))
    }
}

/// Where the parabola through values at -1, 0 and 1 turns, kept within that range.
fn vertex([left, middle, right]: [f64; 3]) -> f64 {
    let bend = left - 2.0 * middle + right;
    if bend == 0.0 { 0.0 } else { (0.5 * (left - right) / bend).clamp(-1.0, 1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        metric::{METRICS, Metric},
        quantity::Quantity,
    };
    use truegap_core::sensor::builtin_sensors;
    use truegap_model::{CoefficientOptions, coefficients};

    #[test]
    fn the_fast_metrics_are_those_of_the_slow_route() {
        for sensor in builtin_sensors() {
            let sensor = sensor.sensor().unwrap();
            let fast = metrics(&sensor, MetricOptions::default()).unwrap();
            let slow = coefficients(&sensor, CoefficientOptions::default()).unwrap();
            let known = [
                slow.baseline_pf,
                slow.span_pf,
                slow.linearity_pct,
                slow.k_baseline_pf_per_k,
                slow.k_baseline_pct_fsr_per_k,
                slow.k_sensitivity_pct_per_k,
            ];
            for (fast, slow) in fast.0.iter().zip(known) {
                approx::assert_relative_eq!(*fast, slow, max_relative = 1e-7);
            }
            // the difference of two linearities, each to 1e-7 of itself, over 30 K
            let tolerance = 1e-7 * slow.linearity_pct / 30.0 * 2.0;
            approx::assert_abs_diff_eq!(fast.of(Metric::KLinearity), slow.k_linearity_pct_per_k, epsilon = tolerance);
        }
    }

    #[test]
    fn a_response_that_bends_to_both_sides_is_as_straight_as_its_worse_side() {
        // found by the search, which had learnt that the scan's worst step need not lie at the higher peak: +0.0585 at a fifth of the load, -0.0566 at four fifths
        let mut sensor = builtin_sensors()[0].sensor().unwrap();
        let design = [
            (Quantity::Young, 1.5e6),
            (Quantity::Height, 1.5e-4),
            (Quantity::Conductor, 1.7e-5),
            (Quantity::Insulator, 7.5e-5),
            (Quantity::BeadDiameter, 6.317_232_08e-4),
            (Quantity::BeadCount, 66.0),
        ];
        design.iter().for_each(|&(quantity, value)| quantity.set(&mut sensor, value));
        sensor.plating = None;
        let options = MetricOptions { cold_c: 50.0, hot_c: 80.0, ..Default::default() };
        let fast = metrics(&sensor, options).unwrap().of(Metric::Linearity);
        let device = Device::new(&sensor, options.stack);
        let curve = Curve::new(&device, 50.0).ok().unwrap();
        let scan = (0..=10_000).map(|i| curve.deviation(f64::from(i) / 1e4).ok().unwrap());
        let (low, high) = scan.fold((0.0_f64, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)));
        assert!(low < -0.05 && high > 0.05, "{low} {high}");
        // a grid of 10 000 misses a peak by (half a step)² times its bend: below 1e-7 of it
        approx::assert_relative_eq!(fast, high.max(-low), max_relative = 1e-6);
    }

    #[test]
    fn names_lead_back_to_their_metric() {
        assert!(METRICS.into_iter().enumerate().all(|(i, m)| m as usize == i && Metric::named(m.name()) == Some(m)));
    }

    #[test]
    fn plates_that_touch_are_named_with_load_and_temperature() {
        let mut sensor = builtin_sensors()[0].sensor().unwrap();
        sensor.full_scale = 200.0;
        let told = metrics(&sensor, MetricOptions::default()).unwrap_err();
        assert!(matches!(told, DesignError::Touches { force_n: 200.0, temperature_c: 20.0, .. }), "{told}");
    }
}
