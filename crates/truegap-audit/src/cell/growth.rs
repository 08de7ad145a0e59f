//! How a bead grows with temperature when its faces stick to plates that grow less.
//!
//! Limits: mean values, linear in temperature; the shape of the side is left to the field.

use truegap_core::Sensor;
use truegap_model::stack::Warm;

/// Coefficients of a bead between plates, 1/K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Growth {
    /// of a free bead, linear
    pub free: f64,
    /// of the plates, linear
    pub plates: f64,
    /// of the held bead's height, linear
    pub height: f64,
    /// of the held bead's volume
    pub volume: f64,
}

impl Growth {
    /// Growth of a sensor's beads whose held expansion is `held` (see [`super::held_expansion`]).
    ///
    /// $$ \alpha_h = \alpha_p + m \alpha', \qquad \alpha_V = 3\alpha_p + 3\alpha' - \frac{1 - 2\nu}{\nu} (m - 1) \alpha', \qquad
    ///    \alpha' = \alpha - \alpha_p $$
    ///
    /// The volume follows exactly from the height: no axial force means no mean axial stress, so the height tells the mean lateral one, and that the volume.
    pub(crate) fn of(sensor: &Sensor, held: f64) -> Self {
        let silicone = &sensor.dielectric.layer.material;
        let (free, plates, nu) = (silicone.expansion, sensor.conductor.material.expansion, silicone.poisson);
        let more = free - plates;
        let squeezed = if nu > 0.0 { (1.0 - 2.0 * nu) / nu * (held - 1.0) * more } else { 0.0 };
        Self { free, plates, height: plates + held * more, volume: 3.0 * free - squeezed }
    }

    /// Gives a warm sensor the height and the mean area of held beads.
    pub(crate) fn apply(&self, warm: &mut Warm) {
        let (free, held) = (1.0 + self.free * warm.kelvin, 1.0 + self.height * warm.kelvin);
        // a free bead's volume grows by free³, which is linear in the same order as the rest
        let volume = 1.0 + (self.volume - 3.0 * self.free) * warm.kelvin;
        warm.layers.beads *= held / free;
        warm.areas.solid *= volume * free / held;
    }
}
