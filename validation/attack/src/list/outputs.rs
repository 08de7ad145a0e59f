//! Places for answers: full disks, links, readers that have gone, requests that are refused and corrected.

use super::material::{HEADER, SENSOR, csv, square};
use crate::attack::{Attack, Put};
use std::fs;
use std::path::Path;

pub fn all() -> Vec<Attack> {
    let diagnose = ["-q", "diagnose", "r.csv", "--sensor", SENSOR, "--effects", "thermal_lag", "-o", "out"];
    let recorded = |class, name: &str| Attack::new(class, name, &diagnose).file("r.csv", csv(HEADER));
    let mut all = vec![
        recorded("11", "an answer that nobody reads").unread().ends(1, &["out"]),
        Attack::new("11", "numbers that nobody reads", &["--json", "simulate", "--load", "0:1 N:20000"]).unread().ends(0, &[]),
        recorded("17", "an answer into a link")
            .with(Put::Folder("real".into()))
            .with(Put::Link("out".into(), "real".into()))
            .ends(1, &["out"])
            .look(still_a_link),
        recorded("17", "an answer into a link that leads nowhere").with(Put::Link("out".into(), "nowhere".into())).says(&["out"]),
        recorded("outputs", "an answer into a file").file("out", "mine").says(&["there is a file"]),
        recorded("outputs", "an answer into somebody's folder")
            .file("out/thesis.tex", "mine")
            .says(&["thesis.tex", "would be lost"]),
        recorded("outputs", "an answer onto a page of somebody else's")
            .file("out/report.html", "mine")
            .says(&["report.html", "would be lost"]),
        recorded("outputs", "an answer onto a full disk").full_disk(8).says(&["cannot be written"]),
    ];
    let studies: [(&str, &[&str]); 3] = [
        ("sensitivity", &["-q", "sensitivity", "--rows", "64", "-o", "out"]),
        ("tolerance", &["-q", "tolerance", "--samples", "64", "-o", "out"]),
        ("optimise", &["-q", "optimise", "--searches", "1", "-o", "out"]),
    ];
    for (name, typed) in studies {
        all.push(Attack::new("14", format!("{name} onto a full disk"), typed).full_disk(0).says(&["cannot be written"]));
    }
    all.extend([
        // the cases are kept, as the study goes on from them; of the answer nothing is there
        Attack::new("14", "the report of a study onto a full disk", studies[0].1)
            .full_disk(8)
            .says(&["cannot be written", "nothing of this answer"]),
        Attack::new("14", "a refused search", &["-q", "optimise", "--least-baseline", "100", "-o", "out"])
            .says(&["widen the space"]),
        Attack::new(
            "14",
            "a sensor that cannot be studied",
            &["-q", "tolerance", "--sensor", "./s.toml", "--samples", "64", "-o", "out"],
        )
        .file("s.toml", super::material::sensor("full_scale = \"4.5 N\"", "full_scale = \"1e-300 N\"")),
        Attack::new("outputs", "a mesh onto a full disk", &["-q", "mesh", "c.toml", "-o", "m.msh"])
            .file("c.toml", square())
            .full_disk(0)
            .says(&["cannot be written"]),
        Attack::new("outputs", "a solved mesh onto a full disk", &["-q", "mesh", "c.toml", "--solved", "-o", "m.vtu"])
            .file("c.toml", square())
            .full_disk(2)
            .says(&["m.vtu", "cannot be written"]),
        // half a description would have the next `init` refused
        Attack::new("outputs", "a description onto a full disk", &["init", "r.csv"])
            .file("r.csv", csv(HEADER))
            .full_disk(0)
            .says(&["r.toml", "cannot be written"]),
        Attack::new("outputs", "a manual onto a full disk", &["man", "-o", "pages"])
            .full_disk(4)
            .says(&["pages", "cannot be written"]),
        Attack::new("outputs", "a blind study onto a full disk", &["-q", "prove", "--cases", "1", "--seed", "7", "-o", "study"])
            .full_disk(8)
            .says(&["study", "recording.csv"]),
        Attack::new("outputs", "a mesh of no format", &["-q", "mesh", "c.toml", "-o", "m.stl"])
            .file("c.toml", square())
            .says(&[".msh", ".vtu"]),
        Attack::new("outputs", "a folder of shards that is none", &["merge", "x"])
            .file("x/sweep.json", "{}")
            .says(&["holds no sweep"]),
        Attack::new("outputs", "a sweep of brackets", &["merge", "x"])
            .file("x/sweep.json", "[".repeat(500_000))
            .says(&["holds no sweep"]),
    ]);
    all
}

fn still_a_link(folder: &Path) -> Option<String> {
    let kept = folder.join("out").is_symlink() && folder.join("real/diagnosis.json").is_file();
    (!kept).then(|| format!("the link was replaced: {:?}", fs::symlink_metadata(folder.join("out"))))
}
