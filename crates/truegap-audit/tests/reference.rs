//! The disc of bead cells against the cells themselves.

#![allow(clippy::unwrap_used)]

use truegap_audit::disc::Fineness;
use truegap_audit::reference::{CellDisc, FlatCells};
use truegap_core::sensor::builtin_sensor;

const QUICK: Fineness = Fineness { columns: 32, rows: 1 };

#[test]
fn held_flat_the_disc_is_its_cells() {
    let sensor = builtin_sensor("singletact-s15-4.5n").unwrap().unwrap();
    let disc = CellDisc::with(FlatCells::new(&sensor, 3e-5).unwrap(), QUICK).unwrap();
    let cold = disc.held_flat(0.0, 20.0).unwrap();
    // a bead and a ring of its share differ by how they bend the field: some hundredths of the permittivity, 3.4
    assert!((cold.permittivities[0] / 3.4 - 1.0).abs() < 0.03, "{:?}", cold.permittivities);
    for (force, celsius) in [(0.0, 50.0), (4.5, 20.0), (4.5, 50.0)] {
        let held = disc.held_flat(force, celsius).unwrap();
        let flat = held.flat;
        println!("{force} N, {celsius} degC: {} {} pF, {} {} pF", held.main, flat.parts.main, held.backing, flat.parts.backing);
        assert!((held.carried.plate_force - force).abs() < 1e-3);
        // the bead cell's height, by another body and another law: to the film below a ring that yields more than one pressed evenly, 0.05 nm
        assert!(held.heights.iter().all(|h| (h - flat.gap).abs() < 0.2e-9), "{:?} {}", held.heights, flat.gap);
        // to the target, and half of the areas' difference (electrode and shield grow by 17.3 and 16.7 ppm/K)
        assert!((held.main / flat.parts.main - 1.0).abs() < 8e-5);
        assert!((held.backing / flat.parts.backing - 1.0).abs() < 3e-6);
        // beads that bulge hold more of the field
        assert!(held.permittivities[0] > cold.permittivities[0] && (force > 0.0) == (held.permittivities[0] > 3.45));
    }
    // the span is seventeen times what the ring's own spread would leave of it
    let loaded = disc.held_flat(4.5, 20.0).unwrap();
    assert!(loaded.main - cold.main > 0.5);
}
