//! The bath: weak imperfections of ordinary sensors under whatever else is concealed.
//!
//! Limits: causes of the library only, each of another family than the others and than the dominant ones; none that asks for another base model or a column
//! that is not recorded.

use crate::causes::{Bench, LIBRARY};
use crate::chain::Act;
use crate::draws::Draws;
use crate::recording::Declared;
use crate::score::family::family;

/// Most imperfections in a bath.
const MOST: usize = 3;
/// Detectability of each.
const FROM: f64 = 1.0;
const TO: f64 = 4.0;
/// Draws before a bath has fewer.
const ATTEMPTS: usize = 24;

/// None to [`MOST`] weak causes beside `acts`.
pub(crate) fn bath(bench: &Bench, acts: &[Act], declared: Declared, draws: &mut Draws) -> Vec<Act> {
    let wanted = draws.index(MOST + 1);
    let mut weak: Vec<Act> = Vec::new();
    for _ in 0..ATTEMPTS {
        if weak.len() == wanted {
            break;
        }
        let (id, shape) = LIBRARY[draws.index(LIBRARY.len())];
        let asked = draws.log_between(FROM, TO);
        let cause = shape(draws);
        let needs = cause.needs();
        let fits = (!needs.warp || declared.warp) && (!needs.no_warp || !declared.warp) && (!needs.humidity || declared.humidity);
        let alone = acts.iter().chain(&weak).all(|act| family(act.mechanism.id()) != family(id));
        if fits
            && alone
            && let Ok(act) = bench.sized(cause, asked)
        {
            weak.push(act);
        }
    }
    weak
}
