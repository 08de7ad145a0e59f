//! The chain from what is done to the sensor to what is read, with a place for every concealed cause.
//!
//! Limits: a cause acts at one or two stages; causes of the same stage act one after the other in the order given.

use crate::mechanism::Mechanism;
use crate::state::{PlatesTouch, Scene, State};

/// A cause at a size.
#[derive(Debug, Clone)]
pub struct Act {
    /// The cause with its drawn shape.
    pub mechanism: Box<dyn Mechanism>,
    /// Its size, in the mechanism's own unit; 0 is the base model.
    pub size: f64,
}

/// Noise-free readings (pF) of `scene.sensor` with the causes `acts`; `warp`: the electrode bends with temperature.
pub fn simulate(scene: Scene, warp: bool, acts: &[Act]) -> Result<Vec<f64>, PlatesTouch> {
    let mut state = State::untouched(scene.history);
    let each = |state: &mut State, stage: fn(&dyn Mechanism, f64, Scene, &mut State)| {
        for act in acts.iter().filter(|act| act.size != 0.0) {
            stage(act.mechanism.as_ref(), act.size, scene, state);
        }
    };
    each(&mut state, |m, size, scene, state| m.inputs(size, scene, state));
    each(&mut state, |m, size, scene, state| m.stiffness(size, scene, state));
    state.compress(scene.sensor);
    each(&mut state, |m, size, scene, state| m.strain(size, scene, state));
    state.shape(scene.sensor, warp);
    each(&mut state, |m, size, scene, state| m.geometry(size, scene, state));
    each(&mut state, |m, size, scene, state| m.dielectric(size, scene, state));
    state.read(scene.sensor)?;
    each(&mut state, |m, size, scene, state| m.field(size, scene, state));
    each(&mut state, |m, size, scene, state| m.readout(size, scene, state));
    Ok(state.reading)
}
