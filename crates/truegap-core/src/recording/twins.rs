//! Two columns of one quantity, where a name says which of them an instrument has written: that one is the reading.
//!
//! Limits: names and units; where neither tells, nothing is taken.

use super::{
    heading::Heading,
    words::{is_called_instrument, is_called_reference, is_called_simulation, subject},
};
use crate::units::{Dimension, MEASURED};

/// A reading, and the column of its quantity that stands beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Twins {
    pub reading: usize,
    pub beside: usize,
    /// whether that is the simulation of it, and not what it is held against
    pub is_simulated: bool,
}

/// What is measured, as far as the unit tells.
fn quantity(heading: &Heading) -> Option<Dimension> {
    MEASURED.into_iter().find(|dimension| heading.shown_unit_of(*dimension).is_some())
}

/// Whether two columns hold one quantity: units of one kind, the same unit, or without units the same name but for who has written it.
pub(super) fn alike(one: &Heading, other: &Heading) -> bool {
    match (quantity(one), quantity(other)) {
        (Some(one), Some(other)) => one == other,
        (None, None) => {
            let subject = |heading: &Heading| subject(&heading.name);
            let same_unit = one.sure_unit().is_some() && one.sure_unit() == other.sure_unit();
            same_unit || (one.sure_unit().is_none() && other.sure_unit().is_none() && subject(one) == subject(other))
        }
        _ => false,
    }
}

/// Whether two names end in the same unit, known or not: `sim_lpm` and `flow_lpm`.
fn same_tail(one: &Heading, other: &Heading) -> bool {
    let tail = |heading: &Heading| heading.unit().filter(|unit| !subject(unit).is_empty()).map(str::to_owned);
    quantity(one) == quantity(other) && tail(one).is_some() && tail(one) == tail(other)
}

/// The one of `free` for which `holds`, where there is exactly one.
fn only(free: &[usize], holds: impl Fn(usize) -> bool) -> Option<usize> {
    let mut found = free.iter().copied().filter(|index| holds(*index));
    found.next().filter(|_| found.next().is_none())
}

/// The reading beside the one column of `free` that is called after a simulation: the other of its quantity, of several the one that an instrument has written, or that is called as the simulation is.
pub(super) fn of_simulation(header: &[Heading], free: &[usize]) -> Option<Twins> {
    let is_computed = |index: usize| is_called_simulation(&header[index].name);
    let simulated = only(free, is_computed)?;
    let is_alike = |other: &Heading| alike(&header[simulated], other) || same_tail(&header[simulated], other);
    let beside = |index: usize| !is_computed(index) && !header[index].dated && is_alike(&header[index]);
    let called_so = |index: usize| subject(measured(&header[index])) == subject(measured(&header[simulated]));
    let reading = only(free, beside)
        .or_else(|| only(free, |index| beside(index) && is_called_instrument(&header[index].name)))
        .or_else(|| only(free, |index| beside(index) && called_so(index)))?;
    Some(Twins { reading, beside: simulated, is_simulated: true })
}

/// The reading beside a reference, where both are the only columns of `free` of their quantity, and each is called so.
pub(super) fn of_reference(header: &[Heading], free: &[usize]) -> Option<Twins> {
    let reading = only(free, |index| is_called_instrument(&header[index].name) && !is_called_reference(&header[index].name))?;
    let other = only(free, |index| index != reading && alike(&header[reading], &header[index]))?;
    is_called_reference(&header[other].name).then_some(Twins { reading, beside: other, is_simulated: false })
}

/// The name without its unit.
fn measured(heading: &Heading) -> &str {
    heading.unit_in_name().filter(|_| heading.sure_unit().is_some()).map_or(heading.name.as_str(), |(measured, _)| measured)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(header: &str, of: fn(&[Heading], &[usize]) -> Option<Twins>) -> Option<(usize, Option<usize>)> {
        let header: Vec<Heading> = header.split(';').map(Heading::of).collect();
        of(&header, &(0..header.len()).collect::<Vec<_>>())
            .map(|twins| (twins.reading, twins.is_simulated.then_some(twins.beside)))
    }

    #[test]
    fn the_other_column_of_a_simulated_quantity_is_the_reading() {
        for (header, twins) in [
            ("Time (s);Sim load (N);Load cell (N);Ambient (degC)", Some((2, Some(1)))),
            ("Time [s];F_sim [N];F_meas [N];T [°C]", Some((2, Some(1)))),
            ("Bad Sim [°C];Fühler [°C];Raum [°C]", Some((1, Some(0)))),
            ("t;force_sim;force_meas;speed", Some((2, Some(1)))),
            ("T_model [°C];T [°C];Room [°C]", Some((1, Some(0)))),
            ("predicted (mV);bridge (mV)", Some((1, Some(0)))),
            ("time_s;sim_lpm;flow_lpm;supply_V", Some((2, Some(1)))),
            ("Setpoint [N];Load cell [N]", None),
            ("T_model [°C];T1 [°C];T2 [°C]", None),
            ("T_model [°C];Load [N]", None),
            ("T_model [°C];F_model [N];T [°C];F [N]", None),
        ] {
            assert_eq!(found(header, of_simulation), twins, "{header}");
        }
    }

    #[test]
    fn an_instrument_beside_a_reference_is_the_reading() {
        for (header, twins) in [
            ("Time [s];Bath [degC];Thermocouple [degC]", Some((2, None))),
            ("F_ref [N];Load cell [N]", Some((1, None))),
            ("time;reference_ppm;sensor_ppm;humidity_pct", Some((2, None))),
            ("Load cell [N];Applied [N]", None),
            ("Bath [degC];Thermocouple 1 [degC];Thermocouple 2 [degC]", None),
            ("Bath [degC];Load cell [N]", None),
        ] {
            assert_eq!(found(header, of_reference), twins, "{header}");
        }
    }
}
