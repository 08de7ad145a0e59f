//! A figure that several assumptions draw: one quantity over the load.
//!
//! Limits: twenty equal steps of the load, at the cold temperature.

use crate::{
    error::AuditError,
    finding::{Curve, Figure},
    study::Study,
    swap::{Row, Swap},
};

/// A figure of one quantity over the load at the cold temperature, a curve a chain.
///
/// # Errors
/// What the chains refuse.
pub(super) fn over_load<const N: usize>(
    study: &Study<'_>,
    (title, y): (&str, &str),
    chains: [(&str, Swap<'_>); N],
    quantity: impl Fn(&Row) -> f64,
) -> Result<Figure, AuditError> {
    let mut curves = Vec::with_capacity(N);
    for (name, swap) in chains {
        let chain = study.chain(swap);
        let point = |i: u32| {
            let force = study.full_n() * f64::from(i) / 20.0;
            Ok((force, quantity(&chain.row(force, study.options.cold_c)?)))
        };
        let points = (0..=20).map(point).collect::<Result<_, AuditError>>()?;
        curves.push(Curve { name: name.into(), points, errors: Vec::new() });
    }
    let x = "load (N)".into();
    Ok(Figure { title: format!("{title} over the load at {} degC", study.options.cold_c), x, y: y.into(), curves })
}
