//! The rows about the electrode, for built-in sensors.

use truegap_audit::assumptions::plate::ASSUMPTIONS;
use truegap_audit::{Options, Study, Watch};
use truegap_core::sensor::builtin_sensor;

#[test]
#[ignore = "prints"]
fn print() {
    for name in ["singletact-s15-4.5n", "singletact-s15-4.5n-stiffening", "singletact-s8-optimised"] {
        let sensor = builtin_sensor(name).unwrap().unwrap();
        let watch = Watch::default();
        let study = Study::new(&sensor, Options::default(), &watch).unwrap();
        println!("== {name}: K_baseline {}", study.base().k_baseline_pct_fsr_per_k);
        for a in ASSUMPTIONS {
            let begin = std::time::Instant::now();
            match a.examine(&study) {
                Ok(f) => println!(
                    "{} analytic {:.5} fem {:.5} +- {:.1e} {} rel {:+.4} {:?} [{:.1?}]\n   {}\n   {:?}",
                    f.id,
                    f.analytic.value,
                    f.fem.value,
                    f.fem.error_estimate,
                    f.fem.unit,
                    f.relative_error,
                    f.verdict,
                    begin.elapsed(),
                    f.reason,
                    f.effect_on.values()
                ),
                Err(e) => println!("{} {e}", a.id()),
            }
        }
    }
}
