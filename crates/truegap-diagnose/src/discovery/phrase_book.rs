//! From words to physics that a reader may know: what such a mechanism could be.
//!
//! Limits: a hint from place, driver and kinetics alone; it never claims more than the words do.

use crate::effects::composed::{
    mechanism::{Numbers, Sentence, Sum},
    words::{Driver, Form, Kinetics, Place},
};

/// Physics that fits the words, each with a source.
pub fn could_be(s: &Sentence, numbers: &Numbers) -> Vec<String> {
    let place = s.quantity.place();
    let entries: [(bool, &str); 22] = [
        (
            s.driver == Driver::TemperatureRate && place != Place::Inputs,
            "a temperature gradient across the stack while it heats or cools (Carslaw & Jaeger, Conduction of Heat in Solids, ch. 3)",
        ),
        (
            s.driver == Driver::TemperatureRate && place == Place::Inputs,
            "a thermometer that is ahead of the sensor or behind it (IEC 60751, response time)",
        ),
        (
            s.driver == Driver::LoadRate && s.kinetics == Kinetics::Static && place == Place::Readout,
            "a voltage or current that the moving stage or its motor couples into the electronics (Ott, Electromagnetic Compatibility Engineering, ch. 2)",
        ),
        (
            s.driver == Driver::LoadRate && matches!(place, Place::Mechanics | Place::Geometry | Place::Inputs),
            "viscous resistance: a damper, air or fluid squeezed out (Ferry, Viscoelastic Properties of Polymers)",
        ),
        (
            s.driver == Driver::LoadRate && s.kinetics == Kinetics::FirstOrder,
            "stiffness that depends on how fast or how often it is loaded (Payne effect; Medalia, Rubber Chem. Technol. 51 (1978) 437)",
        ),
        (
            s.kinetics == Kinetics::Accumulating
                && s.sum == Some(Sum::Dose)
                && matches!(s.driver, Driver::LoadHistory | Driver::Load),
            "flow under load that does not come back: cold flow, permanent set (ISO 815, compression set)",
        ),
        (
            s.kinetics == Kinetics::Accumulating && s.sum == Some(Sum::Greatest),
            "damage or softening up to the greatest value so far (Mullins effect; Diani et al., Eur. Polym. J. 45 (2009) 601)",
        ),
        (
            s.kinetics == Kinetics::Accumulating && s.sum == Some(Sum::Path),
            "wear, fatigue or ratcheting with every cycle (Chaboche, Int. J. Plasticity 24 (2008) 1642)",
        ),
        (
            s.kinetics == Kinetics::Event && s.driver != Driver::Time,
            "a slip or a snap each time that a level is passed (stick-slip: Rabinowicz, J. Appl. Phys. 22 (1951) 1373)",
        ),
        (
            s.kinetics == Kinetics::Event && s.driver == Driver::Time,
            "something that was changed, moved or repaired at that moment",
        ),
        (
            s.kinetics == Kinetics::Static
                && s.form == Form::Threshold
                && matches!(s.driver, Driver::Load)
                && place != Place::Readout,
            "a part that touches a stop or leaves it (bottoming; Johnson, Contact Mechanics, ch. 4)",
        ),
        (
            s.driver == Driver::Temperature && place == Place::Mechanics,
            "a transition of the rubber: glass transition or crystallisation (Ferry, ch. 11)",
        ),
        (
            s.driver == Driver::Temperature && s.form == Form::Threshold && place != Place::Mechanics,
            "a transition of a material or a part that loosens above a temperature (differential scanning calorimetry, ISO 11357)",
        ),
        (
            s.driver == Driver::Reading && s.kinetics == Kinetics::FirstOrder,
            "charge that is left from the reading before: dielectric absorption, settling of the converter (Kester, Data Conversion Handbook, ch. 7)",
        ),
        (
            s.driver == Driver::Reading && s.kinetics == Kinetics::Periodic,
            "unequal steps of the converter (integral nonlinearity, IEEE Std 1241)",
        ),
        (
            s.driver == Driver::Reading && s.kinetics == Kinetics::Static,
            "a bent characteristic of the electronics (integral nonlinearity, IEEE Std 1241)",
        ),
        (s.driver == Driver::Time && s.kinetics == Kinetics::Periodic, "pickup of the mains, a fan, a daily or a yearly cycle"),
        (
            s.kinetics == Kinetics::RateIndependent && matches!(s.driver, Driver::Recorded(_)),
            "dry friction against the motion (Armstrong-Helouvry et al., Automatica 30 (1994) 1083)",
        ),
        (
            s.form == Form::Peak && s.kinetics == Kinetics::Static && numbers.turn > 0.0,
            "something in the way from one direction: the shadow of a mast, a wall, a mark (anemometers: IEC 61400-12-1, annex G)",
        ),
        (
            s.form == Form::Peak && s.kinetics == Kinetics::Static && numbers.turn == 0.0,
            "a resonance, an absorption line, a worn or soiled place",
        ),
        (
            s.kinetics == Kinetics::Periodic && numbers.turn > 0.0,
            "a disc or a scale off its centre (once a turn), or tilted or of several parts (twice and more; Ernst, Digital Linear and Angular Metrology, 1989)",
        ),
        (
            s.driver == Driver::Time && matches!(s.kinetics, Kinetics::FirstOrder | Kinetics::Static) && place == Place::Readout,
            "warming up or drift of the electronics (IEC 60359, stability)",
        ),
    ];
    entries.into_iter().filter(|(fits, _)| *fits).map(|(_, says)| says.to_owned()).take(3).collect()
}
