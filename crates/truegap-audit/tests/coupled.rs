//! scratch
use truegap_audit::disc::*;
use truegap_audit::{Options, Study, Watch};
use truegap_core::sensor::builtin_sensor;

#[test]
fn print() {
    for name in ["singletact-s15-4.5n", "singletact-s8-optimised"] {
        let sensor = builtin_sensor(name).unwrap().unwrap();
        let watch = Watch::default();
        let study = Study::new(&sensor, Options::default(), &watch).unwrap();
        let device = &study.device;
        let strain = |w: &truegap_model::stack::Warm, f: f64| Ok(device.strain(w, f, 1.0, [0.0; 2]).unwrap());
        let whole = Whole::new(&sensor, device, &strain, CoupledOptions::default()).unwrap();
        for (f, t) in [(0.0, 20.0), (4.5, 20.0), (0.0, 50.0), (4.5, 50.0)] {
            let begin = std::time::Instant::now();
            let base = study.chain(truegap_audit::Swap::none()).row(f, t).unwrap();
            match whole.solve(f, t) {
                Ok(c) => {
                    println!(
                        "{name} {f} N {t}: main {:.4} backing {:.4} tail {:.4} +- {:.1e} (model {:.4} {:.4} {:.4}) total {:.4} model {:.4} [{:.1?}] tri {} rings {:?} forces {:?}",
                        1e12 * c.charged.main,
                        1e12 * c.charged.backing,
                        1e12 * c.charged.tail,
                        1e12 * c.charged.error_estimate,
                        1e12 * base.parts.shares.main,
                        1e12 * base.parts.shares.backing,
                        1e12 * base.parts.shares.tail,
                        1e12 * c.charged.total(),
                        1e12 * base.total,
                        begin.elapsed(),
                        c.deformed.triangles.len(),
                        c.disc.rings,
                        c.carried.forces
                    );
                }
                Err(e) => println!("{f} {t} {e} [{:.1?}]", begin.elapsed()),
            }
        }
    }
}
