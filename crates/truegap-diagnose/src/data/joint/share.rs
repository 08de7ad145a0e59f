//! Which parameters the recordings have in common: all of one specimen's, and the material constants of different ones.
//!
//! Limits: material constants are shared where name, unit and prior are the same; two specimens of one drawing are two specimens.

use crate::data::joint::member::Member;
use serde::Serialize;
use truegap_core::Parameter;

/// What is common, for a reader.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Sharing {
    /// parameters of more than one recording
    pub shared: Vec<String>,
    /// parameters that one recording alone has: its number from 1, and their names
    pub own: Vec<(usize, Vec<String>)>,
    /// the same as a sentence
    pub says: String,
}

/// Joint parameters and where each recording's stand among them.
pub(crate) struct Shared {
    pub parameters: Vec<Parameter>,
    pub places: Vec<Vec<usize>>,
    pub sharing: Sharing,
}

/// Numbers the parameters; `own[k]` are those that recording `k` has beside its base model's.
pub(crate) fn share(members: &[Member<'_>], own: &[Vec<Parameter>], materials: &[&str]) -> Shared {
    let mut parameters: Vec<Parameter> = Vec::new();
    let mut places: Vec<Vec<usize>> = Vec::new();
    for (k, member) in members.iter().enumerate() {
        let base = member.simulator.parameters();
        let same = members[..k].iter().position(|m| m.specimen == member.specimen);
        let mut here: Vec<usize> = match same {
            Some(before) => places[before][..base.len()].to_vec(),
            None => base.iter().map(|p| place(&mut parameters, p, k, materials)).collect(),
        };
        for parameter in &own[k] {
            here.push(parameters.len());
            parameters.push(parameter.clone());
        }
        places.push(here);
    }
    let sharing = sharing(&parameters, &places);
    Shared { parameters, places, sharing }
}

/// Index of a parameter of recording `k`, which is added where it is not there yet.
fn place(parameters: &mut Vec<Parameter>, wanted: &Parameter, k: usize, materials: &[&str]) -> usize {
    let alike = |p: &Parameter| p.name == wanted.name && p.unit == wanted.unit && p.prior == wanted.prior;
    if let Some(found) = parameters.iter().position(alike).filter(|_| materials.contains(&wanted.name.as_str())) {
        return found;
    }
    let mut own = wanted.clone();
    if parameters.iter().any(|p| p.name == own.name) {
        own.name = format!("{}_{}", own.name, k + 1);
        own.meaning = format!("{}, recording {}", own.meaning, k + 1);
    }
    parameters.push(own);
    parameters.len() - 1
}

fn sharing(parameters: &[Parameter], places: &[Vec<usize>]) -> Sharing {
    let holders = |index: usize| (0..places.len()).filter(|k| places[*k].contains(&index)).collect::<Vec<_>>();
    let (mut shared, mut own) = (Vec::new(), vec![Vec::new(); places.len()]);
    for (index, parameter) in parameters.iter().enumerate() {
        match holders(index).as_slice() {
            [one] => own[*one].push(parameter.name.clone()),
            _ => shared.push(parameter.name.clone()),
        }
    }
    let own: Vec<(usize, Vec<String>)> =
        own.into_iter().enumerate().filter(|(_, names)| !names.is_empty()).map(|(k, names)| (k + 1, names)).collect();
    let mut says = if shared.is_empty() {
        "added physics is common to all recordings, no parameter of the base model is".to_owned()
    } else {
        format!("common to the recordings: added physics and {}", shared.join(", "))
    };
    for (number, names) in &own {
        says += &format!("; recording {number} alone: {}", names.join(", "));
    }
    Sharing { shared, own, says }
}
